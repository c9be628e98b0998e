#include "core/io/atomic_file.h"

#include "core/io/disk_wait.h"
#include "core/io/system_error.h"

#include <cerrno>
#include <optional>
#include <regex>
#include <system_error>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace alltact {
namespace {

namespace fs = std::filesystem;

class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() {
    if (number_ >= 0) ::close(number_);
  }
  [[nodiscard]] int number() const { return number_; }
  /// Some disks report a failed write only at the close.
  [[nodiscard]] bool close() { return ::close(std::exchange(number_, -1)) == 0; }

 private:
  int number_;
};

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
    return Error{en::at(kWriting, en::say("its folder does not exist")),
                 requested.string(),
                 en::say("make the folder first, or check the path for typing errors")};

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
  if (descriptor.number() < 0 || (::fsync(descriptor.number()) != 0 && errno != EINVAL))
    return system_error(
        en::say("could not make sure that the folder is on the disk"), folder, errno);
  return {};
}

Status sync_disk_of(const fs::path& folder) {
  const DiskWait waiting(folder);
  Descriptor descriptor(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (descriptor.number() < 0 || ::syncfs(descriptor.number()) != 0)
    return system_error(
        en::say("could not make sure that the files are on the disk"), folder, errno);
  return {};
}

Status write_file_atomically(const fs::path& file,
                             const std::function<Status(const fs::path& temporary)>& write) {
  return replace(file, [&](int, const fs::path& temporary) -> Status {
    if (Status status = write(temporary); !status) return status;
    const DiskWait waiting(file);
    // The other library may have replaced the temporary file.
    const Descriptor written(::open(temporary.c_str(), O_RDONLY | O_CLOEXEC));
    if (written.number() < 0 || ::fsync(written.number()) != 0)
      return system_error(kWriting, file, errno);
    return {};
  });
}

Result<std::string> read_file(const fs::path& file, std::size_t limit_bytes) {
  const Message kReading = en::say("could not read the file");
  const DiskWait waiting(file);
  Descriptor descriptor(::open(file.c_str(), O_RDONLY | O_CLOEXEC));
  if (descriptor.number() < 0) return system_error(kReading, file, errno);
  struct stat status {};
  if (::fstat(descriptor.number(), &status) != 0) return system_error(kReading, file, errno);
  if (S_ISDIR(status.st_mode)) return system_error(kReading, file, EISDIR);
  const Error too_large{en::at(kReading, en::say("it is larger than {} bytes", limit_bytes)),
                        file.string(),
                        en::say("check that it is the right file")};
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
  return system_error(
      en::say("could not make the folder"), folder, number == EEXIST ? ENOTDIR : number);
}

}  // namespace alltact
