// Zip archives, written atomically and reproducibly.
#pragma once

#include "core/base/job.h"
#include "core/base/result.h"

#include <filesystem>
#include <string>
#include <vector>

namespace alltact {

/// One file inside an archive.
struct ZipEntry {
  std::string name;            ///< inside the archive: relative, parts divided by '/', UTF-8
  std::filesystem::path file;  ///< source of its bytes; empty: `content` holds them
  std::string content;
};

/// Writes the archive at `file` atomically. Entries retain their order. Every entry is dated
/// 1980-01-01 and readable by everyone, so that the bytes depend only on names and contents. Images
/// and videos, which are compressed already, are stored uncompressed. Beyond 4 GB it is a Zip64.
/// Reports to `job` and ends when it asks to stop. Errors: stopped; a file that cannot be read; a
/// name that is not UTF-8 or a duplicate; those of write_file_atomically.
[[nodiscard]] Status write_zip(const std::filesystem::path& file,
                               const std::vector<ZipEntry>& entries, const Job& job);

}  // namespace alltact
