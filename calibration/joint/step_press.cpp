#include "calibration/joint/step_press.h"

#include "calibration/presses/measured_pixels.h"
#include "core/numerics/median.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Dense>
#include <opencv2/imgproc.hpp>

namespace alltact {
namespace {

constexpr double kMostSamples = 20000;   // of the whole face
constexpr double kPunchedPart = 0.15;    // of the greatest difference
constexpr double kPunchedSd = 6.0;       // of the noise
constexpr double kMarginMm = 1.2;        // in which the skin comes back from an edge
constexpr double kSearchMarginMm = 0.4;  // narrow: else a line aside parts as well
constexpr int kFewest = 40;              // samples a plateau
constexpr int kSearched = 1200;          // samples are enough to find the line
constexpr std::size_t kRead = 2500;      // and so many to read the step
constexpr int kAngles = 48;
constexpr double kSeenPart = 0.5;  // of the scatter without a step: what it may be with one
constexpr double kFlatSdMm = 0.005;
constexpr double kUnevenPart = 0.3;  // of what plateaus are not flat by: what that may shift them

int block_for(const Press& press) {
  const double finite = cv::countNonZero(measured_pixels(press.difference.x));
  return std::max(2, static_cast<int>(std::ceil(std::sqrt(finite / kMostSamples))));
}

/// mm from a sample to the next.
double pitch_mm(const PressSamples& press) {
  std::vector<double> steps;
  for (std::size_t i = 1; i < press.samples.size(); ++i) {
    const Sample &a = press.samples[i - 1], &b = press.samples[i];
    if (a.pixel.y() == b.pixel.y() && b.pixel.x() - a.pixel.x() < 1.5 * press.block_px)
      steps.push_back((b.untouched_n - a.untouched_n).norm());
  }
  return steps.empty() ? 0.0 : upper_median(steps);
}

/// Keeps the largest punched part, without its border.
void keep_punched(PressSamples& press) {
  std::vector<double> x;
  for (const Sample& sample : press.samples) x.push_back(sample.x);
  const auto top = x.begin() + static_cast<std::ptrdiff_t>(0.995 * static_cast<double>(x.size()));
  std::nth_element(x.begin(), top, x.end());
  const double punched = std::max(kPunchedSd * press.x_sd, kPunchedPart * *top);
  const auto place = [&](const Sample& sample) {
    return cv::Point(static_cast<int>(std::floor(sample.pixel.x() / press.block_px)),
                     static_cast<int>(std::floor(sample.pixel.y() / press.block_px)));
  };
  cv::Point last;
  for (const Sample& sample : press.samples)
    last = {std::max(last.x, place(sample).x), std::max(last.y, place(sample).y)};
  cv::Mat mask(last.y + 3, last.x + 3, CV_8UC1, cv::Scalar(0)), labels, stats, centres;
  const cv::Point frame(1, 1);
  for (const Sample& sample : press.samples)
    if (sample.x > punched) mask.at<std::uint8_t>(place(sample) + frame) = 255;
  const int count = cv::connectedComponentsWithStats(mask, labels, stats, centres, 4, CV_32S);
  int largest = 0, area = 0;
  for (int i = 1; i < count; ++i)
    if (stats.at<int>(i, cv::CC_STAT_AREA) > area)
      largest = i, area = stats.at<int>(i, cv::CC_STAT_AREA);
  mask = labels == largest;
  if (largest == 0) mask.setTo(0);
  cv::Mat inside;
  cv::distanceTransform(mask, inside, cv::DIST_L2, cv::DIST_MASK_PRECISE);
  const double margin = kMarginMm / std::max(1e-6, pitch_mm(press));
  std::erase_if(press.samples, [&](const Sample& sample) {
    return !(static_cast<double>(inside.at<float>(place(sample) + frame)) > margin);
  });
}

void thin(std::vector<Sample>& samples) {
  const std::size_t every = samples.size() / kRead + 1;
  std::size_t kept = 0;
  for (std::size_t i = 0; i < samples.size(); i += every) samples[kept++] = samples[i];
  samples.resize(kept);
}

/// Along and across the mean face.
struct Sideways {
  Eigen::Vector3d normal, first, second;
  explicit Sideways(const Eigen::Vector3d& n) : normal(n) {
    first = normal.unitOrthogonal();
    second = normal.cross(first);
  }
  [[nodiscard]] Eigen::Vector2d of(const Eigen::Vector3d& point) const {
    return {first.dot(point), second.dot(point)};
  }
};

/// A straight line: where across.dot(place) is offset.
struct Parting {
  Eigen::Vector2d across = Eigen::Vector2d::Zero();
  double offset_mm = 0;
  double scatter = std::numeric_limits<double>::infinity();  ///< root mean square beside the planes
  double step = 0;                                           ///< in brightness
};

struct Searched {
  Eigen::Vector2d place;
  double x;
};

/// How well a plane of its own fits on either side of a line. Brightness is no straight function of
/// depth, so that a tilted punch's two levels are not parallel in it.
Parting part_along(const std::vector<Searched>& samples, const Eigen::Vector2d& across, double at) {
  struct Side {
    Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
    Eigen::Vector3d pull = Eigen::Vector3d::Zero();
    double squares = 0;
    int count = 0;
  } sides[2];
  for (const Searched& one : samples) {
    const double off = across.dot(one.place) - at;
    if (std::abs(off) < kSearchMarginMm) continue;
    Side& side = sides[off < 0 ? 0 : 1];
    const Eigen::Vector3d row(1.0, one.place.x(), one.place.y());
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
  // Where the middle of all lies on the line.
  Eigen::Vector2d middle = Eigen::Vector2d::Zero();
  for (const Searched& one : samples) middle += one.place / static_cast<double>(samples.size());
  middle += (at - across.dot(middle)) * across;
  const Eigen::Vector3d there(1.0, middle.x(), middle.y());
  return {across,
          at,
          std::sqrt(left / (sides[0].count + sides[1].count)),
          there.dot(planes[1] - planes[0])};
}

Parting best_parting(const std::vector<Searched>& samples) {
  Parting best;
  for (int i = 0; i < kAngles; ++i) {
    const double angle = M_PI * i / kAngles;
    const Eigen::Vector2d across(std::cos(angle), std::sin(angle));
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const Searched& one : samples) {
      low = std::min(low, across.dot(one.place));
      high = std::max(high, across.dot(one.place));
    }
    for (double at = low + kMarginMm; at < high - kMarginMm; at += 0.25 * kMarginMm)
      if (const Parting one = part_along(samples, across, at); one.scatter < best.scatter)
        best = one;
  }
  return best;
}

/// What one plane leaves of the brightness.
double scatter_without(const std::vector<Searched>& samples) {
  Eigen::MatrixXd rows(static_cast<Eigen::Index>(samples.size()), 3);
  Eigen::VectorXd x(rows.rows());
  for (Eigen::Index i = 0; i < rows.rows(); ++i) {
    const Searched& one = samples[static_cast<std::size_t>(i)];
    rows.row(i) << 1.0, one.place.x(), one.place.y();
    x[i] = one.x;
  }
  const Eigen::VectorXd left = x - rows * rows.colPivHouseholderQr().solve(x);
  return std::sqrt(left.squaredNorm() / static_cast<double>(samples.size()));
}

Error refused(const Press& press, Message what) {
  return {std::move(what),
          press.name,
          en::say("pressing the punch in until the skin lies on both of its levels, each 4 mm wide "
                  "or more")};
}

}  // namespace

Result<StepSamples> find_step(const Press& press, const Face& face) {
  StepSamples step{press.name,
                   press.step_mm.value_or(0.0),
                   sample_press(press, face, block_for(press)),
                   {},
                   Eigen::Vector3d::Zero()};
  std::vector<Sample>& samples = step.samples.samples;
  if (!samples.empty()) keep_punched(step.samples);
  if (samples.size() < 2 * kFewest)
    return refused(press, en::say("the punch touches too little of the face"));
  for (const Sample& sample : samples) step.face_normal += sample.normal;
  step.face_normal.normalize();
  const Sideways sideways(step.face_normal);
  std::vector<Searched> searched;
  const std::size_t every = samples.size() / kSearched + 1;
  for (std::size_t i = 0; i < samples.size(); i += every)
    searched.push_back({sideways.of(samples[i].untouched_n), samples[i].x});
  const Parting parting = best_parting(searched);
  if (!(parting.scatter < kSeenPart * scatter_without(searched)) ||
      !(std::abs(parting.step) > kPunchedSd * step.samples.x_sd))
    return refused(press, en::say("no step is to be seen"));
  const auto off_mm = [&](const Sample& sample) {
    return parting.across.dot(sideways.of(sample.untouched_n)) - parting.offset_mm;
  };
  std::erase_if(samples,
                [&](const Sample& sample) { return std::abs(off_mm(sample)) < kMarginMm; });
  thin(samples);
  for (const Sample& sample : samples)
    step.is_lower.push_back((off_mm(sample) < 0) == (parting.step > 0));
  const auto lower = std::count(step.is_lower.begin(), step.is_lower.end(), char{1});
  if (lower < kFewest || static_cast<std::ptrdiff_t>(samples.size()) - lower < kFewest)
    return refused(press, en::say("one of the punch's levels touches too little of the face"));
  return step;
}

StepReading read_step(const StepSamples& step,
                      const MappingCurve& curve,
                      const double* values,
                      MappingAlong along) {
  const std::vector<Sample>& samples = step.samples.samples;
  const auto count = static_cast<Eigen::Index>(samples.size());
  const Eigen::Index numbers = curve.family().numbers();
  const Sideways sideways(step.face_normal);
  Eigen::MatrixXd rows(count, 4), by_values(count, numbers);
  Eigen::VectorXd up(count), noise(count);
  std::vector<Eigen::Vector3d> towards;  // where a millimetre more of depth moves a point to
  for (Eigen::Index i = 0; i < count; ++i) {
    const Sample& sample = samples[static_cast<std::size_t>(i)];
    Eigen::VectorXd gradient(numbers);
    const double depth = curve.evaluate(values, sample.x, sample.place, gradient.data());
    const bool is_normal = along == MappingAlong::kNormal;
    Eigen::Vector3d direction = is_normal ? sample.normal : Eigen::Vector3d::UnitZ();
    if (along == MappingAlong::kProjected) direction /= sample.cos_incline;
    const Eigen::Vector3d point =
        (is_normal ? sample.untouched_n : sample.untouched_z) - depth * direction;
    const Eigen::Vector2d place = sideways.of(point);
    rows.row(i) << 1.0, place.x(), place.y(), step.is_lower[static_cast<std::size_t>(i)];
    up[i] = sideways.normal.dot(point);
    by_values.row(i) = gradient.transpose();
    noise[i] = curve.slope_mm(sample.x) * step.samples.x_sd;
    towards.push_back(-direction);
  }
  const Eigen::Matrix4d inverse = (rows.transpose() * rows).inverse();
  const Eigen::Vector4d planes = inverse * (rows.transpose() * up);
  // By what a point that rises lifts the lower level over the other.
  const Eigen::VectorXd weight = rows * inverse.col(3);
  const double length = std::sqrt(1.0 + planes[1] * planes[1] + planes[2] * planes[2]);
  const Eigen::Vector3d across =
      (sideways.normal - planes[1] * sideways.first - planes[2] * sideways.second) / length;
  StepReading reading;
  reading.height_mm = planes[3] / length;
  reading.by_values = Eigen::VectorXd::Zero(numbers);
  for (Eigen::Index i = 0; i < count; ++i)
    reading.by_values +=
        weight[i] * across.dot(towards[static_cast<std::size_t>(i)]) * by_values.row(i).transpose();
  const double uneven2 =
      ((up - rows * planes).squaredNorm() - noise.squaredNorm()) / static_cast<double>(count);
  reading.sd_mm = std::hypot(2.0 * weight.cwiseProduct(noise).norm(),  // neighbours share noise
                             kUnevenPart * std::sqrt(std::max(0.0, uneven2)),
                             kFlatSdMm);
  return reading;
}

}  // namespace alltact
