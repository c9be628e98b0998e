#include "calibration/reference/recording_study.h"

#include "calibration/presses/measured_pixels.h"
#include "core/numerics/median.h"
#include "core/sensing/depth/local_depth.h"
#include "core/sensing/face/face_edges.h"
#include "core/sensing/face/face_shape.h"

#include <algorithm>
#include <cmath>

#include <opencv2/imgproc.hpp>

namespace alltact {
namespace {

constexpr int kStudyDegree = 7;
constexpr double kPatchMm = 1.5;  // a side
constexpr double kMaxSeconds = 2.0;
constexpr double kMaxFraction = 0.125;
constexpr double kRimPx = 4.0;  // next to the face's edges a shift of a tenth of a pixel is visible

struct AnalysedFrame {
  cv::Mat grey;
  FaceShape shape;
  double noise_sd;
};

std::optional<AnalysedFrame> analyse(const cv::Mat& grey,
                                     const Camera& camera,
                                     const Finger& finger) {
  const auto edges = FaceEdgeFinder({.view = FaceView{camera, finger.face.width_mm}})(grey);
  if (!edges) return std::nullopt;
  auto shape = FaceShape::fit(*edges, camera, finger.face, kStudyDegree);
  if (!shape) return std::nullopt;
  return AnalysedFrame{grey, std::move(shape).value(), edges->noise_sd};
}

/// Means of the valid part of an image over squares.
class Means {
 public:
  explicit Means(const cv::Mat& x) : known_(measured_pixels(x)) {
    known_.convertTo(weight_, CV_32FC1, 1.0 / 255.0);
    filled_ = x.clone();
    filled_.setTo(0.0F, ~known_);
  }
  /// NaN where less than half of the square is known, or the middle is not.
  [[nodiscard]] cv::Mat over(int side) const {
    cv::Mat sum, weight;
    cv::boxFilter(filled_, sum, CV_32F, {side, side}, {-1, -1}, true, cv::BORDER_CONSTANT);
    cv::boxFilter(weight_, weight, CV_32F, {side, side}, {-1, -1}, true, cv::BORDER_CONSTANT);
    cv::Mat mean = sum / weight;
    mean.setTo(std::numeric_limits<float>::quiet_NaN(), (weight < 0.25F) | ~known_);
    return mean;
  }

 private:
  cv::Mat known_, weight_, filled_;
};

/// Difference of the face from the reference in patches around every pixel.
struct Patches {
  cv::Mat mean;
  double noise;  ///< sd of a patch's mean by noise alone
};

Patches patches_of(const Difference& difference, const FaceShape& shape, double grey_level) {
  std::vector<double> z;
  for (const FaceColumn& column : shape.columns())
    if (column.valid) z.push_back(column.z_mm);
  const int side =
      std::max(3, static_cast<int>(kPatchMm / shape.camera().mm_per_px_at(upper_median(z))));
  const Means means(difference.x);
  Patches patches;
  patches.mean = means.over(side);
  // Smoothing has already averaged over neighbours; a patch is wider than that.
  patches.noise = difference.grey_sd * 2.0 * std::sqrt(M_PI) / (side * grey_level);
  return patches;
}

class Study {
 public:
  Study(const ReferenceLibrary& library, const std::vector<Markers>& numbered, double frames_per_s)
      : library_(library), numbered_(numbered) {
    const double most = kMaxFraction * static_cast<double>(library.frame_count());
    gap_ = static_cast<std::size_t>(std::max(1.0, std::min(most, kMaxSeconds * frames_per_s)));
  }

  [[nodiscard]] StudiedFrame frame(std::size_t index, const AnalysedFrame& analysed) const {
    StudiedFrame studied;
    studied.number = library_.frame_numbers()[index];
    const Markers& markers = numbered_[index];
    for (std::size_t pair = 0; pair < markers.size() / 2; ++pair)
      studied.pairs.push_back(tip_pose(markers, pair, analysed.shape));
    std::vector<char> without(library_.frame_count(), 0);
    const std::size_t first = index > gap_ ? index - gap_ : 0;
    for (std::size_t i = first; i <= index + gap_ && i < without.size(); ++i) without[i] = 1;
    if (std::count(without.begin(), without.end(), 0) < 2) return studied;
    const auto local = compare(index, analysed, ReferenceMethod::kLocal, without);
    if (!local) return studied;
    studied.compared = true;
    studied.error = mean_error(*local);
    if (const auto nearest = compare(index, analysed, ReferenceMethod::kNearest, without))
      studied.nearest_error = mean_error(*nearest);
    return studied;
  }

 private:
  [[nodiscard]] std::optional<Patches> compare(std::size_t index,
                                               const AnalysedFrame& analysed,
                                               ReferenceMethod method,
                                               const std::vector<char>& without) const {
    const Reference reference =
        library_.reference_for(numbered_[index], analysed.shape, method, without);
    // Outside the others' poses the reference is extrapolated and does not count.
    if (!reference.known_pose || reference.noise_gain > 1.0) return std::nullopt;
    DifferenceOptions options;
    options.edge_margin_px = kRimPx;
    options.noise_sd = analysed.noise_sd;
    options.correct_light = true;
    const Difference compared = difference(analysed.grey, reference, analysed.shape, options);
    if (compared.face.runs.empty()) return std::nullopt;
    return patches_of(compared, analysed.shape, mean_brightness(analysed.grey, compared.face));
  }

  static double mean_error(const Patches& patches) {
    double square = 0, count = 0;
    for (int v = 0; v < patches.mean.rows; v += 4)
      for (int u = 0; u < patches.mean.cols; u += 4)
        if (const float x = patches.mean.at<float>(v, u); std::isfinite(x))
          square += static_cast<double>(x) * x, ++count;
    if (count == 0) return 0;
    // Of a normal distribution the mean magnitude is 0.8 of the standard deviation.
    return 0.8 * std::sqrt(std::max(0.0, square / count - patches.noise * patches.noise));
  }

  const ReferenceLibrary& library_;
  const std::vector<Markers>& numbered_;
  std::size_t gap_;
};

double quantile_of(std::vector<double> values, double part) {
  if (values.empty()) return 0;
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(part * (values.size() - 1.0));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

}  // namespace

Result<RecordingStudy> study_recording(const ReferenceLibrary& library,
                                       const std::vector<Markers>& numbered,
                                       const RecordingFrameReader& frame,
                                       double frames_per_s,
                                       const Finger& finger,
                                       const Camera& camera,
                                       const Job& job) {
  const std::size_t count = library.frame_count();
  const Study study(library, numbered, frames_per_s);
  RecordingStudy result;
  const auto analysed_at = [&](std::size_t index) -> Result<std::optional<AnalysedFrame>> {
    const auto grey = frame(static_cast<std::size_t>(library.frame_numbers()[index]));
    if (!grey) return grey.error();
    return analyse(*grey, camera, finger);
  };
  for (std::size_t i = 0; i < count; ++i) {
    if (job.stop_requested())
      return Error{en::say("stopped before the recording was compared"), "", ""};
    job.report(static_cast<double>(i) / static_cast<double>(count),
               en::say("comparing frame {} of {}", i + 1, count));
    const auto analysed = analysed_at(i);
    if (!analysed) return analysed.error();
    StudiedFrame studied;
    studied.number = library.frame_numbers()[i];
    if (*analysed) studied = study.frame(i, **analysed);
    result.frames.push_back(std::move(studied));
  }
  std::vector<double> errors, nearest;
  for (std::size_t i = 0; i < count; ++i) {
    if (!result.frames[i].compared) continue;
    errors.push_back(result.frames[i].error);
    nearest.push_back(result.frames[i].nearest_error);
  }
  result.error_median = quantile_of(errors, 0.5);
  result.error_p95 = quantile_of(errors, 0.95);
  result.nearest_error_median = quantile_of(nearest, 0.5);
  return result;
}

}  // namespace alltact
