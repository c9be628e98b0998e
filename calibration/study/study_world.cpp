#include "calibration/study/study_world.h"

#include "core/finger/finger_store.h"
#include "core/numerics/checksum.h"
#include "core/numerics/image_noise.h"
#include "core/recording/video_file.h"
#include "core/sensing/contact/contact_regions.h"
#include "core/sensing/depth/depth_map.h"
#include "core/sensing/depth/light_spread.h"
#include "core/sensing/pipeline.h"
#include "core/sensing/reference/reference_library.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <vector>

#include <fmt/format.h>

namespace alltact {
namespace {

constexpr float kMinPressMm = 0.02F;

void add_image(Checksum& checksum, const cv::Mat& image) {
  const std::size_t bytes = static_cast<std::size_t>(image.cols) * image.elemSize();
  for (int row = 0; row < image.rows; ++row) checksum.add(image.ptr(row), bytes);
}

}  // namespace

std::optional<FaceZone> zone_of_press(const cv::Mat& depth_mm, const cv::Mat& view_z_mm) {
  float nearest = std::numeric_limits<float>::infinity(), farthest = -nearest;
  float greatest = kMinPressMm;
  std::optional<float> z;  // where it is deepest
  for (int v = 0; v < depth_mm.rows; ++v) {
    const auto* depth = depth_mm.ptr<float>(v);
    const auto* view_z = view_z_mm.ptr<float>(v);
    for (int u = 0; u < depth_mm.cols; ++u) {
      if (std::isnan(view_z[u])) continue;
      nearest = std::min(nearest, view_z[u]);
      farthest = std::max(farthest, view_z[u]);
      if (depth[u] > greatest) greatest = depth[u], z = view_z[u];
    }
  }
  if (!z) return std::nullopt;
  const float part = (*z - nearest) / std::max(farthest - nearest, 1e-6F);
  return static_cast<FaceZone>(std::clamp(static_cast<int>(3 * part), 0, 2));
}

std::uint64_t checksum_of(const std::vector<StudyFrame>& frames) {
  Checksum checksum;
  for (const StudyFrame& frame : frames) {
    add_image(checksum, frame.image->grey);
    add_image(checksum, frame.depth_mm);
  }
  return checksum.value();
}

namespace {

constexpr double kMaxDepthFraction = 0.8;  // of the depth range of the calibration
constexpr double kMinDepthMm = 0.15;       // still distinguishable from zero
constexpr std::uint32_t kMaxTries = 20;    // to find a valid position
constexpr double kBarRadiusPart = 0.5;     // of the ball's
constexpr double kBarHalfLengthMm = 3.0;
constexpr double kBarDepthMm = 0.5;

std::optional<double> distance_to_ball(const Eigen::Vector3d& centre_mm, double radius_mm,
                                       const Eigen::Vector3d& from,
                                       const Eigen::Vector3d& direction) {
  const Eigen::Vector3d to_centre = centre_mm - from;
  const double along = to_centre.dot(direction);
  const double off2 = (to_centre - along * direction).squaredNorm();
  const double inside = radius_mm * radius_mm - off2;
  if (inside <= 0) return std::nullopt;
  return along - std::sqrt(inside);
}

// The body's middle part, without its ends.
std::optional<double> distance_to_cylinder(const PaintedBody& body, const Eigen::Vector3d& from,
                                           const Eigen::Vector3d& direction) {
  const auto across = [&](const Eigen::Vector3d& v) -> Eigen::Vector3d {
    return v - v.dot(body.axis) * body.axis;
  };
  const Eigen::Vector3d off = across(from - body.centre_mm), step = across(direction);
  const double a = step.squaredNorm(), b = off.dot(step);
  const double root = b * b - a * (off.squaredNorm() - body.radius_mm * body.radius_mm);
  if (!(a > 1e-12) || root <= 0) return std::nullopt;
  const double t = (-b - std::sqrt(root)) / a;
  const double along = (from + t * direction - body.centre_mm).dot(body.axis);
  if (std::abs(along) > body.half_length_mm) return std::nullopt;
  return t;
}

// Thinning of the layer over a view-face point: along the mapping's direction, and along z.
struct Thinning {
  double of_mapping_mm = 0, along_z_mm = 0;
};

Thinning thinning(const FaceShape::Local& local, const PaintedBody& body, double layer_mm,
                  MappingAlong along) {
  Thinning thinner;
  const double layer_z_mm = layer_mm / local.cos_incline;
  if (const auto z = distance_to_body(body, local.view_point_mm, Eigen::Vector3d::UnitZ()))
    thinner.along_z_mm = std::clamp(layer_z_mm - *z, 0.0, layer_z_mm);
  switch (along) {
    case MappingAlong::kZ:
      thinner.of_mapping_mm = thinner.along_z_mm;
      break;
    case MappingAlong::kProjected:
      thinner.of_mapping_mm = thinner.along_z_mm * local.cos_incline;
      break;
    case MappingAlong::kNormal:
      if (const auto n = distance_to_body(body, local.view_point_mm, local.normal))
        thinner.of_mapping_mm = std::clamp(layer_mm - *n, 0.0, layer_mm);
      break;
  }
  return thinner;
}

// At a z drawn evenly within the zone; where all columns have the same z, at a random column.
std::optional<int> column_in(FaceZone zone, const FaceShape& shape, StudyDraws& draws) {
  const auto& columns = shape.columns();
  std::vector<int> valid;
  for (int u = 0; u < shape.width_px(); ++u)
    if (columns[static_cast<std::size_t>(u)].valid) valid.push_back(u);
  if (valid.empty()) return std::nullopt;
  const auto z_of = [&](int u) { return columns[static_cast<std::size_t>(u)].z_mm; };
  const auto [nearest, farthest] = std::minmax_element(
      valid.begin(), valid.end(), [&](int a, int b) { return z_of(a) < z_of(b); });
  const double part =
      (static_cast<double>(zone) + draws.uniform()) / static_cast<double>(kFaceZones);
  const double range_mm = z_of(*farthest) - z_of(*nearest);
  if (range_mm <= 0)
    return valid[static_cast<std::size_t>(part * static_cast<double>(valid.size()))];
  const double z_mm = z_of(*nearest) + part * range_mm;
  return *std::min_element(valid.begin(), valid.end(), [&](int a, int b) {
    return std::abs(z_of(a) - z_mm) < std::abs(z_of(b) - z_mm);
  });
}

// Position of the greatest depth in the ground truth.
std::optional<Eigen::Vector2d> deepest_position(const cv::Mat& depth_mm, const FaceShape& shape,
                                                const Face& face) {
  DepthMap truth;
  truth.depth_mm = depth_mm;
  truth.flags = cv::Mat::zeros(depth_mm.size(), CV_8UC1);
  truth.cells_mm = depth_cells(truth.depth_mm);
  const auto regions = contact_regions(truth, shape, face, RegionOptions{});
  if (regions.empty()) return std::nullopt;
  return regions.front().deepest_on_face_mm;
}

}  // namespace

std::optional<double> distance_to_body(const PaintedBody& body, const Eigen::Vector3d& from,
                                       const Eigen::Vector3d& direction) {
  if (body.half_length_mm <= 0)
    return distance_to_ball(body.centre_mm, body.radius_mm, from, direction);
  std::optional<double> first = distance_to_cylinder(body, from, direction);
  for (const double end : {-body.half_length_mm, body.half_length_mm}) {
    const auto there =
        distance_to_ball(body.centre_mm + end * body.axis, body.radius_mm, from, direction);
    if (there && (!first || *there < *first)) first = there;
  }
  return first;
}

struct PressPainter::Spot {
  FaceShape::Local local;
  Eigen::Vector3d outer_mm;
  double u, v;
};

PressPainter::PressPainter(const FingerSnapshot& finger, double radius_mm)
    : finger_(finger), mapping_(*finger.mapping), radius_mm_(radius_mm) {
  deepest_mm_ = std::min(kMaxDepthFraction * mapping_.depth_mm(mapping_.x_max()),
                         kMaxDepthFraction * finger.finger.face.layer_mm);
}

std::optional<PressPainter::Spot> PressPainter::spot_on(const FaceShape& shape, StudyDraws& draws,
                                                        FaceZone zone) const {
  for (std::uint32_t tried = 0; tried < kMaxTries; ++tried) {
    const auto u = column_in(zone, shape, draws);
    if (!u) continue;
    const FaceColumn& column = shape.columns()[static_cast<std::size_t>(*u)];
    const double v =
        column.upper_v + (0.2 + 0.6 * draws.uniform()) * (column.lower_v - column.upper_v);
    const auto local = shape.at(*u, v);
    if (!local) continue;
    return Spot{*local, local->view_point_mm + finger_.finger.face.layer_mm * local->normal,
                static_cast<double>(*u), v};
  }
  return std::nullopt;
}

std::optional<StudyFrame> PressPainter::ball(const cv::Mat& grey, const FaceShape& shape,
                                             StudyDraws& draws, FaceZone zone) const {
  const auto spot = spot_on(shape, draws, zone);
  if (!spot) return std::nullopt;
  const double depth_mm = kMinDepthMm + draws.uniform() * (deepest_mm_ - kMinDepthMm);
  PaintedBody body;
  body.centre_mm = spot->outer_mm + (radius_mm_ - depth_mm) * spot->local.normal;
  body.radius_mm = radius_mm_;
  StudyFrame frame = painted_with(body, zone, grey, shape);
  frame.position_mm = deepest_position(frame.depth_mm, shape, finger_.finger.face);
  return frame;
}

std::optional<StudyFrame> PressPainter::bar(const cv::Mat& grey, const FaceShape& shape,
                                            StudyDraws& draws, FaceZone zone) const {
  const double depth_mm = std::min(kBarDepthMm, deepest_mm_);
  const auto is_on_face = [&](const Eigen::Vector3d& point_mm) {
    const auto pixel = shape.camera().project(point_mm);
    return pixel && pixel->x() >= 0 && pixel->x() <= grey.cols - 1 && pixel->y() >= 0 &&
           pixel->y() <= grey.rows - 1 && shape.at(pixel->x(), pixel->y());
  };
  for (std::uint32_t tried = 0; tried < kMaxTries; ++tried) {
    const auto spot = spot_on(shape, draws, zone);
    if (!spot) continue;
    const auto plane = contact_plane(shape, {spot->u, spot->v});
    const double angle_rad = M_PI * (draws.uniform() - 0.5);
    if (!plane) continue;
    PaintedBody body;
    body.radius_mm = kBarRadiusPart * radius_mm_;
    body.half_length_mm = kBarHalfLengthMm;
    body.axis = *plane * Eigen::Vector2d(std::cos(angle_rad), std::sin(angle_rad));
    body.centre_mm = spot->outer_mm + (body.radius_mm - depth_mm) * spot->local.normal;
    // A bar that the face's end cuts off has another angle.
    const Eigen::Vector3d to_end = (body.half_length_mm + body.radius_mm) * body.axis;
    if (!is_on_face(spot->local.view_point_mm + to_end) ||
        !is_on_face(spot->local.view_point_mm - to_end))
      continue;
    StudyFrame frame = painted_with(body, zone, grey, shape);
    frame.angle_deg = 180.0 / M_PI * angle_rad;
    return frame;
  }
  return std::nullopt;
}

StudyFrame PressPainter::painted_with(const PaintedBody& body, FaceZone zone, const cv::Mat& grey,
                                      const FaceShape& shape) const {
  constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
  const MappingParameters& parameters = mapping_.parameters();
  StudyFrame frame;
  frame.depth_mm = cv::Mat(grey.size(), CV_32FC1, cv::Scalar(kNaN));
  frame.zone = zone;
  cv::Mat local_x(grey.size(), CV_64FC1, cv::Scalar(0.0));
  for (int v = 0; v < grey.rows; ++v)
    for (int u = 0; u < grey.cols; ++u) {
      const auto local = shape.at(u, v);
      if (!local) continue;
      const Thinning thinner =
          thinning(*local, body, finger_.finger.face.layer_mm, parameters.along);
      frame.depth_mm.at<float>(v, u) = static_cast<float>(thinner.along_z_mm);
      if (thinner.of_mapping_mm <= 0) continue;
      const double factor =
          parameters.variation.is_none() ? 1.0 : parameters.variation.at(shape.position_mm(u, v));
      local_x.at<double>(v, u) = mapping_.difference_at(thinner.of_mapping_mm / factor);
    }
  const cv::Mat x = with_light_spread(local_x, parameters, shape);
  cv::Mat indented = grey.clone();
  for (int v = 0; v < grey.rows; ++v)
    for (int u = 0; u < grey.cols; ++u) {
      const double here = x.at<double>(v, u);
      if (here == 0 || !std::isfinite(frame.depth_mm.at<float>(v, u))) continue;
      indented.at<std::uint8_t>(v, u) =
          cv::saturate_cast<std::uint8_t>(std::lround(grey.at<std::uint8_t>(v, u) * (1 - here)));
    }
  auto image = std::make_shared<Frame>();
  image->grey = std::move(indented);
  frame.image = std::move(image);
  return frame;
}

namespace {

constexpr double kDefaultBallRadiusMm = 3.0;
constexpr std::size_t kMaxGap = 5;        // frames on either side of a painted one, left out too
constexpr std::size_t kMinFrames = 3;     // painted
constexpr std::size_t kFramesPerBar = 4;  // one of so many shows a bar as well

// 95 % bound of the mapping's own error, from the calibration. Images painted with the mapping that
// reads them cannot show that error.
double mapping_p95_mm(const FingerSnapshot& finger) {
  constexpr int kDepths = 12;
  constexpr double kP95OfSd = 1.96, kSdOfMean = 1.2533;  // of a Gaussian
  const Mapping& mapping = *finger.mapping;
  double square = 0;
  for (int i = 1; i <= kDepths; ++i)
    square += std::pow(mapping.depth_sd_mm(mapping.x_max() * i / kDepths), 2) / kDepths;
  double sd_mm = std::sqrt(square);
  if (finger.finger.mapping_record)
    sd_mm = std::max(sd_mm, kSdOfMean * finger.finger.mapping_record->spread_mm);
  return kP95OfSd * sd_mm;
}

FaceZone zone_of_frame(std::size_t number) { return static_cast<FaceZone>(number % kFaceZones); }

// Rows of the table that are painted, evenly over its time, and rows that stay in the reference.
struct Split {
  std::vector<std::size_t> painted, retained;
};

Split split_of(std::size_t rows, std::size_t painted) {
  Split split;
  painted = std::min(painted, rows / 6);
  if (painted == 0) return split;
  const std::size_t gap = std::min(kMaxGap, (rows / (3 * painted) - 1) / 2);
  std::vector<char> left_out(rows, 0);
  for (std::size_t i = 0; i < painted; ++i) {
    const std::size_t row = (2 * i + 1) * rows / (2 * painted);
    split.painted.push_back(row);
    for (std::size_t k = row - std::min(row, gap); k <= std::min(row + gap, rows - 1); ++k)
      left_out[k] = 1;
  }
  for (std::size_t row = 0; row < rows; ++row)
    if (!left_out[row]) split.retained.push_back(row);
  return split;
}

Error too_few(const FingerSnapshot& finger) {
  return {en::say("too few images of the reference recording show the face"),
          finger.folder.string(), en::say("record the finger bending through all its poses")};
}

Error stopped_painting() { return {en::say("stopped before the study was over"), "", ""}; }

/// A recording's frames, decoded once for libraries of several image sizes, up to a memory limit.
class DecodedFrames {
 public:
  explicit DecodedFrames(VideoFile video) : video_(std::move(video)) {}
  [[nodiscard]] std::size_t count() const { return video_.frame_count(); }
  Result<cv::Mat> operator()(std::size_t number) {
    if (const auto known = greys_.find(number); known != greys_.end()) return known->second;
    const auto frame = video_.frame(number);
    if (!frame) return frame.error();
    const cv::Mat& grey = (*frame)->grey;
    if (bytes_ + grey.total() <= kMostBytes) {
      bytes_ += grey.total();
      greys_.emplace(number, grey);
    }
    return grey;
  }

 private:
  static constexpr std::size_t kMostBytes = 256U << 20U;
  VideoFile video_;
  std::map<std::size_t, cv::Mat> greys_;
  std::size_t bytes_ = 0;
};

Result<UntouchedImages> untouched_of_recording(const FingerSnapshot& snapshot,
                                               const StudyWorldOptions& options, const Job& job) {
  const Finger& finger = snapshot.finger;
  if (!finger.reference || finger.reference->video.empty() || finger.reference->markers.empty())
    return Error{en::say("the finger has no reference recording"),
                 (snapshot.folder / Finger::kFileName).string(),
                 en::say("record the untouched finger bending and create its reference")};
  const auto table =
      MarkerTable::load(snapshot.folder / finger.reference->markers, finger.marker_count());
  if (!table) return table.error();
  const auto file = snapshot.folder / finger.reference->video;
  const Split split = split_of(table->frames.size(), static_cast<std::size_t>(options.frames));
  if (split.painted.size() < kMinFrames) return too_few(snapshot);
  auto video = VideoFile::open(file, job);
  if (!video) return video.error();
  const auto frames = std::make_shared<DecodedFrames>(std::move(video).value());
  const auto library_of = [file, frames, retained = rows_of(*table, split.retained), snapshot](
                              const PipelineSettings& settings, const Job& doing) {
    const FingerSnapshot measuring = finger_as_measured(snapshot, settings);
    const auto image = [&](std::size_t number) -> Result<cv::Mat> {
      const auto grey = (*frames)(number);
      if (!grey) return grey.error();
      return image_for(measuring, *grey, en::say("the recording's image"), "", "");
    };
    return ReferenceLibrary::from_frames(
        {image, frames->count(), file, reduced_table(retained, measuring.reduced_by)},
        measuring.finger, measuring.camera, doing);
  };
  auto library = library_of({}, job);
  if (!library) return library.error();
  UntouchedImages untouched{nullptr, std::move(library).value(), {}, library_of};
  for (const std::size_t row : split.painted) {
    if (job.stop_requested()) return stopped_painting();
    const auto raw = (*frames)(static_cast<std::size_t>(table->frames[row]));
    if (!raw) return raw.error();
    auto grey =
        oriented_for(finger.camera, *raw, en::say("the recording's image"), file.string(), "");
    if (!grey) return grey.error();
    untouched.images.push_back(grey->clone());
  }
  return untouched;
}

// The single image with added noise, as much as two images differ by.
Result<UntouchedImages> untouched_of_flat(const FingerSnapshot& snapshot,
                                          const StudyWorldOptions& options, const Job& job) {
  auto library = ReferenceLibrary::load(snapshot, job);
  if (!library) return library.error();
  const auto turned = flat_reference(snapshot);
  if (!turned) return turned.error();
  const cv::Mat& grey = *turned;
  const double sd = std::sqrt(2.0) * image_noise_sd(grey);
  const auto library_of = [snapshot](const PipelineSettings& settings, const Job& doing) {
    return ReferenceLibrary::load(finger_as_measured(snapshot, settings), doing);
  };
  UntouchedImages untouched{nullptr, std::move(library).value(), {}, library_of};
  for (int number = 0; number < options.frames; ++number) {
    if (job.stop_requested()) return stopped_painting();
    StudyDraws draws(~options.seed, static_cast<std::uint32_t>(number));
    cv::Mat noisy = grey.clone();
    for (int v = 0; v < noisy.rows; ++v)
      for (int u = 0; u < noisy.cols; ++u) {
        auto& level = noisy.at<std::uint8_t>(v, u);
        level = cv::saturate_cast<std::uint8_t>(level + sd * draws.normal());
      }
    untouched.images.push_back(noisy);
  }
  return untouched;
}

// The finger with a camera whose images are already oriented.
Result<FingerPtr> upright(const FingerSnapshot& finger) {
  auto turned = std::make_shared<FingerSnapshot>(finger);
  turned->finger.camera.orientation = Orientation::kNone;
  auto camera = Camera::create(turned->finger.camera);
  if (!camera) return camera.error();
  turned->camera = std::move(camera).value();
  return FingerPtr(std::move(turned));
}

}  // namespace

double painted_radius_mm(const FingerSnapshot& finger) {
  return finger.presses.ball_radius_mm > 0 ? finger.presses.ball_radius_mm : kDefaultBallRadiusMm;
}

Result<UntouchedImages> untouched_images(const FingerPtr& finger, const StudyWorldOptions& options,
                                         const Job& job) {
  if (!finger->mapping)
    return Error{en::say("the finger is not calibrated yet"),
                 (finger->folder / Finger::kFileName).string(),
                 en::say("alltact calibrate with ball presses")};
  const bool is_flat = finger->finger.face.kind == FaceKind::kFlat;
  auto untouched = is_flat ? untouched_of_flat(*finger, options, job)
                           : untouched_of_recording(*finger, options, job);
  if (!untouched) return untouched.error();
  auto turned = upright(*finger);
  if (!turned) return turned.error();
  untouched->finger = std::move(turned).value();
  return untouched;
}

Result<StudyWorld> painted_world(const FingerPtr& finger, const StudyWorldOptions& options,
                                 const Job& job) {
  const auto untouched = untouched_images(finger, options, job);
  if (!untouched) return untouched.error();
  StudyWorld world{en::say("balls painted into untouched images of {}", finger->finger.name),
                   false,
                   untouched->finger,
                   untouched->library,
                   {},
                   0};
  Pipeline pipeline = Pipeline::with_library(world.library, *world.finger, PipelineSettings{});
  const PressPainter painter(*finger, painted_radius_mm(*finger));
  for (std::size_t i = 0; i < untouched->images.size(); ++i) {
    if (job.stop_requested()) return stopped_painting();
    auto frame = std::make_shared<Frame>();
    frame->grey = untouched->images[i];
    pipeline.forget();
    const auto seen = pipeline(frame);
    if (!seen || !seen->shape) continue;
    StudyDraws draws(options.seed, static_cast<std::uint32_t>(i));
    if (auto painted = painter.ball(seen->grey, *seen->shape, draws, zone_of_frame(i)))
      world.frames.push_back(std::move(*painted));
    if (i % kFramesPerBar != 0) continue;
    if (auto painted = painter.bar(seen->grey, *seen->shape, draws, zone_of_frame(i)))
      world.bars.push_back(std::move(*painted));
  }
  if (world.frames.size() < kMinFrames) return too_few(*finger);
  world.mapping_p95_mm = mapping_p95_mm(*finger);
  world.library_for = untouched->library_for;
  world.checksum = checksum_of(world.frames);
  return world;
}

}  // namespace alltact
