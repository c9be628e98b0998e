#include "calibration/recording_study.h"

#include "core/numerics/median.h"
#include "core/sensing/face_edges.h"
#include "core/sensing/face_shape.h"
#include "core/sensing/local_depth.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <opencv2/imgproc.hpp>

namespace alltact {
namespace {

constexpr int kProfileDegree = 7;
constexpr double kPatchMm = 1.5;       // a side: no ball that matters dents less
constexpr double kDarker = 0.03;       // about 0.08 mm of a usual layer
constexpr double kTimesTypical = 4.0;  // of the recording's own darkest patches
constexpr double kMostSeconds = 2.0;
constexpr double kMostPart = 0.125;
constexpr double kRimPx = 4.0;  // beside the face's edges a shift of a tenth of a pixel shows

struct Looked {
  cv::Mat grey;
  FaceShape shape;
  double noise_sd;
};

std::optional<Looked> look(const cv::Mat& grey, const Camera& camera, const Finger& finger) {
  const auto edges = FaceEdgeFinder()(grey);
  if (!edges) return std::nullopt;
  auto shape = FaceShape::fit(*edges, camera, finger.face, kProfileDegree);
  if (!shape) return std::nullopt;
  return Looked{grey, std::move(shape).value(), edges->noise_sd};
}

/// Means over patches of the face, NaN where less than half of a patch is measured; centred on
/// every pixel of the picture.
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
  const cv::Mat known = difference.x == difference.x;
  cv::Mat filled = difference.x.clone(), weight, sum;
  filled.setTo(0.0F, ~known);
  known.convertTo(weight, CV_32FC1, 1.0 / 255.0);
  cv::boxFilter(filled, sum, CV_32F, {side, side}, {-1, -1}, true, cv::BORDER_CONSTANT);
  cv::boxFilter(weight, weight, CV_32F, {side, side}, {-1, -1}, true, cv::BORDER_CONSTANT);
  Patches patches;
  patches.mean = sum / weight;
  patches.mean.setTo(std::numeric_limits<float>::quiet_NaN(), weight < 0.5F);
  patches.mean.setTo(std::numeric_limits<float>::quiet_NaN(), ~known);
  // Smoothing has already averaged over neighbours; a patch is wider than that.
  patches.noise = difference.grey_sd * 2.0 * std::sqrt(M_PI) / (side * grey_level);
  return patches;
}

double mean_level(const cv::Mat& grey, const FaceRuns& face) {
  double sum = 0, count = 0;
  for (std::size_t i = 0; i < face.runs.size(); i += 8) {
    const FaceRun& run = face.runs[i];
    const std::uint8_t* row = grey.ptr<std::uint8_t>(run.row);
    for (int u = run.first; u < run.end; ++u) sum += row[u];
    count += run.size();
  }
  return std::max(1.0, sum / std::max(1.0, count));
}

class Study {
 public:
  Study(const ReferenceLibrary& library, const std::vector<Markers>& numbered, double frames_per_s)
      : library_(library), numbered_(numbered) {
    const double most = kMostPart * static_cast<double>(library.frame_count());
    gap_ = static_cast<std::size_t>(std::max(1.0, std::min(most, kMostSeconds * frames_per_s)));
  }

  /// `touched`: frames known to be touched take no part.
  [[nodiscard]] StudiedFrame frame(std::size_t index,
                                   const Looked& looked,
                                   const std::vector<char>& touched) const {
    StudiedFrame studied;
    studied.number = library_.frame_numbers()[index];
    studied.tip = tip_place(numbered_[index], looked.shape);
    std::vector<char> without = touched;
    const std::size_t first = index > gap_ ? index - gap_ : 0;
    for (std::size_t i = first; i <= index + gap_ && i < without.size(); ++i) without[i] = 1;
    if (std::count(without.begin(), without.end(), 0) < 2) return studied;
    const auto local = compare(index, looked, ReferenceMethod::kLocal, without);
    if (!local) return studied;
    studied.compared = true;
    studied.error = mean_error(*local);
    find_darkest(*local, looked.shape, studied);
    if (const auto nearest = compare(index, looked, ReferenceMethod::kNearest, without))
      studied.nearest_error = mean_error(*nearest);
    return studied;
  }

 private:
  [[nodiscard]] std::optional<Patches> compare(std::size_t index,
                                               const Looked& looked,
                                               ReferenceMethod method,
                                               const std::vector<char>& without) const {
    const Reference reference = library_.reference_for(numbered_[index], method, without);
    if (!reference.known_pose) return std::nullopt;
    DifferenceOptions options;
    options.edge_margin_px = kRimPx;
    options.noise_sd = looked.noise_sd;
    options.correct_light = true;
    const Difference compared = difference(looked.grey, reference, looked.shape, options);
    if (compared.face.runs.empty()) return std::nullopt;
    return patches_of(compared, looked.shape, mean_level(looked.grey, compared.face));
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

  static void find_darkest(const Patches& patches, const FaceShape& shape, StudiedFrame& studied) {
    cv::Mat mean = patches.mean.clone();
    mean.setTo(-1.0F, mean != mean);
    double darkest = 0;
    cv::Point place;
    cv::minMaxLoc(mean, nullptr, &darkest, nullptr, &place);
    studied.darkest = std::max(0.0, darkest);
    if (const auto local = shape.at(place.x, place.y)) {
      studied.along_mm = shape.length_at(place.x);
      studied.across_mm = local->view_point_mm.y();
    }
  }

  const ReferenceLibrary& library_;
  const std::vector<Markers>& numbered_;
  std::size_t gap_;
};

double typical_darkest(const std::vector<StudiedFrame>& frames) {
  std::vector<double> darkest;
  for (const StudiedFrame& frame : frames)
    if (frame.compared) darkest.push_back(frame.darkest);
  return upper_median(darkest);
}

double part_of(std::vector<double> values, double part) {
  if (values.empty()) return 0;
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(part * (values.size() - 1.0));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

}  // namespace

Result<RecordingStudy> study_recording(const ReferenceLibrary& library,
                                       const std::vector<Markers>& numbered,
                                       VideoFile& video,
                                       const Finger& finger,
                                       const Camera& camera,
                                       const Job& job) {
  const std::size_t count = library.frame_count();
  const Study study(library, numbered, video.frames_per_s());
  RecordingStudy result;
  result.touched.assign(count, 0);
  const auto looked_at = [&](std::size_t index) -> Result<std::optional<Looked>> {
    const int number = library.frame_numbers()[index];
    const auto frame = video.frame(static_cast<std::size_t>(number));
    if (!frame) return frame.error();
    const auto grey =
        oriented_for(finger.camera, (*frame)->grey, "the recording's picture", "", "");
    if (!grey) return grey.error();
    return look(*grey, camera, finger);
  };
  for (std::size_t i = 0; i < count; ++i) {
    if (job.stop_requested()) return Error{"stopped before the recording was compared", "", ""};
    job.report(static_cast<double>(i) / static_cast<double>(count),
               fmt::format("comparing frame {} of {}", i + 1, count));
    const auto looked = looked_at(i);
    if (!looked) return looked.error();
    StudiedFrame studied;
    studied.number = library.frame_numbers()[i];
    if (*looked) studied = study.frame(i, **looked, result.touched);
    result.frames.push_back(std::move(studied));
  }
  // Suspects are looked at again without each other: an untouched frame that was compared with
  // touched ones is none.
  const double limit = std::max(kDarker, kTimesTypical * typical_darkest(result.frames));
  for (std::size_t i = 0; i < count; ++i) result.touched[i] = result.frames[i].darkest > limit;
  const std::vector<char> suspects = result.touched;
  for (std::size_t i = 0; i < count; ++i) {
    if (!suspects[i]) continue;
    const auto looked = looked_at(i);
    if (!looked) return looked.error();
    const StudiedFrame again = study.frame(i, **looked, suspects);
    if (!again.compared) continue;
    result.frames[i] = again;
    result.touched[i] = again.darkest > limit;
  }
  std::vector<double> errors, nearest;
  for (std::size_t i = 0; i < count; ++i) {
    if (result.touched[i] || !result.frames[i].compared) continue;
    errors.push_back(result.frames[i].error);
    nearest.push_back(result.frames[i].nearest_error);
  }
  result.error_median = part_of(errors, 0.5);
  result.error_p95 = part_of(errors, 0.95);
  result.nearest_error_median = part_of(nearest, 0.5);
  return result;
}

}  // namespace alltact
