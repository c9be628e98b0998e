#include "calibration/joint/outline_methods.h"

#include "calibration/joint/joint_fit.h"
#include "calibration/joint/mapping_curve.h"
#include "calibration/joint/stored_curve.h"
#include "calibration/joint/tangent_arc.h"
#include "calibration/presses/press_samples.h"
#include "core/geometry/ball.h"
#include "core/geometry/circle_fit.h"
#include "core/numerics/bilinear.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Dense>

namespace alltact {
namespace {

constexpr int kDegree = 3;
constexpr int kBlockPx = 2;
constexpr double kLeastArcDeg = 40;  // of an outline that a ball follows from

/// Steepest fall of x along rays from the middle of the dark disc, around its 40 % contour.
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
    double place = 0;
    for (double r = 0.6 * radius_px; r < 1.6 * radius_px; r += 0.5) {
      const double fall =
          bilinear(x, middle + (r - kStep) * out) - bilinear(x, middle + (r + kStep) * out);
      if (!(fall > steepest)) continue;
      steepest = fall;
      place = r;
    }
    if (place > 0.0) points.emplace_back(middle + place * out);
  }
  auto circle = fit_circle(points);
  if (!circle) return std::nullopt;
  const double gate = 2.0 * circle->rms + 0.5;
  std::erase_if(points, [&](const Eigen::Vector2d& p) {
    return std::abs((p - circle->centre).norm() - circle->radius) > gate;
  });
  return fit_circle(points);
}

/// Depth of a ball over the samples inside the circle, where it presses at all: d = z_LUF - z_D,
/// with the ball's point D on the line along z on which the paper's p_CF = p_LUF - (0, 0, d) lies.
struct Cloud {
  std::vector<double> x, depth_mm;
};

Cloud cloud_of(const std::vector<Sample>& samples,
               const Eigen::Vector3d& centre,
               double radius_mm) {
  Cloud cloud;
  for (const Sample& sample : samples) {
    const double depth = ball_depth_mm(sample, MappingAlong::kZ, centre, radius_mm);
    if (!(depth > 0.0)) continue;
    cloud.x.push_back(sample.x);
    cloud.depth_mm.push_back(depth);
  }
  return cloud;
}

/// The Chebyshev polynomial of degree 3, with a constant, through a cloud.
struct Cubic {
  double at_zero;  ///< its value at x = 0
  double misfit;   ///< rms of what it leaves, over the rms of the depths
};

std::optional<Cubic> cubic_through(const Cloud& cloud, double x_max) {
  const auto n = static_cast<Eigen::Index>(cloud.x.size());
  if (n < 50) return std::nullopt;
  Eigen::MatrixXd design(n, kDegree + 1);
  for (Eigen::Index i = 0; i < n; ++i) {
    const double t = 2.0 * cloud.x[static_cast<std::size_t>(i)] / x_max - 1.0;
    design.row(i) << 1.0, t, 2.0 * t * t - 1.0, t * (4.0 * t * t - 3.0);
  }
  const Eigen::Map<const Eigen::VectorXd> depth(cloud.depth_mm.data(), n);
  const Eigen::VectorXd c = design.colPivHouseholderQr().solve(depth);
  if (!c.allFinite()) return std::nullopt;
  return Cubic{c[0] - c[1] + c[2] - c[3], (design * c - depth).norm() / depth.norm()};
}

/// The ball's place on its line of sight for which the cubic's constant is zero; of several, the
/// one whose cubic fits best. Looked for within 1.5 mm of z_mm.
std::optional<Eigen::Vector3d> without_constant(const std::vector<Sample>& samples,
                                                const Ray& sight,
                                                double z_mm,
                                                double radius_mm,
                                                double x_max) {
  constexpr double kReachMm = 1.5, kStepMm = 0.05;
  std::optional<double> found_mm, nearest_mm;
  double nearest_constant = std::numeric_limits<double>::infinity();
  double least_misfit = std::numeric_limits<double>::infinity();
  std::optional<Cubic> before;
  for (double z = z_mm - kReachMm; z < z_mm + kReachMm; z += kStepMm) {
    const auto here = cubic_through(cloud_of(samples, sight.point_at(z), radius_mm), x_max);
    if (before && here && before->at_zero * here->at_zero <= 0.0 && here->misfit < least_misfit) {
      const double drop = before->at_zero - here->at_zero;
      found_mm = z - kStepMm * (drop == 0.0 ? 0.0 : 1.0 - before->at_zero / drop);
      least_misfit = here->misfit;
    }
    if (here && std::abs(here->at_zero) < nearest_constant) {
      nearest_constant = std::abs(here->at_zero);
      nearest_mm = z;
    }
    before = here;
  }
  if (!found_mm) found_mm = nearest_mm;
  if (!found_mm) return std::nullopt;
  return sight.point_at(*found_mm);
}

/// What there is to work with for one press.
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

/// The ball that leaves the face at the circle, taken as an ellipse would be: by its mean radius.
Result<Eigen::Vector3d> by_contact_line(const Border& border, const Face& face) {
  constexpr int kPlaces = 72;
  const Eigen::Vector3d foot =
      untouched_point_mm(border.middle, face.layer_mm, MappingAlong::kNormal);
  double radius_mm = 0;
  int seen = 0;
  for (int i = 0; i < kPlaces; ++i) {
    const double turn = 2.0 * M_PI * i / kPlaces;
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

/// The ball whose outline is seen.
Result<Eigen::Vector3d> by_cone(const OutlinePress& input) {
  const Press& press = *input.press;
  const TangentArc arc = find_tangent_arc(press, input.guess.centre_mm, press.ball_radius_mm);
  if (arc.arc_deg < kLeastArcDeg)
    return no_ball(
        press,
        en::say("{:.0f} degrees of the ball's outline are seen, a cone needs {:.0f}; the "
                "rest of the dark border is where the skin leaves the ball",
                arc.arc_deg,
                kLeastArcDeg));
  std::vector<Eigen::Vector3d> directions;
  for (const OutlinePoint& point : arc.points) directions.push_back(point.direction);
  const auto centre = fit_ball_to_outline(directions, press.ball_radius_mm);
  if (!centre) return no_ball(press, en::say("no cone touches the outline"));
  return *centre;
}

/// The samples of a press that the circle holds, and the largest difference among them.
struct Inside {
  std::vector<Sample> samples;
  double x_max = 0;
};

Inside inside_of(const Border& border, const Face& face) {
  Inside inside;
  for (const Sample& sample : sample_press(border.press, face, kBlockPx).samples)
    if ((sample.pixel - border.circle.centre).norm() < border.circle.radius) {
      inside.samples.push_back(sample);
      inside.x_max = std::max(inside.x_max, sample.x);
    }
  return inside;
}

/// The paper's: the circle says how far the ball is; in which direction, the ball finder, moved to
/// the paper's untouched face, which lies along z: on an inclined face the dark disc does not lie
/// around the ball's middle, and taking it to would cost the paper's method millimetres.
Result<Eigen::Vector3d> by_circle_and_constant(const Border& border,
                                               const Camera& camera,
                                               const Face& face) {
  const double radius_mm = border.press.ball_radius_mm;
  const auto to_middle = camera.unproject(border.circle.centre);
  const auto to_edge =
      camera.unproject(border.circle.centre + Eigen::Vector2d(0.0, border.circle.radius));
  const auto local = border.press.shape.at(border.guess.disc_px.x(), border.guess.disc_px.y());
  const Error no_sight =
      no_ball(border.press, en::say("the camera does not see the circle's middle"));
  if (!to_middle || !to_edge || !local) return no_sight;
  const Eigen::Vector3d near = border.guess.centre_mm +
                               untouched_point_mm(*local, face.layer_mm, MappingAlong::kZ) -
                               untouched_point_mm(*local, face.layer_mm, MappingAlong::kNormal);
  const auto near_px = camera.project(near);
  const auto sight = near_px ? camera.unproject(*near_px) : std::nullopt;
  if (!sight) return no_sight;
  double z_mm = near.z();
  if (camera.is_perspective()) {
    const double sine = sine_between(to_edge->direction, to_middle->direction);
    if (!(sine > 0.0)) return no_sight;
    // A dark border that is the contact's rim, not the ball's outline, puts the ball far behind the
    // finger, where it touches nothing; the search then begins at the face.
    const double by_circle_mm = radius_mm / (sine * sight->direction.norm());
    if (std::abs(by_circle_mm - z_mm) < radius_mm) z_mm = by_circle_mm;
  }
  const Inside inside = inside_of(border, face);
  const auto found = inside.x_max > 0.0
                         ? without_constant(inside.samples, *sight, z_mm, radius_mm, inside.x_max)
                         : std::nullopt;
  if (!found) return no_ball(border.press, en::say("no place of the ball gives a cubic"));
  return *found;
}

struct Solved {
  BallFit ball;
  Cloud cloud;
};

Result<Solved> solve_press(const OutlinePress& input,
                           CalibrationMethod method,
                           const Camera& camera,
                           const Face& face) {
  const Press& press = *input.press;
  const auto border = border_of(input);
  if (!border) return border.error();
  const auto centre = method == CalibrationMethod::kCone ? by_cone(input)
                      : method == CalibrationMethod::kCircle
                          ? by_contact_line(*border, face)
                          : by_circle_and_constant(*border, camera, face);
  if (!centre) return centre.error();
  Solved solved;
  solved.cloud = cloud_of(inside_of(*border, face).samples, *centre, press.ball_radius_mm);
  if (solved.cloud.x.size() < 50)
    return no_ball(press,
                   en::say("the ball that follows from the dark border hardly touches the face"));
  solved.ball.press = press.name;
  solved.ball.radius_mm = press.ball_radius_mm;
  solved.ball.centre_mm = *centre;
  solved.ball.centre_sd_mm.setZero();
  solved.ball.cut_by_edge = input.guess.cut_by_edge;
  solved.ball.depth_mm =
      *std::max_element(solved.cloud.depth_mm.begin(), solved.cloud.depth_mm.end());
  return solved;
}

std::optional<MappingCurve> curve_through(const std::vector<Solved>& presses,
                                          int coefficients,
                                          double x_max) {
  std::vector<double> x, depth;
  for (const Solved& s : presses) {
    x.insert(x.end(), s.cloud.x.begin(), s.cloud.x.end());
    depth.insert(depth.end(), s.cloud.depth_mm.begin(), s.cloud.depth_mm.end());
  }
  MappingCurve curve({MappingKind::kPolynomial, coefficients}, x_max);
  Eigen::MatrixXd design(static_cast<Eigen::Index>(x.size()), coefficients);
  std::vector<double> row(static_cast<std::size_t>(coefficients));
  for (std::size_t i = 0; i < x.size(); ++i) {
    (void)curve.depth_mm(x[i], row.data());
    design.row(static_cast<Eigen::Index>(i)) =
        Eigen::Map<const Eigen::RowVectorXd>(row.data(), coefficients);
  }
  const Eigen::Map<const Eigen::VectorXd> target(depth.data(), design.rows());
  curve.values() = design.colPivHouseholderQr().solve(target);
  if (!Mapping::create(mapping_parameters(curve, MappingAlong::kZ))) return std::nullopt;
  return curve;
}

}  // namespace

BallFinderOptions ball_finder_for(CalibrationMethod method) {
  return method == CalibrationMethod::kPaper
             ? BallFinderOptions{.opening_px = 5, .second_contact = 1.0}
             : BallFinderOptions{};
}

Result<Calibration> calibrate_by_outline(const std::vector<OutlinePress>& presses,
                                         CalibrationMethod method,
                                         const Camera& camera,
                                         const Face& face,
                                         const Job& job,
                                         Calibration calibration) {
  std::vector<Solved> solved;
  Message reason;
  for (const OutlinePress& input : presses) {
    if (job.stop_requested()) break;
    auto one = solve_press(input, method, camera, face);
    if (one) {
      solved.push_back(std::move(*one));
    } else {
      calibration.left_out.push_back(en::say("{}.", one.error().message()));
      reason = one.error().what;
    }
  }
  if (solved.empty())
    return Error{en::say("no ball follows from the dark border of any of {} presses ({})",
                         presses.size(),
                         reason),
                 "",
                 en::say("the joint method, which fits the ball itself")};
  double x_max = 0;
  for (const Solved& s : solved)
    for (const double x : s.cloud.x) x_max = std::max(x_max, x);
  x_max = std::min(x_max, 1.0);
  std::optional<MappingCurve> curve;
  for (int degree = kDegree; degree >= 1 && !curve; --degree)
    curve = curve_through(solved, degree, x_max);
  if (!curve)
    return Error{en::say("the polynomial through the balls' depths does not increase"),
                 "",
                 en::say("the joint method, or more presses of different depth")};
  const int degree = curve->family().coefficients;
  if (degree != kDegree)
    calibration.remarks.push_back(
        en::say("the cubic does not increase; degree {} was used instead", degree));
  calibration.mapping = mapping_parameters(*curve, MappingAlong::kZ);
  calibration.degree_choice =
      degree == kDegree ? en::at(curve->family().name(), en::say("the source paper's"))
                        : en::say("{}, in place of the paper's cubic", curve->family().name());
  for (Solved& s : solved) {
    double sum = 0;
    for (std::size_t i = 0; i < s.cloud.x.size(); ++i)
      sum += std::abs(curve->depth_mm(s.cloud.x[i]) - s.cloud.depth_mm[i]);
    s.ball.residual_mm = sum / static_cast<double>(s.cloud.x.size());
    calibration.residual_mm += s.ball.residual_mm / static_cast<double>(solved.size());
    calibration.balls.push_back(s.ball);
  }
  return calibration;
}

}  // namespace alltact
