#include "core/sensing/surface_measurement.h"

#include "core/sensing/depth/depth_sd.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

#include <Eigen/Dense>

namespace alltact {
namespace {

constexpr std::size_t kMinBallPoints = 30, kMinRoughnessPoints = 30, kMinPlanePoints = 10,
                      kMinStepPoints = 12;
constexpr std::size_t kCoarseSteps = 64;
constexpr double kMinNoiseMm = 1e-6;  // finite weights for pixels without noise

Error too_few(std::size_t have, std::size_t need) {
  return {en::say("{} measured pixels where {} are needed", have, need), "",
          en::say("a larger piece, or one that is measured")};
}

Error at_a_limit() {
  return {en::say("part of this piece is at a limit of the measuring range"), "",
          en::say("a piece that is pressed in less deeply")};
}

/// The patch with all depths shifted by their common standard deviation.
SurfacePatch moved(const SurfacePatch& patch) {
  SurfacePatch other = patch;
  for (SurfacePoint& point : other.points) point.depth_mm += point.common_mm;
  return other;
}

bool has_limit(const SurfacePatch& patch) {
  return std::any_of(patch.points.begin(), patch.points.end(),
                     [](const SurfacePoint& point) { return point.is_limit; });
}

Eigen::Vector3d mean_point_mm(const SurfacePatch& patch) {
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  for (const SurfacePoint& point : patch.points) middle += point.point_mm();
  return middle / static_cast<double>(patch.points.size());
}

/// Initial sphere from a linear fit: |p|^2 is linear in centre and R^2 - |c|^2.
std::optional<Eigen::Vector4d> initial_sphere(const std::vector<const SurfacePoint*>& points,
                                              const Eigen::Vector3d& middle) {
  Eigen::Matrix4d normal = Eigen::Matrix4d::Zero();
  Eigen::Vector4d right = Eigen::Vector4d::Zero();
  for (const SurfacePoint* point : points) {
    const Eigen::Vector3d p = point->point_mm() - middle;
    const Eigen::Vector4d row(2 * p.x(), 2 * p.y(), 2 * p.z(), 1);
    normal += row * row.transpose();
    right += row * p.squaredNorm();
  }
  const Eigen::FullPivLU<Eigen::Matrix4d> lu(normal);
  if (!lu.isInvertible()) return std::nullopt;
  const Eigen::Vector4d found = lu.solve(right);
  const double squared = found[3] + found.head<3>().squaredNorm();
  if (!(squared > 0) || !std::isfinite(squared)) return std::nullopt;
  return Eigen::Vector4d(found[0], found[1], found[2], std::sqrt(squared));
}

/// Gauss-Newton on the distances from the sphere, each weighted by the effect of its noise along z.
std::optional<FittedBall> fit_sphere(const std::vector<const SurfacePoint*>& points,
                                     double noise_pixels) {
  constexpr int kRounds = 60;
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  for (const SurfacePoint* point : points) middle += point->point_mm();
  middle /= static_cast<double>(points.size());
  const auto begin = initial_sphere(points, middle);
  if (!begin) return std::nullopt;
  Eigen::Vector4d now = *begin;
  Eigen::Matrix4d normal;
  double squares = 0;
  for (int round = 0; round < kRounds; ++round) {
    normal.setZero();
    Eigen::Vector4d right = Eigen::Vector4d::Zero();
    squares = 0;
    for (const SurfacePoint* point : points) {
      const Eigen::Vector3d from = point->point_mm() - middle - now.head<3>();
      const double distance = from.norm();
      if (!(distance > 0)) return std::nullopt;
      const Eigen::Vector3d direction = from / distance;
      const double off = distance - now[3];
      const double sd =
          std::max(point->noise_mm, kMinNoiseMm) * std::max(std::abs(direction.z()), 0.05);
      const Eigen::Vector4d row(-direction.x(), -direction.y(), -direction.z(), -1);
      normal += row * row.transpose() / (sd * sd);
      right += row * off / (sd * sd);
      squares += off * off;
    }
    const Eigen::LDLT<Eigen::Matrix4d> solver(normal);
    if (solver.info() != Eigen::Success || !(solver.rcond() > 1e-14)) return std::nullopt;
    const Eigen::Vector4d step = solver.solve(right);
    now -= step;
    if (!now.allFinite() || !(now[3] > 0)) return std::nullopt;
    if (step.norm() < 1e-12 * now[3]) break;
  }
  const Eigen::Matrix4d covariance = normal.inverse() * noise_pixels;
  return FittedBall{middle + now.head<3>(),
                    {now[3], std::sqrt(std::max(covariance(3, 3), 0.0))},
                    std::sqrt(squares / static_cast<double>(points.size())),
                    points.size()};
}

/// Initial choice of points: half the largest depth or more.
std::vector<std::size_t> deep_half(const SurfacePatch& patch) {
  double deepest = 0;
  for (const SurfacePoint& point : patch.points) deepest = std::max(deepest, point.depth_mm);
  std::vector<std::size_t> chosen;
  for (std::size_t i = 0; i < patch.points.size(); ++i)
    if (patch.points[i].depth_mm > 0 && patch.points[i].depth_mm >= 0.5 * deepest)
      chosen.push_back(i);
  return chosen;
}

/// The same choice by the depth of the ball. Noise of single depths would choose the points that
/// fit it.
std::vector<std::size_t> deep_half_of(const FittedBall& ball, const SurfacePatch& patch) {
  std::vector<double> depth_mm(patch.points.size(), 0);
  double deepest = 0;
  for (std::size_t i = 0; i < depth_mm.size(); ++i) {
    const Eigen::Vector3d from = patch.points[i].untouched_mm - ball.centre_mm;
    const double squared =
        ball.radius_mm.value * ball.radius_mm.value - from.head<2>().squaredNorm();
    if (squared > 0) depth_mm[i] = from.z() + std::sqrt(squared);
    deepest = std::max(deepest, depth_mm[i]);
  }
  std::vector<std::size_t> chosen;
  for (std::size_t i = 0; i < depth_mm.size(); ++i)
    if (depth_mm[i] > 0 && depth_mm[i] >= 0.5 * deepest) chosen.push_back(i);
  return chosen;
}

std::vector<const SurfacePoint*> points_of(const SurfacePatch& patch,
                                           const std::vector<std::size_t>& chosen) {
  std::vector<const SurfacePoint*> points;
  for (const std::size_t i : chosen)
    if (!patch.points[i].is_limit) points.push_back(&patch.points[i]);
  return points;
}

/// Regression line through one side of a step.
struct Side {
  std::vector<double> along_mm, depth_mm;
  double noise_square = 0;  // sum
  bool has_limit = false;
  double slope = 0, slope_sd = 0, misfit_mm = 0, noise_mm = 0, independent = 1;

  void add(double along, const SurfacePoint& point) {
    along_mm.push_back(along);
    depth_mm.push_back(point.depth_mm);
    noise_square += std::pow(std::max(point.noise_mm, kMinNoiseMm), 2);
    has_limit |= point.is_limit;
  }
  [[nodiscard]] double length_mm() const {
    return along_mm.empty() ? 0 : along_mm.back() - along_mm.front();
  }
  void fit(double noise_pixels) {
    const auto n = static_cast<double>(along_mm.size());
    const double middle = std::accumulate(along_mm.begin(), along_mm.end(), 0.0) / n;
    const double mean = std::accumulate(depth_mm.begin(), depth_mm.end(), 0.0) / n;
    double second = 0, mixed = 0, square = 0;
    for (std::size_t i = 0; i < along_mm.size(); ++i) {
      const double s = along_mm[i] - middle, d = depth_mm[i] - mean;
      second += s * s, mixed += s * d, square += d * d;
    }
    noise_mm = std::sqrt(noise_square / n);
    independent = std::max(1.0, n / noise_pixels - 2);
    slope = mixed / second;
    slope_sd = noise_mm * std::sqrt(noise_pixels / second);
    misfit_mm = std::sqrt(std::max(0.0, square - slope * mixed) / n);
  }
};

/// The reason why both sides of a step are not two parallel planes; nullopt if they are.
std::optional<Error> no_planes(const SurfacePatch& line, const std::vector<double>& along_mm,
                               double at_mm, double gap_mm, double height_mm) {
  constexpr double kMinLength = 0.1;  // of the line
  constexpr double kMaxNoiseRatio = 1.5, kMaxOfStep = 0.05;
  constexpr double kSlopeSds = 4, kTiltOfStep = 0.1;
  Side before, after;
  for (std::size_t i = 0; i < along_mm.size(); ++i)
    if (std::abs(along_mm[i] - at_mm) >= gap_mm)
      (along_mm[i] < at_mm ? before : after).add(along_mm[i] - at_mm, line.points[i]);
  const double length_mm = along_mm.back() - along_mm.front();
  for (Side* side : {&before, &after}) {
    if (side->along_mm.size() < kMinStepPoints / 3 || side->length_mm() < kMinLength * length_mm)
      return Error{en::say("one side of the step is too short to be a plane"), "",
                   en::say("a line that reaches further over both sides")};
    if (side->has_limit) return at_a_limit();
    side->fit(line.noise_pixels);
    // A mean square of n independent values has a relative spread of sqrt(2 / n).
    const double spread = 1 + 2 * std::sqrt(2 / side->independent);
    const double max_mm = std::max(kMaxNoiseRatio * side->noise_mm * std::sqrt(spread),
                                   kMaxOfStep * std::abs(height_mm));
    if (side->misfit_mm > max_mm)
      return Error{en::say("one side of the step is not flat"), "",
                   en::say("a line over two planes, with the step between them")};
  }
  const double tilt = std::abs(before.slope - after.slope);
  const double max_tilt = std::max(kSlopeSds * std::hypot(before.slope_sd, after.slope_sd),
                                   kTiltOfStep * std::abs(height_mm) / (0.5 * length_mm));
  if (tilt > max_tilt)
    return Error{en::say("the two sides of the step are not parallel"), "",
                 en::say("a line over two parallel planes, with the step between them")};
  return std::nullopt;
}

}  // namespace

double noise_pixels_of_area(double smoothing_px) {
  return std::max(1.0, 4 * std::numbers::pi * smoothing_px * smoothing_px);
}

double noise_pixels_of_row(double smoothing_px) {
  return std::max(1.0, 2 * std::sqrt(std::numbers::pi) * smoothing_px);
}

Result<FittedBall> fit_ball(const SurfacePatch& patch) {
  const Error none{en::say("no ball lies in this piece"), "",
                   en::say("a round piece, visible down to half its depth")};
  std::vector<std::size_t> cap = deep_half(patch);
  std::optional<FittedBall> ball;
  constexpr int kChoices = 4;
  for (int choice = 0; choice < kChoices; ++choice) {
    const auto points = points_of(patch, cap);
    if (points.size() < kMinBallPoints) return too_few(points.size(), kMinBallPoints);
    ball = fit_sphere(points, patch.noise_pixels);
    if (!ball) return none;
    cap = deep_half_of(*ball, patch);
  }
  const SurfacePatch other = moved(patch);
  const auto if_moved = fit_sphere(points_of(other, cap), patch.noise_pixels);
  if (!if_moved) return none;
  MeasuredValue& radius = ball->radius_mm;
  radius.sd = std::hypot(radius.sd, if_moved->radius_mm.value - radius.value);
  if (!(radius.sd < 0.5 * radius.value)) return none;
  ball->points = cap.size();
  return *ball;
}

Result<PressedSurface> pressed_part(const SurfacePatch& patch, double threshold_mm) {
  double area = 0, volume = 0, flat = 0;
  double noise_of_volume = 0, common_of_volume = 0, min_area = 0, max_area = 0;
  bool is_lower_bound = false;
  for (const SurfacePoint& point : patch.points) {
    const double sd = std::hypot(point.noise_mm, point.common_mm);
    if (point.depth_mm - sd > threshold_mm) min_area += point.on_face_mm2;
    if (point.depth_mm + sd > threshold_mm) max_area += point.on_face_mm2;
    if (!(point.depth_mm > threshold_mm)) continue;
    is_lower_bound |= point.is_limit;
    area += point.on_face_mm2;
    flat += point.projected_mm2;
    volume += point.projected_mm2 * point.depth_mm;
    noise_of_volume += std::pow(point.projected_mm2 * point.noise_mm, 2);
    common_of_volume += point.projected_mm2 * point.common_mm;
  }
  if (!(area > 0))
    return Error{en::say("nothing here is deeper than {} mm", threshold_mm), "",
                 en::say("a piece where something presses")};
  PressedSurface part;
  part.area_mm2 = {area, (max_area - min_area) / 2};
  part.volume_mm3 = {volume,
                     std::hypot(std::sqrt(noise_of_volume * patch.noise_pixels), common_of_volume)};
  part.mean_mm = {volume / flat, part.volume_mm3.sd / flat};
  part.is_lower_bound = is_lower_bound;
  return part;
}

namespace {

/// Heights over a plane, with the positions on it.
struct Heights {
  std::vector<Eigen::Vector2d> at_mm;
  Eigen::VectorXd height_mm;
  double noise_squares = 0;  // sum over the points
  double area_mm2 = 0;
};

Heights heights_over(const FittedPlane& plane, const SurfacePatch& patch) {
  const Eigen::Vector3d across = plane.normal.unitOrthogonal();
  const Eigen::Vector3d along = plane.normal.cross(across);
  const Eigen::Vector3d middle = mean_point_mm(patch);
  Heights heights;
  heights.height_mm.resize(std::ssize(patch.points));
  for (Eigen::Index i = 0; const SurfacePoint& point : patch.points) {
    const Eigen::Vector3d p = point.point_mm() - middle;
    heights.at_mm.emplace_back(across.dot(p), along.dot(p));
    heights.height_mm[i++] = plane.normal.dot(p);
    heights.noise_squares += std::pow(point.noise_mm * plane.normal.z(), 2);
    heights.area_mm2 += point.on_face_mm2;
  }
  return heights;
}

/// Subtracts the polynomial of this degree. Returns its number of terms; 0: the points do not
/// determine it.
int remove_form(int degree, Heights& heights) {
  double reach = 0;
  for (const Eigen::Vector2d& at : heights.at_mm) reach = std::max(reach, at.norm());
  const int terms = (degree + 1) * (degree + 2) / 2;
  Eigen::MatrixXd form(heights.height_mm.size(), terms);
  for (Eigen::Index i = 0; const Eigen::Vector2d& at : heights.at_mm) {
    const Eigen::Vector2d p = at / reach;
    Eigen::Index k = 0;
    for (int power = 0; power <= degree; ++power)
      for (int of_y = 0; of_y <= power; ++of_y)
        form(i, k++) = std::pow(p.x(), power - of_y) * std::pow(p.y(), of_y);
    ++i;
  }
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> solver(form);
  if (solver.rank() < terms) return 0;
  heights.height_mm -= form * solver.solve(heights.height_mm).eval();
  return terms;
}

/// Gaussian weighted means around points, by cells of a sixteenth of lambda_c: a cell's points act
/// from their middle.
class GaussianMean {
 public:
  GaussianMean(const Heights& heights, double lambda_c_mm)
      : heights_(heights), cell_mm_(lambda_c_mm / kCells), lambda_mm_(lambda_c_mm) {
    low_ = heights.at_mm.front();
    Eigen::Vector2d high = low_;
    for (const Eigen::Vector2d& at : heights.at_mm)
      low_ = low_.cwiseMin(at), high = high.cwiseMax(at);
    columns_ = 1 + static_cast<int>((high.x() - low_.x()) / cell_mm_);
    rows_ = 1 + static_cast<int>((high.y() - low_.y()) / cell_mm_);
    cells_.resize(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_));
    for (Eigen::Index i = 0; const Eigen::Vector2d& at : heights.at_mm) {
      Cell& cell = cells_[index(column(at.x()), row(at.y()))];
      cell.count += 1;
      cell.at_mm += at;
      cell.height_mm += heights.height_mm[i++];
    }
    for (Cell& cell : cells_)
      if (cell.count > 0) cell.at_mm /= cell.count;
  }

  [[nodiscard]] double at(const Eigen::Vector2d& at) const {
    const double alpha_mm = kAlpha * lambda_mm_;
    const double most_mm = kReach * lambda_mm_;
    double weights = 0, sum = 0;
    const int first_row = std::max(0, row(at.y() - most_mm)),
              last_row = std::min(rows_ - 1, row(at.y() + most_mm));
    const int first = std::max(0, column(at.x() - most_mm)),
              last = std::min(columns_ - 1, column(at.x() + most_mm));
    for (int y = first_row; y <= last_row; ++y)
      for (int x = first; x <= last; ++x) {
        const Cell& cell = cells_[index(x, y)];
        if (cell.count == 0) continue;
        const double weight =
            std::exp(-std::numbers::pi * (cell.at_mm - at).squaredNorm() / (alpha_mm * alpha_mm));
        weights += weight * cell.count;
        sum += weight * cell.height_mm;
      }
    return sum / weights;  // the point's own cell counts
  }

  /// Degrees of freedom of noise that subtracting the means removes: the trace of 2 S - S S' over
  /// the area, S being the weights.
  [[nodiscard]] double removed() const {
    return 1.5 * heights_.area_mm2 / std::pow(kAlpha * lambda_mm_, 2);
  }

 private:
  static constexpr double kCells = 16;
  static constexpr double kReach = 0.7;       // weights beyond are below 1e-3 of the middle's
  static constexpr double kAlpha = 0.469719;  // sqrt(ln 2 / pi), ISO 16610-61

  struct Cell {
    double count = 0, height_mm = 0;  // sum of the heights
    Eigen::Vector2d at_mm = Eigen::Vector2d::Zero();
  };
  [[nodiscard]] int column(double x) const {
    return static_cast<int>(std::floor((x - low_.x()) / cell_mm_));
  }
  [[nodiscard]] int row(double y) const {
    return static_cast<int>(std::floor((y - low_.y()) / cell_mm_));
  }
  [[nodiscard]] std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(columns_) +
           static_cast<std::size_t>(x);
  }

  const Heights& heights_;
  double cell_mm_, lambda_mm_;
  Eigen::Vector2d low_;
  int columns_ = 1, rows_ = 1;
  std::vector<Cell> cells_;
};

/// Empty: the filter suits the patch.
std::optional<Error> unsuitable(double lambda_c_mm, const Heights& heights) {
  constexpr double kLeastPixels = 5;
  const double pixel_mm = std::sqrt(heights.area_mm2 / static_cast<double>(heights.at_mm.size()));
  if (!(lambda_c_mm >= kLeastPixels * pixel_mm))
    return Error{en::say("lambda_c of {} mm is less than five pixels here", lambda_c_mm), "",
                 en::say("{:.2f} mm or more", kLeastPixels * pixel_mm)};
  if (!(lambda_c_mm * lambda_c_mm <= heights.area_mm2))
    return Error{en::say("the piece is smaller than lambda_c of {} mm", lambda_c_mm), "",
                 en::say("a larger piece, or a smaller lambda_c")};
  return std::nullopt;
}

}  // namespace

Result<Roughness> roughness(const SurfacePatch& patch, const RoughnessFilter& filter) {
  assert(filter.form_degree >= 1 && filter.form_degree <= kMaxFormDegree);
  const std::size_t n = patch.points.size();
  if (n < kMinRoughnessPoints) return too_few(n, kMinRoughnessPoints);
  if (has_limit(patch)) return at_a_limit();
  const auto plane = fit_plane(patch);
  if (!plane) return plane.error();
  Heights heights = heights_over(*plane, patch);
  double removed = remove_form(filter.form_degree, heights);
  if (removed == 0)
    return Error{en::say("the piece is too narrow to remove its form"), "", en::say("a wider one")};
  if (filter.lambda_c_mm) {
    if (auto problem = unsuitable(*filter.lambda_c_mm, heights)) return *problem;
    const GaussianMean mean(heights, *filter.lambda_c_mm);
    Eigen::VectorXd above = heights.height_mm;
    for (Eigen::Index i = 0; const Eigen::Vector2d& at : heights.at_mm) above[i++] -= mean.at(at);
    heights.height_mm = std::move(above);
    removed += mean.removed();
  }
  const double pixels = static_cast<double>(n);
  Roughness rough;
  rough.noise_mm = std::sqrt(heights.noise_squares / pixels *
                             (1 - std::min(removed * patch.noise_pixels / pixels, 0.5)));
  rough.sz_mm = heights.height_mm.maxCoeff() - heights.height_mm.minCoeff();
  // Standard deviation of a mean square over the independent pixels, propagated through the root.
  const double squares = heights.height_mm.squaredNorm() / pixels;
  const double independent = std::max(pixels / patch.noise_pixels, 2.0);
  const double sd_of_squares = squares * std::sqrt(2 / independent);
  const double true_squares = std::max(0.0, squares - rough.noise_mm * rough.noise_mm);
  const double sq = std::sqrt(true_squares);
  rough.sq_mm = {sq, std::max(sq - std::sqrt(std::max(0.0, true_squares - sd_of_squares)),
                              std::sqrt(true_squares + sd_of_squares) - sq)};
  return rough;
}

Result<StepHeight> step_height(const SurfacePatch& line, const std::vector<double>& along_mm) {
  const std::size_t n = line.points.size();
  if (n < kMinStepPoints) return too_few(n, kMinStepPoints);
  const double begin = along_mm.front(), length = along_mm.back() - begin;
  struct Fit {
    double height, sd, misfit;
  };
  // Regression of offset, slope and step, without points nearer to the step than `gap_mm`.
  const auto fit_at = [&](double at, double gap_mm, bool is_moved) -> std::optional<Fit> {
    Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
    Eigen::Vector3d right = Eigen::Vector3d::Zero();
    double squares = 0;
    std::size_t before = 0, after = 0;
    for (std::size_t i = 0; i < n; ++i) {
      const double from = along_mm[i] - at;
      if (std::abs(from) < gap_mm) continue;
      ++(from < 0 ? before : after);
      const SurfacePoint& point = line.points[i];
      const double depth = point.depth_mm + (is_moved ? point.common_mm : 0);
      const double weight = 1 / std::pow(std::max(point.noise_mm, kMinNoiseMm), 2);
      const Eigen::Vector3d row(1, from / length, from < 0 ? 0 : 1);
      normal += weight * row * row.transpose();
      right += weight * row * depth;
      squares += weight * depth * depth;
    }
    if (before < kMinStepPoints / 3 || after < kMinStepPoints / 3) return std::nullopt;
    const Eigen::LDLT<Eigen::Matrix3d> solver(normal);
    if (solver.info() != Eigen::Success || !(solver.rcond() > 1e-13)) return std::nullopt;
    const Eigen::Vector3d found = solver.solve(right);
    const double variance = normal.inverse()(2, 2) * line.noise_pixels;
    const double used = static_cast<double>(before + after);
    return Fit{found[2], std::sqrt(variance), (squares - right.dot(found)) / used};
  };
  std::optional<Fit> best;
  double best_at = 0;
  std::size_t best_i = 1;
  // A coarse search, then all positions near its best one.
  const std::size_t coarse = std::max<std::size_t>(1, n / kCoarseSteps);
  const auto try_at = [&](std::size_t i) {
    const double at = (along_mm[i - 1] + along_mm[i]) / 2;
    const auto fit = fit_at(at, 0, false);
    if (fit && (!best || fit->misfit < best->misfit)) best = fit, best_at = at, best_i = i;
  };
  for (std::size_t i = 1; i < n; i += coarse) try_at(i);
  const std::size_t first = best_i > coarse ? best_i - coarse : 1;
  for (std::size_t i = first; i < std::min(n, best_i + coarse); ++i) try_at(i);
  const double gap_mm = 0.05 * length;
  if (best) best = fit_at(best_at, gap_mm, false);
  const auto if_moved = best ? fit_at(best_at, gap_mm, true) : std::nullopt;
  if (!if_moved || !(std::abs(best->height) > 3 * best->sd))
    return Error{en::say("no step along this line exceeds the noise"), "",
                 en::say("a line that crosses the step at a right angle")};
  if (auto problem = no_planes(line, along_mm, best_at, gap_mm, best->height)) return *problem;
  return StepHeight{{best->height, std::hypot(best->sd, if_moved->height - best->height)}, best_at};
}

namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

std::optional<double> if_finite(float value) {
  if (!std::isfinite(value)) return std::nullopt;
  return value;
}

/// Samples from one pixel to another, at most a pixel apart.
std::vector<FaceSample> samples_between(const FrameResult& result, const Face& face,
                                        const cv::Mat& sd_mm, cv::Point2d from, cv::Point2d to) {
  const int steps = std::max(1, static_cast<int>(std::ceil(cv::norm(to - from))));
  std::vector<FaceSample> samples;
  for (int i = 0; i <= steps; ++i) {
    const double fraction = static_cast<double>(i) / steps;
    if (auto sample = sample_face(result, face, sd_mm, from + fraction * (to - from)))
      samples.push_back(*sample);
  }
  return samples;
}

}  // namespace

float bilinear_value(const cv::Mat& image, double u, double v) {
  const int left = static_cast<int>(std::floor(u)), upper = static_cast<int>(std::floor(v));
  const auto across = static_cast<float>(u - left), down = static_cast<float>(v - upper);
  const int right = across > 0 ? left + 1 : left, lower = down > 0 ? upper + 1 : upper;
  if (left < 0 || upper < 0 || right >= image.cols || lower >= image.rows)
    return std::numeric_limits<float>::quiet_NaN();
  const float* a = image.ptr<float>(upper);
  const float* b = image.ptr<float>(lower);
  return (1 - down) * ((1 - across) * a[left] + across * a[right]) +
         down * ((1 - across) * b[left] + across * b[right]);
}

std::optional<FaceSample> sample_face(const FrameResult& result, const Face& face,
                                      const cv::Mat& sd_mm, cv::Point2d pixel) {
  if (!result.shape || !result.depth) return std::nullopt;
  const int u = static_cast<int>(std::lround(pixel.x)), v = static_cast<int>(std::lround(pixel.y));
  const cv::Mat& depth = result.depth->depth_mm;
  if (u < 0 || v < 0 || u >= depth.cols || v >= depth.rows) return std::nullopt;
  const auto rows = result.shape->rows(u, 0);
  if (v < rows.first || v > rows.last) return std::nullopt;
  const auto local = result.shape->at(pixel.x, pixel.y);
  if (!local) return std::nullopt;
  FaceSample sample;
  sample.pixel = pixel;
  sample.untouched_mm = untouched_point_mm(*local, face.layer_mm, MappingAlong::kZ);
  sample.depth_mm = if_finite(bilinear_value(depth, pixel.x, pixel.y));
  if (!sd_mm.empty()) sample.sd_mm = if_finite(bilinear_value(sd_mm, pixel.x, pixel.y));
  sample.flag = result.depth->flags.at<std::uint8_t>(v, u);
  return sample;
}

Profile profile_between(const FrameResult& result, const Face& face, const cv::Mat& sd_mm,
                        cv::Point2d from, cv::Point2d to) {
  Profile profile;
  double along = 0;
  const auto samples = samples_between(result, face, sd_mm, from, to);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (i > 0) along += (samples[i].untouched_mm - samples[i - 1].untouched_mm).norm();
    profile.pixels.push_back(samples[i].pixel);
    profile.along_mm.push_back(along);
    profile.depth_mm.push_back(samples[i].depth_mm.value_or(kNaN));
    profile.sd_mm.push_back(samples[i].sd_mm.value_or(kNaN));
  }
  return profile;
}

std::optional<Distance> distance_between(const FrameResult& result, const Face& face,
                                         cv::Point2d from, cv::Point2d to) {
  const auto first = sample_face(result, face, {}, from), last = sample_face(result, face, {}, to);
  if (!first || !last) return std::nullopt;
  Distance distance;
  distance.apart_mm = last->point_mm() - first->point_mm();
  distance.straight_mm = distance.apart_mm.norm();
  const auto samples = samples_between(result, face, {}, from, to);
  for (std::size_t i = 1; i < samples.size(); ++i)
    distance.along_face_mm += (samples[i].point_mm() - samples[i - 1].point_mm()).norm();
  return distance;
}

namespace {

/// Columns over which errors of the face's z are correlated.
double correlation_px(const FaceShape& shape) {
  constexpr double kCoefficients = 8;
  const auto valid = std::count_if(shape.columns().begin(), shape.columns().end(),
                                   [](const FaceColumn& column) { return column.valid; });
  return std::max(1.0, static_cast<double>(valid) / kCoefficients);
}

}  // namespace

Result<MeasuredValue> straight_distance(const FrameResult& result, const Face& face,
                                        const cv::Mat& sd_mm, cv::Point2d from, cv::Point2d to) {
  const auto first = sample_face(result, face, sd_mm, from);
  const auto second = sample_face(result, face, sd_mm, to);
  if (!first || !second)
    return Error{en::say("a point lies off the face"), "", en::say("points on the face")};
  const Eigen::Vector3d apart_mm = second->point_mm() - first->point_mm();
  const double distance_mm = apart_mm.norm();
  if (!(distance_mm > 0))
    return Error{en::say("both points are the same"), "", en::say("two different points")};
  const Eigen::Vector3d direction = apart_mm / distance_mm;
  const FaceShape& shape = *result.shape;
  // Change of the distance when the face's z is off by one standard deviation.
  const auto by_face = [&](const FaceSample& sample) {
    const auto u = static_cast<std::size_t>(
        std::clamp<long>(std::lround(sample.pixel.x), 0, shape.width_px() - 1));
    const Eigen::Vector3d sight = sample.untouched_mm / sample.untouched_mm.z();
    return direction.dot(sight) * shape.columns()[u].z_sd_mm;
  };
  const double one = by_face(*first), two = by_face(*second);
  const double columns = (to.x - from.x) / correlation_px(shape);
  const double rho = std::exp(-0.5 * columns * columns);
  const double depth = std::hypot(first->sd_mm.value_or(0), second->sd_mm.value_or(0));
  const double variance =
      one * one + two * two - 2 * rho * one * two + std::pow(direction.z() * depth, 2);
  return MeasuredValue{distance_mm, std::sqrt(std::max(variance, 0.0))};
}

namespace {

constexpr double kMaxPoints = 1500;

/// nullopt off the face.
std::optional<SurfacePoint> point_at(const FrameResult& result, const Face& face, int u, int v,
                                     const DepthErrorTerms& causes) {
  const auto local = result.shape->at(u, v);
  const auto area = result.shape->pixel_area(u, v);
  if (!local || !area) return std::nullopt;
  SurfacePoint point;
  point.untouched_mm = untouched_point_mm(*local, face.layer_mm, MappingAlong::kZ);
  point.depth_mm = static_cast<double>(result.depth->depth_mm.at<float>(v, u));
  point.noise_mm = std::hypot(causes.noise, causes.lateral);
  point.common_mm = std::hypot(causes.mapping, causes.reference, causes.light);
  point.is_limit = is_at_limit(result.depth->flags.at<std::uint8_t>(v, u));
  point.on_face_mm2 = area->on_face_mm2;
  point.projected_mm2 = area->projected_mm2;
  return point;
}

bool is_measured(const FrameResult& result) {
  return result.depth && result.reference && result.shape;
}

}  // namespace

SurfacePatch patch_in(const FrameResult& result, const Face& face, const Mapping& mapping,
                      double smoothing_px, const cv::Rect& box) {
  SurfacePatch patch;
  if (!is_measured(result)) return patch;
  const cv::Rect inside = box & cv::Rect({}, result.depth->depth_mm.size());
  const int step = std::max(1, static_cast<int>(std::ceil(std::sqrt(inside.area() / kMaxPoints))));
  const double pixels = static_cast<double>(step) * step;
  patch.noise_pixels = std::max(1.0, noise_pixels_of_area(smoothing_px) / pixels);
  DepthErrorModel error(*result.depth, *result.reference, *result.shape, mapping);
  for (int v = inside.y; v < inside.y + inside.height; v += step)
    for (int u = inside.x; u < inside.x + inside.width; u += step) {
      const auto depth_mm = static_cast<double>(result.depth->depth_mm.at<float>(v, u));
      if (!std::isfinite(depth_mm)) continue;
      auto point = point_at(result, face, u, v, error.of_depth(u, v, depth_mm));
      if (!point) continue;
      point->on_face_mm2 *= pixels;
      point->projected_mm2 *= pixels;
      patch.points.push_back(*point);
    }
  return patch;
}

SurfaceLine line_between(const FrameResult& result, const Face& face, const Mapping& mapping,
                         double smoothing_px, cv::Point2d from, cv::Point2d to) {
  SurfaceLine line;
  if (!is_measured(result)) return line;
  line.patch.noise_pixels = noise_pixels_of_row(smoothing_px);
  const cv::Rect image({}, result.depth->depth_mm.size());
  const cv::Point2d delta = to - from;
  const int steps = static_cast<int>(std::ceil(std::max(std::abs(delta.x), std::abs(delta.y))));
  DepthErrorModel error(*result.depth, *result.reference, *result.shape, mapping);
  double along_mm = 0;
  for (int i = 0; i <= steps; ++i) {
    const cv::Point2d at = from + delta * (static_cast<double>(i) / std::max(steps, 1));
    const int u = static_cast<int>(std::lround(at.x)), v = static_cast<int>(std::lround(at.y));
    if (!image.contains({u, v})) continue;
    const auto depth_mm = static_cast<double>(result.depth->depth_mm.at<float>(v, u));
    if (!std::isfinite(depth_mm)) continue;
    const auto point = point_at(result, face, u, v, error.of_depth(u, v, depth_mm));
    if (!point) continue;
    auto& points = line.patch.points;
    if (!points.empty()) along_mm += (point->untouched_mm - points.back().untouched_mm).norm();
    points.push_back(*point);
    line.along_mm.push_back(along_mm);
  }
  return line;
}

namespace {

struct Slopes {
  Eigen::Vector2d slope;       ///< dz/dx, dz/dy
  Eigen::Matrix2d covariance;  ///< from the noise
};

/// Fits z = a + b x + c y: the noise is along z.
std::optional<Slopes> slopes_of(const SurfacePatch& patch, bool is_moved) {
  const Eigen::Vector3d middle = mean_point_mm(patch);
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  for (const SurfacePoint& point : patch.points) {
    const Eigen::Vector3d p = point.point_mm() - middle;
    const double z = p.z() - (is_moved ? point.common_mm : 0);
    const double weight = 1 / std::pow(std::max(point.noise_mm, kMinNoiseMm), 2);
    const Eigen::Vector3d row(1, p.x(), p.y());
    normal += weight * row * row.transpose();
    right += weight * row * z;
  }
  // A patch is neither a thousandth nor a thousand mm wide, so that the system is well scaled.
  const Eigen::LDLT<Eigen::Matrix3d> solver(normal);
  if (solver.info() != Eigen::Success || !(solver.rcond() > 1e-12)) return std::nullopt;
  const Eigen::Vector3d found = solver.solve(right);
  const Eigen::Matrix3d covariance = normal.inverse() * patch.noise_pixels;
  return Slopes{found.tail<2>(), covariance.bottomRightCorner<2, 2>()};
}

Eigen::Vector3d normal_of(const Eigen::Vector2d& slope) {
  return Eigen::Vector3d(slope.x(), slope.y(), -1).normalized();
}

}  // namespace

Result<FittedPlane> fit_plane(const SurfacePatch& patch) {
  const Error none{en::say("so few measured pixels, or pixels on one line, define no plane"), "",
                   en::say("a larger piece, or one that is measured")};
  if (patch.points.size() < kMinPlanePoints) return none;
  if (has_limit(patch)) return at_a_limit();
  const auto slopes = slopes_of(patch, false), if_moved = slopes_of(patch, true);
  if (!slopes || !if_moved) return none;
  FittedPlane plane;
  plane.normal = normal_of(slopes->slope);
  plane.normal_if_moved = normal_of(if_moved->slope);
  const double length = std::hypot(slopes->slope.x(), slopes->slope.y(), 1);
  Eigen::Matrix<double, 3, 2> turned;  // d normal / d slope
  turned.col(0) = (Eigen::Vector3d::UnitX() - plane.normal * plane.normal.x()) / length;
  turned.col(1) = (Eigen::Vector3d::UnitY() - plane.normal * plane.normal.y()) / length;
  plane.covariance = turned * slopes->covariance * turned.transpose();
  return plane;
}

MeasuredValue angle_deg(const FittedPlane& a, const FittedPlane& b) {
  const auto angle = [](const Eigen::Vector3d& p, const Eigen::Vector3d& q) {
    return std::atan2(p.cross(q).norm(), p.dot(q)) * 180 / std::numbers::pi;
  };
  const double between = angle(a.normal, b.normal);
  // The angle changes by the noise of both normals in their common plane. Parallel normals define
  // no plane: there the larger bound, both traces, is used.
  const Eigen::Vector3d axis = a.normal.cross(b.normal);
  double variance = 0;
  if (axis.norm() > 1e-9) {
    const Eigen::Vector3d unit = axis.normalized();
    const Eigen::Vector3d direction_a = unit.cross(a.normal), direction_b = unit.cross(b.normal);
    variance =
        direction_a.dot(a.covariance * direction_a) + direction_b.dot(b.covariance * direction_b);
  } else {
    variance = a.covariance.trace() + b.covariance.trace();
  }
  const double noise = std::sqrt(std::max(variance, 0.0)) * 180 / std::numbers::pi;
  return {between, std::hypot(noise, angle(a.normal_if_moved, b.normal_if_moved) - between)};
}

}  // namespace alltact
