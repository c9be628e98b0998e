// Detects contact before there is a reference recording: every patch of skin is compared with its
// surroundings, and their contrast with that of the frames before.
#pragma once

#include "core/sensing/face/face_shape.h"

#include <optional>
#include <vector>

#include <opencv2/core.hpp>

namespace alltact {

/// A patch that is darker against its surroundings than before.
struct ReferenceFreeContact {
  double darker = 0;    ///< 0.1: by 10 %
  double along_mm = 0;  ///< from the base
};

/// Bending changes the light evenly over a centimetre, a contact darkens a few millimetres. Marked
/// or dirty skin is so in every frame. Two kinds of contact are not detected. One lasts since the
/// first frame, until it ends and its patch is learnt again. The other presses evenly over more
/// than a centimetre. The study of the complete recording is more sensitive.
class ReferenceFreeContactDetector {
 public:
  /// nullopt: no contact, or these are the first frames. `grey`: CV_8UC1, the shape's width.
  [[nodiscard]] std::optional<ReferenceFreeContact> operator()(const cv::Mat& grey,
                                                               const FaceShape& shape);
  /// Enough frames have been seen for a comparison.
  [[nodiscard]] bool is_ready() const { return frames_ >= kFirstFrames; }
  /// Resets the state: the next frame shows another finger, or another light.
  void forget();

 private:
  static constexpr int kFirstFrames = 5;
  struct Skin {  // one patch, over the frames without contact on it
    int frames = 0;
    double typical = 0, variance = 0;
  };
  /// Returns false where the patch is darker than it varies without contact.
  static bool learn(Skin& skin, double now);

  std::vector<Skin> skin_;
  int frames_ = 0;
};

}  // namespace alltact
