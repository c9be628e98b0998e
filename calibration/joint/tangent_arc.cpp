#include "calibration/joint/tangent_arc.h"

#include "core/geometry/ball.h"
#include "core/numerics/bilinear.h"

#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include <Eigen/Dense>

namespace alltact {
namespace {

// along the layer's normal: less gives no jump in brightness
constexpr double kMinHiddenMm = 0.05;
constexpr int kHalf = 12;         // samples of a profile on each side
constexpr double kStepPx = 0.5;   // between them
constexpr double kReachPx = 3.0;  // the jump lies within this distance of its expected position
constexpr double kMinArcDeg = 20.0;
constexpr double kJumpSd = 5.0;         // a jump exceeds the noise by this factor
constexpr double kMinErrorRatio = 2.0;  // squared error of the best fade over that of the best jump
constexpr double kSpacingPx = 3.5;  // images are smoothed over about a pixel: 2 sqrt(pi) of its sd
constexpr std::array<double, 3> kBlursPx{0.7, 1.1, 1.6};

using Profile = Eigen::Matrix<double, 2 * kHalf + 1, 1>;  // inside to outside

double offset_px(int i) {
  return (i - kHalf) * kStepPx;
}

std::optional<Profile> profile_at(const cv::Mat& x, const HorizonPoint& horizon) {
  Profile profile;
  for (int i = 0; i <= 2 * kHalf; ++i)
    profile[i] = bilinear(x, horizon.pixel + offset_px(i) * horizon.outward);
  if (!profile.allFinite()) return std::nullopt;
  return profile;
}

enum class Border { kJump, kFade };

/// Basis of a border at `at_px` before blurring, as columns: the level outside; inside of a jump
/// its height, the square root in which a ball's surface turns away from sight, and a slope; inside
/// of a fade, which has no height, its first three powers.
constexpr int kColumns = 4;
using Columns = Eigen::Matrix<double, 2 * kHalf + 1, kColumns>;

Columns columns_of(Border border, double at_px, double blur_px) {
  constexpr int kFine = 4;  // steps of the blurring integral per sample
  const int reach = static_cast<int>(std::ceil(3.0 * blur_px / kStepPx * kFine));
  Columns columns = Columns::Zero();
  columns.col(0).setOnes();
  for (int i = 0; i <= 2 * kHalf; ++i) {
    double sum = 0;
    for (int k = -reach; k <= reach; ++k) {
      const double off = k * kStepPx / kFine;
      const double weight = std::exp(-0.5 * off * off / (blur_px * blur_px));
      const double inside = at_px - (offset_px(i) + off);
      sum += weight;
      if (inside <= 0.0) continue;
      const double root = std::sqrt(inside);
      columns(i, 1) += weight * (border == Border::kJump ? 1.0 : inside);
      columns(i, 2) += weight * (border == Border::kJump ? root : inside * inside);
      columns(i, 3) += weight * (border == Border::kJump ? inside : inside * inside * inside);
    }
    columns.row(i).tail<kColumns - 1>() /= sum;
  }
  return columns;
}

/// A candidate position of a border, with its factorised basis.
struct Candidate {
  double at_px;
  Columns columns;
  Eigen::ColPivHouseholderQR<Columns> qr;
};

constexpr double kGridPx = 0.25;

std::vector<Candidate> candidates_of(Border border, double blur_px) {
  std::vector<Candidate> candidates;
  for (double at = -kReachPx - kGridPx; at <= kReachPx + 1.5 * kGridPx; at += kGridPx) {
    const Columns columns = columns_of(border, at, blur_px);
    candidates.push_back({at, columns, columns.colPivHouseholderQr()});
  }
  return candidates;
}

struct BorderFit {
  double at_px = 0;
  double height = 0;         ///< of the jump
  double squared_error = 0;  ///< over the profile
  double curvature = 0;      ///< of the squared error by the position, 1/px^2
};

/// The best position on the grid, refined by the parabola through it and its neighbours. nullopt
/// where the best lies at an end.
std::optional<BorderFit> fit_border(const std::vector<Candidate>& candidates, const Profile& x) {
  std::vector<double> errors;
  std::size_t best = 0;
  double height = 0;
  for (std::size_t k = 0; k < candidates.size(); ++k) {
    const Eigen::Vector4d solution = candidates[k].qr.solve(x);
    errors.push_back((x - candidates[k].columns * solution).squaredNorm());
    if (errors[k] > errors[best]) continue;
    best = k;
    const int inside = kHalf + static_cast<int>(std::lround(candidates[k].at_px / kStepPx)) - 4;
    height = candidates[k].columns.row(inside) * solution - solution[0];
  }
  if (best == 0 || best + 1 == candidates.size()) return std::nullopt;
  const double before = errors[best - 1], here = errors[best], after = errors[best + 1];
  const double bend = before - 2.0 * here + after;
  if (!(bend > 0.0)) return std::nullopt;
  BorderFit fit;
  fit.at_px = candidates[best].at_px + 0.5 * kGridPx * (before - after) / bend;
  fit.height = height;
  fit.squared_error = here;
  fit.curvature = bend / (kGridPx * kGridPx);
  return fit;
}

/// The borders of one kind along the entire arc, with the one blur that suits them best.
struct ArcFit {
  std::vector<std::optional<BorderFit>> borders;
  double squared_error = std::numeric_limits<double>::infinity();
};

ArcFit fit_arc(Border border, const std::vector<Profile>& profiles) {
  ArcFit best;
  for (const double blur_px : kBlursPx) {
    const auto candidates = candidates_of(border, blur_px);
    ArcFit fit;
    fit.squared_error = 0;
    for (const Profile& profile : profiles) {
      fit.borders.push_back(fit_border(candidates, profile));
      // Where no border of this kind fits, all of the profile's scatter remains.
      fit.squared_error += fit.borders.back()
                               ? fit.borders.back()->squared_error
                               : (profile.array() - profile.mean()).matrix().squaredNorm();
    }
    if (fit.squared_error < best.squared_error) best = std::move(fit);
  }
  return best;
}

}  // namespace

std::vector<HorizonPoint> occluding_horizon(const FaceShape& shape,
                                            const Eigen::Vector3d& centre_mm,
                                            double radius_mm,
                                            double step_deg) {
  std::vector<HorizonPoint> occluding;
  const Camera& camera = shape.camera();
  if (!camera.is_central()) return occluding;
  const auto middle = camera.project(centre_mm);
  const int count = static_cast<int>(std::lround(360.0 / step_deg));
  const auto horizon = ball_horizon_mm(true, centre_mm, radius_mm, count);
  const std::size_t n = horizon.size();
  for (std::size_t i = 0; middle && i < n; ++i) {
    const auto pixel = camera.project(horizon[i]);
    const auto before = camera.project(horizon[(i + n - 1) % n]);
    const auto after = camera.project(horizon[(i + 1) % n]);
    if (!pixel || !before || !after) continue;
    const auto local = shape.at(pixel->x(), pixel->y());
    if (!local) continue;
    const double beyond_view = local->normal.dot(horizon[i] - local->view_point_mm);
    const double hidden_mm = shape.face().layer_mm - beyond_view;
    if (!(hidden_mm > kMinHiddenMm && beyond_view > 0.0)) continue;
    const Eigen::Vector2d tangent = (*after - *before).normalized();
    Eigen::Vector2d outward(tangent.y(), -tangent.x());
    if (outward.dot(*pixel - *middle) < 0.0) outward = -outward;
    occluding.push_back({horizon[i], *pixel, outward, hidden_mm});
  }
  return occluding;
}

TangentArc find_tangent_arc(const Press& press,
                            const Eigen::Vector3d& centre_mm,
                            double radius_mm) {
  // Pieces so far apart that they share no noise.
  const double radius_px = radius_mm / press.shape.camera().mm_per_px_at(centre_mm.z());
  const double step_deg =
      360.0 / std::clamp(std::floor(2.0 * M_PI * radius_px / kSpacingPx), 12.0, 180.0);
  std::vector<HorizonPoint> horizon;
  std::vector<Profile> profiles;
  for (const HorizonPoint& point : occluding_horizon(press.shape, centre_mm, radius_mm, step_deg)) {
    const auto profile = profile_at(press.difference.x, point);
    if (!profile) continue;
    horizon.push_back(point);
    profiles.push_back(*profile);
  }
  TangentArc arc;
  if (static_cast<double>(profiles.size()) * step_deg < kMinArcDeg) return arc;
  const ArcFit jump = fit_arc(Border::kJump, profiles);
  const ArcFit fade = fit_arc(Border::kFade, profiles);
  if (!(fade.squared_error > kMinErrorRatio * jump.squared_error)) return arc;
  const double noise2 =
      jump.squared_error / (static_cast<double>(profiles.size()) * (2 * kHalf + 1 - kColumns - 1));
  for (std::size_t i = 0; i < horizon.size(); ++i) {
    const auto& border = jump.borders[i];
    if (!border || !(border->height > kJumpSd * std::sqrt(noise2))) continue;
    const Eigen::Vector2d border_px = horizon[i].pixel + border->at_px * horizon[i].outward;
    const auto ray = press.shape.camera().unproject(border_px);
    const auto further = press.shape.camera().unproject(border_px + horizon[i].outward);
    if (!ray || !further) continue;
    const double rad_per_px = angle_between(further->direction, ray->direction);
    const double sd_px = std::sqrt(2.0 * noise2 / border->curvature * (kSpacingPx / kStepPx));
    arc.points.push_back({ray->direction, rad_per_px * sd_px});
  }
  arc.arc_deg = step_deg * static_cast<double>(arc.points.size());
  if (arc.arc_deg < kMinArcDeg) return {};
  return arc;
}

}  // namespace alltact
