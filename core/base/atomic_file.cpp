#include "core/base/atomic_file.h"

#include "core/base/message.h"
#include "core/base/result.h"
#include "core/base/slow_disk.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <ctime>
#include <optional>
#include <regex>
#include <set>
#include <sstream>
#include <system_error>
#include <thread>
#include <utility>

#include <fcntl.h>
#include <fmt/chrono.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace alltact {
namespace {

namespace fs = std::filesystem;

/// A file that is removed with this object, unless retain() was called.
class Temporary {
 public:
  explicit Temporary(fs::path path) : path_(std::move(path)) {}
  Temporary(const Temporary&) = delete;
  Temporary& operator=(const Temporary&) = delete;
  ~Temporary() {
    if (!is_retained_) ::unlink(path_.c_str());
  }
  [[nodiscard]] const fs::path& path() const { return path_; }
  void retain() { is_retained_ = true; }

 private:
  fs::path path_;
  bool is_retained_ = false;
};

const Message kWriting = en::say("could not write the file");

/// Hidden, in the same folder and with the same extension, which gives encoders the format.
fs::path temporary_name(const fs::path& file, int attempt) {
  const std::string stem = file.stem().string().substr(0, 100);
  return file.parent_path() /
         fmt::format(".{}.{}-{}.tmp{}", stem, ::getpid(), attempt, file.extension().string());
}

/// Makes an empty file exclusively; returns its descriptor, or -1 and errno.
std::pair<int, fs::path> create_temporary(const fs::path& file) {
  constexpr int kAttempts = 10000;  // other threads, and rests of an earlier crash
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    fs::path path = temporary_name(file, attempt);
    const int number = ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (number >= 0 || errno != EEXIST) return {number, std::move(path)};
  }
  return {-1, {}};
}

bool write_all(int number, std::string_view content) {
  while (!content.empty()) {
    const ssize_t written = ::write(number, content.data(), content.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return false;
    content.remove_prefix(static_cast<std::size_t>(written));
  }
  return true;
}

Status fill(int number, const fs::path& file, std::string_view content) {
  const DiskWait waiting(file);
  if (!write_all(number, content)) return system_error(kWriting, file, errno);
  return {};
}

/// Resolves a link, so that its target is replaced instead.
fs::path without_links(const fs::path& file) {
  std::error_code ignored;
  if (!fs::is_symlink(file, ignored)) return file;
  fs::path target = fs::weakly_canonical(file, ignored);
  return ignored ? file : target;
}

/// Copies the old file's permissions to the new one.
void copy_permissions(const fs::path& from, int to) {
  struct stat status {};
  if (::stat(from.c_str(), &status) != 0) return;
  // Missing rights are no reason to lose the content.
  [[maybe_unused]] const int ignored = ::fchmod(to, status.st_mode & 07777U);
}

/// `fill` writes the content, given the open temporary and its path.
Status replace(const fs::path& requested,
               const std::function<Status(int number, const fs::path& temporary)>& fill,
               bool waits_for_disk = true) {
  std::optional<DiskWait> waiting(std::in_place, requested);
  const fs::path file = without_links(requested);
  std::error_code ignored;
  if (file.filename().empty() || fs::is_directory(file, ignored))
    return system_error(kWriting, requested, EISDIR);
  const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
  if (!fs::exists(folder, ignored) && !ignored)
    return Error{en::at(kWriting, en::say("its folder does not exist")), requested.string(),
                 en::say("create the folder first, or check the path for typing errors")};

  auto [number, path] = create_temporary(file);
  if (number < 0) return system_error(kWriting, requested, errno);
  Descriptor descriptor(number);
  Temporary temporary(path);
  copy_permissions(file, number);
  waiting.reset();  // the content may take minutes to compute
  if (Status status = fill(number, temporary.path()); !status) return status;
  waiting.emplace(requested);
  if ((waits_for_disk && ::fsync(number) != 0) || !descriptor.close() ||
      ::rename(temporary.path().c_str(), file.c_str()) != 0)
    return system_error(kWriting, requested, errno);
  temporary.retain();
  return waits_for_disk ? sync_folder(folder) : Status();
}

}  // namespace

Status write_file_atomically(const fs::path& file, std::string_view content) {
  return replace(file, [&](int number, const fs::path&) { return fill(number, file, content); });
}

Status write_file_unsynced(const fs::path& file, std::string_view content) {
  return replace(
      file, [&](int number, const fs::path&) { return fill(number, file, content); }, false);
}

Status sync_folder(const fs::path& folder) {
  const DiskWait waiting(folder);
  Descriptor descriptor(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  // Some file systems have no fsync of a folder (EINVAL).
  if (!descriptor.is_open() || (::fsync(descriptor.number()) != 0 && errno != EINVAL))
    return system_error(en::say("could not confirm that the folder is on the disk"), folder, errno);
  return {};
}

Status sync_disk_of(const fs::path& folder) {
  const DiskWait waiting(folder);
  Descriptor descriptor(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (!descriptor.is_open() || ::syncfs(descriptor.number()) != 0)
    return system_error(en::say("could not confirm that the files are on the disk"), folder, errno);
  return {};
}

Status write_file_atomically(const fs::path& file,
                             const std::function<Status(const fs::path& temporary)>& write) {
  return replace(file, [&](int, const fs::path& temporary) -> Status {
    if (Status status = write(temporary); !status) return status;
    const DiskWait waiting(file);
    // The other library may have replaced the temporary file.
    const Descriptor written(::open(temporary.c_str(), O_RDONLY | O_CLOEXEC));
    if (!written.is_open() || ::fsync(written.number()) != 0)
      return system_error(kWriting, file, errno);
    return {};
  });
}

Result<std::string> read_file(const fs::path& file, std::size_t limit_bytes) {
  const Message kReading = en::say("could not read the file");
  const DiskWait waiting(file);
  Descriptor descriptor(::open(file.c_str(), O_RDONLY | O_CLOEXEC));
  if (!descriptor.is_open()) return system_error(kReading, file, errno);
  struct stat status {};
  if (::fstat(descriptor.number(), &status) != 0) return system_error(kReading, file, errno);
  if (S_ISDIR(status.st_mode)) return system_error(kReading, file, EISDIR);
  const Error too_large{en::at(kReading, en::say("it is larger than {} bytes", limit_bytes)),
                        file.string(), en::say("check that it is the right file")};
  if (static_cast<std::size_t>(status.st_size) > limit_bytes) return too_large;

  // The size is a hint only: pipes have none, and a file may grow while it is read.
  std::string content;
  content.resize(static_cast<std::size_t>(status.st_size) + 1);
  std::size_t filled = 0;
  while (true) {
    if (filled == content.size()) content.resize(2 * content.size());
    const ssize_t got =
        ::read(descriptor.number(), content.data() + filled, content.size() - filled);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) return system_error(kReading, file, errno);
    if (got == 0) break;
    filled += static_cast<std::size_t>(got);
    if (filled > limit_bytes) return too_large;
  }
  content.resize(filled);
  return content;
}

fs::path target_of_temporary(const fs::path& path) {
  static const std::regex pattern(R"(\.(.+)\.[0-9]+-[0-9]+\.tmp(\.[^.]*)?)");
  std::smatch parts;
  const std::string name = path.filename().string();
  if (!std::regex_match(name, parts, pattern)) return path;
  return path.parent_path() / (parts[1].str() + parts[2].str());
}

Status make_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (!error && fs::is_directory(folder, error)) return {};
  const int number = error ? error.value() : ENOTDIR;
  // An existing file gives two different errors, depending on its position in the path.
  return system_error(en::say("could not create the folder"), folder,
                      number == EEXIST ? ENOTDIR : number);
}

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
  return {en::say("{} lies in a folder that is a link to elsewhere", name), folder,
          en::say("putting that folder itself there instead of the link")};
}

Result<ChangeList> list_in(const fs::path& folder) {
  const auto text = read_file(folder / kList);
  if (!text) return text.error();
  const Error broken{en::say("this is not a list of files to be changed"), folder / kList,
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

namespace {

constexpr auto kLockPoll = std::chrono::milliseconds(5);

/// True when the file's name still refers to the opened file: nobody removed it in between.
bool is_still_there(const std::filesystem::path& file, int descriptor) {
  struct stat opened {
  }, named{};
  return fstat(descriptor, &opened) == 0 && stat(file.c_str(), &named) == 0 &&
         opened.st_ino == named.st_ino && opened.st_dev == named.st_dev;
}

std::string owner_in(int descriptor) {
  std::array<char, 400> text{};
  const ssize_t read = pread(descriptor, text.data(), text.size(), 0);
  return read > 0 ? printable({text.data(), static_cast<std::size_t>(read)}) : std::string();
}

Error held_by(const std::string& who, const std::filesystem::path& file) {
  const Message other = who.empty() ? en::say("another program") : Message::typed(who);
  Message what = en::say("already in use by {0}", other);
  return {std::move(what), file.parent_path(), en::say("waiting until that is done")};
}

}  // namespace

Result<LockFile> LockFile::hold(const std::filesystem::path& file, const std::string& who,
                                std::chrono::milliseconds timeout) {
  const auto end = std::chrono::steady_clock::now() + timeout;
  while (true) {
    Descriptor opened(::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0666));
    if (!opened.is_open())
      return system_error(en::say("could not be written"), file.parent_path().string(), errno);
    const int descriptor = opened.number();
    LockFile held(file, std::move(opened));
    if (flock(descriptor, LOCK_EX | LOCK_NB) == 0) {
      if (!is_still_there(file, descriptor)) {
        held.file_.clear();  // now another owner's, who removes it
        continue;
      }
      // The text is for people only; the lock does not depend on it.
      if (ftruncate(descriptor, 0) == 0) (void)!pwrite(descriptor, who.data(), who.size(), 0);
      return held;
    }
    const int problem = errno;
    held.file_.clear();
    if (problem != EWOULDBLOCK && problem != EINTR)
      return system_error(en::say("could not be locked"), file.string(), problem);
    if (std::chrono::steady_clock::now() >= end) return held_by(owner_in(descriptor), file);
    std::this_thread::sleep_for(kLockPoll);
  }
}

LockFile& LockFile::operator=(LockFile&& other) noexcept {
  std::swap(file_, other.file_);
  std::swap(descriptor_, other.descriptor_);
  return *this;
}

LockFile::~LockFile() {
  // Removed under the lock: a program that opened it meanwhile detects that it is gone, and
  // retries.
  if (descriptor_.is_open() && !file_.empty()) unlink(file_.c_str());
}

std::string this_process(const std::string& doing) {
  std::array<char, 256> computer{};
  if (gethostname(computer.data(), computer.size() - 1) != 0) computer[0] = '?';
  return fmt::format("{}, process {} on {}, since {:%H:%M:%S} UTC", doing, getpid(),
                     computer.data(), fmt::gmtime(std::time(nullptr)));
}

}  // namespace alltact
