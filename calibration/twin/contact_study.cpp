#include "calibration/twin/contact_study.h"

#include "calibration/twin/twin_image.h"

#include <algorithm>
#include <cmath>

namespace alltact {
namespace {

// Weight of a given depth: grey levels a block per standard deviation, over all blocks of a sector.
constexpr double kGivenDepthGrey = 1.0;

}  // namespace

void ContactStudy::add_log(double value,
                           double low,
                           double high,
                           double& (*of)(TwinScene&),
                           std::optional<double> ContactSpread::*sd) {
  unknowns_.push_back({std::log(std::clamp(value, low, high)),
                       std::log(low),
                       std::log(high),
                       -1,
                       [of](TwinScene& scene, double x) { of(scene) = std::exp(x); },
                       [sd](ContactSpread& spread) { return &(spread.*sd); },
                       [](double x) { return std::exp(x); }});
}

void ContactStudy::add_linear(double value,
                              double low,
                              double high,
                              double unit,
                              double& (*of)(TwinScene&),
                              std::optional<double> ContactSpread::*sd) {
  unknowns_.push_back({value / unit,
                       low / unit,
                       high / unit,
                       -1,
                       [of, unit](TwinScene& scene, double x) { of(scene) = unit * x; },
                       [sd](ContactSpread& spread) { return &(spread.*sd); },
                       [unit](double) { return unit; }});
}

void ContactStudy::add_ball(std::size_t ball, bool with_light) {
  using Ball = ContactSpread::Ball;
  const auto add = [&](double value,
                       double low,
                       double high,
                       double unit,
                       double TwinBall::*of,
                       std::optional<double> Ball::*sd) {
    unknowns_.push_back({value / unit,
                         low / unit,
                         high / unit,
                         static_cast<int>(ball),
                         [=](TwinScene& scene, double x) { scene.balls[ball].*of = unit * x; },
                         [=](ContactSpread& spread) { return &(spread.balls[ball].*sd); },
                         [unit](double) { return unit; }});
  };
  const TwinBall& b = scene_.balls[ball];
  const double disc = b.radius_mm;
  add(b.s_mm, b.s_mm - disc, b.s_mm + disc, 1, &TwinBall::s_mm, &Ball::s_mm);
  add(b.y_mm, b.y_mm - disc, b.y_mm + disc, 1, &TwinBall::y_mm, &Ball::y_mm);
  const double deepest = 0.98 * std::min(scene_.face.layer_mm, b.radius_mm);
  add(b.depth_mm, 0.02, deepest, 1, &TwinBall::depth_mm, &Ball::depth_mm);
  if (with_light) add(b.light, 0.9, 1.1, 0.1, &TwinBall::light, &Ball::light);
}

void ContactStudy::choose(ContactChoice choice) {
  using S = TwinScene;
  using D = ContactSpread;
  add_log(
      scene_.layer.scatter_per_mm,
      0.02,
      20,
      [](S& s) -> double& { return s.layer.scatter_per_mm; },
      &D::scatter_per_mm);
  if (choice.coat)
    add_linear(
        std::max(0.001, scene_.layer.coat),
        1e-6,
        0.95,
        1,
        [](S& s) -> double& { return s.layer.coat; },
        &D::coat);
  const bool is_hertz = scene_.rolloff == TwinRolloff::kHertz;
  add_log(
      scene_.rolloff_mm,
      is_hertz ? 0.01 : 0.02,
      is_hertz ? 100 : 2,
      [](S& s) -> double& { return s.rolloff_mm; },
      &D::rolloff_mm);
  if (scene_.halo != TwinHalo::kNone) {
    add_linear(
        scene_.halo_share,
        1e-6,
        0.5,
        0.1,
        [](S& s) -> double& { return s.halo_share; },
        &D::halo_share);
    add_log(
        scene_.halo_width_mm,
        0.1,
        10,
        [](S& s) -> double& { return s.halo_width_mm; },
        &D::halo_width_mm);
  }
  if (scene_.halo == TwinHalo::kExponential)
    add_log(
        scene_.halo_steepness,
        0.5,
        20,
        [](S& s) -> double& { return s.halo_steepness; },
        &D::halo_steepness);
  if (choice.blur)
    add_log(
        std::max(0.5, scene_.blur_px),
        0.05,
        20,
        [](S& s) -> double& { return s.blur_px; },
        &D::blur_px);
  for (std::size_t ball = 0; ball < scene_.balls.size(); ++ball) add_ball(ball, choice.light);
}

/// Block means of the twin's image of one press.
bool ContactStudy::predict(const TwinScene& scene, std::size_t press, double* means) const {
  const TwinPatch& patch = patches_[press];
  TwinScene one = scene.with_ball(scene.balls[press]);
  one.camera = cropped_camera(one.camera, patch.view);
  if (patch.is_coarse) {
    one.camera = downsampled_camera(one.camera, patch.side_px);
    one.blur_px /= patch.side_px;
  }
  const auto image = twin_image(one, 1);
  if (!image) return false;
  if (patch.is_coarse) {
    for (const cv::Point& corner : patch.corners)
      *means++ = image->at<float>((corner.y - patch.view.y) / patch.side_px,
                                  (corner.x - patch.view.x) / patch.side_px);
    return true;
  }
  for (const cv::Point& corner : patch.corners) {
    double sum = 0;
    for (int v = 0; v < patch.side_px; ++v) {
      const auto* row = image->ptr<float>(corner.y - patch.view.y + v) + corner.x - patch.view.x;
      for (int u = 0; u < patch.side_px; ++u) sum += row[u];
    }
    *means++ = sum / (patch.side_px * patch.side_px);
  }
  return true;
}

bool ContactStudy::evaluate(const Eigen::VectorXd& x,
                            Eigen::VectorXd& residuals_out,
                            Eigen::MatrixXd* slopes) const {
  residuals_out.resize(residuals());
  if (slopes) *slopes = Eigen::MatrixXd::Zero(residuals(), x.size());
  const TwinScene scene = scene_at(x);
  Eigen::Index at = 0;
  for (std::size_t press = 0; press < patches_.size(); ++press) {
    const Eigen::Index n = patches_[press].target.size();
    Eigen::VectorXd means(n), moved_means(n);
    if (!predict(scene, press, means.data())) return false;
    residuals_out.segment(at, n) = means - patches_[press].target;
    for (std::size_t i = 0; slopes && i < unknowns_.size(); ++i) {
      const ContactUnknown& unknown = unknowns_[i];
      if (unknown.ball >= 0 && unknown.ball != static_cast<int>(press)) continue;
      const auto k = static_cast<Eigen::Index>(i);
      const double step = x[k] + kTwinStep > unknown.high ? -kTwinStep : kTwinStep;
      Eigen::VectorXd moved = x;
      moved[k] += step;
      if (!predict(scene_at(moved), press, moved_means.data())) return false;
      slopes->col(k).segment(at, n) = (moved_means - means) / step;
    }
    at += n;
  }
  for (const std::size_t press : given_depths_) {
    const GivenDepth& given = *presses_[press].given_depth;
    const double weight = kGivenDepthGrey *
                          std::sqrt(static_cast<double>(patches_[press].target.size())) /
                          (kTwinSectors * std::max(1e-3, given.sd_mm));
    const double upright = std::cos(scene.incline_rad);  // depth along z to depth along the normal
    residuals_out[at] = weight * (upright * scene.balls[press].depth_mm - given.mm);
    for (std::size_t i = 0; slopes && i < unknowns_.size(); ++i) {
      TwinScene moved = scene_;
      if (unknowns_[i].ball != static_cast<int>(press)) continue;
      const auto k = static_cast<Eigen::Index>(i);
      moved = scene;
      unknowns_[i].put(moved, x[k] + kTwinStep);
      (*slopes)(at, k) = weight * upright *
                         (moved.balls[press].depth_mm - scene.balls[press].depth_mm) / kTwinStep;
    }
    ++at;
  }
  return true;
}

std::vector<int> ContactStudy::clusters() const {
  std::vector<int> all;
  for (std::size_t press = 0; press < patches_.size(); ++press)
    for (const int sector : patches_[press].sectors)
      all.push_back(static_cast<int>(press) * kTwinSectors + sector);
  for (const std::size_t press : given_depths_)
    all.push_back(static_cast<int>((patches_.size() + press) * kTwinSectors));
  return all;
}

ContactSpread ContactStudy::spread_of(const TwinSolution& solution) const {
  ContactSpread spread;
  spread.balls.resize(scene_.balls.size());
  const auto sd = clustered_sd(solution, clusters());
  for (std::size_t i = 0; i < unknowns_.size(); ++i)
    if (sd[i])
      *unknowns_[i].spread(spread) =
          *sd[i] * unknowns_[i].value_per_unit(solution.x[static_cast<Eigen::Index>(i)]);
  return spread;
}

}  // namespace alltact
