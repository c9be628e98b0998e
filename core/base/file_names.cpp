#include "core/base/file_names.h"

#include <algorithm>
#include <cstdlib>

#include <utf8proc.h>

namespace alltact {
namespace {

namespace fs = std::filesystem;

bool is_ascii(const std::string& text) {
  return std::all_of(text.begin(), text.end(),
                     [](char letter) { return static_cast<unsigned char>(letter) < 0x80; });
}

bool is_there(const fs::path& path) {
  std::error_code failed;
  return fs::exists(path, failed);
}

/// The only entry of a folder whose name is composed of these characters; empty where there is none
/// or more than one.
fs::path entry_composed_as(const std::string& name, const fs::path& folder) {
  std::error_code failed;
  fs::path found;
  for (fs::directory_iterator entry(folder.empty() ? fs::path(".") : folder, failed), end;
       !failed && entry != end; entry.increment(failed)) {
    const fs::path stored = entry->path().filename();
    if (composed(stored.string()) != name) continue;
    if (!found.empty()) return {};
    found = stored;
  }
  return found;
}

}  // namespace

std::string composed(const std::string& text) {
  if (is_ascii(text)) return text;
  utf8proc_uint8_t* made = nullptr;
  const utf8proc_ssize_t size =
      utf8proc_map(reinterpret_cast<const utf8proc_uint8_t*>(text.data()),
                   static_cast<utf8proc_ssize_t>(text.size()), &made,
                   static_cast<utf8proc_option_t>(UTF8PROC_STABLE | UTF8PROC_COMPOSE));
  if (size < 0) return text;
  std::string result(reinterpret_cast<const char*>(made), static_cast<std::size_t>(size));
  std::free(made);
  return result;
}

fs::path as_stored(const fs::path& path) {
  if (is_ascii(path.string()) || is_there(path)) return path;
  fs::path stored;
  for (const fs::path& name : path) {
    const fs::path entry =
        is_there(stored / name) ? fs::path() : entry_composed_as(composed(name.string()), stored);
    stored /= entry.empty() ? name : entry;
  }
  return stored;
}

}  // namespace alltact
