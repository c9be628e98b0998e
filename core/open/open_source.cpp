#include "core/open/open_source.h"

#include "core/base/letters.h"
#include "core/sources/file_source.h"

namespace alltact {
namespace {

namespace fs = std::filesystem;

bool is_scene(const fs::path& file) {
  static constexpr std::array kExtensions{".yaml", ".yml"};
  return is_one_of(lowered_extension(file), kExtensions);
}

Error not_an_input(const fs::path& path) {
  return {en::say("this is neither an image, nor a folder of images, nor a video, nor a scene"),
          path.string(),
          en::say("png, jpg, bmp, tif or pgm images, a video that players open, or a yaml scene")};
}

Result<std::unique_ptr<Source>> open_video(const fs::path& file, const SourceOptions& options) {
  auto video = options.job != nullptr ? VideoFile::open(file, *options.job) : VideoFile::open(file);
  if (!video) return video.error();
  return std::unique_ptr<Source>(std::make_unique<VideoSource>(std::move(*video), options));
}

/// Whether a missing file was meant to be a video.
bool has_video_name(const fs::path& file) {
  static constexpr std::array kExtensions{".mkv", ".webm", ".avi", ".mp4", ".mov",
                                          ".m4v", ".ts",   ".mpg", ".wmv", ".mjpeg"};
  return is_one_of(lowered_extension(file), kExtensions);
}

/// True for a node, or a possible camera name that is no file.
bool may_name_camera(const fs::path& input) {
  std::error_code ignored;
  if (input.string().starts_with("/dev/")) return !fs::is_directory(input, ignored);
  return !fs::exists(input, ignored) && !input.has_parent_path() && !is_image_file(input) &&
         !has_video_name(input) && !is_scene(input);
}

InputOpener& opener_of(InputKind kind) {
  static std::array<InputOpener, 2> openers{};
  return openers.at(static_cast<std::size_t>(kind));
}

/// Opens a video or a scene; empty for images and their folders.
std::optional<Result<std::unique_ptr<Source>>> open_single(const fs::path& input,
                                                           const SourceOptions& options) {
  if (is_video(input)) return open_video(input, options);
  if (const InputOpener opener = opener_of(InputKind::kScene); opener && is_scene(input))
    return opener(input, options);
  return std::nullopt;
}

Result<std::unique_ptr<Source>> open_images(const std::vector<fs::path>& inputs) {
  std::vector<fs::path> files;
  for (const fs::path& input : inputs) {
    std::error_code ignored;
    if (fs::is_directory(input, ignored)) {
      auto inside = images_in(input);
      if (!inside) return inside.error();
      files.insert(files.end(), inside->begin(), inside->end());
    } else if (is_image_file(input)) {
      files.push_back(input);
    } else if (is_video(input) || is_scene(input)) {
      const Message kind = is_video(input) ? en::say("video") : en::say("scene");
      return Error{en::say("a {} cannot be mixed with other inputs", kind), input.string(),
                   en::say("it alone, or images only")};
    } else {
      return not_an_input(input);
    }
  }
  // A shell sorts image_10 before image_9.
  const auto by_letters = [](const fs::path& a, const fs::path& b) {
    return a.string() < b.string();
  };
  const bool is_one_folder = std::all_of(files.begin(), files.end(), [&](const fs::path& file) {
    return file.parent_path() == files.front().parent_path();
  });
  if (is_one_folder && std::is_sorted(files.begin(), files.end(), by_letters))
    std::sort(files.begin(), files.end(), is_before);
  return std::unique_ptr<Source>(std::make_unique<ImageSource>(std::move(files)));
}

}  // namespace

bool add_input_kind(InputKind kind, InputOpener opener) {
  opener_of(kind) = opener;
  return true;
}

bool is_video(const fs::path& file) {
  std::error_code ignored;
  return !is_image_file(file) && !is_scene(file) && fs::is_regular_file(file, ignored) &&
         (has_video_name(file) || contains_video(file));
}

Result<std::unique_ptr<Source>> open_source(const std::vector<fs::path>& inputs,
                                            const SourceOptions& options) {
  if (const InputOpener opener = opener_of(InputKind::kCamera);
      opener && inputs.size() == 1 && may_name_camera(inputs.front()))
    return opener(inputs.front(), options);
  if (inputs.empty())
    return Error{en::say("no input was given"), "",
                 en::say("specify an image, a folder of images, a video, a scene or a camera")};
  for (const fs::path& input : inputs) {
    std::error_code ignored;
    if (!fs::exists(input, ignored))
      return Error{en::say("there is no such file or folder"), input.string(),
                   en::say("check the path for typing errors")};
  }
  std::error_code ignored;
  if (inputs.size() == 1 && !fs::is_directory(inputs.front(), ignored))
    if (auto single = open_single(inputs.front(), options)) return std::move(*single);
  return open_images(inputs);
}

}  // namespace alltact
