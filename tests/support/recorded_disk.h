// What a program did to a disk, played again up to any moment, and what a power cut then leaves.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

namespace alltact::test {

/// As rigs/preload/faulty_disk.cpp writes it down.
struct DiskOperation {
  std::string what, path, other;
  std::size_t at = 0;  ///< offset of what is written, length that is left
  std::string bytes;
};
[[nodiscard]] std::vector<DiskOperation> disk_log(const std::filesystem::path& file);

/// The files below a folder, twice: as programs see them, and as they are sure to be on the disk.
/// Bytes are on the disk once their file was synced, names once their folder was; a disk may have
/// more of both than it must (Pillai et al., "All file systems are not created equal", OSDI 2014).
class DiskModel {
 public:
  /// As it is now, all on the disk.
  explicit DiskModel(const std::filesystem::path& folder);
  void apply(const DiskOperation& operation);

  enum class Lost { kNothing, kBytes, kNames, kBoth };
  using Files = std::map<std::string, std::string>;  ///< bytes by the path below the folder
  /// What is there after a power cut that takes all that was not synced of what `lost` says.
  [[nodiscard]] Files files(Lost lost) const;

 private:
  struct File {
    std::string now, synced;
  };
  struct Names {
    std::map<std::string, std::shared_ptr<File>> files;
    std::set<std::string> folders;
  };
  [[nodiscard]] std::string inside(const std::string& path) const;
  void sync(const std::string& name);

  std::string folder_;
  Names now_, synced_;
};

/// But for those that are hidden, which nobody misses.
[[nodiscard]] DiskModel::Files shown(const DiskModel::Files& files);
/// Of a folder as it is now, by the same measure.
[[nodiscard]] DiskModel::Files files_in(const std::filesystem::path& folder);

/// Makes a folder that holds these files and nothing else.
void lay_out(const DiskModel::Files& files, const std::filesystem::path& folder);

inline constexpr std::array kEveryLoss{DiskModel::Lost::kNothing, DiskModel::Lost::kBytes,
                                       DiskModel::Lost::kNames, DiskModel::Lost::kBoth};

/// Cuts the power after each operation, with each loss. What a program finds then, once it has
/// opened the finger, is all old or all new; both occur.
///   before: the finger's folder before the operations
///   finger: the folder after them
void expect_old_or_new_after_cuts(DiskModel before, const std::vector<DiskOperation>& operations,
                                  const std::filesystem::path& finger);

}  // namespace alltact::test
