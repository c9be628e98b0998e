// Files that are old or new, never half.
#pragma once

#include "core/result.h"

#include <filesystem>
#include <functional>
#include <span>
#include <string_view>

namespace alltact {

/// Writes `content` to a temporary beside `file`, fsyncs it, renames it over `file` and fsyncs the
/// folder. On any error (disk full, folder not writable, ...) `file` is as it was before and the
/// temporary is gone. The error says which of these it was.
[[nodiscard]] Status write_file_atomically(const std::filesystem::path& file,
                                           std::string_view content);

/// One of many: whole or not at all for every program that looks, but not waited for until it is on
/// the disk (two waits a file would take longer than all the rest). sync_disk_of() is called once
/// behind the last one, before anything is written that says that they are there.
[[nodiscard]] Status write_file_of_many(const std::filesystem::path& file,
                                        std::string_view content);

/// Waits until the names in `folder` are on the disk: what was made, renamed or removed there. No
/// error where its file system knows no such thing. Error: not a folder, or the disk refuses.
[[nodiscard]] Status sync_folder(const std::filesystem::path& folder);

/// Waits until everything written to the disk that holds `folder` is there. Error: some of it could
/// not be written.
[[nodiscard]] Status sync_disk_of(const std::filesystem::path& folder);

/// As write_file_atomically() for content that another library must write itself: `write` gets the
/// path of the temporary (same folder, same ending) and fills it.
[[nodiscard]] Status write_file_atomically(
    const std::filesystem::path& file,
    const std::function<Status(const std::filesystem::path& temporary)>& write);

/// The whole file. Errors: missing, a folder, not readable, larger than `limit_bytes`.
[[nodiscard]] Result<std::string> read_file(const std::filesystem::path& file,
                                            std::size_t limit_bytes = std::size_t{1} << 30);

/// The file that a temporary of write_file_atomically() becomes; any other path as it is. The name
/// alone decides, no disk is asked. Names of over 100 characters come back cut.
[[nodiscard]] std::filesystem::path target_of_temporary(const std::filesystem::path& path);

/// Makes the folder (and its parents) if it is not there. The error says why it could not.
[[nodiscard]] Status make_folder(const std::filesystem::path& folder);

}  // namespace alltact
