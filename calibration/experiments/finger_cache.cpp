#include "calibration/experiments/finger_cache.h"

#include "core/io/atomic_file.h"
#include "core/io/cache_folder.h"
#include "core/io/system_error.h"
#include "core/numerics/checksum.h"
#include "core/program.h"

#include <algorithm>
#include <cerrno>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace alltact {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMaxCached = 8;
constexpr const char* kListFile = "kept.json";
constexpr const char* kFingerFolder = "finger";
constexpr const char* kUnfinished = ".unfinished-";

/// Of a file's bytes; nullopt: it cannot be read.
std::optional<std::string> file_checksum(const fs::path& file) {
  const auto bytes = read_file(file);
  if (!bytes) return std::nullopt;
  Checksum sum;
  sum.add(bytes->data(), bytes->size());
  return sum.text();
}

/// Checksum of the program's code.
const std::string& program_checksum() {
  static const std::string checksum =
      checksum_of_code(reinterpret_cast<const void*>(&program_version)) +
      checksum_of_code(reinterpret_cast<const void*>(&cached_finger_name));
  return checksum;
}

/// Relative, in order of their names.
std::vector<fs::path> files_below(const fs::path& folder, std::error_code& failed) {
  std::vector<fs::path> files;
  for (fs::recursive_directory_iterator entry(folder, failed), end; !failed && entry != end;
       entry.increment(failed))
    if (entry->is_regular_file(failed)) files.push_back(entry->path().lexically_relative(folder));
  std::sort(files.begin(), files.end());
  return files;
}

/// Returns the checksum of each copied file. nullopt: a file cannot be read or written.
std::optional<nlohmann::ordered_json> copy_files(const fs::path& from, const fs::path& to) {
  std::error_code failed;
  auto sums = nlohmann::ordered_json::object();
  for (const fs::path& file : files_below(from, failed)) {
    fs::create_directories((to / file).parent_path(), failed);
    if (failed || !fs::copy_file(from / file, to / file, failed)) return std::nullopt;
    const auto sum = file_checksum(to / file);
    if (!sum) return std::nullopt;
    sums[file.generic_string()] = *sum;
  }
  if (failed || sums.empty()) return std::nullopt;
  return sums;
}

void remove_quietly(const fs::path& folder) {
  std::error_code failed;
  fs::remove_all(folder, failed);
}

Error caching_error(const fs::path& where, int code) {
  return system_error(
      en::say("could not keep the simulated finger for the next time"), where, code);
}

/// A new folder next to the cached ones.
Result<fs::path> unfinished_folder(const fs::path& cache) {
  if (const Status made = make_folder(cache); !made) return made.error();
  std::string path = (cache / (std::string(kUnfinished) + "XXXXXX")).string();
  if (mkdtemp(path.data()) == nullptr) return caching_error(cache, errno);
  return fs::path(path);
}

/// Something exists at the target of a rename: another program's folder, or the rest of one.
bool is_occupied(const std::error_code& failed) {
  return failed == std::errc::directory_not_empty || failed == std::errc::file_exists ||
         failed == std::errc::not_a_directory;
}

/// Renames `made` into the cache, which other programs may change at the same time.
std::error_code rename_into_cache(const fs::path& made,
                                  const fs::path& cache,
                                  const std::string& name) {
  constexpr int kMostTries = 100;  // each that fails is another program's success
  std::error_code failed;
  for (int i = 0; i < kMostTries; ++i) {
    fs::rename(made, cache / name, failed);
    if (!is_occupied(failed)) break;
    // Another program was first, or the existing folder is damaged; this one is complete in
    // both cases. The old one is renamed first, so that no program sees half of it.
    const auto aside = unfinished_folder(cache);
    if (!aside) break;
    std::error_code no_matter;
    fs::rename(cache / name, *aside / "old", no_matter);
    remove_quietly(*aside);
  }
  return failed;
}

}  // namespace

std::string cached_finger_name(const std::vector<std::string_view>& made_by) {
  Checksum sum;
  sum.add(program_checksum().data(), program_checksum().size());
  for (const std::string_view words : made_by) {
    const std::uint64_t length = words.size();  // so that shifted borders change the sum
    sum.add(&length, sizeof length);
    sum.add(words.data(), words.size());
  }
  return fmt::format("{}-{}", program_version(), sum.text());
}

std::optional<std::string> load_cached_finger(const fs::path& cache,
                                              const std::string& name,
                                              const fs::path& to) {
  const auto text = read_file(cache / name / kListFile);
  if (!text) return std::nullopt;
  const auto list = nlohmann::ordered_json::parse(*text, nullptr, false);
  if (!list.is_object() || !list.contains("files") || !list.contains("note") ||
      !list["note"].is_string())
    return std::nullopt;
  // The copy is verified, not the cache, which may change meanwhile.
  const auto copied = copy_files(cache / name / kFingerFolder, to);
  if (copied && *copied == list["files"]) return list["note"].get<std::string>();
  remove_quietly(to);
  return std::nullopt;
}

Status cache_finger(const fs::path& cache,
                    const std::string& name,
                    const fs::path& finger_folder,
                    const std::string& note) {
  const auto made = unfinished_folder(cache);
  if (!made) return made.error();
  const auto files = copy_files(finger_folder, *made / kFingerFolder);
  const int code = errno;
  if (!files) {
    remove_quietly(*made);
    return caching_error(cache, code);
  }
  const nlohmann::ordered_json list{{"note", note}, {"files", *files}};
  const Status listed = write_file_atomically(*made / kListFile, list.dump(1) + "\n");
  if (!listed) {
    remove_quietly(*made);
    return listed;
  }
  if (const std::error_code failed = rename_into_cache(*made, cache, name)) {
    remove_quietly(*made);
    return caching_error(cache, failed.value());
  }
  remove_oldest(cache, kMaxCached);
  return {};
}

}  // namespace alltact
