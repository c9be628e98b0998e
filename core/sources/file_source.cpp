#include "core/sources/file_source.h"

#include "core/base/letters.h"
#include "core/image/image_file.h"

#include <algorithm>
#include <utility>

namespace alltact {
namespace {

namespace fs = std::filesystem;

/// Results that lie next to images: NAME.depth.tiff, NAME.3d.png and the like.
bool is_measurement(const fs::path& file) {
  static constexpr std::array kExtensions{
      ".depth",    ".depth16",    ".depth_sd",     ".flags",    ".points",     ".z",        ".3d",
      ".sd_noise", ".sd_mapping", ".sd_reference", ".sd_light", ".sd_lateral", ".rectified"};
  return is_one_of(lowered_extension(file.stem()), kExtensions);
}

/// A name that ends in a number.
struct NumberedName {
  std::string before;
  std::uint64_t number;
  std::string digits;
};

std::optional<NumberedName> numbered(const fs::path& file) {
  const std::string stem = file.stem().string();
  const std::size_t last = stem.find_last_not_of("0123456789");
  const std::size_t begin = last == std::string::npos ? 0 : last + 1;
  const std::size_t digits = stem.size() - begin;
  if (digits == 0 || digits > 18) return std::nullopt;
  return NumberedName{stem.substr(0, begin), std::stoull(stem.substr(begin)), stem.substr(begin)};
}

/// Two or more images of one folder, with one name and numbers without a gap.
bool is_sequence(const std::vector<fs::path>& files) {
  for (std::size_t i = 1; i < files.size(); ++i) {
    const auto before = numbered(files[i - 1]), now = numbered(files[i]);
    if (!before || !now || before->before != now->before || now->number != before->number + 1)
      return false;
    // 9 is followed by 10, and 09 is, but 9 is not followed by 010.
    const bool is_same_style =
        before->digits.size() == now->digits.size() || !now->digits.starts_with('0');
    if (!is_same_style || files[i - 1].parent_path() != files[i].parent_path() ||
        files[i - 1].extension() != files[i].extension())
      return false;
  }
  return files.size() > 1;
}

}  // namespace

bool is_image_file(const fs::path& file) {
  static constexpr std::array kExtensions{".png", ".jpg", ".jpeg", ".bmp", ".tif", ".tiff", ".pgm"};
  return is_one_of(lowered_extension(file), kExtensions);
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
  std::sort(files.begin(), files.end(), is_before);
  return files;
}

bool is_before(const fs::path& a, const fs::path& b) {
  const std::string first = a.filename().string(), second = b.filename().string();
  std::size_t i = 0, k = 0;
  while (i < first.size() && k < second.size()) {
    if (!is_digit(first[i]) || !is_digit(second[k])) {
      if (first[i] != second[k])
        return static_cast<unsigned char>(first[i]) < static_cast<unsigned char>(second[k]);
      ++i, ++k;
      continue;
    }
    const auto number_at = [&](const std::string& name, std::size_t* at) {
      std::size_t end = *at;
      while (end < name.size() && is_digit(name[end])) ++end;
      while (*at + 1 < end && name[*at] == '0') ++*at;  // leading zeros
      std::string number = name.substr(*at, end - *at);
      *at = end;
      return number;
    };
    const std::string one = number_at(first, &i), other = number_at(second, &k);
    if (one != other) return one.size() != other.size() ? one.size() < other.size() : one < other;
  }
  // The same but for leading zeros, or one begins with the other.
  return first.size() - i != second.size() - k ? i == first.size() : first < second;
}

ImageSource::ImageSource(std::vector<fs::path> files)
    : files_(std::move(files)), is_continuous_(is_sequence(files_)) {}

Result<FramePtr> ImageSource::next() {
  if (position_ == files_.size()) return FramePtr();
  const fs::path& file = files_[position_++];
  std::string settings;
  auto grey = read_grey_image(file, &settings, &look_);
  if (look_.bits > 0 && !std::exchange(are_bits_known_, true)) {
    // All images need the same levels, which the brightest of them shows.
    for (const fs::path& each : files_) (void)read_grey_image(each, nullptr, &look_);
    grey = read_grey_image(file, &settings, &look_);
  }
  if (!grey) return grey.error();
  auto frame = std::make_shared<Frame>();
  if (!settings.empty()) frame->controls = std::make_shared<const std::string>(std::move(settings));
  frame->grey = std::move(*grey);
  frame->name = file.stem().string();
  frame->origin = file.string();
  frame->sequence = position_ - 1;
  return FramePtr(std::move(frame));
}

std::vector<Message> ImageSource::remarks() const {
  std::vector<Message> remarks;
  for (const Message& remark : look_.remarks())
    remarks.push_back(en::say("{}.", en::at(en::say("The images"), remark)));
  return remarks;
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
  if ((*frame)->time_ns && !pacer_.wait_for(*(*frame)->time_ns)) return FramePtr();
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
