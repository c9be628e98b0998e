// Sources of the presses of a calibration or a check; the mean of frames held still.
#pragma once

#include "core/base/message.h"
#include "core/base/result.h"
#include "core/image/frame.h"
#include "core/sources/source.h"

#include <deque>
#include <filesystem>
#include <memory>
#include <vector>

namespace alltact {

struct PressInput {
  std::vector<std::filesystem::path> files;  ///< images, folders or a video; see open_source
  bool bursts = false;                       ///< each file is one press held still; see BurstSource
  /// Images in memory, instead of files.
  std::vector<FramePtr> frames = {};
  std::size_t frames_per_press = 64;  ///< of a burst, averaged at most
};

/// Errors: those of open_source.
[[nodiscard]] Result<std::unique_ptr<Source>> open_presses(const PressInput& input);

/// Whether markers can be tracked from one press to the next, as in one video. Images are separate
/// presses, however they are numbered.
[[nodiscard]] bool is_one_video(const Source& presses);

// A press held still: the mean of frames without motion has less noise than one frame.

/// The last frames of a source. The newest frame and those before it that are the same form a mean.
/// Frames are the same when, but for a common change of brightness, hardly any small block of the
/// image differs by more than noise. A marker that moved by a third of a pixel exceeds that, in
/// strong noise by half a pixel.
class HeldFrames {
 public:
  /// Sixteen frames quarter the noise. More are useful with an entire video.
  explicit HeldFrames(std::size_t max_frames = 16) : max_frames_(max_frames) {}

  void add(FramePtr frame);
  void clear() { seen_.clear(); }
  [[nodiscard]] bool is_empty() const { return seen_.empty(); }
  /// Oldest first; empty before the first frame.
  [[nodiscard]] std::vector<FramePtr> alike() const;

 private:
  struct Seen {
    FramePtr frame;
    cv::Mat blocks;  ///< mean brightness of each, CV_32FC1
  };
  std::size_t max_frames_;
  std::deque<Seen> seen_;
};

/// The mean of frames of one size, rounded to 8 bits, with the last one's name, time and settings.
/// One frame is returned unchanged. `frames` must not be empty.
[[nodiscard]] FramePtr mean_frame(const std::vector<FramePtr>& frames);

/// Each of several short videos or folders of images as one frame, named after it. The frame is the
/// mean of the longest stretch in which the finger is held still, of its last `most` frames, up to
/// 64. A single image is returned unchanged. Errors: those of reading, and a video in which no four
/// consecutive frames are the same.
class BurstSource final : public Source {
 public:
  explicit BurstSource(std::vector<std::filesystem::path> bursts, std::size_t max_frames = 64);

  [[nodiscard]] Result<FramePtr> next() override;
  [[nodiscard]] std::optional<std::size_t> count() const override { return bursts_.size(); }
  [[nodiscard]] bool is_continuous() const override { return false; }
  /// Also how the frames so far were made.
  [[nodiscard]] std::vector<Message> remarks() const override { return remarks_; }

 private:
  std::vector<std::filesystem::path> bursts_;
  std::size_t max_frames_;
  std::size_t position_ = 0;
  std::vector<Message> remarks_;
};

}  // namespace alltact
