#include "core/sources/files/image_source.h"

#include "core/io/image_file.h"
#include "core/sources/files/file_extension.h"

namespace alltact {
namespace {

namespace fs = std::filesystem;

/// Results that lie next to images: NAME.depth.tiff, NAME.3d.png and the like.
bool is_measurement(const fs::path& file) {
  static constexpr std::array kExtensions{".depth",
                                          ".depth16",
                                          ".depth_sd",
                                          ".flags",
                                          ".points",
                                          ".z",
                                          ".3d",
                                          ".sd_noise",
                                          ".sd_mapping",
                                          ".sd_reference",
                                          ".sd_light",
                                          ".sd_lateral"};
  return is_one_of(extension_of(file.stem()), kExtensions);
}

/// A name that ends in a number: prefix, number, and number of digits.
struct NumberedName {
  std::string before;
  std::uint64_t number;
  std::size_t digits;
};

std::optional<NumberedName> numbered(const fs::path& file) {
  const std::string stem = file.stem().string();
  const std::size_t last = stem.find_last_not_of("0123456789");
  const std::size_t begin = last == std::string::npos ? 0 : last + 1;
  const std::size_t digits = stem.size() - begin;
  if (digits == 0 || digits > 18) return std::nullopt;
  return NumberedName{stem.substr(0, begin), std::stoull(stem.substr(begin)), digits};
}

/// Two or more images of one folder, with one name and numbers without a gap.
bool is_sequence(const std::vector<fs::path>& files) {
  for (std::size_t i = 1; i < files.size(); ++i) {
    const auto before = numbered(files[i - 1]), now = numbered(files[i]);
    if (!before || !now || before->before != now->before || now->number != before->number + 1)
      return false;
    if (before->digits != now->digits || files[i - 1].parent_path() != files[i].parent_path() ||
        files[i - 1].extension() != files[i].extension())
      return false;
  }
  return files.size() > 1;
}

}  // namespace

bool is_image_file(const fs::path& file) {
  static constexpr std::array kExtensions{".png", ".jpg", ".jpeg", ".bmp", ".tif", ".tiff", ".pgm"};
  return is_one_of(extension_of(file), kExtensions);
}

Result<std::vector<fs::path>> images_in(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error)) {
    std::error_code ignored;
    const bool is_hidden = entry->path().filename().string().starts_with('.');
    if (!is_hidden && entry->is_regular_file(ignored) && is_image_file(entry->path()) &&
        !is_measurement(entry->path()))
      files.push_back(entry->path());
  }
  if (error)
    return Error{en::say("the folder cannot be read: {}", error.message()),
                 folder.string(),
                 en::say("ask its owner for access")};
  if (files.empty())
    return Error{en::say("the folder holds no pictures"),
                 folder.string(),
                 en::say("a folder with png, jpg, bmp, tif or pgm files")};
  std::sort(files.begin(), files.end(), [](const fs::path& a, const fs::path& b) {
    return a.filename().string() < b.filename().string();
  });
  return files;
}

ImageSource::ImageSource(std::vector<fs::path> files)
    : files_(std::move(files)), is_continuous_(is_sequence(files_)) {}

Result<FramePtr> ImageSource::next() {
  if (position_ == files_.size()) return FramePtr();
  const fs::path& file = files_[position_++];
  std::string settings;
  auto grey = read_grey_image(file, &settings);
  if (!grey) return grey.error();
  auto frame = std::make_shared<Frame>();
  if (!settings.empty()) frame->controls = std::make_shared<const std::string>(std::move(settings));
  frame->grey = std::move(*grey);
  frame->name = file.stem().string();
  frame->origin = file.string();
  frame->sequence = position_ - 1;
  return FramePtr(std::move(frame));
}

FrameSource::FrameSource(std::vector<FramePtr> frames) : frames_(std::move(frames)) {
  std::vector<fs::path> names;
  for (const FramePtr& frame : frames_) names.emplace_back(frame->name + ".png");
  is_continuous_ = is_sequence(names);
}

Result<FramePtr> FrameSource::next() {
  return position_ == frames_.size() ? FramePtr() : frames_[position_++];
}

}  // namespace alltact
