#include "core/sources/file_source.h"

#include "core/image/image_file.h"

#include <algorithm>

namespace alltact {
namespace {

namespace fs = std::filesystem;

/// Results that lie next to images: NAME.depth.tiff, NAME.3d.png and the like.
bool is_measurement(const fs::path& file) {
  static constexpr std::array kExtensions{
      ".depth", ".depth16",  ".depth_sd",   ".flags",        ".points",   ".z",
      ".3d",    ".sd_noise", ".sd_mapping", ".sd_reference", ".sd_light", ".sd_lateral"};
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
    return Error{en::say("the folder cannot be read: {}", error.message()), folder.string(),
                 en::say("ask its owner for access")};
  if (files.empty())
    return Error{en::say("the folder contains no images"), folder.string(),
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

Result<FramePtr> VideoSource::next() {
  if (position_ == video_.frame_count()) return FramePtr();
  auto frame = video_.frame(position_++);
  if (!frame) return frame;
  if (!pacer_.wait_for((*frame)->time_ns)) return FramePtr();
  return frame;
}

Result<RecordedFrames> RecordedFrames::open(const std::filesystem::path& input, const Job& job) {
  RecordedFrames frames;
  std::error_code ignored;
  if (std::filesystem::is_directory(input, ignored)) {
    auto images = images_in(input);
    if (!images) return images.error();
    frames.images_ = std::move(*images);
    frames.is_continuous_ = ImageSource(frames.images_).is_continuous();
    return frames;
  }
  auto video = VideoFile::open(input, job);
  if (!video) return video.error();
  frames.video_ = std::move(*video);
  return frames;
}

std::size_t RecordedFrames::count() const {
  return video_ ? video_->frame_count() : images_.size();
}

Result<FramePtr> RecordedFrames::frame(std::size_t number) {
  if (video_) return video_->frame(number);
  return ImageSource({images_.at(number)}).next();
}

std::shared_ptr<const FrameTimes> RecordedFrames::times_ns() const {
  if (!video_) return nullptr;
  auto times = std::make_shared<FrameTimes>();
  for (std::size_t i = 0; i < count(); ++i) times->push_back(video_->time_ns(i));
  return times;
}

double RecordedFrames::frames_per_s() const {
  constexpr double kImagesPerS = 10;
  return video_ ? video_->frames_per_s() : kImagesPerS;
}

MatchedFrame match_frame(std::size_t number, const FrameTimes& times_ns,
                         const FrameTimes& other_times_ns, std::size_t other_count) {
  if (number >= times_ns.size() || other_times_ns.empty())
    return {std::min(number, other_count - 1), MatchedBy::kNumber, 0};
  const auto [first, last] = std::minmax_element(times_ns.begin(), times_ns.end());
  const auto [other_first, other_last] =
      std::minmax_element(other_times_ns.begin(), other_times_ns.end());
  const bool is_one_time = *first <= *other_last && *other_first <= *last;
  const std::int64_t shift_ns = is_one_time ? 0 : *other_first - *first;
  const std::int64_t target_ns = times_ns[number] + shift_ns;
  const auto nearest = std::min_element(other_times_ns.begin(), other_times_ns.end(),
                                        [&](std::int64_t a, std::int64_t b) {
                                          return std::abs(a - target_ns) < std::abs(b - target_ns);
                                        });
  return {static_cast<std::size_t>(nearest - other_times_ns.begin()),
          is_one_time ? MatchedBy::kTime : MatchedBy::kBeginning,
          1e-6 * static_cast<double>(*nearest - target_ns)};
}

}  // namespace alltact
