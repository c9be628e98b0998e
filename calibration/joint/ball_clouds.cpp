#include "calibration/joint/ball_clouds.h"

#include "calibration/joint/mapping_curve.h"
#include "calibration/joint/sample_misfit.h"
#include "calibration/joint/stored_curve.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Dense>

namespace alltact {
namespace {

constexpr int kCloudDegree = 3;
constexpr int kCloudBlockPx = 2;
constexpr std::size_t kMinCloudSamples = 50;

std::optional<MappingCurve> curve_through(const std::vector<BallCloud>& clouds,
                                          int coefficients,
                                          double x_max) {
  std::vector<double> x, depth;
  for (const BallCloud& cloud : clouds) {
    x.insert(x.end(), cloud.x.begin(), cloud.x.end());
    depth.insert(depth.end(), cloud.depth_mm.begin(), cloud.depth_mm.end());
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

std::vector<Sample> samples_inside(const Press& press, const Face& face, const Circle& circle) {
  std::vector<Sample> samples = sample_press(press, face, kCloudBlockPx).samples;
  std::erase_if(samples, [&](const Sample& sample) {
    return (sample.pixel - circle.centre).norm() >= circle.radius;
  });
  return samples;
}

Result<BallCloud> cloud_of_ball(const Press& press,
                                const std::vector<Sample>& samples,
                                const Eigen::Vector3d& centre_mm,
                                bool cut_by_edge) {
  BallCloud cloud;
  for (const Sample& sample : samples) {
    const double depth = ball_depth_mm(sample, MappingAlong::kZ, centre_mm, press.ball_radius_mm);
    if (!(depth > 0.0)) continue;
    cloud.x.push_back(sample.x);
    cloud.depth_mm.push_back(depth);
  }
  if (cloud.x.size() < kMinCloudSamples)
    return Error{en::say("the ball that follows from the dark border hardly touches the face"),
                 press.name,
                 ""};
  cloud.ball.press = press.name;
  cloud.ball.radius_mm = press.ball_radius_mm;
  cloud.ball.centre_mm = centre_mm;
  cloud.ball.centre_sd_mm.setZero();
  cloud.ball.cut_by_edge = cut_by_edge;
  cloud.ball.depth_mm = *std::max_element(cloud.depth_mm.begin(), cloud.depth_mm.end());
  return cloud;
}

Result<Calibration> fit_cubic_mapping(const std::vector<BallCloud>& clouds,
                                      Calibration calibration) {
  double x_max = 0;
  for (const BallCloud& cloud : clouds)
    for (const double x : cloud.x) x_max = std::max(x_max, x);
  x_max = std::min(x_max, 1.0);
  std::optional<MappingCurve> curve;
  for (int degree = kCloudDegree; degree >= 1 && !curve; --degree)
    curve = curve_through(clouds, degree, x_max);
  if (!curve)
    return Error{en::say("the polynomial through the balls' depths does not increase"),
                 "",
                 en::say("the joint method, or more presses of different depth")};
  const int degree = curve->family().coefficients;
  if (degree != kCloudDegree)
    calibration.remarks.push_back(
        en::say("the cubic does not increase; degree {} was used instead", degree));
  calibration.mapping = mapping_parameters(*curve, MappingAlong::kZ);
  calibration.degree_choice =
      degree == kCloudDegree ? en::at(curve->family().name(), en::say("the source paper's"))
                             : en::say("{}, in place of the paper's cubic", curve->family().name());
  for (const BallCloud& cloud : clouds) {
    BallFit ball = cloud.ball;
    double sum = 0;
    for (std::size_t i = 0; i < cloud.x.size(); ++i)
      sum += std::abs(curve->depth_mm(cloud.x[i]) - cloud.depth_mm[i]);
    ball.residual_mm = sum / static_cast<double>(cloud.x.size());
    calibration.residual_mm += ball.residual_mm / static_cast<double>(clouds.size());
    calibration.balls.push_back(ball);
  }
  return calibration;
}

}  // namespace alltact
