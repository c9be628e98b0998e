// Presses painted into untouched images of a finger: one set calibrates it anew, another set
// measures the depth error of that calibration.
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

/// Processor seconds of this thread, without the load of other programs.
[[nodiscard]] double thread_cpu_s();

/// Presses in the form that a calibration takes, and the reading time of each.
struct ReadPresses {
  std::vector<FramePtr> frames;
  std::vector<Press> presses;
  std::vector<double> read_s;
};

class CalibratingBench {
 public:
  static constexpr int kMaxPresses = 24;

  /// Errors: those of untouched_images(); too few images show the face.
  [[nodiscard]] static Result<CalibratingBench> make(const FingerPtr& finger,
                                                     std::uint64_t seed,
                                                     const Job& job);

  /// kMaxPresses of them: base, middle and tip in turn. With fewer presses the first ones are the
  /// same.
  ///   images: number of images of each press, which are averaged
  [[nodiscard]] Result<const ReadPresses*> presses(int draw, int images);
  /// Measured by the source paper's own steps. Presses that it cannot measure are omitted.
  [[nodiscard]] Result<std::vector<Press>> as_paper(const std::vector<FramePtr>& frames,
                                                    const Job& job);

  /// Depth errors in painted images that took no part in the calibration, measured with this
  /// mapping.
  [[nodiscard]] Result<std::vector<float>> errors_mm(const Mapping& mapping,
                                                     bool is_paper,
                                                     int draw,
                                                     const Job& job);

  [[nodiscard]] const FingerSnapshot& finger() const { return *untouched_.finger; }
  [[nodiscard]] std::uint64_t checksum() const { return checksum_; }

 private:
  /// An untouched image and its noise.
  struct Canvas {
    cv::Mat grey;
    cv::Mat noise;  // CV_32FC1
    FaceShape shape;
  };
  CalibratingBench(UntouchedImages untouched, std::uint64_t seed)
      : untouched_(std::move(untouched)), seed_(seed) {}
  [[nodiscard]] Status analyse_images();
  [[nodiscard]] std::optional<StudyFrame> painted(int draw, int number, int images, bool is_new);
  [[nodiscard]] Status need_paper(const Job& job);

  UntouchedImages untouched_;
  std::uint64_t seed_;
  std::uint64_t checksum_ = 0;
  std::vector<Canvas> canvases_;
  std::map<std::pair<int, int>, ReadPresses> read_;  // by draw and number of images
  std::map<int, std::vector<StudyFrame>> new_;       // by draw
  std::optional<PaperMethod> paper_;
  bool is_turned_ = false;  // the camera's images, which the paper's method would rotate again
};

}  // namespace alltact
