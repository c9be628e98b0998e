// A press held still: frames that show the same, averaged, carry less noise than one of them.
#pragma once

#include "core/frame.h"
#include "core/message.h"
#include "core/result.h"
#include "core/sources/source.h"

#include <deque>
#include <filesystem>
#include <memory>
#include <vector>

namespace alltact {

/// The last frames of a source; of these the newest and those before it that show the same make a
/// mean. Frames are the same when, but for a common change of brightness, hardly any small block of
/// the picture differs by more than noise: a marker that moved by a third of a pixel does, by half
/// in much noise.
class HeldFrames {
 public:
  /// Sixteen quarter the noise; more are worth it where a whole video is there.
  explicit HeldFrames(std::size_t most = 16) : most_(most) {}

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
  std::size_t most_;
  std::deque<Seen> seen_;
};

/// The mean of frames of one size, rounded to 8 bits, with the last one's name, time and settings.
/// One frame is given back as it is. Not for none.
[[nodiscard]] FramePtr mean_frame(const std::vector<FramePtr>& frames);

/// Each of several short videos or folders of pictures as one frame, named after it: the mean of
/// the longest part of it in which the finger is held still, of its last `most` frames, up to 64. A
/// single picture stays what it is. The source's errors are those of reading, and a video in which
/// no four frames in a row show the same.
class BurstSource final : public Source {
 public:
  explicit BurstSource(std::vector<std::filesystem::path> bursts, std::size_t most = 64);

  [[nodiscard]] Result<FramePtr> next() override;
  [[nodiscard]] std::optional<std::size_t> count() const override { return bursts_.size(); }
  [[nodiscard]] bool is_continuous() const override { return false; }
  /// What the frames so far were made of, a sentence each.
  [[nodiscard]] const std::vector<Message>& made_of() const { return made_of_; }

 private:
  std::vector<std::filesystem::path> bursts_;
  std::size_t most_;
  std::size_t position_ = 0;
  std::vector<Message> made_of_;
};

}  // namespace alltact
