#include "calibration/joint/outline_methods.h"

#include "calibration/joint/ball_clouds.h"
#include "calibration/joint/tangent_arc.h"
#include "core/geometry/ball.h"
#include "core/geometry/circle_fit.h"
#include "core/numerics/bilinear.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include <Eigen/Dense>

namespace alltact {
namespace {

constexpr double kMinArcDeg = 40;  // of the outline; less does not determine a ball

/// The circle of the steepest fall of x along rays from the dark disc's middle, around its 40 %
/// contour.
std::optional<Circle> border_circle(const cv::Mat& x,
                                    const Eigen::Vector2d& middle,
                                    double radius_px) {
  constexpr int kRays = 180;
  constexpr double kStep = 2.0;
  std::vector<Eigen::Vector2d> points;
  for (int i = 0; i < kRays; ++i) {
    const double angle = 2.0 * M_PI * i / kRays;
    const Eigen::Vector2d out(std::cos(angle), std::sin(angle));
    double steepest = 0;
    double steepest_at = 0;
    for (double r = 0.6 * radius_px; r < 1.6 * radius_px; r += 0.5) {
      const double fall =
          bilinear(x, middle + (r - kStep) * out) - bilinear(x, middle + (r + kStep) * out);
      if (!(fall > steepest)) continue;
      steepest = fall;
      steepest_at = r;
    }
    if (steepest_at > 0.0) points.emplace_back(middle + steepest_at * out);
  }
  auto circle = fit_circle(points);
  if (!circle) return std::nullopt;
  const double gate = 2.0 * circle->rms + 0.5;
  std::erase_if(points, [&](const Eigen::Vector2d& p) {
    return std::abs((p - circle->centre).norm() - circle->radius) > gate;
  });
  return fit_circle(points);
}

/// The border of one press's disc, with its position on the face.
struct Border {
  const Press& press;
  const BallGuess& guess;
  Circle circle;
  FaceShape::Local middle;  ///< under the circle's middle
};

Error no_ball(const Press& press, Message why) {
  return {std::move(why), press.name, ""};
}

Result<Border> border_of(const OutlinePress& input) {
  const Press& press = *input.press;
  const auto circle =
      border_circle(press.difference.x, input.guess.disc_px, input.guess.disc_radius_px);
  if (!circle) return no_ball(press, en::say("no circle goes through the dark border"));
  const auto middle = press.shape.at(circle->centre.x(), circle->centre.y());
  if (!middle) return no_ball(press, en::say("the circle's middle lies off the face"));
  return Border{press, input.guess, *circle, *middle};
}

/// The ball that leaves the face at the circle, by the circle's mean radius.
Result<Eigen::Vector3d> by_contact_line(const Border& border, const Face& face) {
  constexpr int kPoints = 72;
  const Eigen::Vector3d foot =
      untouched_point_mm(border.middle, face.layer_mm, MappingAlong::kNormal);
  double radius_mm = 0;
  int seen = 0;
  for (int i = 0; i < kPoints; ++i) {
    const double turn = 2.0 * M_PI * i / kPoints;
    const Eigen::Vector2d at =
        border.circle.centre +
        border.circle.radius * Eigen::Vector2d(std::cos(turn), std::sin(turn));
    const auto local = border.press.shape.at(at.x(), at.y());
    if (!local) continue;
    radius_mm += (untouched_point_mm(*local, face.layer_mm, MappingAlong::kNormal) - foot).norm();
    ++seen;
  }
  if (seen == 0) return no_ball(border.press, en::say("the circle lies off the face"));
  radius_mm /= seen;
  const double ball_mm = border.press.ball_radius_mm;
  if (radius_mm >= ball_mm)
    return no_ball(border.press, en::say("the circle is larger than the ball"));
  return Eigen::Vector3d(foot + std::sqrt((ball_mm - radius_mm) * (ball_mm + radius_mm)) *
                                    border.middle.normal);
}

/// The ball by its visible outline.
Result<Eigen::Vector3d> by_cone(const OutlinePress& input) {
  const Press& press = *input.press;
  const TangentArc arc = find_tangent_arc(press, input.guess.centre_mm, press.ball_radius_mm);
  if (arc.arc_deg < kMinArcDeg)
    return no_ball(
        press,
        en::say("{:.0f} degrees of the ball's outline are seen, a cone needs {:.0f}; the "
                "rest of the dark border is where the skin leaves the ball",
                arc.arc_deg,
                kMinArcDeg));
  std::vector<Eigen::Vector3d> directions;
  for (const OutlinePoint& point : arc.points) directions.push_back(point.direction);
  const auto centre = fit_ball_to_outline(directions, press.ball_radius_mm);
  if (!centre) return no_ball(press, en::say("no cone touches the outline"));
  return *centre;
}

Result<BallCloud> solve_press(const OutlinePress& input,
                              CalibrationMethod method,
                              const Face& face) {
  const Press& press = *input.press;
  const auto border = border_of(input);
  if (!border) return border.error();
  const auto centre =
      method == CalibrationMethod::kCone ? by_cone(input) : by_contact_line(*border, face);
  if (!centre) return centre.error();
  return cloud_of_ball(
      press, samples_inside(press, face, border->circle), *centre, input.guess.cut_by_edge);
}

}  // namespace

Result<Calibration> calibrate_by_outline(const std::vector<OutlinePress>& presses,
                                         CalibrationMethod method,
                                         const Face& face,
                                         const Job& job,
                                         Calibration calibration) {
  CloudsFound found = clouds_of(
      presses, [&](const OutlinePress& press) { return solve_press(press, method, face); }, job);
  if (found.clouds.empty())
    return Error{en::say("no ball follows from the dark border of any of {} presses ({})",
                         presses.size(),
                         found.reason),
                 "",
                 en::say("the joint method, which fits the ball itself")};
  std::move(found.left_out.begin(), found.left_out.end(), std::back_inserter(calibration.left_out));
  return fit_cubic_mapping(found.clouds, std::move(calibration));
}

}  // namespace alltact
