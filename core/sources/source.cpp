#include "core/sources/source.h"

#include "core/io/picture.h"

#include <opencv2/videoio.hpp>

namespace alltact {
namespace {

namespace fs = std::filesystem;

std::string ending_of(const fs::path& file) {
  std::string ending = file.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(), [](unsigned char c) {
    return static_cast<char>(std::tolower(c));
  });
  return ending;
}

template <std::size_t N>
bool is_one_of(const std::string& ending, const std::array<const char*, N>& endings) {
  return std::find(endings.begin(), endings.end(), ending) != endings.end();
}

bool is_picture(const fs::path& file) {
  static constexpr std::array kEndings{".png", ".jpg", ".jpeg", ".bmp", ".tif", ".tiff", ".pgm"};
  return is_one_of(ending_of(file), kEndings);
}

/// Depth maps and the like, which lie beside pictures and are none: NAME.depth.tiff.
bool is_measurement(const fs::path& file) {
  static constexpr std::array kEndings{".depth", ".points", ".z"};
  return is_one_of(ending_of(file.stem()), kEndings);
}

bool is_video(const fs::path& file) {
  static constexpr std::array kEndings{".mkv", ".avi", ".mp4"};
  return is_one_of(ending_of(file), kEndings);
}

/// A name that ends in a number: what stands before it, the number, and how it is written.
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

/// Two or more pictures of one folder, all named alike and numbered without a gap.
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

class PictureSource : public Source {
 public:
  explicit PictureSource(std::vector<fs::path> files)
      : files_(std::move(files)), is_continuous_(is_sequence(files_)) {}

  Result<FramePtr> next() override {
    if (position_ == files_.size()) return FramePtr();
    const fs::path& file = files_[position_++];
    auto grey = read_grey_picture(file);
    if (!grey) return grey.error();
    auto frame = std::make_shared<Frame>();
    frame->grey = std::move(*grey);
    frame->name = file.stem().string();
    frame->origin = file.string();
    frame->sequence = position_ - 1;
    return FramePtr(std::move(frame));
  }
  std::optional<std::size_t> count() const override { return files_.size(); }
  bool is_continuous() const override { return is_continuous_; }

 private:
  std::vector<fs::path> files_;
  bool is_continuous_;
  std::size_t position_ = 0;
};

Error video_error(const fs::path& file, std::string_view what) {
  return {std::string(what),
          file.string(),
          "play it in a video player; if that fails too, record it again"};
}

class VideoSource : public Source {
 public:
  /// Error: cannot be opened, or no first frame.
  static Result<std::unique_ptr<Source>> open(const fs::path& file) {
    try {
      auto source = std::unique_ptr<VideoSource>(new VideoSource(file));
      if (!source->video_.open(file.string(), cv::CAP_FFMPEG))
        return video_error(file, "the video cannot be opened");
      if (!source->video_.read(source->ahead_) || source->ahead_.empty())
        return video_error(file, "the video holds no frame");
      return std::unique_ptr<Source>(std::move(source));
    } catch (const cv::Exception&) {
      return video_error(file, "the video cannot be opened");
    }
  }

  Result<FramePtr> next() override {
    if (ahead_.empty()) return FramePtr();
    auto frame = std::make_shared<Frame>();
    frame->name = fmt::format("frame_{:05}", position_);
    frame->origin = file_.string();
    frame->sequence = position_;
    ++position_;
    try {
      if (ahead_.channels() == 3) {
        cv::cvtColor(ahead_, frame->grey, cv::COLOR_BGR2GRAY);
      } else {
        frame->grey = ahead_.clone();
      }
      if (!video_.read(ahead_)) ahead_.release();
    } catch (const cv::Exception&) {
      ahead_.release();
      return video_error(file_,
                         fmt::format("the video cannot be read from frame {} on", position_));
    }
    return FramePtr(std::move(frame));
  }
  /// What the file's header says of its length is a guess for some formats.
  std::optional<std::size_t> count() const override {
    const double frames = video_.get(cv::CAP_PROP_FRAME_COUNT);
    if (!(frames >= 1 && frames < 1e9)) return std::nullopt;
    return static_cast<std::size_t>(frames);
  }
  bool is_continuous() const override { return true; }

 private:
  explicit VideoSource(fs::path file) : file_(std::move(file)) {}

  fs::path file_;
  cv::VideoCapture video_;
  cv::Mat ahead_;  // the frame that next() will give; empty at the end
  std::uint64_t position_ = 0;
};

Result<std::vector<fs::path>> pictures_in(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error)) {
    std::error_code ignored;
    const bool is_hidden = entry->path().filename().string().starts_with('.');
    if (!is_hidden && entry->is_regular_file(ignored) && is_picture(entry->path()) &&
        !is_measurement(entry->path()))
      files.push_back(entry->path());
  }
  if (error)
    return Error{fmt::format("the folder cannot be read: {}", error.message()),
                 folder.string(),
                 "ask its owner for access"};
  if (files.empty())
    return Error{"the folder holds no pictures",
                 folder.string(),
                 "a folder with png, jpg, bmp, tif or pgm files"};
  std::sort(files.begin(), files.end(), [](const fs::path& a, const fs::path& b) {
    return a.filename().string() < b.filename().string();
  });
  return files;
}

Error not_an_input(const fs::path& path) {
  return {"this is neither a picture, nor a folder of pictures, nor a video",
          path.string(),
          "png, jpg, bmp, tif or pgm pictures, or a mkv, avi or mp4 video"};
}

}  // namespace

Result<std::unique_ptr<Source>> open_source(const std::vector<fs::path>& inputs) {
  if (inputs.empty())
    return Error{"no input was given", "", "name a picture, a folder of pictures or a video"};
  std::vector<fs::path> files;
  for (const fs::path& input : inputs) {
    std::error_code ignored;
    if (!fs::exists(input, ignored))
      return Error{
          "there is no such file or folder", input.string(), "check the path for typing errors"};
    if (fs::is_directory(input, ignored)) {
      auto inside = pictures_in(input);
      if (!inside) return inside.error();
      files.insert(files.end(), inside->begin(), inside->end());
    } else if (is_picture(input)) {
      files.push_back(input);
    } else if (is_video(input)) {
      if (inputs.size() == 1) return VideoSource::open(input);
      return Error{"a video cannot be mixed with other inputs",
                   input.string(),
                   "the video alone, or pictures only"};
    } else {
      return not_an_input(input);
    }
  }
  return std::unique_ptr<Source>(std::make_unique<PictureSource>(std::move(files)));
}

}  // namespace alltact
