// Several files of a folder that change together: all of them or none.
//
// New files are written beside the old ones, in a folder of their own. Then a list of what takes
// whose place is put into the folder, whole or not at all: that is the one moment at which
// everything is decided. Whatever ends the program before it, the folder is as it was; whatever
// ends it afterwards, the list says how to complete the change, as often as it takes.
#pragma once

#include "core/result.h"

#include <filesystem>
#include <string>
#include <vector>

namespace alltact {

/// Of one thread. Two changes of one folder exclude each other by whatever lock the folder has.
class FolderChange {
 public:
  /// Makes a folder for the new files, and removes what changes that were never decided left
  /// behind. Error: it cannot be written.
  [[nodiscard]] static Result<FolderChange> begin(const std::filesystem::path& folder);
  FolderChange(FolderChange&& other) noexcept;
  FolderChange& operator=(FolderChange&&) = delete;
  /// Nothing has changed where commit() was not reached.
  ~FolderChange();

  /// Where new files are written, each whole and on the disk (write_file_atomically), under the
  /// names that they will have in the folder.
  [[nodiscard]] const std::filesystem::path& staged() const { return staged_; }
  /// This file will be gone, if it is there.
  void remove(std::string name) { removed_.push_back(std::move(name)); }

  /// What was staged takes its place. Error: nothing has changed; or it was decided and could not
  /// be completed yet, which complete_change() does.
  [[nodiscard]] Status commit();

 private:
  explicit FolderChange(std::filesystem::path folder) : folder_(std::move(folder)) {}

  std::filesystem::path folder_, staged_;
  std::vector<std::string> removed_;
};

/// The path under which a person knows what is written here: that of the final file in place of a
/// temporary or a staged one, the folder in place of the list of a change. No disk is asked.
[[nodiscard]] std::filesystem::path final_path(const std::filesystem::path& path);

/// A change of this folder was decided and is not complete.
[[nodiscard]] bool has_open_change(const std::filesystem::path& folder);

/// Completes it; nothing where there is none. Error: the folder cannot be written, or the list is
/// not one.
[[nodiscard]] Status complete_change(const std::filesystem::path& folder);

}  // namespace alltact
