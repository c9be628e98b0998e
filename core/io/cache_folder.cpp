#include "core/io/cache_folder.h"

#include "core/io/atomic_file.h"
#include "core/numerics/checksum.h"
#include "core/program.h"

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <functional>
#include <utility>
#include <vector>

namespace alltact {
namespace {

namespace fs = std::filesystem;

fs::path told_by(const char* variable) {
  const char* text = std::getenv(variable);
  return text != nullptr ? fs::path(text) : fs::path();
}

}  // namespace

std::optional<fs::path> cache_folder(std::string_view kind) {
  const fs::path cache = told_by("XDG_CACHE_HOME"), home = told_by("HOME");
  if (cache.is_absolute()) return cache / "alltact" / kind;
  if (home.is_absolute()) return home / ".cache" / "alltact" / kind;
  return std::nullopt;
}

void remove_oldest(const fs::path& cache, std::size_t most) {
  std::error_code failed;
  std::vector<std::pair<fs::file_time_type, fs::path>> kept, gone;
  for (fs::directory_iterator entry(cache, failed), end; !failed && entry != end;
       entry.increment(failed)) {
    std::error_code removed;  // by another program
    const auto time = fs::last_write_time(entry->path(), removed);
    if (removed) continue;
    if (!entry->path().filename().string().starts_with('.'))
      kept.emplace_back(time, entry->path());
    else if (fs::file_time_type::clock::now() - time > std::chrono::hours(24))
      gone.emplace_back(time, entry->path());
  }
  std::sort(kept.begin(), kept.end(), std::greater<>());
  if (kept.size() > most)
    gone.insert(gone.end(), kept.begin() + static_cast<std::ptrdiff_t>(most), kept.end());
  for (const auto& one : gone) fs::remove_all(one.second, failed);
}

std::string checksum_of_code(const void* function) {
  const auto bytes = read_file(file_with(function));
  if (!bytes) return "";
  Checksum sum;
  sum.add(bytes->data(), bytes->size());
  return sum.text();
}

}  // namespace alltact
