#include "core/io/folder_change.h"

#include "core/io/atomic_file.h"
#include "core/io/system_error.h"

#include <algorithm>
#include <cerrno>
#include <optional>
#include <set>
#include <sstream>
#include <utility>

#include <fmt/format.h>
#include <unistd.h>

namespace alltact {
namespace {

namespace fs = std::filesystem;

constexpr const char* kList = ".change.list";
constexpr const char* kStagedPrefix = ".change-";
constexpr std::string_view kHead = "alltact-change/1";

struct ChangeList {
  std::string staged;  // name of the folder of new files
  std::vector<std::string> taken, removed;
};

std::string text_of(const ChangeList& list) {
  std::string text = std::string(kHead) + "\nfrom " + list.staged + "\n";
  for (const std::string& name : list.taken) text += "take " + name + "\n";
  for (const std::string& name : list.removed) text += "remove " + name + "\n";
  return text + "end\n";
}

bool is_inside(const std::string& name) {
  const fs::path path(name);
  if (name.empty() || path.is_absolute()) return false;
  return std::none_of(path.begin(), path.end(), [](const fs::path& part) { return part == ".."; });
}

/// True when no folder in the path to a file is a link. Listed files then stay in their folder, and
/// renames on its disk.
bool is_without_links(const fs::path& folder, const fs::path& name) {
  std::error_code absent;
  fs::path current = folder;
  for (const fs::path& part : name.parent_path())
    if (fs::is_symlink(fs::symlink_status(current /= part, absent))) return false;
  return true;
}

/// The first name whose path contains a link.
std::optional<std::string> path_with_link(const fs::path& folder, const ChangeList& list) {
  for (const std::string& name : list.taken)
    if (!is_without_links(folder, name) || !is_without_links(folder, list.staged + "/" + name))
      return name;
  for (const std::string& name : list.removed)
    if (!is_without_links(folder, name)) return name;
  return std::nullopt;
}

Error leads_elsewhere(const fs::path& folder, const std::string& name) {
  return {en::say("{} lies in a folder that is a link to elsewhere", name),
          folder,
          en::say("putting that folder itself there instead of the link")};
}

Result<ChangeList> list_in(const fs::path& folder) {
  const auto text = read_file(folder / kList);
  if (!text) return text.error();
  const Error broken{en::say("this is no list of files to be changed"),
                     folder / kList,
                     en::say("removing it; the finger's files are then some old, some new")};
  std::istringstream lines(*text);
  ChangeList list;
  std::string line;
  if (!std::getline(lines, line) || line != kHead) return broken;
  while (std::getline(lines, line) && line != "end") {
    const std::size_t space = line.find(' ');
    const std::string what = line.substr(0, space);
    const std::string name = space == std::string::npos ? "" : line.substr(space + 1);
    if (!is_inside(name)) return broken;
    if (what == "from" && name.starts_with(kStagedPrefix))
      list.staged = name;
    else if (what == "take")
      list.taken.push_back(name);
    else if (what == "remove")
      list.removed.push_back(name);
    else
      return broken;
  }
  if (line != "end" || list.staged.empty()) return broken;
  if (const auto name = path_with_link(folder, list)) return leads_elsewhere(folder, *name);
  return list;
}

/// May be repeated: completed steps are skipped.
Status apply_list(const fs::path& folder, const ChangeList& list) {
  const Message kChanging = en::say("could not be changed");
  std::set<fs::path> changed_folders{folder};
  for (const std::string& name : list.taken) {
    const fs::path from = folder / list.staged / name, to = folder / name;
    if (const Status made = make_folder(to.parent_path()); !made) return made;
    if (::rename(from.c_str(), to.c_str()) != 0 && errno != ENOENT)
      return system_error(kChanging, to, errno);
    changed_folders.insert(to.parent_path());
  }
  for (const std::string& name : list.removed) {
    const fs::path gone = folder / name;
    if (::unlink(gone.c_str()) != 0 && errno != ENOENT) return system_error(kChanging, gone, errno);
    changed_folders.insert(gone.parent_path());
  }
  std::error_code absent;
  for (const fs::path& one : changed_folders)
    if (fs::is_directory(one, absent))
      if (const Status synced = sync_folder(one); !synced) return synced;
  if (::unlink((folder / kList).c_str()) != 0 && errno != ENOENT)
    return system_error(kChanging, folder / kList, errno);
  if (const Status synced = sync_folder(folder); !synced) return synced;
  std::error_code ignored;
  fs::remove_all(folder / list.staged, ignored);
  return {};
}

/// Files below a folder, as relative paths; syncs all their folders to the disk.
Result<std::vector<std::string>> files_below(const fs::path& folder) {
  std::vector<std::string> names;
  std::error_code error;
  if (const Status synced = sync_folder(folder); !synced) return synced.error();
  for (fs::recursive_directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error)) {
    if (!entry->is_directory())
      names.push_back(fs::relative(entry->path(), folder).generic_string());
    else if (const Status synced = sync_folder(entry->path()); !synced)
      return synced.error();
  }
  if (error) return system_error(en::say("could not read the folder"), folder, error.value());
  std::sort(names.begin(), names.end());
  return names;
}

/// Removes the rests of programs that ended before a decision.
void remove_rests(const fs::path& folder) {
  std::vector<fs::path> left;
  std::error_code ignored;
  for (fs::directory_iterator entry(folder, ignored), end; !ignored && entry != end;
       entry.increment(ignored))
    if (entry->path().filename().string().starts_with(kStagedPrefix)) left.push_back(entry->path());
  for (const fs::path& one : left) fs::remove_all(one, ignored);
}

}  // namespace

Result<FolderChange> FolderChange::begin(const fs::path& folder) {
  if (const Status completed = complete_change(folder); !completed) return completed.error();
  remove_rests(folder);
  FolderChange change(folder);
  const fs::path staged = folder / fmt::format("{}{}", kStagedPrefix, ::getpid());
  if (const Status made = make_folder(staged); !made) return made.error();
  change.staged_ = staged;
  return change;
}

FolderChange::FolderChange(FolderChange&& other) noexcept
    : folder_(std::move(other.folder_)),
      staged_(std::exchange(other.staged_, {})),
      removed_(std::move(other.removed_)) {}

FolderChange::~FolderChange() {
  std::error_code ignored;
  if (!staged_.empty()) fs::remove_all(staged_, ignored);
}

Status FolderChange::commit() {
  auto names = files_below(staged_);
  if (!names) return names.error();
  const ChangeList list{staged_.filename().string(), std::move(*names), removed_};
  if (const auto name = path_with_link(folder_, list)) return leads_elsewhere(folder_, *name);
  if (const Status decided = write_file_atomically(folder_ / kList, text_of(list)); !decided) {
    // Except where the list exists, and only its folder could not be synced.
    if (has_open_change(folder_)) staged_.clear();
    return decided;
  }
  staged_.clear();  // owned by the list from now on
  return apply_list(folder_, list);
}

fs::path final_path(const fs::path& path) {
  fs::path known;
  for (const fs::path& part : target_of_temporary(path))
    if (!part.string().starts_with(kStagedPrefix) && part != kList) known /= part;
  return known;
}

bool has_open_change(const fs::path& folder) {
  std::error_code absent;
  return fs::exists(folder / kList, absent);
}

Status complete_change(const fs::path& folder) {
  if (!has_open_change(folder)) return {};
  const auto list = list_in(folder);
  return list ? apply_list(folder, *list) : Status(list.error());
}

}  // namespace alltact
