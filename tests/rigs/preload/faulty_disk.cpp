// A disk with faults, under a program that knows nothing of it (LD_PRELOAD). Of what the program
// does in the folder ALLTACT_DISK (an absolute path) everything that changes it is counted, and
//   ALLTACT_DISK_LOG=FILE        written down, in order, so that a power cut can be replayed
//   ALLTACT_DISK_FAIL=N:ERRNO    the N-th and all that follow fail (closing does not)
//   ALLTACT_DISK_STALL=MS        each opening takes so long, as in a network that stalls
// ALLTACT_CLOCK=SECONDS is added to the time of day.
// A line of the log is OPERATION SIZE PATH, tab between them, and behind it SIZE bytes:
//   make PATH (an empty file), write OFFSET.PATH (bytes: the data), cut LENGTH.PATH, sync PATH,
//   syncall, rename PATH (bytes: to where), unlink PATH, mkdir PATH, rmdir PATH
#include <atomic>
#include <cerrno>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <mutex>
#include <string>

#include <dlfcn.h>
#include <fcntl.h>
#include <limits.h>
#include <sys/stat.h>
#include <sys/uio.h>
#include <time.h>
#include <unistd.h>

namespace {

template <class F>
F* next(const char* name) {
  return reinterpret_cast<F*>(dlsym(RTLD_NEXT, name));
}

const char* setting(const char* name) {
  const char* text = std::getenv(name);
  return text == nullptr ? "" : text;
}

std::mutex& log_mutex() {
  static std::mutex mutex;
  return mutex;
}

/// What an open file is called; empty: not in the folder.
std::string path_of(int descriptor) {
  char link[64], path[PATH_MAX];
  std::snprintf(link, sizeof link, "/proc/self/fd/%d", descriptor);
  const ssize_t size = readlink(link, path, sizeof path);
  return size > 0 ? std::string(path, static_cast<std::size_t>(size)) : std::string();
}

std::string whole_path(int folder, const char* path) {
  if (path == nullptr) return {};
  if (path[0] == '/') return path;
  if (folder != AT_FDCWD) return path_of(folder) + "/" + path;
  char here[PATH_MAX];
  return getcwd(here, sizeof here) == nullptr ? std::string() : std::string(here) + "/" + path;
}

bool is_in_folder(const std::string& path) {
  const std::string folder = setting("ALLTACT_DISK");
  return !folder.empty() && path.compare(0, folder.size(), folder) == 0 &&
         (path.size() == folder.size() || path[folder.size()] == '/');
}

void note(const std::string& operation, const std::string& path, const void* bytes = nullptr,
          std::size_t size = 0) {
  static const int descriptor = [] {
    const char* file = setting("ALLTACT_DISK_LOG");
    return *file == '\0' ? -1
                         : next<int(const char*, int, ...)>("open")(
                               file, O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0600);
  }();
  if (descriptor < 0) return;
  std::string line = operation + "\t" + std::to_string(size) + "\t" + path + "\n";
  line.append(static_cast<const char*>(bytes), size);
  static auto* write_next = next<ssize_t(int, const void*, std::size_t)>("write");
  if (write_next(descriptor, line.data(), line.size()) != static_cast<ssize_t>(line.size()))
    abort();
}

/// True: this one fails, and errno says how.
bool fails() {
  static std::atomic<int> count{0};
  const char* text = setting("ALLTACT_DISK_FAIL");
  const char* colon = std::strchr(text, ':');
  if (colon == nullptr || ++count < std::atoi(text)) return false;
  errno = std::atoi(colon + 1);
  return true;
}

void stall(const std::string& path) {
  const int ms = std::atoi(setting("ALLTACT_DISK_STALL"));
  if (ms > 0 && is_in_folder(path)) {
    const timespec time{ms / 1000, (ms % 1000) * 1000000L};
    nanosleep(&time, nullptr);  // ends early where a signal comes, as many network disks allow
  }
}

template <class Open>
int opened(int folder, const char* path, int flags, const Open& open_it) {
  const std::string whole = whole_path(folder, path);
  stall(whole);
  const bool may_change = is_in_folder(whole) && (flags & (O_CREAT | O_TRUNC)) != 0;
  if (!may_change) return open_it();
  const std::lock_guard lock(log_mutex());
  struct stat before {};
  const bool is_there = ::stat(whole.c_str(), &before) == 0;
  const bool is_made = (flags & O_CREAT) != 0 && !is_there;
  const bool is_cut = (flags & O_TRUNC) != 0 && is_there && before.st_size > 0;
  if ((is_made || is_cut) && fails()) return -1;
  const int descriptor = open_it();
  if (descriptor >= 0 && is_made) note("make", whole);
  if (descriptor >= 0 && is_cut) note("cut", "0." + whole);
  return descriptor;
}

mode_t mode_of(int flags, va_list arguments) {
  return (flags & (O_CREAT | O_TMPFILE)) != 0 ? va_arg(arguments, mode_t) : 0;
}

/// `write_it` gives how many bytes it wrote; `bytes` are all that it was given.
template <class Write>
ssize_t written(int descriptor, off_t offset, const void* bytes, const Write& write_it) {
  const std::string path = path_of(descriptor);
  if (!is_in_folder(path)) return write_it();
  const std::lock_guard lock(log_mutex());
  if (fails()) return -1;
  struct stat now {};
  const bool appends = (::fcntl(descriptor, F_GETFL) & O_APPEND) != 0;
  if (offset < 0) offset = ::lseek(descriptor, 0, SEEK_CUR);
  if (appends && ::fstat(descriptor, &now) == 0) offset = now.st_size;
  const ssize_t size = write_it();
  if (size > 0)
    note("write", std::to_string(offset) + "." + path, bytes, static_cast<std::size_t>(size));
  return size;
}

template <class Change>
int changed(const std::string& operation, const std::string& path, const std::string& other,
            const Change& change) {
  if (!is_in_folder(path) && !is_in_folder(other)) return change();
  const std::lock_guard lock(log_mutex());
  if (fails()) return -1;
  const int result = change();
  const int problem = errno;
  if (result == 0) note(operation, path, other.data(), other.size());
  errno = problem;
  return result;
}

}  // namespace

extern "C" {

#define ALLTACT_OPEN(name)                                                                     \
  int name(const char* path, int flags, ...) {                                                 \
    va_list arguments;                                                                         \
    va_start(arguments, flags);                                                                \
    const mode_t mode = mode_of(flags, arguments);                                             \
    va_end(arguments);                                                                         \
    return opened(AT_FDCWD, path, flags,                                                       \
                  [&] { return next<int(const char*, int, ...)>(#name)(path, flags, mode); }); \
  }
ALLTACT_OPEN(open)
ALLTACT_OPEN(open64)

#define ALLTACT_OPENAT(name)                                                          \
  int name(int folder, const char* path, int flags, ...) {                            \
    va_list arguments;                                                                \
    va_start(arguments, flags);                                                       \
    const mode_t mode = mode_of(flags, arguments);                                    \
    va_end(arguments);                                                                \
    return opened(folder, path, flags, [&] {                                          \
      return next<int(int, const char*, int, ...)>(#name)(folder, path, flags, mode); \
    });                                                                               \
  }
ALLTACT_OPENAT(openat)
ALLTACT_OPENAT(openat64)

// Files that are opened for writing as streams write in ways that cannot be seen: none may.
#define ALLTACT_FOPEN(name)                                            \
  FILE* name(const char* path, const char* mode) {                     \
    const std::string whole = whole_path(AT_FDCWD, path);              \
    stall(whole);                                                      \
    if (is_in_folder(whole) && std::strpbrk(mode, "wa+") != nullptr && \
        std::strstr(mode, "cloexec") == nullptr)                       \
      note("stream", whole);                                           \
    return next<FILE*(const char*, const char*)>(#name)(path, mode);   \
  }
ALLTACT_FOPEN(fopen)
ALLTACT_FOPEN(fopen64)

ssize_t write(int descriptor, const void* bytes, std::size_t size) {
  return written(descriptor, -1, bytes, [&] {
    return next<ssize_t(int, const void*, std::size_t)>("write")(descriptor, bytes, size);
  });
}
ssize_t pwrite64(int descriptor, const void* bytes, std::size_t size, off64_t offset) {
  return written(descriptor, offset, bytes, [&] {
    return next<ssize_t(int, const void*, std::size_t, off64_t)>("pwrite64")(descriptor, bytes,
                                                                             size, offset);
  });
}
ssize_t pwrite(int descriptor, const void* bytes, std::size_t size, off_t offset) {
  return pwrite64(descriptor, bytes, size, offset);
}
ssize_t writev(int descriptor, const iovec* pieces, int count) {
  std::string bytes;
  for (int i = 0; i < count; ++i)
    bytes.append(static_cast<const char*>(pieces[i].iov_base), pieces[i].iov_len);
  return write(descriptor, bytes.data(), bytes.size());
}
int ftruncate64(int descriptor, off64_t length) {
  return changed("cut", std::to_string(length) + "." + path_of(descriptor), path_of(descriptor),
                 [&] { return next<int(int, off64_t)>("ftruncate64")(descriptor, length); });
}
int ftruncate(int descriptor, off_t length) { return ftruncate64(descriptor, length); }
int fsync(int descriptor) {
  return changed("sync", path_of(descriptor), "",
                 [&] { return next<int(int)>("fsync")(descriptor); });
}
int fdatasync(int descriptor) {
  return changed("sync", path_of(descriptor), "",
                 [&] { return next<int(int)>("fdatasync")(descriptor); });
}
int syncfs(int descriptor) {
  return changed("syncall", path_of(descriptor), "",
                 [&] { return next<int(int)>("syncfs")(descriptor); });
}
int rename(const char* from, const char* to) {
  return changed("rename", whole_path(AT_FDCWD, from), whole_path(AT_FDCWD, to),
                 [&] { return next<int(const char*, const char*)>("rename")(from, to); });
}
int unlink(const char* path) {
  return changed("unlink", whole_path(AT_FDCWD, path), "",
                 [&] { return next<int(const char*)>("unlink")(path); });
}
int remove(const char* path) {
  struct stat status {};
  const bool is_folder = ::lstat(path, &status) == 0 && S_ISDIR(status.st_mode);
  return is_folder ? rmdir(path) : unlink(path);
}
int unlinkat(int folder, const char* path, int flags) {
  return changed((flags & AT_REMOVEDIR) != 0 ? "rmdir" : "unlink", whole_path(folder, path), "",
                 [&] { return next<int(int, const char*, int)>("unlinkat")(folder, path, flags); });
}
int rmdir(const char* path) {
  return changed("rmdir", whole_path(AT_FDCWD, path), "",
                 [&] { return next<int(const char*)>("rmdir")(path); });
}
int mkdir(const char* path, mode_t mode) {
  return changed("mkdir", whole_path(AT_FDCWD, path), "",
                 [&] { return next<int(const char*, mode_t)>("mkdir")(path, mode); });
}

int clock_gettime(clockid_t clock, timespec* time) {
  const int result = next<int(clockid_t, timespec*)>("clock_gettime")(clock, time);
  if (clock == CLOCK_REALTIME) time->tv_sec += std::atol(setting("ALLTACT_CLOCK"));
  return result;
}
time_t time(time_t* told) {
  timespec now{};
  clock_gettime(CLOCK_REALTIME, &now);
  if (told != nullptr) *told = now.tv_sec;
  return now.tv_sec;
}

}  // extern "C"
