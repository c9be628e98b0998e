#include "calibration/twin/twin_untouched.h"

#include "calibration/twin/twin_scene.h"
#include "calibration/twin/twin_solver.h"
#include "core/camera/camera.h"
#include "core/simulation/face_curve.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <Eigen/Dense>

namespace alltact {
namespace {

constexpr int kColumns = 80;                // of an image
constexpr double kBendPrior_per_mm = 1e-4;  // weight of a bend of 1 mm against residuals in mm
constexpr int kPoseUnknowns = 3;

/// A column's ray, and its intersection with the middle line.
struct MiddleRay {
  double origin_x, direction_x, z_mm, y_mm;
};

std::vector<MiddleRay> middle_rays(const FaceShape& shape) {
  std::vector<int> valid;
  for (int u = 0; u < shape.width_px(); ++u)
    if (shape.columns()[static_cast<std::size_t>(u)].valid) valid.push_back(u);
  std::vector<MiddleRay> rays;
  const std::size_t step = std::max<std::size_t>(1, valid.size() / kColumns);
  for (std::size_t i = 0; i < valid.size(); i += step) {
    const auto middle = shape.middle_at(valid[i]);
    if (!middle) continue;
    const auto pixel = shape.camera().project(middle->point_mm);
    if (!pixel) continue;
    const auto ray = shape.camera().unproject(*pixel);
    if (!ray) continue;
    rays.push_back(
        {ray->origin_mm.x(), ray->direction.x(), middle->point_mm.z(), middle->point_mm.y()});
  }
  return rays;
}

FaceCurve curve_of(const TwinPoses& poses, const TwinPose& pose) {
  FaceCurve curve(poses.base_mm, poses.incline_rad, poses.length_mm);
  curve.bend(pose.q1_mm, pose.q2_mm);
  curve.sway(pose.sway_mm);
  curve.integrate();
  return curve;
}

class PoseStudy {
 public:
  PoseStudy(TwinPoses start, std::vector<std::vector<MiddleRay>> rays)
      : start_(std::move(start)), rays_(std::move(rays)) {}

  /// Unknowns: z and y of the base, incline (0.1 rad), and three a shape.
  [[nodiscard]] TwinUnknowns unknowns() const {
    const auto n = static_cast<Eigen::Index>(3 + kPoseUnknowns * rays_.size());
    TwinUnknowns u{Eigen::VectorXd::Zero(n), Eigen::VectorXd::Constant(n, -60),
                   Eigen::VectorXd::Constant(n, 60)};
    u.start[0] = start_.base_mm.z(), u.low[0] = 1, u.high[0] = 1000;
    u.start[1] = start_.base_mm.y();
    u.start[2] = 10 * start_.incline_rad, u.low[2] = -13, u.high[2] = 13;
    return u;
  }
  [[nodiscard]] Eigen::Index residuals() const {
    std::size_t n = kPoseUnknowns * rays_.size();
    for (const auto& rays : rays_) n += 2 * rays.size();
    return static_cast<Eigen::Index>(n);
  }
  [[nodiscard]] TwinPoses at(const Eigen::VectorXd& x) const {
    TwinPoses poses = start_;
    poses.base_mm.z() = x[0];
    poses.base_mm.y() = x[1];
    poses.incline_rad = 0.1 * x[2];
    poses.poses.clear();
    for (std::size_t i = 0; i < rays_.size(); ++i) {
      const auto k = static_cast<Eigen::Index>(3 + kPoseUnknowns * i);
      poses.poses.push_back({x[k], x[k + 1], x[k + 2]});
    }
    return poses;
  }
  bool residuals_at(const Eigen::VectorXd& x, Eigen::VectorXd& residuals) const {
    const TwinPoses poses = at(x);
    Eigen::Index k = 0;
    for (std::size_t i = 0; i < rays_.size(); ++i) {
      const FaceCurve curve = curve_of(poses, poses.poses[i]);
      for (const MiddleRay& ray : rays_[i]) {
        const double s = curve.intersect(ray.origin_x, ray.direction_x);
        if (!std::isfinite(s)) return false;
        const FaceCurve::Node node = curve.at(s);
        residuals[k++] = node.z_mm - ray.z_mm;
        residuals[k++] = node.shift_mm - ray.y_mm;
      }
      for (const double mm : {poses.poses[i].q1_mm, poses.poses[i].q2_mm, poses.poses[i].sway_mm})
        residuals[k++] = kBendPrior_per_mm * mm;
    }
    return true;
  }
  bool evaluate(const Eigen::VectorXd& x, Eigen::VectorXd& residuals_out,
                Eigen::MatrixXd* slopes) const {
    residuals_out.resize(residuals());
    if (!residuals_at(x, residuals_out)) return false;
    if (!slopes) return true;
    slopes->resize(residuals_out.size(), x.size());
    Eigen::VectorXd there(residuals_out.size());
    constexpr double kStep = 1e-5;  // curves are computed in double precision
    for (Eigen::Index k = 0; k < x.size(); ++k) {
      Eigen::VectorXd moved = x;
      moved[k] += kStep;
      if (!residuals_at(moved, there)) return false;
      slopes->col(k) = (there - residuals_out) / kStep;
    }
    return true;
  }

 private:
  TwinPoses start_;
  std::vector<std::vector<MiddleRay>> rays_;
};

/// A straight face through the visible points of the first shape.
TwinPoses straight_start(const std::vector<const FaceShape*>& shapes,
                         const std::vector<MiddleRay>& rays) {
  TwinPoses start;
  const MiddleRay& first = rays.front();
  const MiddleRay& last = rays.back();
  const double x = first.origin_x + first.z_mm * first.direction_x;
  const double x_last = last.origin_x + last.z_mm * last.direction_x;
  start.base_mm = {x, first.y_mm, first.z_mm};
  start.incline_rad = std::atan2(last.z_mm - first.z_mm, x_last - x);
  for (const FaceShape* shape : shapes)
    for (int u = shape->width_px() - 1; u >= 0; --u)
      if (shape->columns()[static_cast<std::size_t>(u)].valid) {
        start.length_mm = std::max(start.length_mm, shape->length_at(u));
        break;
      }
  return start;
}

}  // namespace

Result<TwinPoses> fit_poses(const std::vector<const FaceShape*>& shapes, const Job& job) {
  std::vector<std::vector<MiddleRay>> rays;
  for (const FaceShape* shape : shapes) {
    rays.push_back(middle_rays(*shape));
    if (rays.back().size() < 12)
      return Error{en::say("too little of the finger's length is visible"), "",
                   en::say("images in which the entire face is visible")};
    if (!shape->base_at_low_u())
      return Error{
          en::say("the finger's base is on the right of the image, which no scene supports"), "",
          en::say("camera.orientation: flip_u in finger.yaml")};
  }
  const PoseStudy study(straight_start(shapes, rays.front()), rays);
  auto solution = solve_twin([&](const Eigen::VectorXd& x, Eigen::VectorXd& r,
                                 Eigen::MatrixXd* slopes) { return study.evaluate(x, r, slopes); },
                             study.unknowns(), study.residuals(), {100, 1e-10}, job);
  if (!solution) return solution.error();
  TwinPoses poses = study.at(solution->x);
  double sum = 0;
  Eigen::Index k = 0, count = 0;
  for (const auto& one : rays) {
    for (std::size_t i = 0; i < one.size(); ++i, k += 2, ++count)
      sum += solution->residuals[k] * solution->residuals[k];
    k += kPoseUnknowns;
  }
  poses.rms_mm = std::sqrt(sum / static_cast<double>(count));
  return poses;
}

Eigen::Vector2d position_under(const TwinScene& scene, const TwinPose& pose,
                               const Eigen::Vector3d& ball_mm) {
  if (scene.face.kind == FaceKind::kFlat) return ball_mm.head<2>();
  const TwinPoses poses{scene.base_mm, scene.incline_rad, scene.length_mm, {}, 0};
  const FaceCurve curve = curve_of(poses, pose);
  double nearest = std::numeric_limits<double>::infinity(), at = 0;
  const auto distance = [&](double s) {
    const FaceCurve::Node node = curve.at(s);
    return std::hypot(node.x_mm - ball_mm.x(), node.z_mm - ball_mm.z());
  };
  for (double s = 0; s <= scene.length_mm; s += 0.05)
    if (const double d = distance(s); d < nearest) nearest = d, at = s;
  return {at, ball_mm.y() - curve.at(at).shift_mm};
}

namespace {

constexpr int kThinWidth = 100;             // px, of the images that lamps are fitted to
constexpr double kMaxLampResidual = 0.967;  // of the residual without it
constexpr double kGreyTolerance = 0.05;     // grey levels: below a camera's resolution
constexpr double kUnit = 1e5;               // power of single lamps in rendered images
constexpr int kTiles = 6;                   // along either side: clusters of residuals

/// The lit face: its middle, and half of its extent.
struct LitFace {
  Eigen::Vector3d middle_mm;
  double reach_mm;
};

class LampStudy {
 public:
  static Result<LampStudy> create(const TwinScene& scene,
                                  const std::vector<TwinUntouched>& untouched) {
    LampStudy study;
    study.scene_ = scene;
    study.scene_.balls.clear();
    study.scene_.blur_px = 0;
    const int side = std::max(1, scene.camera.width_px / kThinWidth);
    study.scene_.camera = downsampled_camera(scene.camera, side);
    for (const TwinUntouched& one : untouched) {
      study.poses_.push_back(one.pose);
      study.masks_.push_back(downsampled_image(one.grey, side));
    }
    // Pixels that lamp light does not reach show no face to compare.
    std::vector<double> target;
    for (std::size_t i = 0; i < study.poses_.size(); ++i)
      study.add_pixels(static_cast<int>(i), target);
    if (target.size() < 50)
      return Error{en::say("too little of the untouched face is visible"), "",
                   en::say("images in which the entire face is visible")};
    study.target_ =
        Eigen::Map<Eigen::VectorXd>(target.data(), static_cast<Eigen::Index>(target.size()));
    study.know_face();
    return study;
  }

  [[nodiscard]] const Eigen::VectorXd& target() const { return target_; }
  [[nodiscard]] const std::vector<int>& clusters() const { return clusters_; }
  [[nodiscard]] const LitFace& face() const { return face_; }
  [[nodiscard]] bool is_flat() const { return scene_.face.kind == FaceKind::kFlat; }
  [[nodiscard]] const TwinScene& scene() const { return scene_; }

  /// Brightness of all pixels under one lamp of power kUnit. nullopt: there is no such image.
  [[nodiscard]] std::optional<Eigen::VectorXd> light_of(TwinLamp lamp) const {
    lamp.power = kUnit;
    Eigen::VectorXd light(target_.size());
    Eigen::Index at = 0;
    for (std::size_t i = 0; i < poses_.size(); ++i) {
      TwinScene one = scene_.untouched(poses_[i]);
      one.lamps = {lamp};
      const auto image = twin_image(one, 0);
      if (!image) return std::nullopt;
      for (const cv::Point& pixel : pixels_[i]) light[at++] = image->at<float>(pixel);
    }
    return light;
  }
  /// Even light of level 1.
  [[nodiscard]] Eigen::VectorXd room_light() const {
    return Eigen::VectorXd::Constant(target_.size(),
                                     scene_.layer.reflectance(scene_.face.layer_mm));
  }
  [[nodiscard]] std::vector<TwinLamp> candidates() const;

 private:
  void add_pixels(int number, std::vector<double>& target) {
    const cv::Mat& grey = masks_[static_cast<std::size_t>(number)];
    pixels_.emplace_back();
    for (int v = 0; v < grey.rows; ++v)
      for (int u = 0; u < grey.cols; ++u) {
        const float level = grey.at<float>(v, u);
        if (!std::isfinite(level)) continue;
        pixels_.back().emplace_back(u, v);
        target.push_back(level);
        clusters_.push_back(kTiles * kTiles * number + kTiles * (kTiles * v / grey.rows) +
                            kTiles * u / grey.cols);
      }
  }
  void know_face() {
    if (!is_flat()) {
      const Eigen::Vector3d along(std::cos(scene_.incline_rad), 0, std::sin(scene_.incline_rad));
      face_ = {scene_.base_mm + 0.5 * scene_.length_mm * along, 0.5 * scene_.length_mm};
      return;
    }
    const CameraParameters& c = scene_.camera;
    const double z = scene_.face.plane_z_mm;
    const double mm_per_px = c.model == CameraModel::kOrthographic ? c.mm_per_px : z / c.fx_px;
    face_.middle_mm = {mm_per_px * (0.5 * (c.width_px - 1) - c.cx_px),
                       mm_per_px * (0.5 * (c.height_px - 1) - c.cy_px), z};
    face_.reach_mm = 0.5 * mm_per_px * std::hypot(c.width_px, c.height_px);
  }

  TwinScene scene_;
  std::vector<TwinPose> poses_;
  std::vector<cv::Mat> masks_;
  std::vector<std::vector<cv::Point>> pixels_;
  Eigen::VectorXd target_;
  std::vector<int> clusters_;
  LitFace face_{};
};

std::vector<TwinLamp> LampStudy::candidates() const {
  std::vector<TwinLamp> all;
  if (is_flat()) {
    for (const double height : {0.4, 0.8, 1.6, 3.2})
      for (const double x : {-1.6, -0.8, 0.0, 0.8, 1.6})
        for (const double y : {-1.6, -0.8, 0.0, 0.8, 1.6})
          all.push_back({face_.middle_mm + face_.reach_mm * Eigen::Vector3d(x, y, -height)});
    return all;
  }
  // About the camera, and along the finger's inner side.
  const double unit = std::max(4.0, 0.4 * scene_.base_mm.z());
  for (const double x : {-1.0, 0.0, 1.0, 2.5})
    for (const double y : {-0.5, 0.0, 0.5})
      for (const double z : {-3.0, -1.5, 0.0, 0.8})
        all.push_back({unit * Eigen::Vector3d(x, y, z)});
  const Eigen::Vector3d along(std::cos(scene_.incline_rad), 0, std::sin(scene_.incline_rad));
  for (const double part : {0.2, 0.5, 0.8, 1.1})
    for (const double z : {0.0, -1.5})
      for (const int lobe : {2, 8})
        all.push_back({Eigen::Vector3d(0, 0, unit * z), 0,
                       Eigen::Vector3d(scene_.base_mm + part * scene_.length_mm * along), lobe});
  return all;
}

/// Non-negative shares of `columns` closest to the target (Lawson and Hanson's condition, reached
/// by dropping columns with a negative share).
Eigen::VectorXd shares_of(const std::vector<Eigen::VectorXd>& columns,
                          const Eigen::VectorXd& target) {
  std::vector<std::size_t> used;
  for (std::size_t i = 0; i < columns.size(); ++i) used.push_back(i);
  Eigen::VectorXd shares = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(columns.size()));
  while (!used.empty()) {
    Eigen::MatrixXd design(target.size(), static_cast<Eigen::Index>(used.size()));
    for (std::size_t i = 0; i < used.size(); ++i)
      design.col(static_cast<Eigen::Index>(i)) = columns[used[i]];
    const Eigen::VectorXd x = design.colPivHouseholderQr().solve(target);
    Eigen::Index worst = 0;
    if (x.minCoeff(&worst) >= 0) {
      for (std::size_t i = 0; i < used.size(); ++i)
        shares[static_cast<Eigen::Index>(used[i])] = x[static_cast<Eigen::Index>(i)];
      return shares;
    }
    used.erase(used.begin() + worst);
  }
  return shares;
}

/// Positions and powers of lamps as unknowns, four a lamp: position in units of the face's extent,
/// and the logarithm of the power. The last unknown is the room's level, in tens of grey levels.
struct LampUnknowns {
  const LampStudy& study;
  std::vector<TwinLamp> lamps;

  [[nodiscard]] TwinUnknowns unknowns(double room) const {
    const auto n = static_cast<Eigen::Index>(4 * lamps.size() + 1);
    TwinUnknowns u{Eigen::VectorXd(n), Eigen::VectorXd(n), Eigen::VectorXd(n)};
    const LitFace& face = study.face();
    for (std::size_t i = 0; i < lamps.size(); ++i) {
      const auto at = static_cast<Eigen::Index>(4 * i);
      const double behind = study.is_flat() ? -0.1 : 4;
      u.start.segment<3>(at) = (lamps[i].at_mm - face.middle_mm) / face.reach_mm;
      u.start[at + 3] = std::log(lamps[i].power);
      u.low.segment<3>(at) = Eigen::Vector3d(-6, -6, -8);
      u.high.segment<3>(at) = Eigen::Vector3d(6, 6, behind);
      u.low[at + 3] = u.start[at + 3] - 12;
      u.high[at + 3] = std::min(std::log(9e8), u.start[at + 3] + 6);
    }
    u.start[n - 1] = 0.1 * room;
    u.low[n - 1] = 0;
    u.high[n - 1] = 900;
    return u;
  }

  [[nodiscard]] TwinLamp lamp_at(const Eigen::VectorXd& x, std::size_t i) const {
    const auto at = static_cast<Eigen::Index>(4 * i);
    TwinLamp lamp = lamps[i];
    lamp.at_mm = study.face().middle_mm + study.face().reach_mm * x.segment<3>(at);
    lamp.power = std::exp(x[at + 3]);
    return lamp;
  }

  bool evaluate(const Eigen::VectorXd& x, Eigen::VectorXd& residuals,
                Eigen::MatrixXd* slopes) const {
    const Eigen::VectorXd room = study.room_light();
    residuals = 10 * x[x.size() - 1] * room - study.target();
    if (slopes) slopes->resize(residuals.size(), x.size());
    for (std::size_t i = 0; i < lamps.size(); ++i) {
      const auto light = study.light_of(lamp_at(x, i));
      if (!light) return false;
      const auto at = static_cast<Eigen::Index>(4 * i);
      const double share = std::exp(x[at + 3]) / kUnit;
      residuals += share * *light;
      if (!slopes) continue;
      slopes->col(at + 3) = share * *light;
      for (Eigen::Index k = 0; k < 3; ++k) {
        Eigen::VectorXd moved = x;
        moved[at + k] -= kTwinStep;  // towards the open side of z
        const auto there = study.light_of(lamp_at(moved, i));
        if (!there) return false;
        slopes->col(at + k) = share / -kTwinStep * (*there - *light);
      }
    }
    if (slopes) slopes->col(x.size() - 1) = 10 * room;
    return true;
  }
};

struct LampRound {
  std::vector<TwinLamp> lamps;
  double room = 0;
  TwinSolution solution;
};

Result<LampRound> refine(const LampStudy& study, std::vector<TwinLamp> lamps, double room,
                         TwinEffort effort, const Job& job) {
  const LampUnknowns unknowns{study, std::move(lamps)};
  auto solution =
      solve_twin([&](const Eigen::VectorXd& x, Eigen::VectorXd& r,
                     Eigen::MatrixXd* slopes) { return unknowns.evaluate(x, r, slopes); },
                 unknowns.unknowns(room), study.target().size(), effort, job);
  if (!solution) return solution.error();
  LampRound round;
  for (std::size_t i = 0; i < unknowns.lamps.size(); ++i)
    round.lamps.push_back(unknowns.lamp_at(solution->x, i));
  round.room = 10 * solution->x[solution->x.size() - 1];
  round.solution = std::move(solution).value();
  return round;
}

/// The candidate that reduces the remaining residual most.
std::size_t best_candidate(const std::vector<Eigen::VectorXd>& lights,
                           const std::vector<Eigen::VectorXd>& used,
                           const Eigen::VectorXd& target) {
  std::size_t best = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < lights.size(); ++i) {
    std::vector<Eigen::VectorXd> columns = used;
    columns.push_back(lights[i]);
    const Eigen::VectorXd shares = shares_of(columns, target);
    Eigen::VectorXd rest = target;
    for (std::size_t k = 0; k < columns.size(); ++k)
      rest -= shares[static_cast<Eigen::Index>(k)] * columns[k];
    if (rest.squaredNorm() < least) least = rest.squaredNorm(), best = i;
  }
  return best;
}

}  // namespace

Result<TwinLamps> fit_lamps(const TwinScene& scene, const std::vector<TwinUntouched>& untouched,
                            const Job& job) {
  auto study = LampStudy::create(scene, untouched);
  if (!study) return study.error();
  std::vector<TwinLamp> candidates;
  std::vector<Eigen::VectorXd> lights;
  for (const TwinLamp& candidate : study->candidates()) {
    auto light = study->light_of(candidate);
    if (!light || light->maxCoeff() <= 0) continue;
    candidates.push_back(candidate);
    lights.push_back(std::move(*light));
  }
  if (candidates.empty())
    return Error{en::say("no lamp would light the face"), "",
                 en::say("checking the finger's face")};
  std::optional<LampRound> best;
  while (!best || best->lamps.size() < kMaxLamps) {
    if (job.stop_requested()) return Error{en::say("stopped before the twin was found"), "", ""};
    std::vector<TwinLamp> lamps = best ? best->lamps : std::vector<TwinLamp>();
    job.report(static_cast<double>(lamps.size()) / kMaxLamps, en::say("finding the lamps"));
    std::vector<Eigen::VectorXd> used{study->room_light()};
    for (const TwinLamp& lamp : lamps)
      if (auto light = study->light_of(lamp)) used.push_back(std::move(*light));
    const std::size_t added = best_candidate(lights, used, study->target());
    lamps.push_back(candidates[added]);
    used.push_back(lights[added]);
    const Eigen::VectorXd shares = shares_of(used, study->target());
    if (shares[shares.size() - 1] <= 0) break;
    std::vector<TwinLamp> shining;
    for (std::size_t i = 0; i < lamps.size(); ++i)
      if (const double share = shares[static_cast<Eigen::Index>(i) + 1]; share > 0) {
        lamps[i].power = std::clamp(kUnit * share, 1e-3, 8e8);
        shining.push_back(lamps[i]);
      }
    auto round = refine(*study, std::move(shining), shares[0], {8, 1e-3}, job);
    if (!round) return round.error();
    if (best && round->solution.rms() > kMaxLampResidual * best->solution.rms()) break;
    best = std::move(*round);
    if (best->solution.rms() < kGreyTolerance) break;
  }
  if (!best)
    return Error{en::say("no lamp reproduces the untouched image"), "",
                 en::say("checking the finger's face")};
  auto last = refine(*study, best->lamps, best->room, {30, 1e-5}, job);
  if (!last) return last.error();
  TwinLamps result{last->lamps, last->room < 0.05 ? 0 : last->room, {}, last->solution.rms()};
  const auto sd = clustered_sd(last->solution, study->clusters());
  for (std::size_t i = 0; i < result.lamps.size(); ++i) {
    LampSpread spread;
    if (sd[4 * i] && sd[4 * i + 1] && sd[4 * i + 2])
      spread.at_mm =
          study->face().reach_mm * Eigen::Vector3d(*sd[4 * i], *sd[4 * i + 1], *sd[4 * i + 2]);
    if (sd[4 * i + 3]) spread.power = *sd[4 * i + 3] * result.lamps[i].power;
    result.spread.push_back(spread);
  }
  return result;
}

}  // namespace alltact
