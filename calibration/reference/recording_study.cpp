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
constexpr double kPatchMm = 1.5;  // a side: no ball that matters dents less
constexpr double kDarker = 0.04;  // about 0.1 mm of a usual layer
constexpr double kSigmas = 8.0;   // of what patches of a zone differ by from frame to frame
constexpr double kMostSeconds = 2.0;
constexpr double kMostPart = 0.125;
constexpr int kSurroundings = 5;  // times a patch's side
constexpr double kEndMm = 4.0;  // of the face's length at both ends, where light ends with the face
constexpr double kRimPx = 4.0;  // beside the face's edges a shift of a tenth of a pixel shows

struct Looked {
  cv::Mat grey;
  FaceShape shape;
  double noise_sd;
};

std::optional<Looked> look(const cv::Mat& grey, const Camera& camera, const Finger& finger) {
  const auto edges = FaceEdgeFinder({.view = FaceView{camera, finger.face.width_mm}})(grey);
  if (!edges) return std::nullopt;
  auto shape = FaceShape::fit(*edges, camera, finger.face, kStudyDegree);
  if (!shape) return std::nullopt;
  return Looked{grey, std::move(shape).value(), edges->noise_sd};
}

/// Means of a picture over squares, of what is known of it.
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

/// What patches of the face differ by from the reference, around every pixel.
struct Patches {
  cv::Mat mean;
  cv::Mat standing_out;  ///< the same against their surroundings: what presses is a dent
  double noise;          ///< sd of a patch's mean by noise alone
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
  patches.standing_out = patches.mean - means.over(kSurroundings * side);
  // Smoothing has already averaged over neighbours; a patch is wider than that.
  patches.noise = difference.grey_sd * 2.0 * std::sqrt(M_PI) / (side * grey_level);
  return patches;
}

/// More than measure: until they are found, some of them may be dented themselves.
constexpr int kNeighbours = 16;

class Study {
 public:
  Study(const ReferenceLibrary& library, const std::vector<Markers>& numbered, double frames_per_s)
      : library_(library), numbered_(numbered) {
    const double most = kMostPart * static_cast<double>(library.frame_count());
    gap_ = static_cast<std::size_t>(std::max(1.0, std::min(most, kMostSeconds * frames_per_s)));
  }

  /// `dented`: frames known to be dented take no part.
  [[nodiscard]] StudiedFrame frame(std::size_t index,
                                   const Looked& looked,
                                   const std::vector<char>& dented) const {
    StudiedFrame studied;
    studied.number = library_.frame_numbers()[index];
    const Markers& markers = numbered_[index];
    for (std::size_t pair = 0; pair < markers.size() / 2; ++pair)
      studied.pairs.push_back(tip_place(markers, pair, looked.shape));
    std::vector<char> without = dented;
    const std::size_t first = index > gap_ ? index - gap_ : 0;
    for (std::size_t i = first; i <= index + gap_ && i < without.size(); ++i) without[i] = 1;
    if (std::count(without.begin(), without.end(), 0) < 2) return studied;
    const auto local = compare(index, looked, ReferenceMethod::kLocal, without);
    if (!local) return studied;
    studied.compared = true;
    studied.error = mean_error(*local);
    studied.darkest = darkest_by_zone(*local, looked.shape);
    if (const auto nearest = compare(index, looked, ReferenceMethod::kNearest, without))
      studied.nearest_error = mean_error(*nearest);
    return studied;
  }

 private:
  [[nodiscard]] std::optional<Patches> compare(std::size_t index,
                                               const Looked& looked,
                                               ReferenceMethod method,
                                               const std::vector<char>& without) const {
    const Reference reference =
        library_.reference_for(numbered_[index], looked.shape, method, without, kNeighbours);
    // Beyond the others' poses the reference is a guess, and no frame is to be judged by it.
    if (!reference.known_pose || reference.noise_gain > 1.0) return std::nullopt;
    DifferenceOptions options;
    options.edge_margin_px = kRimPx;
    options.noise_sd = looked.noise_sd;
    options.correct_light = true;
    const Difference compared = difference(looked.grey, reference, looked.shape, options);
    if (compared.face.runs.empty()) return std::nullopt;
    return patches_of(compared, looked.shape, mean_brightness(looked.grey, compared.face));
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

  static std::vector<float> darkest_by_zone(const Patches& patches, const FaceShape& shape) {
    const FaceZones zones;
    std::vector<float> darkest(static_cast<std::size_t>(zones.count()),
                               std::numeric_limits<float>::quiet_NaN());
    const double last_mm = std::max(shape.length_at(0), shape.length_at(shape.width_px() - 1));
    for (int u = 0; u < patches.mean.cols; u += 2) {
      const FaceColumn& column = shape.columns()[static_cast<std::size_t>(u)];
      const double along_mm = shape.length_at(u);
      const int piece = static_cast<int>(along_mm / zones.piece_mm);
      if (!column.valid || piece >= zones.pieces || along_mm < kEndMm ||
          along_mm > last_mm - kEndMm)
        continue;
      const double height = (column.lower_v - column.upper_v) / FaceZones::kAcross;
      for (int v = 0; v < patches.mean.rows; v += 2) {
        const float x = patches.standing_out.at<float>(v, u);
        if (!std::isfinite(x)) continue;
        const int third =
            std::clamp(static_cast<int>((v - column.upper_v) / height), 0, FaceZones::kAcross - 1);
        float& here = darkest[static_cast<std::size_t>(piece * FaceZones::kAcross + third)];
        here = std::isfinite(here) ? std::max(here, x) : x;
      }
    }
    return darkest;
  }

  const ReferenceLibrary& library_;
  const std::vector<Markers>& numbered_;
  std::size_t gap_;
};

/// By zone, how dark a patch may be: what the zone's patches usually show and how far they scatter.
std::vector<double> limits_of(const std::vector<StudiedFrame>& frames) {
  const FaceZones zones;
  std::vector<double> limits(static_cast<std::size_t>(zones.count()), kDarker);
  for (std::size_t zone = 0; zone < limits.size(); ++zone) {
    std::vector<float> values;
    for (const StudiedFrame& frame : frames)
      if (frame.compared && std::isfinite(frame.darkest[zone]))
        values.push_back(frame.darkest[zone]);
    const float median = upper_median(values);
    for (float& value : values) value = std::abs(value - median);
    const double sd = 1.4826 * static_cast<double>(upper_median(values));
    limits[zone] = std::max(kDarker, static_cast<double>(median) + kSigmas * sd);
  }
  return limits;
}

std::optional<DentedFrame> dent_in(const StudiedFrame& frame, const std::vector<double>& limits) {
  std::optional<DentedFrame> dent;
  if (!frame.compared) return dent;
  for (std::size_t zone = 0; zone < limits.size(); ++zone) {
    const auto darker = static_cast<double>(frame.darkest[zone]);
    if (!(darker > limits[zone]) || (dent && darker < dent->darker)) continue;
    dent = DentedFrame{darker, FaceZones().along_mm(static_cast<int>(zone))};
  }
  return dent;
}

/// Frames that could be compared with no other and lie between dented ones in time, or next to
/// them, count as dented as well.
void spread_to_neighbours(RecordingStudy& study) {
  const auto pass = [&](std::size_t from, std::size_t to) {
    if (study.dented[from] && !study.dented[to] && !study.frames[to].compared)
      study.dented[to] = study.dented[from];
  };
  for (std::size_t i = 1; i < study.frames.size(); ++i) pass(i - 1, i);
  for (std::size_t i = study.frames.size(); i-- > 1;) pass(i, i - 1);
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
                                       const FrameOfRecording& frame,
                                       double frames_per_s,
                                       const Finger& finger,
                                       const Camera& camera,
                                       const Job& job) {
  const std::size_t count = library.frame_count();
  const Study study(library, numbered, frames_per_s);
  RecordingStudy result;
  const std::vector<char> none(count, 0);
  const auto looked_at = [&](std::size_t index) -> Result<std::optional<Looked>> {
    const auto grey = frame(static_cast<std::size_t>(library.frame_numbers()[index]));
    if (!grey) return grey.error();
    return look(*grey, camera, finger);
  };
  for (std::size_t i = 0; i < count; ++i) {
    if (job.stop_requested())
      return Error{en::say("stopped before the recording was compared"), "", ""};
    job.report(static_cast<double>(i) / static_cast<double>(count),
               en::say("comparing frame {} of {}", i + 1, count));
    const auto looked = looked_at(i);
    if (!looked) return looked.error();
    StudiedFrame studied;
    studied.number = library.frame_numbers()[i];
    if (*looked) studied = study.frame(i, **looked, none);
    result.frames.push_back(std::move(studied));
  }
  const std::vector<double> limits = limits_of(result.frames);
  std::vector<char> suspects(count, 0);
  for (std::size_t i = 0; i < count; ++i) {
    result.dented.push_back(dent_in(result.frames[i], limits));
    suspects[i] = result.dented[i].has_value();
  }
  // Suspects are looked at again without each other: an untouched frame that was compared with
  // dented ones is none.
  for (std::size_t i = 0; i < count; ++i) {
    if (!suspects[i]) continue;
    const auto looked = looked_at(i);
    if (!looked) return looked.error();
    StudiedFrame again = study.frame(i, **looked, suspects);
    if (!again.compared) continue;
    result.dented[i] = dent_in(again, limits);
    result.frames[i] = std::move(again);
  }
  spread_to_neighbours(result);
  std::vector<double> errors, nearest;
  for (std::size_t i = 0; i < count; ++i) {
    if (result.dented[i] || !result.frames[i].compared) continue;
    errors.push_back(result.frames[i].error);
    nearest.push_back(result.frames[i].nearest_error);
  }
  result.error_median = part_of(errors, 0.5);
  result.error_p95 = part_of(errors, 0.95);
  result.nearest_error_median = part_of(nearest, 0.5);
  return result;
}

}  // namespace alltact
