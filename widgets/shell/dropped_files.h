// Files and folders that were dropped on the window, and what they are.
#pragma once

#include <filesystem>
#include <vector>

namespace alltact {

enum class FileKind {
  kFinger = 1,  ///< one folder of a finger, or its finger.yaml
  kFolder,      ///< one other folder
  kVideo,       ///< one video
  kImages,      ///< one image or more
  kRecipe,      ///< an inspection recipe
  kMesh,        ///< a body
  kOther,       ///< a scene, a camera file, several kinds
};

struct DroppedFiles {
  FileKind kind = FileKind::kOther;
  std::vector<std::filesystem::path> files;  ///< not empty; of a finger its folder
};

/// Reads the beginning of the files: not for the window's thread.
[[nodiscard]] DroppedFiles dropped_files(std::vector<std::filesystem::path> files);

}  // namespace alltact
