#include "calibration/joint/circle_search.h"

#include "calibration/joint/sample_misfit.h"
#include "core/geometry/ball.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Dense>
#include <opencv2/imgproc.hpp>

namespace alltact {
namespace {

constexpr double kDarkPart = 0.4;  // of the darkest difference
constexpr float kMinDark = 0.02F;
constexpr int kOpeningPx = 5;
constexpr std::size_t kMinSamples = 50;
constexpr double kZero_mm = 1e-3;   // tolerance of a zero constant
constexpr double kMaxMisfit = 0.3;  // above, the cubic fits noise

Error no_circle(const Press& press, Message what) {
  return {std::move(what), press.name, en::say("pressing the ball in deeper, whole on the face")};
}

/// The cubic through (x, d) of a press for any ball.
class CubicOfBall {
 public:
  CubicOfBall(const Press& press, const std::vector<Sample>& samples)
      : samples_(samples), radius_mm_(press.ball_radius_mm) {
    for (const Sample& sample : samples) x_max_ = std::max(x_max_, sample.x);
  }

  struct Fit {
    double constant_mm, misfit;
  };
  /// Uses the samples whose line along z meets the ball; nullopt where these are fewer than nine
  /// tenths. Depths are signed, so that a ball off the face has a large misfit.
  [[nodiscard]] std::optional<Fit> operator()(const Eigen::Vector3d& centre_mm) const {
    Eigen::Matrix4d normal = Eigen::Matrix4d::Zero();
    Eigen::Vector4d right = Eigen::Vector4d::Zero();
    double square = 0, sum = 0;
    std::size_t met = 0;
    for (const Sample& sample : samples_) {
      const double d = ball_depth_mm(sample, MappingAlong::kZ, centre_mm, radius_mm_);
      if (!std::isfinite(d)) continue;
      const double t = 2.0 * sample.x / x_max_ - 1.0;
      const Eigen::Vector4d row(1.0, t, 2.0 * t * t - 1.0, t * (4.0 * t * t - 3.0));
      normal.noalias() += row * row.transpose();
      right += d * row;
      square += d * d;
      sum += d;
      ++met;
    }
    const double spread = square - sum * sum / static_cast<double>(std::max<std::size_t>(1, met));
    if (met < kMinSamples || 10 * met < 9 * samples_.size() || !(spread > 0.0)) return std::nullopt;
    const Eigen::Vector4d c = normal.ldlt().solve(right);
    const double left = std::max(0.0, square - c.dot(right));
    if (!c.allFinite()) return std::nullopt;
    return Fit{c[0] - c[1] + c[2] - c[3], std::sqrt(left / spread)};
  }

 private:
  const std::vector<Sample>& samples_;
  double radius_mm_;
  double x_max_ = 0;
};

/// The circles of one press and their cubics.
class CirclesOfPress {
 public:
  CirclesOfPress(const Press& press,
                 const std::vector<Sample>& samples,
                 const Camera& camera,
                 const Face& face)
      : camera_(camera),
        shape_(press.shape),
        face_(face),
        radius_mm_(press.ball_radius_mm),
        cubic_(press, samples) {}

  /// The size without a constant at one middle; of several the one whose cubic fits best.
  [[nodiscard]] std::optional<SearchedCircle> at(const Eigen::Vector2d& middle_px) const {
    const auto local = shape_.at(middle_px.x(), middle_px.y());
    if (!local) return std::nullopt;
    constexpr int kSteps = 24;
    std::optional<SearchedCircle> best, before;
    double before_mm = 0;
    for (int step = 0; step <= kSteps; ++step) {
      const double depth_mm = face_.layer_mm * (step + 0.25) / kSteps;
      const auto here = with_depth(middle_px, *local, depth_mm);
      if (before && here && before->constant_mm * here->constant_mm <= 0.0) {
        const auto zero = between(middle_px, *local, {before_mm, *before}, {depth_mm, *here});
        if (zero && (!best || zero->misfit < best->misfit)) best = zero;
      }
      before = here;
      before_mm = depth_mm;
    }
    return best;
  }

  /// 1.2 times the ball's radius in the image.
  [[nodiscard]] double reach_px(const Eigen::Vector2d& middle_px) const {
    const auto local = shape_.at(middle_px.x(), middle_px.y());
    return local ? 1.2 * radius_mm_ / camera_.mm_per_px_at(local->view_point_mm.z()) : 0.0;
  }

 private:
  struct AtDepth {
    double depth_mm;
    SearchedCircle circle;
  };

  /// Bisection. A change of sign at a pole, or where samples appear or vanish, is no zero.
  [[nodiscard]] std::optional<SearchedCircle> between(const Eigen::Vector2d& middle_px,
                                                      const FaceShape::Local& local,
                                                      AtDepth from,
                                                      AtDepth to) const {
    while (to.depth_mm - from.depth_mm > 1e-5) {
      const double half_mm = 0.5 * (from.depth_mm + to.depth_mm);
      const auto half = with_depth(middle_px, local, half_mm);
      if (!half) return std::nullopt;
      const bool before_zero = half->constant_mm * from.circle.constant_mm > 0.0;
      (before_zero ? from : to) = {half_mm, *half};
    }
    if (!(std::abs(to.circle.constant_mm) < kZero_mm)) return std::nullopt;
    return to.circle;
  }

  /// The circle of the ball in the middle's direction that is pressed in by about `depth_mm`.
  [[nodiscard]] std::optional<SearchedCircle> with_depth(const Eigen::Vector2d& middle_px,
                                                         const FaceShape::Local& local,
                                                         double depth_mm) const {
    const double untouched_mm = untouched_point_mm(local, face_.layer_mm, MappingAlong::kZ).z();
    const double ahead_mm = (radius_mm_ - depth_mm) / local.cos_incline;
    const auto circle = circle_at(middle_px, untouched_mm + ahead_mm, depth_mm);
    const auto ball =
        circle ? ball_of_circle(*circle, camera_, radius_mm_, untouched_mm) : std::nullopt;
    const auto fit = ball ? cubic_(*ball) : std::nullopt;
    if (!fit) return std::nullopt;
    return SearchedCircle{*circle, *ball, fit->constant_mm, fit->misfit};
  }

  /// The size for which ball_of_circle() returns that distance.
  [[nodiscard]] std::optional<Circle> circle_at(const Eigen::Vector2d& middle_px,
                                                double z_mm,
                                                double depth_mm) const {
    if (!camera_.is_perspective()) {
      const double rim2 = depth_mm * (2.0 * radius_mm_ - depth_mm);
      if (!(rim2 > 0.0)) return std::nullopt;
      return Circle{middle_px, std::sqrt(rim2) / camera_.parameters().mm_per_px, 0.0};
    }
    const auto sight = camera_.unproject(middle_px);
    if (!sight) return std::nullopt;
    // The size depends so smoothly on the distance that a secant converges in a few steps.
    const double target_mm = z_mm;
    double size = radius_mm_ / z_mm * camera_.parameters().fy_px;
    for (int step = 0; step < 30; ++step) {
      const auto ball = ball_of_circle({middle_px, size, 0.0}, camera_, radius_mm_, 0.0);
      if (!ball) return std::nullopt;
      if (std::abs(ball->z() - target_mm) < 1e-9 * target_mm) break;
      size *= ball->z() / target_mm;
    }
    return Circle{middle_px, size, 0.0};
  }

  const Camera& camera_;
  const FaceShape& shape_;
  const Face& face_;
  double radius_mm_;
  CubicOfBall cubic_;
};

}  // namespace

Result<Circle> dark_circle(const Press& press, const Camera& camera) {
  if (press.ball_mm) {
    const auto outline =
        fit_circle(ball_outline_px(camera, *press.ball_mm, press.ball_radius_mm, 72));
    if (outline) return *outline;
  }
  cv::Mat x = press.difference.x.clone();
  cv::patchNaNs(x, 0.0);
  cv::blur(x, x, {5, 5});
  const cv::Mat disc =
      cv::getStructuringElement(cv::MORPH_ELLIPSE, {2 * kOpeningPx + 1, 2 * kOpeningPx + 1});
  cv::morphologyEx(x, x, cv::MORPH_OPEN, disc);
  double darkest = 0;
  cv::Point darkest_px;
  cv::minMaxLoc(x, nullptr, &darkest, nullptr, &darkest_px);
  if (!(darkest >= static_cast<double>(kMinDark)))
    return no_circle(press, en::say("nothing is dark enough for a ball that presses"));
  std::vector<std::vector<cv::Point>> borders;
  cv::findContours(x > kDarkPart * darkest, borders, cv::RETR_EXTERNAL, cv::CHAIN_APPROX_NONE);
  const auto around = std::find_if(borders.begin(), borders.end(), [&](const auto& border) {
    return cv::pointPolygonTest(border, cv::Point2f(darkest_px), false) >= 0;
  });
  std::vector<Eigen::Vector2d> points;
  if (around != borders.end())
    for (const cv::Point& p : *around) points.emplace_back(p.x, p.y);
  const auto circle = fit_circle(points);
  if (!circle) return no_circle(press, en::say("no circle goes through the dark border"));
  return *circle;
}

std::optional<Eigen::Vector3d> ball_of_circle(const Circle& circle,
                                              const Camera& camera,
                                              double ball_radius_mm,
                                              double height_mm) {
  const auto middle = camera.unproject(circle.centre);
  if (!middle) return std::nullopt;
  if (!camera.is_perspective()) {
    const double rim_mm = circle.radius * camera.parameters().mm_per_px;
    if (!(rim_mm < ball_radius_mm)) return std::nullopt;
    Eigen::Vector3d ball = middle->point_at(height_mm);
    ball.z() += std::sqrt((ball_radius_mm - rim_mm) * (ball_radius_mm + rim_mm));
    return ball;
  }
  const auto lowest = camera.unproject(circle.centre + Eigen::Vector2d(0.0, circle.radius));
  if (!lowest) return std::nullopt;
  const double sine = sine_between(lowest->direction, middle->direction);
  if (!(sine > 0.0)) return std::nullopt;
  return Eigen::Vector3d(middle->direction.normalized() * (ball_radius_mm / sine));
}

Result<SearchedCircle> search_circle(const Press& press,
                                     const Circle& dark,
                                     const std::vector<Sample>& samples,
                                     const Camera& camera,
                                     const Face& face) {
  const CirclesOfPress search(press, samples, camera, face);
  std::optional<SearchedCircle> best;
  const auto scan = [&](const Eigen::Vector2d& middle, double reach_px, int steps) {
    for (int i = -steps; i <= steps; ++i)
      for (int j = -steps; j <= steps; ++j) {
        const auto here = search.at(middle + reach_px / steps * Eigen::Vector2d(i, j));
        if (here && (!best || here->misfit < best->misfit)) best = here;
      }
  };
  // Over an inclined face the ball's middle lies next to the dark disc.
  double reach_px = search.reach_px(dark.centre);
  constexpr int kSteps = 10;
  scan(dark.centre, reach_px, kSteps);
  if (!best) return no_circle(press, en::say("no circle gives a cubic whose constant is zero"));
  for (reach_px /= kSteps; reach_px > 0.05; reach_px /= 2) scan(best->circle.centre, reach_px, 2);
  if (best->misfit > kMaxMisfit)
    return no_circle(press,
                     en::say("the cubic without a constant leaves {:.0f} % of the depths' spread: "
                             "its contact is too faint, small or steep",
                             100.0 * best->misfit));
  return *best;
}

}  // namespace alltact
