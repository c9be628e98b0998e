#include "calibration/paper_method.h"

#include "calibration/joint_fit.h"
#include "calibration/mapping_curve.h"
#include "calibration/model_choice.h"
#include "calibration/press_samples.h"
#include "core/geometry/ball.h"
#include "core/geometry/circle_fit.h"
#include "core/numerics/bilinear.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Dense>
#include <fmt/format.h>

namespace alltact {
namespace {

constexpr int kDegree = 3;
constexpr int kBlockPx = 2;

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

struct Solved {
  BallFit ball;
  std::vector<Sample> samples;
  Cloud cloud;
};

std::optional<Solved> solve_press(const PaperPress& input,
                                  const Camera& camera,
                                  const Face& face,
                                  double radius_mm) {
  const Press& press = *input.press;
  const auto circle =
      border_circle(press.difference.x, input.guess.disc_px, input.guess.disc_radius_px);
  if (!circle) return std::nullopt;
  const auto to_middle = camera.unproject(circle->centre);
  const auto to_edge = camera.unproject(circle->centre + Eigen::Vector2d(0.0, circle->radius));
  const auto local = press.shape.at(input.guess.disc_px.x(), input.guess.disc_px.y());
  if (!to_middle || !to_edge || !local) return std::nullopt;
  // The circle says how far the ball is; in which direction, the ball finder, moved to the paper's
  // untouched face, which lies along z: on an inclined face the dark disc does not lie around the
  // ball's middle, and taking it to would cost the paper's method millimetres.
  const Eigen::Vector3d near = input.guess.centre_mm +
                               untouched_point_mm(*local, face.layer_mm, MappingAlong::kZ) -
                               untouched_point_mm(*local, face.layer_mm, MappingAlong::kNormal);
  const auto near_px = camera.project(near);
  const auto sight = near_px ? camera.unproject(*near_px) : std::nullopt;
  if (!sight) return std::nullopt;
  double z_mm = near.z();
  if (camera.is_perspective()) {
    const double sine = sine_between(to_edge->direction, to_middle->direction);
    if (!(sine > 0.0)) return std::nullopt;
    // A dark border that is the contact's rim, not the ball's outline, puts the ball far behind the
    // finger, where it touches nothing; the search then begins at the face.
    const double by_circle_mm = radius_mm / (sine * sight->direction.norm());
    if (std::abs(by_circle_mm - z_mm) < radius_mm) z_mm = by_circle_mm;
  }
  Solved solved;
  for (const Sample& sample : sample_press(press, face, kBlockPx).samples)
    if ((sample.pixel - circle->centre).norm() < circle->radius) solved.samples.push_back(sample);
  double x_max = 0;
  for (const Sample& sample : solved.samples) x_max = std::max(x_max, sample.x);
  if (!(x_max > 0.0)) return std::nullopt;

  const auto found = without_constant(solved.samples, *sight, z_mm, radius_mm, x_max);
  if (!found) return std::nullopt;
  const Eigen::Vector3d centre = *found;
  solved.cloud = cloud_of(solved.samples, centre, radius_mm);
  if (solved.cloud.x.size() < 50) return std::nullopt;
  solved.ball.press = press.name;
  solved.ball.centre_mm = centre;
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

BallFinderOptions paper_ball_finder() {
  return {.opening_px = 5, .second_contact = 1.0};
}

Result<Calibration> calibrate_as_paper(const std::vector<PaperPress>& presses,
                                       const Camera& camera,
                                       const Face& face,
                                       double ball_radius_mm,
                                       const Job& job,
                                       Calibration calibration) {
  std::vector<Solved> solved;
  for (const PaperPress& input : presses) {
    if (job.stop_requested()) break;
    if (auto one = solve_press(input, camera, face, ball_radius_mm)) {
      solved.push_back(std::move(*one));
    } else {
      calibration.left_out.push_back(fmt::format(
          "{}: no ball follows from the circle on its dark border.", input.press->name));
    }
  }
  if (solved.empty())
    return Error{"the paper's circle led to no ball in any press",
                 "",
                 "the joint method, which fits the ball itself"};
  double x_max = 0;
  for (const Solved& s : solved)
    for (const double x : s.cloud.x) x_max = std::max(x_max, x);
  x_max = std::min(x_max, 1.0);
  std::optional<MappingCurve> curve;
  int degree = kDegree;
  for (; degree >= 1 && !curve; --degree) curve = curve_through(solved, degree, x_max);
  if (!curve)
    return Error{"the paper's polynomial does not increase",
                 "",
                 "the joint method, or more presses of different depth"};
  if (curve->family().coefficients != kDegree)
    calibration.remarks.push_back(fmt::format(
        "the cubic does not increase; degree {} was used instead", curve->family().coefficients));
  calibration.mapping = mapping_parameters(*curve, MappingAlong::kZ);
  calibration.degree_choice = curve->family().coefficients == kDegree
                                  ? curve->family().name() + ": the source paper's"
                                  : curve->family().name() + ", in place of the paper's cubic";
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
