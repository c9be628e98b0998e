#include "calibration/joint/step_press.h"

#include "calibration/joint/pressed_part.h"
#include "calibration/presses/press.h"
#include "core/numerics/median.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Dense>
#include <opencv2/imgproc.hpp>

namespace alltact {
namespace {

constexpr double kMaxSamples = 20000;  // of the entire face
constexpr double kPunchedPart = 0.15;  // of the greatest difference
constexpr double kPunchedSd = 6.0;     // of the noise
constexpr double kMarginMm = 1.2;      // in which the skin returns from an edge
// narrow: a wider one would let a shifted line separate as well
constexpr double kSearchMarginMm = 0.4;
constexpr int kFewest = 40;          // samples a plateau
constexpr int kSearched = 1200;      // samples are enough to find the line
constexpr std::size_t kRead = 2500;  // samples are enough to measure the step
constexpr int kAngles = 48;
constexpr double kSeenPart = 0.5;  // of the scatter without a step: limit of the scatter with one
constexpr double kFlatSdMm = 0.005;
constexpr double kUnevenPart = 0.3;  // of the plateaus' unevenness: the shift it may cause

/// Distance of neighbouring samples, mm.
double pitch_mm(const PressSamples& press) {
  std::vector<double> steps;
  for (std::size_t i = 1; i < press.samples.size(); ++i) {
    const Sample &a = press.samples[i - 1], &b = press.samples[i];
    if (a.pixel.y() == b.pixel.y() && b.pixel.x() - a.pixel.x() < 1.5 * press.block_px)
      steps.push_back((b.untouched_n - a.untouched_n).norm());
  }
  return steps.empty() ? 0.0 : upper_median(steps);
}

/// Retains the largest punched region, without its border.
void select_punched(PressSamples& press) {
  std::vector<double> x;
  for (const Sample& sample : press.samples) x.push_back(sample.x);
  const auto top = x.begin() + static_cast<std::ptrdiff_t>(0.995 * static_cast<double>(x.size()));
  std::nth_element(x.begin(), top, x.end());
  const double punched = std::max(kPunchedSd * press.x_sd, kPunchedPart * *top);
  const cv::Mat mask = largest_part(
      press, [&](const Sample& sample) { return sample.x > punched; }, 4);
  cv::Mat inside;
  cv::distanceTransform(mask, inside, cv::DIST_L2, cv::DIST_MASK_PRECISE);
  const double margin = kMarginMm / std::max(1e-6, pitch_mm(press));
  std::erase_if(press.samples, [&](const Sample& sample) {
    return !(static_cast<double>(inside.at<float>(cell_of(sample, press.block_px))) > margin);
  });
}

void thin(std::vector<Sample>& samples) {
  const std::size_t every = samples.size() / kRead + 1;
  std::size_t retained = 0;
  for (std::size_t i = 0; i < samples.size(); i += every) samples[retained++] = samples[i];
  samples.resize(retained);
}

/// Coordinates in the plane of the mean face.
struct TangentFrame {
  Eigen::Vector3d normal, first, second;
  explicit TangentFrame(const Eigen::Vector3d& n) : normal(n) {
    first = normal.unitOrthogonal();
    second = normal.cross(first);
  }
  [[nodiscard]] Eigen::Vector2d of(const Eigen::Vector3d& point) const {
    return {first.dot(point), second.dot(point)};
  }
};

/// A straight line: where across.dot(position) is offset.
struct StepLine {
  Eigen::Vector2d across = Eigen::Vector2d::Zero();
  double offset_mm = 0;
  /// root mean square distance from the planes
  double scatter = std::numeric_limits<double>::infinity();
  double step = 0;  ///< in brightness
};

struct Searched {
  Eigen::Vector2d position_mm;
  double x;
};

/// Fits a separate plane on either side of a line. Brightness is no linear function of depth, so
/// the two levels of a tilted punch are not parallel in it.
StepLine fit_step_line(const std::vector<Searched>& samples, const Eigen::Vector2d& across,
                       double at) {
  struct Side {
    Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
    Eigen::Vector3d pull = Eigen::Vector3d::Zero();
    double squares = 0;
    int count = 0;
  } sides[2];
  for (const Searched& one : samples) {
    const double off = across.dot(one.position_mm) - at;
    if (std::abs(off) < kSearchMarginMm) continue;
    Side& side = sides[off < 0 ? 0 : 1];
    const Eigen::Vector3d row(1.0, one.position_mm.x(), one.position_mm.y());
    side.normal += row * row.transpose();
    side.pull += one.x * row;
    side.squares += one.x * one.x;
    ++side.count;
  }
  const int fewest = std::max<int>(12, static_cast<int>(samples.size()) / 20);
  Eigen::Vector3d planes[2];
  double left = 0;
  for (int i = 0; i < 2; ++i) {
    if (sides[i].count < fewest) return {};
    const Eigen::LDLT<Eigen::Matrix3d> solver(sides[i].normal);
    if (solver.info() != Eigen::Success || !(solver.rcond() > 1e-12)) return {};
    planes[i] = solver.solve(sides[i].pull);
    left += std::max(0.0, sides[i].squares - planes[i].dot(sides[i].pull));
  }
  // The point on the line that is nearest to the middle of all samples.
  Eigen::Vector2d middle = Eigen::Vector2d::Zero();
  for (const Searched& one : samples)
    middle += one.position_mm / static_cast<double>(samples.size());
  middle += (at - across.dot(middle)) * across;
  const Eigen::Vector3d there(1.0, middle.x(), middle.y());
  return {across, at, std::sqrt(left / (sides[0].count + sides[1].count)),
          there.dot(planes[1] - planes[0])};
}

StepLine best_step_line(const std::vector<Searched>& samples) {
  StepLine best;
  for (int i = 0; i < kAngles; ++i) {
    const double angle = M_PI * i / kAngles;
    const Eigen::Vector2d across(std::cos(angle), std::sin(angle));
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const Searched& one : samples) {
      low = std::min(low, across.dot(one.position_mm));
      high = std::max(high, across.dot(one.position_mm));
    }
    for (double at = low + kMarginMm; at < high - kMarginMm; at += 0.25 * kMarginMm)
      if (const StepLine one = fit_step_line(samples, across, at); one.scatter < best.scatter)
        best = one;
  }
  return best;
}

/// Scatter of the brightness about one plane.
double scatter_without(const std::vector<Searched>& samples) {
  Eigen::MatrixXd rows(static_cast<Eigen::Index>(samples.size()), 3);
  Eigen::VectorXd x(rows.rows());
  for (Eigen::Index i = 0; i < rows.rows(); ++i) {
    const Searched& one = samples[static_cast<std::size_t>(i)];
    rows.row(i) << 1.0, one.position_mm.x(), one.position_mm.y();
    x[i] = one.x;
  }
  const Eigen::VectorXd left = x - rows * rows.colPivHouseholderQr().solve(x);
  return std::sqrt(left.squaredNorm() / static_cast<double>(samples.size()));
}

Error refused(const Press& press, Message what) {
  return {std::move(what), press.name,
          en::say("pressing the punch in until the skin rests on both of its levels, each 4 mm "
                  "wide or more")};
}

}  // namespace

Result<StepSamples> find_step(const Press& press, const Face& face) {
  StepSamples step{press.name,
                   press.step_mm.value_or(0.0),
                   sample_press(press, face, block_px_for(press, kMaxSamples)),
                   {},
                   Eigen::Vector3d::Zero()};
  std::vector<Sample>& samples = step.samples.samples;
  if (!samples.empty()) select_punched(step.samples);
  if (samples.size() < std::size_t{2} * kFewest)
    return refused(press, en::say("the punch touches too little of the face"));
  for (const Sample& sample : samples) step.face_normal += sample.normal;
  step.face_normal.normalize();
  const TangentFrame tangent(step.face_normal);
  std::vector<Searched> searched;
  const std::size_t every = samples.size() / kSearched + 1;
  for (std::size_t i = 0; i < samples.size(); i += every)
    searched.push_back({tangent.of(samples[i].untouched_n), samples[i].x});
  const StepLine step_line = best_step_line(searched);
  if (!(step_line.scatter < kSeenPart * scatter_without(searched)) ||
      !(std::abs(step_line.step) > kPunchedSd * step.samples.x_sd))
    return refused(press, en::say("no step is visible"));
  const auto off_mm = [&](const Sample& sample) {
    return step_line.across.dot(tangent.of(sample.untouched_n)) - step_line.offset_mm;
  };
  std::erase_if(samples,
                [&](const Sample& sample) { return std::abs(off_mm(sample)) < kMarginMm; });
  thin(samples);
  for (const Sample& sample : samples)
    step.is_lower.push_back(static_cast<char>((off_mm(sample) < 0) == (step_line.step > 0)));
  const auto lower = std::count(step.is_lower.begin(), step.is_lower.end(), char{1});
  if (lower < kFewest || static_cast<std::ptrdiff_t>(samples.size()) - lower < kFewest)
    return refused(press, en::say("one of the punch's levels touches too little of the face"));
  return step;
}

StepReading read_step(const StepSamples& step, const MappingCurve& curve, const double* values,
                      MappingAlong along) {
  const std::vector<Sample>& samples = step.samples.samples;
  const auto count = static_cast<Eigen::Index>(samples.size());
  const Eigen::Index numbers = curve.family().numbers();
  const TangentFrame tangent(step.face_normal);
  Eigen::MatrixXd rows(count, 4), by_values(count, numbers);
  Eigen::VectorXd up(count), noise(count);
  std::vector<Eigen::Vector3d> towards;  // displacement of a point by a millimetre more of depth
  for (Eigen::Index i = 0; i < count; ++i) {
    const Sample& sample = samples[static_cast<std::size_t>(i)];
    Eigen::VectorXd gradient(numbers);
    const double depth = curve.at(values).depth_mm(sample.x, sample.unit_position, gradient.data());
    const bool is_normal = along == MappingAlong::kNormal;
    Eigen::Vector3d direction = is_normal ? sample.normal : Eigen::Vector3d::UnitZ();
    if (along == MappingAlong::kProjected) direction /= sample.cos_incline;
    const Eigen::Vector3d point =
        (is_normal ? sample.untouched_n : sample.untouched_z) - depth * direction;
    const Eigen::Vector2d position_mm = tangent.of(point);
    rows.row(i) << 1.0, position_mm.x(), position_mm.y(),
        step.is_lower[static_cast<std::size_t>(i)];
    up[i] = tangent.normal.dot(point);
    by_values.row(i) = gradient.transpose();
    noise[i] = curve.slope_mm(sample.x) * step.samples.x_sd;
    towards.push_back(-direction);
  }
  const Eigen::Matrix4d inverse = (rows.transpose() * rows).inverse();
  const Eigen::Vector4d planes = inverse * (rows.transpose() * up);
  // How much a rising point lifts the lower level over the other.
  const Eigen::VectorXd weight = rows * inverse.col(3);
  const double length = std::sqrt(1.0 + planes[1] * planes[1] + planes[2] * planes[2]);
  const Eigen::Vector3d across =
      (tangent.normal - planes[1] * tangent.first - planes[2] * tangent.second) / length;
  StepReading reading;
  reading.height_mm = planes[3] / length;
  reading.by_values = Eigen::VectorXd::Zero(numbers);
  for (Eigen::Index i = 0; i < count; ++i)
    reading.by_values +=
        weight[i] * across.dot(towards[static_cast<std::size_t>(i)]) * by_values.row(i).transpose();
  const double uneven2 =
      ((up - rows * planes).squaredNorm() - noise.squaredNorm()) / static_cast<double>(count);
  reading.sd_mm = std::hypot(2.0 * weight.cwiseProduct(noise).norm(),  // neighbours share noise
                             kUnevenPart * std::sqrt(std::max(0.0, uneven2)), kFlatSdMm);
  return reading;
}

}  // namespace alltact
