// Presses painted into untouched pictures of a finger, to calibrate it with anew, and others to
// tell how far its depth is off then.
#pragma once

#include "calibration/finger/paper_pipeline.h"
#include "calibration/study/painted_press.h"
#include "core/sensing/paper_method.h"
#include "core/sensing/pipeline.h"

#include <cstdint>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include <opencv2/core.hpp>

namespace alltact {

/// Seconds that this thread has computed: what else the computer does is not in it.
[[nodiscard]] double computed_s();

/// Presses as a calibration takes them, and what reading each took.
struct ReadPresses {
  std::vector<FramePtr> frames;
  std::vector<Press> presses;
  std::vector<double> read_s;
};

class CalibratingBench {
 public:
  static constexpr int kMostPresses = 24;

  /// Errors: those of untouched_pictures(); too few of them show the face.
  [[nodiscard]] static Result<CalibratingBench> make(const FingerPtr& finger,
                                                     std::uint64_t seed,
                                                     const Job& job);

  /// kMostPresses of them, base, middle and tip in turn; the first ones of fewer are the same.
  ///   pictures: of each, whose mean is taken
  [[nodiscard]] Result<const ReadPresses*> presses(int draw, int pictures);
  /// As the source paper's own steps measure them; those that it cannot measure are missing.
  [[nodiscard]] Result<std::vector<Press>> as_paper(const std::vector<FramePtr>& frames,
                                                    const Job& job);

  /// Of depth in painted pictures that calibrated nothing, measured with this mapping.
  [[nodiscard]] Result<std::vector<float>> errors_mm(const Mapping& mapping,
                                                     bool is_paper,
                                                     int draw,
                                                     const Job& job);

  [[nodiscard]] const FingerSnapshot& finger() const { return *untouched_.finger; }
  [[nodiscard]] std::uint64_t checksum() const { return checksum_; }

 private:
  /// An untouched picture, and what of it is noise.
  struct Canvas {
    cv::Mat grey;
    cv::Mat noise;  // CV_32FC1
    FaceShape shape;
  };
  CalibratingBench(UntouchedPictures untouched, std::uint64_t seed)
      : untouched_(std::move(untouched)), seed_(seed) {}
  [[nodiscard]] Status look_at_pictures();
  [[nodiscard]] std::optional<StudyFrame> painted(int draw, int number, int pictures, bool is_new);
  [[nodiscard]] Status need_paper(const Job& job);

  UntouchedPictures untouched_;
  std::uint64_t seed_;
  std::uint64_t checksum_ = 0;
  std::vector<Canvas> canvases_;
  std::map<std::pair<int, int>, ReadPresses> read_;  // by draw and pictures
  std::map<int, std::vector<StudyFrame>> new_;       // by draw
  std::optional<PaperMethod> paper_;
  bool is_turned_ = false;  // the camera's pictures, which the paper's method would turn again
};

}  // namespace alltact
