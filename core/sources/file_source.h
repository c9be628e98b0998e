// A source of image files and a source of frames in memory.
#pragma once

#include "core/base/job.h"
#include "core/base/result.h"
#include "core/image/frame.h"
#include "core/image/image_file.h"
#include "core/recording/video_file.h"
#include "core/sources/source.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace alltact {

/// True for a file name with an image extension.
[[nodiscard]] bool is_image_file(const std::filesystem::path& file);

/// The order of names, with the numbers in them by their values: image_9 before image_10.
[[nodiscard]] bool is_before(const std::filesystem::path& a, const std::filesystem::path& b);

/// Returns a folder's images in that order of their names. Errors: it cannot be read, or holds
/// none.
[[nodiscard]] Result<std::vector<std::filesystem::path>> images_in(
    const std::filesystem::path& folder);

/// Continuous when the images have one name with numbers without a gap.
class ImageSource : public Source {
 public:
  explicit ImageSource(std::vector<std::filesystem::path> files);

  [[nodiscard]] Result<FramePtr> next() override;
  void skip(std::size_t count) override { position_ += std::min(count, files_.size() - position_); }
  [[nodiscard]] std::optional<std::size_t> count() const override { return files_.size(); }
  [[nodiscard]] bool is_continuous() const override { return is_continuous_; }
  [[nodiscard]] std::vector<Message> remarks() const override;

 private:
  std::vector<std::filesystem::path> files_;
  bool is_continuous_;
  std::size_t position_ = 0;
  ImageLook look_;
  bool are_bits_known_ = false;
};

/// Frames in memory. Continuous when their names are numbered without a gap.
class FrameSource : public Source {
 public:
  explicit FrameSource(std::vector<FramePtr> frames);

  [[nodiscard]] Result<FramePtr> next() override;
  [[nodiscard]] std::optional<std::size_t> count() const override { return frames_.size(); }
  [[nodiscard]] bool is_continuous() const override { return is_continuous_; }

 private:
  std::vector<FramePtr> frames_;
  bool is_continuous_;
  std::size_t position_ = 0;
};

// A source of a video's frames.

class VideoSource : public Source {
 public:
  VideoSource(VideoFile video, const SourceOptions& options)
      : video_(std::move(video)), pacer_(options) {}

  [[nodiscard]] Result<FramePtr> next() override;
  void skip(std::size_t count) override {
    position_ += std::min(count, video_.frame_count() - position_);
  }
  [[nodiscard]] std::optional<std::size_t> count() const override { return video_.frame_count(); }
  [[nodiscard]] bool is_continuous() const override { return true; }
  [[nodiscard]] double frames_per_s() const override { return video_.frames_per_s(); }
  [[nodiscard]] std::optional<std::filesystem::path> lossless_file() const override {
    return position_ == 0 ? video_.lossless_file() : std::nullopt;
  }
  [[nodiscard]] std::vector<Message> remarks() const override { return video_.remarks(); }

 private:
  VideoFile video_;
  Pacer pacer_;
  std::size_t position_ = 0;
};

// Matches frames of two recordings by time.

/// Times of capture of a recording's frames, ns; empty where it has none (images).
using FrameTimes = std::vector<std::int64_t>;

enum class MatchedBy {
  kTime = 1,   ///< one common clock: recorded at the same time
  kBeginning,  ///< recorded one after the other: their beginnings are aligned
  kNumber,     ///< one of them has no times
};

struct MatchedFrame {
  std::size_t number = 0;
  MatchedBy by = MatchedBy::kNumber;
  double later_ms = 0;  ///< relative to the first recording's frame; 0 for kNumber
};

/// The frame of the second recording that is nearest in time; its last one where it is shorter.
///   number: below the first recording's count; other_count: at least 1
[[nodiscard]] MatchedFrame match_frame(std::size_t number, const FrameTimes& times_ns,
                                       const FrameTimes& other_times_ns, std::size_t other_count);

// Random access to the frames of a recording.

/// A video, or the images of a folder in name order. One thread.
class RecordedFrames {
 public:
  /// Errors: those of VideoFile::open and images_in.
  [[nodiscard]] static Result<RecordedFrames> open(const std::filesystem::path& input,
                                                   const Job& job);

  [[nodiscard]] std::size_t count() const;  ///< at least 1
  /// Error: this frame cannot be read; others may still be readable.
  [[nodiscard]] Result<FramePtr> frame(std::size_t number);
  /// The recorded rate of a video; 10 per second for images, which have no times.
  [[nodiscard]] double frames_per_s() const;
  /// Times of capture, ns; null where the frames have none.
  [[nodiscard]] std::shared_ptr<const FrameTimes> times_ns() const;
  /// True when each frame follows the one before it in time.
  [[nodiscard]] bool is_continuous() const { return is_continuous_; }

 private:
  std::optional<VideoFile> video_;
  std::vector<std::filesystem::path> images_;
  bool is_continuous_ = true;
};

// The kind of a file by its extension.

template <std::size_t N>
bool is_one_of(const std::string& extension, const std::array<const char*, N>& extensions) {
  return std::find(extensions.begin(), extensions.end(), extension) != extensions.end();
}

}  // namespace alltact
