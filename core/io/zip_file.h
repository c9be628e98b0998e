// Zip archives that are old or new, never half, and the same bytes from the same files.
#pragma once

#include "core/job.h"
#include "core/result.h"

#include <filesystem>
#include <string>
#include <vector>

namespace alltact {

/// One file inside an archive.
struct ZipEntry {
  std::string name;            ///< inside the archive: relative, parts divided by '/', UTF-8
  std::filesystem::path file;  ///< where its bytes are; empty: `content` holds them
  std::string content;
};

/// Writes the archive at `file` whole or not at all. Entries keep their order. Every entry is dated
/// 1980-01-01 and may be read by everyone, whatever its file says, so that the bytes depend on
/// names and contents alone; pictures and videos, which are packed already, are stored as they are.
/// Beyond 4 GB it is a Zip64. Reports to `job` and ends when it asks to stop. Errors: stopped; a
/// file that cannot be read; a name that is not UTF-8 or there twice; those of
/// write_file_atomically.
[[nodiscard]] Status write_zip(const std::filesystem::path& file,
                               const std::vector<ZipEntry>& entries,
                               const Job& job);

}  // namespace alltact
