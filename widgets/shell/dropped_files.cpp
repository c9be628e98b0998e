#include "widgets/shell/dropped_files.h"

#include "core/finger/finger.h"
#include "core/open/open_source.h"
#include "core/sources/file_source.h"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <string>

namespace alltact {
namespace {

constexpr std::size_t kBeginning = 4096;

bool is_mesh(const std::filesystem::path& file) {
  std::string ending = file.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  return ending == ".stl" || ending == ".obj";
}

/// By the name of its format; the rest may hold errors, which are reported when it is opened.
bool is_recipe(const std::filesystem::path& file) {
  const std::string ending = file.extension().string();
  if (ending != ".yaml" && ending != ".yml") return false;
  std::string beginning(kBeginning, '\0');
  std::ifstream stream(file, std::ios::binary);
  stream.read(beginning.data(), static_cast<std::streamsize>(beginning.size()));
  return beginning.find("alltact-inspection-recipe/") != std::string::npos;
}

}  // namespace

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
  if (is_mesh(first)) return {FileKind::kMesh, {first}};
  if (is_recipe(first)) return {FileKind::kRecipe, {first}};
  return {is_video(first) ? FileKind::kVideo : FileKind::kOther, {first}};
}

}  // namespace alltact
