#include "core/base/cache.h"

#include "core/base/atomic_file.h"
#include "core/base/program.h"
#include "core/numerics/checksum.h"

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <functional>
#include <utility>
#include <vector>

namespace alltact {
namespace {

namespace fs = std::filesystem;

fs::path path_from(const char* variable) {
  const char* text = std::getenv(variable);
  return text != nullptr ? fs::path(text) : fs::path();
}

}  // namespace

std::optional<fs::path> cache_folder(std::string_view kind) {
  const fs::path cache = path_from("XDG_CACHE_HOME"), home = path_from("HOME");
  if (cache.is_absolute()) return cache / "alltact" / kind;
  if (home.is_absolute()) return home / ".cache" / "alltact" / kind;
  return std::nullopt;
}

void remove_oldest(const fs::path& cache, std::size_t max_entries) {
  std::error_code failed;
  std::vector<std::pair<fs::file_time_type, fs::path>> entries, removable;
  for (fs::directory_iterator entry(cache, failed), end; !failed && entry != end;
       entry.increment(failed)) {
    std::error_code removed;  // by another program
    const auto time = fs::last_write_time(entry->path(), removed);
    if (removed) continue;
    if (!entry->path().filename().string().starts_with('.'))
      entries.emplace_back(time, entry->path());
    else if (fs::file_time_type::clock::now() - time > std::chrono::hours(24))
      removable.emplace_back(time, entry->path());
  }
  std::sort(entries.begin(), entries.end(), std::greater<>());
  if (entries.size() > max_entries)
    removable.insert(removable.end(), entries.begin() + static_cast<std::ptrdiff_t>(max_entries),
                     entries.end());
  for (const auto& one : removable) fs::remove_all(one.second, failed);
}

std::string checksum_of_code(const void* function) {
  const auto bytes = read_file(binary_of(function));
  if (!bytes) return "";
  Checksum sum;
  sum.add(bytes->data(), bytes->size());
  return sum.text();
}

}  // namespace alltact
