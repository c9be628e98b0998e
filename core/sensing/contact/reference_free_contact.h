// Whether something presses on the face before there is a reference recording: every patch of skin
// compared with its surroundings, and that with what it was in the frames before.
#pragma once

#include "core/sensing/face/face_shape.h"

#include <optional>
#include <vector>

#include <opencv2/core.hpp>

namespace alltact {

/// A patch that is darker against its surroundings than it was.
struct ReferenceFreeContact {
  double darker = 0;    ///< 0.1: by 10 %
  double along_mm = 0;  ///< from the base
};

/// Bending changes the light evenly over a centimetre, a press darkens a few millimetres. Skin that
/// is marked or dirty is so in every frame, wherever it lies in the picture. Two things cannot be
/// seen so: what presses from the first frame on (until it lets go, when that patch is learnt
/// anew), and what presses evenly over more than a centimetre. study_recording looks closer, once
/// the recording is there.
class ReferenceFreeContactDetector {
 public:
  /// nullopt: nothing presses, or these are the first frames. `grey`: CV_8UC1, the shape's width.
  [[nodiscard]] std::optional<ReferenceFreeContact> operator()(const cv::Mat& grey,
                                                               const FaceShape& shape);
  /// Enough frames have been seen to compare with.
  [[nodiscard]] bool is_ready() const { return frames_ >= kFirstFrames; }
  /// The next frame shows another finger, or another light.
  void forget();

 private:
  static constexpr int kFirstFrames = 5;
  struct Skin {  // one patch, over the frames in which nothing pressed on it
    int frames = 0;
    double usual = 0, variance = 0;
  };
  /// False: it is darker than it ever was by itself.
  static bool learn(Skin& skin, double now);

  std::vector<Skin> skin_;
  int frames_ = 0;
};

}  // namespace alltact
