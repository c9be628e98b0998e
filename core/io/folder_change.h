// Several files of a folder that change together: all of them or none.
//
// New files are written to a separate folder within the folder. Then a list of replacements is put
// into the folder atomically: this is the moment of decision. A crash before it leaves the folder
// unchanged; after it, the list allows completing the change, repeatedly if necessary.
#pragma once

#include "core/result.h"

#include <filesystem>
#include <string>
#include <vector>

namespace alltact {

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

}  // namespace alltact
