#include "calibration/joint/outline_methods.h"

#include "calibration/joint/contact_model.h"
#include "calibration/joint/mapping_curve.h"
#include "core/geometry/ball.h"
#include "core/geometry/circle_fit.h"
#include "core/numerics/image_noise.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include <Eigen/Dense>
#include <opencv2/imgproc.hpp>

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

double offset_px(int i) { return (i - kHalf) * kStepPx; }

std::optional<Profile> profile_at(const cv::Mat& x, const HorizonPoint& horizon) {
  Profile profile;
  for (int i = 0; i <= 2 * kHalf; ++i)
    profile[i] = bilinear(x, horizon.pixel + offset_px(i) * horizon.outward);
  if (!profile.allFinite()) return std::nullopt;
  return profile;
}

/// Basis of a jump, else of a fade, at `at_px` before blurring, as columns: the level outside;
/// inside of a jump its height, the square root in which a ball's surface turns away from sight,
/// and a slope; inside of a fade, which has no height, its first three powers.
constexpr int kColumns = 4;
using Columns = Eigen::Matrix<double, 2 * kHalf + 1, kColumns>;

Columns columns_of(bool is_jump, double at_px, double blur_px) {
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
      columns(i, 1) += weight * (is_jump ? 1.0 : inside);
      columns(i, 2) += weight * (is_jump ? root : inside * inside);
      columns(i, 3) += weight * (is_jump ? inside : inside * inside * inside);
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

std::vector<Candidate> candidates_of(bool is_jump, double blur_px) {
  std::vector<Candidate> candidates;
  for (double at = -kReachPx - kGridPx; at <= kReachPx + 1.5 * kGridPx; at += kGridPx) {
    const Columns columns = columns_of(is_jump, at, blur_px);
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

ArcFit fit_arc(bool is_jump, const std::vector<Profile>& profiles) {
  ArcFit best;
  for (const double blur_px : kBlursPx) {
    const auto candidates = candidates_of(is_jump, blur_px);
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
                                            const Eigen::Vector3d& centre_mm, double radius_mm,
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
    // how far, along the normal, the ball juts out over the face it hides
    const double hidden_mm = shape.face().layer_mm - beyond_view;
    if (!(hidden_mm > kMinHiddenMm && beyond_view > 0.0)) continue;
    const Eigen::Vector2d tangent = (*after - *before).normalized();
    Eigen::Vector2d outward(tangent.y(), -tangent.x());
    if (outward.dot(*pixel - *middle) < 0.0) outward = -outward;
    occluding.push_back({horizon[i], *pixel, outward});
  }
  return occluding;
}

TangentArc find_tangent_arc(const Press& press, const Eigen::Vector3d& centre_mm,
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
  const ArcFit jump = fit_arc(true, profiles);
  const ArcFit fade = fit_arc(false, profiles);
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

namespace {

constexpr double kDarkPart = 0.4;  // of the darkest difference
constexpr float kMinDark = 0.02F;
constexpr int kOpeningPx = 5;
constexpr std::size_t kMinSamples = 50;
constexpr double kZero_mm = 1e-3;   // tolerance of a zero constant
constexpr double kMaxMisfit = 0.3;  // above, the cubic fits noise

Error no_circle(const Press& press, Message what) {
  return {std::move(what), press.name,
          en::say("pressing the ball in deeper, entirely on the face")};
}

/// The circles of one press and their cubics.
class CirclesOfPress {
 public:
  CirclesOfPress(const Press& press, const std::vector<Sample>& samples, const Camera& camera,
                 const Face& face)
      : camera_(camera),
        shape_(press.shape),
        face_(face),
        radius_mm_(press.ball_radius_mm),
        samples_(samples) {
    for (const Sample& sample : samples) x_max_ = std::max(x_max_, sample.x);
  }

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
        const auto zero =
            between(middle_px, *local, before_mm, before->constant_mm, depth_mm, *here);
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
  /// Bisection between two depths. A change of sign at a pole, or where samples appear or vanish,
  /// is no zero.
  [[nodiscard]] std::optional<SearchedCircle> between(const Eigen::Vector2d& middle_px,
                                                      const FaceShape::Local& local, double from_mm,
                                                      double from_constant_mm, double to_mm,
                                                      SearchedCircle to) const {
    while (to_mm - from_mm > 1e-5) {
      const double half_mm = 0.5 * (from_mm + to_mm);
      const auto half = with_depth(middle_px, local, half_mm);
      if (!half) return std::nullopt;
      if (half->constant_mm * from_constant_mm > 0.0) {
        from_mm = half_mm;
        from_constant_mm = half->constant_mm;
      } else {
        to_mm = half_mm;
        to = *half;
      }
    }
    if (!(std::abs(to.constant_mm) < kZero_mm)) return std::nullopt;
    return to;
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
    return ball ? with_cubic(*circle, *ball) : std::nullopt;
  }

  /// The cubic through (x, d) of a ball. Uses the samples whose line along z meets the ball;
  /// nullopt where these are fewer than nine tenths. Depths are signed, so that a ball off the face
  /// has a large misfit.
  [[nodiscard]] std::optional<SearchedCircle> with_cubic(const Circle& circle,
                                                         const Eigen::Vector3d& ball_mm) const {
    Eigen::Matrix4d normal = Eigen::Matrix4d::Zero();
    Eigen::Vector4d right = Eigen::Vector4d::Zero();
    double square = 0, sum = 0;
    std::size_t met = 0;
    for (const Sample& sample : samples_) {
      const double d = ball_depth_mm(sample, MappingAlong::kZ, ball_mm, radius_mm_);
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
    if (!c.allFinite()) return std::nullopt;
    const double left = std::max(0.0, square - c.dot(right));
    return SearchedCircle{circle, ball_mm, c[0] - c[1] + c[2] - c[3], std::sqrt(left / spread)};
  }

  /// The size for which ball_of_circle() returns that distance.
  [[nodiscard]] std::optional<Circle> circle_at(const Eigen::Vector2d& middle_px, double z_mm,
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
  const std::vector<Sample>& samples_;
  double x_max_ = 0;
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
    return no_circle(press, en::say("nothing is dark enough for a pressed ball"));
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

std::optional<Eigen::Vector3d> ball_of_circle(const Circle& circle, const Camera& camera,
                                              double ball_radius_mm, double height_mm) {
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

Result<SearchedCircle> search_circle(const Press& press, const Circle& dark,
                                     const std::vector<Sample>& samples, const Camera& camera,
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

std::vector<Sample> samples_inside(const Press& press, const Face& face, const Circle& circle) {
  constexpr int kBlockPx = 2;
  std::vector<Sample> samples = sample_press(press, face, kBlockPx).samples;
  std::erase_if(samples, [&](const Sample& sample) {
    return (sample.pixel - circle.centre).norm() >= circle.radius;
  });
  return samples;
}

namespace {

constexpr int kCloudDegree = 3;
constexpr std::size_t kMinCloudSamples = 50;

/// A ball, and the brightness differences and depths of its samples.
struct BallCloud {
  BallFit ball;
  std::vector<double> x, depth_mm;
};

/// The clouds of the presses for which `cloud_of` finds one. `left_out` receives the reasons of the
/// others, `reason` the last one. A stopped job ends it early.
template <class Presses, class CloudOf>
std::vector<BallCloud> clouds_of(const Presses& presses, const CloudOf& cloud_of, const Job& job,
                                 std::vector<Message>* left_out, Message* reason) {
  std::vector<BallCloud> clouds;
  for (const auto& press : presses) {
    if (job.stop_requested()) break;
    Result<BallCloud> cloud = cloud_of(press);
    if (cloud) {
      clouds.push_back(std::move(*cloud));
    } else {
      left_out->push_back(en::say("{}.", cloud.error().message()));
      *reason = cloud.error().what;
    }
  }
  return clouds;
}

std::optional<MappingCurve> curve_through(const std::vector<BallCloud>& clouds, int coefficients,
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

/// Computes the depth of a ball over samples, where it presses at all: d = z_LUF - z_D. The ball's
/// point D lies on the line along z of the source paper's p_CF = p_LUF - (0, 0, d). Error: the ball
/// presses fewer than 50 samples.
Result<BallCloud> cloud_of_ball(const Press& press, const std::vector<Sample>& samples,
                                const Eigen::Vector3d& centre_mm, bool cut_by_edge) {
  BallCloud cloud;
  for (const Sample& sample : samples) {
    const double depth = ball_depth_mm(sample, MappingAlong::kZ, centre_mm, press.ball_radius_mm);
    if (!(depth > 0.0)) continue;
    cloud.x.push_back(sample.x);
    cloud.depth_mm.push_back(depth);
  }
  if (cloud.x.size() < kMinCloudSamples)
    return Error{en::say("the ball that follows from the dark border hardly touches the face"),
                 press.name, ""};
  cloud.ball.press = press.name;
  cloud.ball.radius_mm = press.ball_radius_mm;
  cloud.ball.centre_mm = centre_mm;
  cloud.ball.centre_sd_mm.setZero();
  cloud.ball.cut_by_edge = cut_by_edge;
  cloud.ball.depth_mm = *std::max_element(cloud.depth_mm.begin(), cloud.depth_mm.end());
  return cloud;
}

/// Fits the cubic without constant through d of all clouds (at least one), in the basis of
/// MappingParameters. Where the cubic does not increase, a lower degree is used and a remark states
/// it. Adds mapping, balls and residuals to `calibration`. Error: no increasing curve.
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
    return Error{en::say("the polynomial through the balls' depths does not increase"), "",
                 en::say("the joint method, or more presses of different depth")};
  const int degree = curve->family().coefficients;
  if (degree != kCloudDegree)
    calibration.remarks.push_back(
        en::say("the cubic does not increase; degree {} was used instead", degree));
  calibration.mapping = mapping_parameters(*curve, MappingAlong::kZ);
  calibration.degree_choice =
      degree == kCloudDegree ? en::at(curve->family().name(), en::say("the source paper's"))
                             : en::say("{}, instead of the paper's cubic", curve->family().name());
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

constexpr double kMinConeArcDeg = 40;  // of the outline; less does not determine a ball

/// The circle of the steepest fall of x along rays from the dark disc's middle, around its 40 %
/// contour.
std::optional<Circle> border_circle(const cv::Mat& x, const Eigen::Vector2d& middle,
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

Error no_ball(const Press& press, Message why) { return {std::move(why), press.name, ""}; }

/// The ball that leaves the face at the circle, by the circle's mean radius. `middle`: of the face
/// under the circle's middle.
Result<Eigen::Vector3d> by_contact_line(const Press& press, const Circle& circle,
                                        const FaceShape::Local& middle, const Face& face) {
  constexpr int kPoints = 72;
  const Eigen::Vector3d foot = untouched_point_mm(middle, face.layer_mm, MappingAlong::kNormal);
  double radius_mm = 0;
  int seen = 0;
  for (int i = 0; i < kPoints; ++i) {
    const double turn = 2.0 * M_PI * i / kPoints;
    const Eigen::Vector2d at =
        circle.centre + circle.radius * Eigen::Vector2d(std::cos(turn), std::sin(turn));
    const auto local = press.shape.at(at.x(), at.y());
    if (!local) continue;
    radius_mm += (untouched_point_mm(*local, face.layer_mm, MappingAlong::kNormal) - foot).norm();
    ++seen;
  }
  if (seen == 0) return no_ball(press, en::say("the circle is off the face"));
  radius_mm /= seen;
  const double ball_mm = press.ball_radius_mm;
  if (radius_mm >= ball_mm) return no_ball(press, en::say("the circle is larger than the ball"));
  return Eigen::Vector3d(foot +
                         std::sqrt((ball_mm - radius_mm) * (ball_mm + radius_mm)) * middle.normal);
}

/// The ball by its visible outline.
Result<Eigen::Vector3d> by_cone(const FoundBall& input) {
  const Press& press = *input.press;
  const TangentArc arc = find_tangent_arc(press, input.guess.centre_mm, press.ball_radius_mm);
  if (arc.arc_deg < kMinConeArcDeg)
    return no_ball(press,
                   en::say("{:.0f} degrees of the ball's outline are visible, a cone needs {:.0f}; "
                           "the rest of the dark border is where the skin leaves the ball",
                           arc.arc_deg, kMinConeArcDeg));
  std::vector<Eigen::Vector3d> directions;
  for (const OutlinePoint& point : arc.points) directions.push_back(point.direction);
  const auto centre = fit_ball_to_outline(directions, press.ball_radius_mm);
  if (!centre) return no_ball(press, en::say("no cone touches the outline"));
  return *centre;
}

Result<BallCloud> solve_press(const FoundBall& input, CalibrationMethod method, const Face& face) {
  const Press& press = *input.press;
  const auto circle =
      border_circle(press.difference.x, input.guess.disc_px, input.guess.disc_radius_px);
  if (!circle) return no_ball(press, en::say("no circle goes through the dark border"));
  const auto middle = press.shape.at(circle->centre.x(), circle->centre.y());
  if (!middle) return no_ball(press, en::say("the circle's centre is off the face"));
  const auto centre = method == CalibrationMethod::kCone
                          ? by_cone(input)
                          : by_contact_line(press, *circle, *middle, face);
  if (!centre) return centre.error();
  return cloud_of_ball(press, samples_inside(press, face, *circle), *centre,
                       input.guess.cut_by_edge);
}

Result<BallCloud> cloud_of_press(const Press& press, const Camera& camera, const Face& face) {
  const auto dark = dark_circle(press, camera);
  if (!dark) return dark.error();
  const std::vector<Sample> samples = samples_inside(press, face, *dark);
  const auto found = search_circle(press, *dark, samples, camera, face);
  if (!found) return found.error();
  return cloud_of_ball(press, samples, found->ball_mm, false);
}

}  // namespace

Result<Calibration> calibrate_by_outline(const std::vector<FoundBall>& presses,
                                         CalibrationMethod method, const Face& face, const Job& job,
                                         Calibration calibration) {
  Message reason;
  const auto clouds = clouds_of(
      presses, [&](const FoundBall& press) { return solve_press(press, method, face); }, job,
      &calibration.left_out, &reason);
  if (clouds.empty())
    return Error{en::say("no ball follows from the dark border of any of {} presses ({})",
                         presses.size(), reason),
                 "", en::say("the joint method, which fits the ball itself")};
  return fit_cubic_mapping(clouds, std::move(calibration));
}

Result<Calibration> calibrate_as_paper(const std::vector<Press>& presses, const Camera& camera,
                                       const Face& face, const Job& job) {
  Calibration calibration;
  Message reason;
  const auto clouds = clouds_of(
      presses, [&](const Press& press) { return cloud_of_press(press, camera, face); }, job,
      &calibration.left_out, &reason);
  if (clouds.empty() && calibration.left_out.size() < presses.size())
    return Error{en::say("stopped before the first solution"), "", ""};
  if (clouds.empty())
    return Error{en::say("the source paper's method finds a ball in none of {} presses ({})",
                         presses.size(), reason),
                 "", en::say("the joint method, which fits the ball itself")};
  return fit_cubic_mapping(clouds, std::move(calibration));
}

}  // namespace alltact
