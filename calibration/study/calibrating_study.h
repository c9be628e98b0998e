// Cost and benefit of a calibration's choices: number of presses, images of each, method, family
// and iterations, against computing time and the technician's time.
//
// Two kinds of ground truth, reported separately:
//   painted  balls painted into untouched images of the finger calibrate it anew, and other
//            painted images measure its depth error. Any number of presses is possible, but the
//            skin follows the ball exactly and the mapping has the finger's own form;
//   real     the finger's stored presses: some calibrate, the others are compared with the
//            ball's sphere (real_presses.h). Limited to the stored presses.
#pragma once

#include "calibration/finger/paper_pipeline.h"
#include "calibration/joint/calibration_settings.h"
#include "calibration/study/accuracy_study.h"
#include "calibration/study/real_presses.h"
#include "calibration/study/study_world.h"
#include "core/base/job.h"
#include "core/base/message.h"
#include "core/base/result.h"
#include "core/finger/finger_store.h"
#include "core/sensing/frame_result.h"
#include "core/sensing/paper_method.h"

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json_fwd.hpp>
#include <opencv2/core.hpp>

namespace alltact {

/// Time that a technician spends. An estimate, not measured here: replace it by better values here.
struct TechnicianTimes {
  double once_s = 120;        ///< fetch and clean the ball, start, read the verdict
  double press_s = 20;        ///< move the ball, press, wait until it is still, take, lift
  double image_s = 1.0 / 30;  ///< each further image of a press that is held
  [[nodiscard]] double minutes(int presses, int images) const {
    return (once_s + presses * (press_s + (images - 1) * image_s)) / 60;
  }
};

struct CalibratingChoice {
  int presses = 6;
  int images = 1;  ///< of each press, averaged
  CalibrationMethod method = CalibrationMethod::kJoint;
  FamilyChoice family = FamilyChoice::kAuto;
  int iterations = CalibrationSettings{}.iterations;
  bool operator==(const CalibratingChoice&) const = default;
};

struct CalibratingRow {
  CalibratingChoice choice;
  /// calibrations with painted presses; those without a mapping
  int draws = 0, failed = 0;
  std::optional<ErrorSpread> painted;  ///< of depth in other painted images
  int splits = 0, splits_failed = 0;   ///< the same for the stored presses
  std::optional<RealErrors> real;
  /// reading the presses and solving, on this computer at that time; median
  double computing_s = 0;
  double time_ratio = 1;  ///< to the base, median over the draws
  double technician_min = 0;
};

struct CalibratingStudy {
  Message about;
  std::uint64_t world_checksum = 0;
  TechnicianTimes technician;
  Message no_real_reason;            ///< why no stored press gives a figure; empty: they do
  std::vector<CalibratingRow> rows;  ///< the base (a default calibration) first
};

struct CalibratingOptions {
  std::uint64_t seed = 1;
  std::optional<CalibratingChoice> base =
      std::nullopt;    ///< absent: as many presses as the finger's
  bool quick = false;  ///< fewer choices and draws
  TechnicianTimes technician;
};

/// Varies each choice alone, and combines the number of presses with the method and the number of
/// images. Errors: those of untouched_images() and Pipeline; stopped.
[[nodiscard]] Result<CalibratingStudy> study_calibrating(const FingerPtr& finger,
                                                         const CalibratingOptions& options,
                                                         const Job& job);

/// The choices in their order, from the values that calibration_settings() lists as worth trying;
/// the base first.
[[nodiscard]] std::vector<CalibratingChoice> calibrating_choices(const CalibratingChoice& base,
                                                                 bool quick);

/// The choice that the finger was calibrated with, as far as enough presses can be painted.
/// Unrecorded values take their defaults.
[[nodiscard]] CalibratingChoice choice_of_finger(const Finger& finger);

/// For example "6 presses, cone".
[[nodiscard]] Message words_of(const CalibratingChoice& choice);

/// Total minutes of technician and computer.
[[nodiscard]] double total_minutes(const CalibratingRow& row);

/// Rows (by index, quickest first) that no other beats in both total_minutes() and median error on
/// painted images.
[[nodiscard]] std::vector<std::size_t> calibrating_front(const CalibratingStudy& study);

/// Benefit over `from` of one more press, of more images of each and of more minutes, on painted
/// images. One sentence each, for studied choices only.
[[nodiscard]] std::vector<Message> benefit_of_more_data(const CalibratingStudy& study,
                                                        const CalibratingChoice& from);

[[nodiscard]] std::string text_of(const CalibratingStudy& study);
[[nodiscard]] std::string csv_of(const CalibratingStudy& study);
[[nodiscard]] nlohmann::json json_of(const CalibratingStudy& study);

// Presses painted into untouched images of a finger: one set calibrates it anew, another set
// measures the depth error of that calibration.

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
  [[nodiscard]] static Result<CalibratingBench> make(const FingerPtr& finger, std::uint64_t seed,
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
  [[nodiscard]] Result<std::vector<float>> errors_mm(const Mapping& mapping, bool is_paper,
                                                     int draw, const Job& job);

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
