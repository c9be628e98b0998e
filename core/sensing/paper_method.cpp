#include "core/sensing/paper_method.h"

#include "core/numerics/chebyshev.h"
#include "core/numerics/image_noise.h"
#include "core/numerics/linear_algebra.h"
#include "core/recording/video_file.h"
#include "core/sensing/contact/finger_contact.h"
#include "core/sensing/depth/depth_map.h"
#include "core/sensing/depth/depth_sd.h"
#include "core/sensing/frame_result.h"
#include "core/sensing/markers/marker_detector.h"
#include "core/sensing/markers/marker_tracker.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>

#include <opencv2/imgproc.hpp>

namespace alltact {
namespace {

Error unsuitable_finger(Message what, const FingerSnapshot& finger) {
  return {std::move(what), (finger.folder / Finger::kFileName).string(),
          en::say("our own method, which needs no dots, or a recording of a finger that has them")};
}

DifferenceOptions paper_difference_options(double noise_sd) {
  DifferenceOptions options;
  options.smoothing = smoothing_of(0.0);
  options.correct_light = false;
  options.noise_sd = noise_sd;
  return options;
}

}  // namespace

Result<PaperMethod> PaperMethod::create(const FingerSnapshot& finger, const Job& job) {
  if (finger.finger.face.kind == FaceKind::kFlat) {
    auto untouched = ReferenceLibrary::load(finger, job);
    if (!untouched) return untouched.error();
    return flat(std::move(untouched).value(), finger);
  }
  const auto& files = finger.finger.reference;
  if (!files || files->video.empty())
    return Error{en::say("the finger has no reference recording"),
                 (finger.folder / Finger::kFileName).string(),
                 en::say("alltact reference with a video of the untouched finger bending")};
  if (finger.finger.markers.per_row < 1 || files->positions)
    return unsuitable_finger(
        en::say("the source paper's method chooses its reference by the markers, and this finger "
                "has none"),
        finger);
  if (!finger.finger.markers.missing.empty())
    return unsuitable_finger(en::say("the source paper's method sorts two full rows, and {} of "
                                     "this finger's dots are missing",
                                     finger.finger.markers.missing.size()),
                             finger);
  auto read = PaperReference::read(finger.folder / files->video, finger.finger, finger.camera, job);
  if (!read) return read.error();
  PaperMethod method(finger);
  method.reference_ = std::make_shared<const PaperReference>(std::move(read).value());
  return method;
}

PaperMethod PaperMethod::flat(ReferenceLibrary untouched, const FingerSnapshot& finger) {
  PaperMethod method(finger);
  method.plane_ = FaceShape::plane(finger.camera, finger.finger.face);
  method.untouched_ = std::move(untouched);
  return method;
}

PaperMethod PaperMethod::with(std::optional<Mapping> mapping) const {
  PaperMethod other = *this;
  other.mapping_ = std::move(mapping);
  other.forget();
  return other;
}

Result<FrameResult> PaperMethod::measure(const FramePtr& frame) {
  StopWatch watch;
  FrameResult result;
  result.frame = frame;
  auto grey = oriented_for(finger_.camera, frame->grey, en::say("the image"), frame->origin,
                           en::say("an image of the size that the finger was calibrated with"));
  if (!grey) return grey.error();
  result.grey = std::move(grey).value();
  watch.lap(result.times_ms.prepare);
  const bool has_face = find_face(result);
  watch.lap(result.times_ms.global);
  const bool has_reference = has_face && find_reference(result);
  watch.lap(result.times_ms.reference);
  if (has_reference) find_depth(result);
  watch.lap(result.times_ms.local);
  if (result.depth) find_regions(result);
  watch.lap(result.times_ms.contact);
  watch.total(result.times_ms.total);
  return result;
}

// Finds the edges and fits the face.
bool PaperMethod::find_face(FrameResult& result) const {
  if (plane_) {
    result.shape = plane_;
    return true;
  }
  const auto face = PaperFace::fit(paper_edges(result.grey), camera_, finger_.face);
  auto shape = face ? face->shape(camera_, finger_.face) : Result<FaceShape>(face.error());
  if (!shape) {
    result.problems.push_back(en::say("{}.", shape.error().message()));
    return false;
  }
  result.shape = std::move(shape).value();
  return true;
}

// Finds the markers and the recorded frame whose markers lie nearest.
bool PaperMethod::find_reference(FrameResult& result) {
  if (untouched_) {
    result.reference = untouched_->reference_for({}, *plane_, ReferenceMethod::kSingle);
    return true;
  }
  result.markers = paper_markers(result.grey, *result.shape, finger_.markers,
                                 last_ ? &*last_ : &reference_->frame(0).markers);
  if (!result.markers) {
    result.problems.push_back(
        en::say("fewer than two dots of a row are visible; the source paper's method cannot infer "
                "the others: uncover and light the dots on the side faces"));
    return false;
  }
  last_ = result.markers;
  const auto nearest = reference_->nearest(*result.markers);
  const PaperReference::Recorded& recorded =
      reference_->frame(static_cast<std::size_t>(nearest.row));
  cv::Mat grey;
  recorded.grey.convertTo(grey, CV_32F);
  result.reference.emplace();
  result.reference->image = ReferenceImage(grey);
  result.reference->frame = recorded.number;
  result.reference->distance_px = nearest.distance_px;
  return true;
}

void PaperMethod::find_depth(FrameResult& result) const {
  const DifferenceOptions options = paper_difference_options(image_noise_sd(result.grey));
  if (mapping_) {
    result.depth = depth_map(result.grey, *result.reference, *result.shape, options, *mapping_);
    return;
  }
  result.difference = difference(result.grey, *result.reference, *result.shape, options);
  result.problems.push_back(
      en::say("the finger is not calibrated: calibrate it with ball presses"));
}

void PaperMethod::find_regions(FrameResult& result) const {
  RegionOptions options;
  options.noise_mm = result.depth->noise_mm;
  DepthErrorModel error(*result.depth, *result.reference, *result.shape, *mapping_);
  options.untouched = [&](int u, int v) { return error.untouched(u, v); };
  options.pressed = [&](int u, int v, double mm) { return error.of_depth(u, v, mm); };
  result.regions = contact_regions(*result.depth, *result.shape, finger_.face, options);
}

namespace {

constexpr int kStripPx = 32;
constexpr double kMinContrast = 16;  // of a strip's bright part over its dark part, grey levels
constexpr int kProfileDegree = 5;
constexpr double kUnseen = std::numeric_limits<double>::quiet_NaN();

/// Otsu's threshold of a strip; nullopt where all of it is dark or all of it is bright.
std::optional<double> threshold_of_strip(const cv::Mat& strip) {
  cv::Mat ignored;
  const double level = cv::threshold(strip, ignored, 0, 255, cv::THRESH_BINARY | cv::THRESH_OTSU);
  const cv::Mat bright = strip > level;
  const cv::Scalar inside = cv::mean(strip, bright), outside = cv::mean(strip, ~bright);
  if (!(inside[0] - outside[0] >= kMinContrast)) return std::nullopt;
  return level;
}

cv::Mat binarised(const cv::Mat& grey) {
  cv::Mat binary(grey.size(), CV_8UC1, cv::Scalar(0));
  for (int first = 0; first < grey.cols; first += kStripPx) {
    const cv::Rect columns(first, 0, std::min(kStripPx, grey.cols - first), grey.rows);
    const auto level = threshold_of_strip(grey(columns));
    if (level) cv::compare(grey(columns), *level, binary(columns), cv::CMP_GT);
  }
  return binary;
}

/// Chebyshev polynomial over x, fitted by linear regression.
class PaperCurve {
 public:
  PaperCurve(const std::vector<double>& x, const std::vector<double>& y, int degree) {
    const auto [lowest, highest] = std::minmax_element(x.begin(), x.end());
    middle_ = 0.5 * (*lowest + *highest);
    half_ = std::max(1e-9, 0.5 * (*highest - *lowest));
    const auto n = static_cast<Eigen::Index>(x.size());
    Eigen::MatrixXd design(n, degree + 1);
    for (Eigen::Index i = 0; i < n; ++i)
      design.row(i) = chebyshev_row(at(x[static_cast<std::size_t>(i)]), degree + 1);
    values_ = least_squares(design, Eigen::Map<const Eigen::VectorXd>(y.data(), n));
    slopes_ = chebyshev_derivative(values_);
  }
  [[nodiscard]] double value(double x) const { return chebyshev_value(values_, at(x)); }
  [[nodiscard]] double slope(double x) const { return chebyshev_value(slopes_, at(x)) / half_; }

 private:
  [[nodiscard]] double at(double x) const { return (x - middle_) / half_; }
  double middle_ = 0, half_ = 1;
  Eigen::VectorXd values_, slopes_;
};

/// z where the line of sight x = across z meets the profile z = P(x). NaN where Newton's method
/// does not converge from the column's own z.
double intersect_profile(const PaperCurve& profile, double across, double z_mm) {
  for (int step = 0; step < 20; ++step) {
    const double off = profile.value(across * z_mm) - z_mm;
    const double slope = across * profile.slope(across * z_mm) - 1.0;
    const double move = off / slope;
    if (!std::isfinite(move)) return kUnseen;
    z_mm -= move;
    if (std::abs(move) < 1e-9) return z_mm > 0.0 ? z_mm : kUnseen;
  }
  return kUnseen;
}

Error paper_face_error(Message what) {
  return {
      std::move(what), en::say("the source paper's method"),
      en::say(
          "an image in which the entire face is brighter than its side faces, or our own method")};
}

}  // namespace

PaperEdges paper_edges(const cv::Mat& grey) {
  PaperEdges edges;
  edges.upper_v.assign(static_cast<std::size_t>(grey.cols), kUnseen);
  edges.lower_v = edges.upper_v;
  cv::Mat labels, parts, middles;
  const int count =
      cv::connectedComponentsWithStats(binarised(grey), labels, parts, middles, 4, CV_32S);
  int face = 0;
  for (int part = 1; part < count; ++part)
    if (face == 0 || parts.at<int>(part, cv::CC_STAT_AREA) > parts.at<int>(face, cv::CC_STAT_AREA))
      face = part;
  if (face == 0) return edges;
  std::vector<int> first(static_cast<std::size_t>(grey.cols), -1), last = first;
  for (int v = 0; v < grey.rows; ++v) {
    const int* row = labels.ptr<int>(v);
    for (int u = 0; u < grey.cols; ++u) {
      if (row[u] != face) continue;
      const auto column = static_cast<std::size_t>(u);
      if (first[column] < 0) first[column] = v;
      last[column] = v;
    }
  }
  for (std::size_t u = 0; u < first.size(); ++u) {
    if (first[u] <= 0 || last[u] >= grey.rows - 1 || last[u] == first[u]) continue;
    edges.upper_v[u] = first[u] - 0.5;
    edges.lower_v[u] = last[u] + 0.5;
    ++edges.seen;
  }
  return edges;
}

Result<PaperFace> PaperFace::fit(const PaperEdges& edges, const Camera& camera, const Face& face) {
  if (!camera.is_perspective())
    return paper_face_error(
        en::say("the shape of a Fin Ray needs a perspective camera, not an orthographic one"));
  const std::size_t width = edges.upper_v.size();
  if (5 * edges.seen < static_cast<int>(width))
    return paper_face_error(
        en::say("the binarised image shows both edges of the face in {} of {} columns; at least a "
                "fifth is needed",
                edges.seen, width));
  std::vector<double> x_mm, z_mm, middle;
  std::vector<std::size_t> columns;
  for (std::size_t u = 0; u < width; ++u) {
    if (!std::isfinite(edges.upper_v[u])) continue;
    const auto upper = camera.unproject({static_cast<double>(u), edges.upper_v[u]});
    const auto lower = camera.unproject({static_cast<double>(u), edges.lower_v[u]});
    if (!upper || !lower) continue;
    const Eigen::Vector2d a = upper->direction.head<2>() / upper->direction.z(),
                          b = lower->direction.head<2>() / lower->direction.z();
    const double z = face.width_mm / (b.y() - a.y());  // fy W / (v2 - v1)
    if (!(z > 0.0) || !std::isfinite(z)) continue;
    columns.push_back(u);
    z_mm.push_back(z);
    x_mm.push_back(0.5 * (a.x() + b.x()) * z);
    middle.push_back(0.5 * (a.y() + b.y()));
  }
  if (columns.size() < std::size_t{4} * (kProfileDegree + 1))
    return paper_face_error(en::say("the edges of the face give no distance"));
  const PaperCurve profile(x_mm, z_mm, kProfileDegree);
  const std::vector<double> column_u(columns.begin(), columns.end());
  const PaperCurve line(column_u, middle, kProfileDegree);
  PaperFace fitted;
  fitted.z_mm_.assign(width, kUnseen);
  fitted.middle_y_.assign(width, kUnseen);
  bool any = false;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const double z = intersect_profile(profile, x_mm[i] / z_mm[i], z_mm[i]);
    fitted.z_mm_[columns[i]] = z;
    fitted.middle_y_[columns[i]] = line.value(column_u[i]);
    any = any || std::isfinite(z);
  }
  if (!any) return paper_face_error(en::say("the edges of the face give no distance"));
  return fitted;
}

Result<FaceShape> PaperFace::shape(const Camera& camera, const Face& face) const {
  constexpr int kStep = 4, kDegree = 12;
  constexpr double kSdPx = 0.29;  // of an edge quantised to integer pixels: 1 / sqrt(12)
  FaceEdges edges;
  const auto add = [&](Edge& edge, const Eigen::Vector2d* pixel) {
    edge.v.push_back(pixel ? pixel->y() : 0.0);
    edge.sd.push_back(kSdPx);
    edge.valid.push_back(static_cast<char>(pixel != nullptr));
  };
  for (std::size_t u = 0; u < z_mm_.size(); u += kStep) {
    const double z = z_mm_[u];
    edges.u.push_back(static_cast<double>(u));
    std::optional<Eigen::Vector2d> upper, lower;
    if (const auto pixel = camera.unproject({static_cast<double>(u), camera.parameters().cy_px});
        pixel && std::isfinite(z)) {
      const double x = z * pixel->direction.x() / pixel->direction.z();
      const double y = z * middle_y_[u];
      upper = camera.project({x, y - 0.5 * face.width_mm, z});
      lower = camera.project({x, y + 0.5 * face.width_mm, z});
    }
    add(edges.upper, upper && lower ? &*upper : nullptr);
    add(edges.lower, upper && lower ? &*lower : nullptr);
  }
  return FaceShape::fit(edges, camera, face, kDegree, std::numeric_limits<double>::infinity());
}

std::optional<Markers> paper_markers(const cv::Mat& grey, const FaceShape& shape,
                                     const MarkerRows& rows, const Markers* before) {
  const auto found = MarkerDetector(rows)(grey, shape);
  return paper_rows(found.dots, rows.per_row, shape.base_at_low_u(), before);
}

Result<PaperReference> PaperReference::read(const std::filesystem::path& video,
                                            const Finger& finger, const Camera& camera,
                                            const Job& job, std::size_t memory_limit_bytes) {
  auto file = VideoFile::open(video, job);
  if (!file) return file.error();
  const std::size_t count = file->frame_count();
  const std::size_t one = static_cast<std::size_t>(camera.size().area());
  const std::size_t step = 1 + one * (count - 1) / std::max(one, memory_limit_bytes);
  PaperReference reference;
  std::optional<Markers> before;
  for (std::size_t number = 0; number < count; number += step) {
    if (job.stop_requested())
      return Error{en::say("stopped while the recording was read"), video.string(), ""};
    job.report(static_cast<double>(number) / static_cast<double>(count),
               en::say("reading the recording as the source paper does"));
    const auto frame = file->frame(number);
    if (!frame) return frame.error();
    const auto grey =
        oriented_for(finger.camera, (*frame)->grey, en::say("the reference recording"),
                     video.string(), en::say("recording it anew with this camera"));
    if (!grey) return grey.error();
    const auto face = PaperFace::fit(paper_edges(*grey), camera, finger.face);
    if (!face) continue;
    const auto shape = face->shape(camera, finger.face);
    if (!shape) continue;
    auto markers = paper_markers(*grey, *shape, finger.markers, before ? &*before : nullptr);
    if (!markers) continue;
    before = markers;
    reference.frames_.push_back({grey->clone(), std::move(*markers), static_cast<int>(number)});
  }
  if (reference.frames_.empty())
    return Error{
        en::say("the source paper's method finds face and markers in none of {} frames", count),
        video.string(), en::say("our own method, or a recording with brighter dots")};
  return reference;
}

NearestFrame PaperReference::nearest(const Markers& markers) const {
  NearestFrame best{0, std::numeric_limits<double>::infinity()};
  for (std::size_t i = 0; i < frames_.size(); ++i) {
    const Markers& there = frames_[i].markers;
    assert(there.size() == markers.size());
    double sum = 0;
    for (std::size_t m = 0; m < markers.size(); ++m)
      sum += std::hypot(markers[m].u - there[m].u, markers[m].v - there[m].v);
    if (sum < best.distance_px) best = {static_cast<int>(i), sum};
  }
  best.distance_px /= static_cast<double>(std::max<std::size_t>(1, markers.size()));
  return best;
}

}  // namespace alltact
