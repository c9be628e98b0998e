// Atomic replacement of files.
#pragma once

#include "core/result.h"

#include <filesystem>
#include <functional>
#include <span>
#include <string_view>

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

}  // namespace alltact
