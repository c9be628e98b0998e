// Atomic replacement of files.
#pragma once

#include "core/base/descriptor.h"
#include "core/base/result.h"

#include <chrono>
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace alltact {

/// Writes `content` to a temporary next to `file`, fsyncs it, renames it over `file` and fsyncs the
/// folder. On any error (disk full, folder not writable, ...) `file` is unchanged and the temporary
/// is removed. The error names the reason.
[[nodiscard]] Status write_file_atomically(const std::filesystem::path& file,
                                           std::string_view content);

/// Writes one of many files, atomically for other programs, but without waiting for the disk,
/// because two waits per file would dominate. Call sync_disk_of() once after the last file, before
/// anything is written that refers to them.
[[nodiscard]] Status write_file_unsynced(const std::filesystem::path& file,
                                         std::string_view content);

/// Waits until the names in `folder` are on the disk: new, renamed and removed ones. No error where
/// its file system has no such operation. Error: not a folder, or the disk refuses.
[[nodiscard]] Status sync_folder(const std::filesystem::path& folder);

/// Waits until everything written to the disk of `folder` is there. Error: some of it could not be
/// written.
[[nodiscard]] Status sync_disk_of(const std::filesystem::path& folder);

/// As write_file_atomically() for content that another library writes: `write` gets the path of the
/// temporary (same folder, same extension) and fills it.
[[nodiscard]] Status write_file_atomically(
    const std::filesystem::path& file,
    const std::function<Status(const std::filesystem::path& temporary)>& write);

/// The full content. Errors: missing, a folder, not readable, larger than `limit_bytes`.
[[nodiscard]] Result<std::string> read_file(const std::filesystem::path& file,
                                            std::size_t limit_bytes = std::size_t{1} << 30);

/// The final path of a temporary of write_file_atomically(); any other path unchanged. Only the
/// name counts, without access to the disk. Names of over 100 characters are cut.
[[nodiscard]] std::filesystem::path target_of_temporary(const std::filesystem::path& path);

/// Makes the folder (and its parents) if it is missing. The error names the reason.
[[nodiscard]] Status make_folder(const std::filesystem::path& folder);

// Several files of a folder that change together: all of them or none.
//
// New files are written to a separate folder within the folder. Then a list of replacements is put
// into the folder atomically: this is the moment of decision. A crash before it leaves the folder
// unchanged; after it, the list allows completing the change, repeatedly if necessary.

/// One thread. The folder's own lock must exclude two changes at the same time.
class FolderChange {
 public:
  /// Makes a folder for the new files, and removes the rests of undecided changes. Error: it cannot
  /// be written.
  [[nodiscard]] static Result<FolderChange> begin(const std::filesystem::path& folder);
  FolderChange(FolderChange&& other) noexcept;
  FolderChange& operator=(FolderChange&&) = delete;
  /// Nothing has changed where commit() was not reached.
  ~FolderChange();

  /// Folder for the new files, each complete and on the disk (write_file_atomically), under its
  /// final name.
  [[nodiscard]] const std::filesystem::path& staged() const { return staged_; }
  /// Marks this file for removal, if it exists.
  void remove(std::string name) { removed_.push_back(std::move(name)); }

  /// Moves the staged files to their final paths. Error: nothing has changed; or the change was
  /// decided and is incomplete, and complete_change() will complete it.
  [[nodiscard]] Status commit();

 private:
  explicit FolderChange(std::filesystem::path folder) : folder_(std::move(folder)) {}

  std::filesystem::path folder_, staged_;
  std::vector<std::string> removed_;
};

/// The path that a person knows: the final file for a temporary or staged one, the folder for the
/// list of a change. Without access to the disk.
[[nodiscard]] std::filesystem::path final_path(const std::filesystem::path& path);

/// True when a change of this folder was decided and is incomplete.
[[nodiscard]] bool has_open_change(const std::filesystem::path& folder);

/// Completes the change; does nothing where there is none. Error: the folder cannot be written, or
/// the list is invalid.
[[nodiscard]] Status complete_change(const std::filesystem::path& folder);

// A lock file with the name of its owner.

/// The lock is held from hold() until destruction or the end of the program, even by a crash; the
/// file exists meanwhile. Threads of one program exclude each other like programs. It works between
/// computers where the folder's server supports flock() (NFS does).
class LockFile {
 public:
  /// Makes the file, locks it and writes the owner into it. Waits up to `timeout` for another
  /// owner. Errors: another owner, with the line it wrote; the folder cannot be written.
  ///   who: one line ("calibrating, alltact on ada, since 12:00:05")
  [[nodiscard]] static Result<LockFile> hold(const std::filesystem::path& file,
                                             const std::string& who,
                                             std::chrono::milliseconds timeout);
  LockFile(LockFile&& other) noexcept = default;
  LockFile& operator=(LockFile&& other) noexcept;
  ~LockFile();

 private:
  LockFile(std::filesystem::path file, Descriptor descriptor)
      : file_(std::move(file)), descriptor_(std::move(descriptor)) {}

  std::filesystem::path file_;
  Descriptor descriptor_;
};

/// Returns "DOING, process 4711 on ada, since 12:00:05 UTC", for `who`.
[[nodiscard]] std::string this_process(const std::string& doing);

}  // namespace alltact
