#include "widgets/shell/dropped_files.h"

#include "core/finger/finger.h"
#include "core/open/open_source.h"
#include "core/sources/file_source.h"

#include <algorithm>

namespace alltact {

DroppedFiles dropped_files(std::vector<std::filesystem::path> files) {
  namespace fs = std::filesystem;
  std::error_code failed;
  const fs::path first = files.front();
  if (std::all_of(files.begin(), files.end(), is_image_file))
    return {FileKind::kImages, std::move(files)};
  if (files.size() > 1) return {FileKind::kOther, std::move(files)};
  if (first.filename() == Finger::kFileName) return {FileKind::kFinger, {first.parent_path()}};
  if (fs::exists(first / Finger::kFileName, failed)) return {FileKind::kFinger, {first}};
  if (fs::is_directory(first, failed)) return {FileKind::kFolder, {first}};
  return {is_video(first) ? FileKind::kVideo : FileKind::kOther, {first}};
}

}  // namespace alltact
