#include "calibration/study/study_world.h"
#include "core/io/picture.h"
#include "core/numerics/philox.h"
#include "core/numerics/picture_noise.h"
#include "core/recording/video_file.h"
#include "core/sensing/pipeline.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

namespace alltact {
namespace {

constexpr double kUsualBallRadiusMm = 3.0;
constexpr double kDeepestPart = 0.8;      // of what the mapping was calibrated to
constexpr double kShallowestMm = 0.15;    // still to be told from nothing
constexpr std::size_t kMostGap = 5;       // frames on either side of a painted one, left out too
constexpr std::size_t kLeastFrames = 3;   // painted
constexpr std::uint32_t kMostTries = 20;  // to place a ball

/// Numbers of one picture, from its own counter.
class Draws {
 public:
  Draws(std::uint64_t seed, std::uint32_t frame) : seed_(seed), frame_(frame) {}
  double uniform() { return philox_uniform(seed_, "study", frame_, next_++); }
  /// Box and Muller.
  double normal() {
    const double radius = std::sqrt(-2 * std::log(uniform()));
    return radius * std::cos(2 * M_PI * uniform());
  }

 private:
  std::uint64_t seed_;
  std::uint32_t frame_;
  std::uint32_t next_ = 0;
};

struct PaintedBall {
  Eigen::Vector3d centre_mm;
  double radius_mm;
};

// Along a line from `from` in the unit direction `way`: where it first enters the ball.
std::optional<double> way_to_ball(const PaintedBall& ball,
                                  const Eigen::Vector3d& from,
                                  const Eigen::Vector3d& way) {
  const Eigen::Vector3d to_centre = ball.centre_mm - from;
  const double along = to_centre.dot(way);
  const double off2 = (to_centre - along * way).squaredNorm();
  const double inside = ball.radius_mm * ball.radius_mm - off2;
  if (inside <= 0) return std::nullopt;
  return along - std::sqrt(inside);
}

// How much thinner the layer is over a view-face point: in the sense of the mapping, and along z.
struct Thinning {
  double of_mapping_mm = 0, along_z_mm = 0;
};

Thinning thinning(const FaceShape::Local& local,
                  const PaintedBall& ball,
                  double layer_mm,
                  MappingAlong along) {
  Thinning thinner;
  const double layer_z_mm = layer_mm / local.cos_incline;
  if (const auto z = way_to_ball(ball, local.view_point_mm, Eigen::Vector3d::UnitZ()))
    thinner.along_z_mm = std::clamp(layer_z_mm - *z, 0.0, layer_z_mm);
  switch (along) {
    case MappingAlong::kZ:
      thinner.of_mapping_mm = thinner.along_z_mm;
      break;
    case MappingAlong::kProjected:
      thinner.of_mapping_mm = thinner.along_z_mm * local.cos_incline;
      break;
    case MappingAlong::kNormal:
      if (const auto n = way_to_ball(ball, local.view_point_mm, local.normal))
        thinner.of_mapping_mm = std::clamp(layer_mm - *n, 0.0, layer_mm);
      break;
  }
  return thinner;
}

class Painter {
 public:
  Painter(const FingerSnapshot& finger, double radius_mm)
      : finger_(finger), mapping_(*finger.mapping), radius_mm_(radius_mm) {
    deepest_mm_ = std::min(kDeepestPart * mapping_.depth_mm(mapping_.x_max()),
                           kDeepestPart * finger.finger.face.layer_mm);
  }

  /// nullopt: no ball found its place on this face.
  [[nodiscard]] std::optional<StudyFrame> painted(const cv::Mat& grey,
                                                  const FaceShape& shape,
                                                  Draws& draws,
                                                  FaceZone zone) const {
    for (std::uint32_t tried = 0; tried < kMostTries; ++tried)
      if (const auto ball = ball_on(shape, draws, zone)) return painted_with(*ball, grey, shape);
    return std::nullopt;
  }

 private:
  struct Placed {
    PaintedBall ball;
    FaceZone zone;
  };

  // At a z drawn evenly within the zone; where all columns have the same, at a column.
  static std::optional<int> column_in(FaceZone zone, const FaceShape& shape, Draws& draws) {
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

  [[nodiscard]] std::optional<Placed> ball_on(const FaceShape& shape,
                                              Draws& draws,
                                              FaceZone zone) const {
    const auto found = column_in(zone, shape, draws);
    if (!found) return std::nullopt;
    const int u = *found;
    const FaceColumn& column = shape.columns()[static_cast<std::size_t>(u)];
    const double v =
        column.upper_v + (0.2 + 0.6 * draws.uniform()) * (column.lower_v - column.upper_v);
    const auto local = shape.at(u, v);
    if (!local) return std::nullopt;
    const double depth_mm = kShallowestMm + draws.uniform() * (deepest_mm_ - kShallowestMm);
    const double layer_mm = finger_.finger.face.layer_mm;
    const Eigen::Vector3d outer_mm = local->view_point_mm + layer_mm * local->normal;
    return Placed{{outer_mm + (radius_mm_ - depth_mm) * local->normal, radius_mm_}, zone};
  }

  [[nodiscard]] StudyFrame painted_with(const Placed& placed,
                                        const cv::Mat& grey,
                                        const FaceShape& shape) const {
    constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
    const MappingParameters& parameters = mapping_.parameters();
    StudyFrame frame;
    frame.depth_mm = cv::Mat(grey.size(), CV_32FC1, cv::Scalar(kNaN));
    frame.zone = placed.zone;
    cv::Mat dented = grey.clone();
    for (int v = 0; v < grey.rows; ++v)
      for (int u = 0; u < grey.cols; ++u) {
        const auto local = shape.at(u, v);
        if (!local) continue;
        const Thinning thinner =
            thinning(*local, placed.ball, finger_.finger.face.layer_mm, parameters.along);
        frame.depth_mm.at<float>(v, u) = static_cast<float>(thinner.along_z_mm);
        if (thinner.of_mapping_mm <= 0) continue;
        const double factor =
            parameters.variation.is_none() ? 1.0 : parameters.variation.at(shape.place_mm(u, v));
        const double x = mapping_.difference_at(thinner.of_mapping_mm / factor);
        dented.at<std::uint8_t>(v, u) =
            static_cast<std::uint8_t>(std::lround(grey.at<std::uint8_t>(v, u) * (1 - x)));
      }
    auto picture = std::make_shared<Frame>();
    picture->grey = std::move(dented);
    frame.picture = std::move(picture);
    return frame;
  }

  const FingerSnapshot& finger_;
  const Mapping& mapping_;
  double radius_mm_;
  double deepest_mm_ = 0;
};

double ball_radius_mm(const FingerSnapshot& finger) {
  return finger.presses.ball_radius_mm > 0 ? finger.presses.ball_radius_mm : kUsualBallRadiusMm;
}

FaceZone zone_of_frame(std::size_t number) {
  return static_cast<FaceZone>(number % kFaceZones);
}

// Rows of the table that are painted, evenly over its time, and those that are left in.
struct Split {
  std::vector<std::size_t> painted, kept;
};

Split split_of(std::size_t rows, std::size_t painted) {
  Split split;
  painted = std::min(painted, rows / 6);
  if (painted == 0) return split;
  const std::size_t gap = std::min(kMostGap, (rows / (3 * painted) - 1) / 2);
  std::vector<char> left_out(rows, 0);
  for (std::size_t i = 0; i < painted; ++i) {
    const std::size_t row = (2 * i + 1) * rows / (2 * painted);
    split.painted.push_back(row);
    for (std::size_t k = row - std::min(row, gap); k <= std::min(row + gap, rows - 1); ++k)
      left_out[k] = 1;
  }
  for (std::size_t row = 0; row < rows; ++row)
    if (!left_out[row]) split.kept.push_back(row);
  return split;
}

MarkerTable rows_of(const MarkerTable& table, const std::vector<std::size_t>& rows) {
  MarkerTable part;
  part.typical = table.typical;
  part.layouts.resize(static_cast<Eigen::Index>(rows.size()), table.layouts.cols());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    part.frames.push_back(table.frames[rows[i]]);
    part.seen.push_back(table.seen[rows[i]]);
    part.layouts.row(static_cast<Eigen::Index>(i)) =
        table.layouts.row(static_cast<Eigen::Index>(rows[i]));
  }
  return part;
}

Error too_few(const FingerSnapshot& finger) {
  return {en::say("too few pictures of the reference recording show the face"),
          finger.folder.string(),
          en::say("record the finger bending through all its poses")};
}

Error stopped_painting() {
  return {en::say("stopped before the study was over"), "", ""};
}

/// Untouched pictures and the library without them.
struct Untouched {
  ReferenceLibrary library;
  std::vector<cv::Mat> pictures;
};

Result<Untouched> untouched_of_recording(const FingerSnapshot& snapshot,
                                         const StudyWorldOptions& options,
                                         const Job& job) {
  const Finger& finger = snapshot.finger;
  if (!finger.reference || finger.reference->video.empty() || finger.reference->markers.empty())
    return Error{en::say("the finger has no reference recording"),
                 (snapshot.folder / Finger::kFileName).string(),
                 en::say("record the bending, untouched finger and make its reference")};
  const auto table =
      MarkerTable::load(snapshot.folder / finger.reference->markers, finger.marker_count());
  if (!table) return table.error();
  const auto file = snapshot.folder / finger.reference->video;
  const Split split = split_of(table->frames.size(), static_cast<std::size_t>(options.frames));
  if (split.painted.size() < kLeastFrames) return too_few(snapshot);
  auto library = ReferenceLibrary::from_recording(file, rows_of(*table, split.kept), snapshot, job);
  if (!library) return library.error();
  auto video = VideoFile::open(file, job);
  if (!video) return video.error();
  Untouched untouched{std::move(library).value(), {}};
  for (const std::size_t row : split.painted) {
    if (job.stop_requested()) return stopped_painting();
    const auto frame = video->frame(static_cast<std::size_t>(table->frames[row]));
    if (!frame) return frame.error();
    auto grey = oriented_for(
        finger.camera, (*frame)->grey, en::say("the recording's picture"), file.string(), "");
    if (!grey) return grey.error();
    untouched.pictures.push_back(grey->clone());
  }
  return untouched;
}

// The one picture there is, with as much more noise as two pictures differ by.
Result<Untouched> untouched_of_flat(const FingerSnapshot& snapshot,
                                    const StudyWorldOptions& options,
                                    const Job& job) {
  auto library = ReferenceLibrary::load(snapshot, job);
  if (!library) return library.error();
  if (!snapshot.finger.reference) return too_few(snapshot);
  const auto file = snapshot.folder / snapshot.finger.reference->image;
  const auto raw = read_grey_picture(file);
  if (!raw) return raw.error();
  const auto turned = oriented_for(
      snapshot.finger.camera, *raw, en::say("the untouched picture"), file.string(), "");
  if (!turned) return turned.error();
  const cv::Mat& grey = *turned;
  const double sd = std::sqrt(2.0) * picture_noise_sd(grey);
  Untouched untouched{std::move(library).value(), {}};
  for (int number = 0; number < options.frames; ++number) {
    if (job.stop_requested()) return stopped_painting();
    Draws draws(~options.seed, static_cast<std::uint32_t>(number));
    cv::Mat noisy = grey.clone();
    for (int v = 0; v < noisy.rows; ++v)
      for (int u = 0; u < noisy.cols; ++u) {
        auto& level = noisy.at<std::uint8_t>(v, u);
        level = cv::saturate_cast<std::uint8_t>(level + sd * draws.normal());
      }
    untouched.pictures.push_back(noisy);
  }
  return untouched;
}

// Its pictures are turned already.
Result<FingerPtr> upright(const FingerSnapshot& finger) {
  auto turned = std::make_shared<FingerSnapshot>(finger);
  turned->finger.camera.orientation = Orientation::kNone;
  auto camera = Camera::create(turned->finger.camera);
  if (!camera) return camera.error();
  turned->camera = std::move(camera).value();
  return FingerPtr(std::move(turned));
}

}  // namespace

Result<StudyWorld> painted_world(const FingerPtr& finger,
                                 const StudyWorldOptions& options,
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
  StudyWorld world{en::say("balls painted into untouched pictures of {}", finger->finger.name),
                   false,
                   std::move(turned).value(),
                   untouched->library,
                   {},
                   0};
  Pipeline pipeline = Pipeline::over(world.library, *world.finger, PipelineSettings{});
  const Painter painter(*finger, ball_radius_mm(*finger));
  for (std::size_t i = 0; i < untouched->pictures.size(); ++i) {
    if (job.stop_requested()) return stopped_painting();
    auto frame = std::make_shared<Frame>();
    frame->grey = untouched->pictures[i];
    pipeline.forget();
    const auto seen = pipeline(frame);
    if (!seen || !seen->shape) continue;
    Draws draws(options.seed, static_cast<std::uint32_t>(i));
    if (auto painted = painter.painted(seen->grey, *seen->shape, draws, zone_of_frame(i)))
      world.frames.push_back(std::move(*painted));
  }
  if (world.frames.size() < kLeastFrames) return too_few(*finger);
  world.checksum = checksum_of(world.frames);
  return world;
}

}  // namespace alltact
