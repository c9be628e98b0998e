#include "calibration/joint/light_spread_fit.h"

#include "calibration/joint/contact_model.h"
#include "core/sensing/depth/light_spread.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include <Eigen/Dense>

namespace alltact {
namespace {

constexpr int kSamplesAround = 900;   // a press
constexpr double kReachLayers = 4.0;  // beyond the rim of a contact
constexpr double kMaxReachMm = 14.0;  // of samples from the contact's middle
constexpr int kRadii = 160;           // of the radial profile
constexpr std::size_t kMinPresses = 3;
constexpr double kModelPart = 0.02;  // of x: what the formulas of light_spread.h leave
constexpr double kModelFloor = 0.002;
// What the formulas leave varies over the layer's thickness: one observation per so many of its
// squares.
constexpr double kCorrelatedLayers2 = 3.0;
constexpr double kFadePerLift = 20.0;  // length of a half space's fading over the lift-off length
constexpr double kLinearFrom = 3.0;    // standard deviations from which the loss is linear

/// Where the light of a pixel comes from, and how the skin leaves a ball.
enum class SeenAt { kNormal, kZ, kSight, kSpread };
enum class Bed { kMembrane, kHalfSpace };
struct Hypothesis {
  SeenAt seen;
  Bed bed;
};

/// A block of pixels near a ball.
struct SpreadSample {
  Eigen::Vector2d position_mm;  // on the face
  Eigen::Vector2d sight_mm;     // SightInLayer::displacement_mm
  Eigen::Vector2d z_mm;         // from the foot of the normal to the outer side along z
  double cos_sight = 1, cos_incline = 1;
  double x = 0, sd = 1;
};

/// A press and the face around it.
struct SpreadPress {
  std::vector<SpreadSample> samples;
  double radius_mm = 0;
  double curvature_per_mm = 0;  // of the face along it, positive where it bulges outward
  double reach_mm = 0;
  double observations = 1;  // that count as independent
  std::optional<GivenDepth> given_depth;
  Eigen::Vector3d start;  // along, across, depth along the normal
};

/// Unknowns that all presses share (light_spread.h). Scaled to about 1.
enum Shared {
  kLogRho,
  kLogB,
  kLogBAlong,
  kLogLift,
  kRise,
  kLogScattering,
  kLogWidth,
  kSharedCount
};

constexpr int kOwn = 3;  // along, across, log of the depth

struct UnknownPrior {
  double mean, sd;
};
/// Local light may follow other laws than those of light_spread.h.
UnknownPrior prior_of(int shared, bool is_local) {
  switch (shared) {
    case kLogRho:
      return {std::log(0.97), is_local ? 0.5 : 0.08};
    case kLogB:
      return {0.0, 1.5};
    case kLogBAlong:
      return {0.0, 0.4};
    case kLogLift:
      return {std::log(kTypicalLiftMm), 1.0};
    case kRise:
      return {0.02, 0.04};
    case kLogScattering:
      return {std::log(0.6), 0.8};
    default:
      return {0.0, 0.2};
  }
}
// b = 0.65 t^1.85 for light at 53 degrees, and about twice or half of that for 70 or 25 degrees.
constexpr double kBOfT = 0.65, kBPower = 1.85, kLogBSd = 0.5;

struct FitState {
  Eigen::VectorXd shared = Eigen::VectorXd::Zero(kSharedCount);
  std::vector<Eigen::Vector3d> own;  // by press
};

/// A function of the distance from the contact's axis.
class RadialProfile {
 public:
  RadialProfile(double reach_mm) : step_mm_(reach_mm / kRadii), values_(kRadii) {}
  [[nodiscard]] double radius_mm(int i) const { return (i + 0.5) * step_mm_; }
  double& operator[](int i) { return values_[static_cast<std::size_t>(i)]; }
  [[nodiscard]] double operator[](int i) const { return values_[static_cast<std::size_t>(i)]; }
  [[nodiscard]] double at(double r_mm) const {
    const double index = r_mm / step_mm_ - 0.5;
    if (index <= 0) return values_.front();  // flat on the axis
    const int i = static_cast<int>(index);
    if (i + 1 >= kRadii) return values_.back();
    const double part = index - i;
    return (*this)[i] + part * ((*this)[i + 1] - (*this)[i]);
  }
  /// Its mean over the skirt: q - width^2 laplace q = y over rings; beyond them q decays alone.
  [[nodiscard]] RadialProfile over_skirt(double width_mm) const {
    RadialProfile skirt = *this;
    std::array<double, kRadii> above{};
    const double w2 = width_mm * width_mm / (step_mm_ * step_mm_);
    for (int i = 0; i < kRadii; ++i) {
      const double middle = i + 0.5;
      const double in = w2 * i / middle;
      const double out = i + 1 < kRadii ? w2 * (i + 1) / middle : w2 * step_mm_ / width_mm;
      const double diagonal =
          1.0 + in + out - (i > 0 ? in * above[static_cast<std::size_t>(i) - 1] : 0.0);
      above[static_cast<std::size_t>(i)] = (i + 1 < kRadii ? out : 0.0) / diagonal;
      skirt[i] = ((*this)[i] + (i > 0 ? in * skirt[i - 1] : 0.0)) / diagonal;
    }
    for (int i = kRadii - 2; i >= 0; --i)
      skirt[i] += above[static_cast<std::size_t>(i)] * skirt[i + 1];
    return skirt;
  }

 private:
  double step_mm_;
  std::vector<double> values_;
};

/// Form of the rise of the skin around a contact, 0 to 1: incompressible material yields outward.
double rise_at(double outside_mm, double lift_mm, double layer_mm) {
  const double layers = outside_mm / layer_mm;
  return (1.0 - std::exp(-outside_mm / lift_mm)) * std::exp(-layers * layers);
}

/// Depth of the skin along the normal around a ball, by the distance from its axis. A half space:
/// K. L. Johnson, Contact Mechanics, 3.42a, faded by the bond of the layer.
RadialProfile skin_profile(const SpreadPress& press, Bed bed, double layer_mm, double depth_mm,
                           double lift_mm, double rise) {
  // A face that bulges outward meets the ball as an even one meets a smaller ball.
  const double outer = press.curvature_per_mm / (1.0 + layer_mm * press.curvature_per_mm);
  const double radius = 1.0 / (1.0 / press.radius_mm + 0.5 * outer);
  const double depth = std::min(depth_mm, 0.95 * radius);
  const auto ball = [&](double r) {
    return depth - r * r / (radius + std::sqrt(std::max(0.0, (radius - r) * (radius + r))));
  };
  const bool is_half_space = bed == Bed::kHalfSpace;
  const double contact = is_half_space ? std::min(std::sqrt(radius * depth), radius)
                                       : contact_radius_mm(depth * (2.0 * radius - depth), lift_mm);
  const auto returning = [&](double r) {
    if (!is_half_space) return std::exp(-(r - contact) / lift_mm);
    const double q = r / contact;
    return 2.0 / M_PI * ((2.0 - q * q) * std::asin(1.0 / q) + std::sqrt(q * q - 1.0)) *
           std::exp(-(r - contact) / (kFadePerLift * lift_mm));
  };
  RadialProfile skin(press.reach_mm);
  const double at_edge = std::max(0.0, ball(contact));
  for (int i = 0; i < kRadii; ++i) {
    const double r = skin.radius_mm(i);
    skin[i] = r <= contact
                  ? ball(r)
                  : at_edge * returning(r) - rise * depth * rise_at(r - contact, lift_mm, layer_mm);
  }
  return skin;
}

class SpreadModel {
 public:
  /// `presses` must outlive it.
  SpreadModel(const std::vector<SpreadPress>& presses, double layer_mm)
      : presses_(presses), layer_mm_(layer_mm) {
    const auto [first, last] = std::minmax_element(
        presses.begin(), presses.end(),
        [](const SpreadPress& a, const SpreadPress& b) { return a.start[0] < b.start[0]; });
    middle_mm_ = 0.5 * (first->start[0] + last->start[0]);
    half_mm_ = std::max(0.5 * (last->start[0] - first->start[0]), 1.0);
  }

  [[nodiscard]] static int count_of(Hypothesis one) {
    return one.seen == SeenAt::kSpread ? kSharedCount : kLogScattering;
  }
  [[nodiscard]] const std::vector<SpreadPress>& presses() const { return presses_; }
  [[nodiscard]] double layer_mm() const { return layer_mm_; }
  [[nodiscard]] LightSpread spread_by(const Eigen::VectorXd& shared) const {
    LightSpread spread;
    spread.scattering =
        std::clamp(std::exp(shared[kLogScattering]), 0.01, LightSpread::kMaxScattering);
    spread.width_factor =
        std::clamp(std::exp(shared[kLogWidth]), LightSpread::kMinWidth, LightSpread::kMaxWidth);
    spread.b_straight = std::exp(std::clamp(shared[kLogB], -6.0, 4.0));
    spread.log_b_along = std::clamp(shared[kLogBAlong], -3.0, 3.0);
    spread.middle_mm = middle_mm_;
    spread.half_mm = half_mm_;
    return spread;
  }

  /// Brightness differences that a press should show.
  void predict(const SpreadPress& press, Hypothesis one, const Eigen::VectorXd& shared,
               const Eigen::Vector3d& own, Eigen::VectorXd* x) const {
    const double depth = std::exp(std::min(own[2], 2.0));
    const double lift = std::exp(std::clamp(shared[kLogLift], -4.0, 1.0));
    const SeenAt seen = one.seen;
    RadialProfile y = skin_profile(press, one.bed, layer_mm_, depth, lift, shared[kRise]);
    const LightSpread spread = spread_by(shared);
    const SpreadSample& nearest = nearest_to(press, own.head<2>());
    double gain = 1.0;
    if (seen == SeenAt::kZ) gain = nearest.cos_incline;
    const double b = b_at(spread, own[0], seen == SeenAt::kSpread ? nearest.cos_sight : 1.0);
    const double thickness = std::exp(shared[kLogRho]) * layer_mm_ * gain;
    constexpr double kNearPole = 0.1;
    for (int i = 0; i < kRadii; ++i)
      y[i] /= std::max(kNearPole * thickness, thickness * (1.0 + b) - b * y[i]);
    const double stretch = 1.0 + layer_mm_ * press.curvature_per_mm;
    const auto distance = [&](const Eigen::Vector2d& at) {
      return std::hypot(stretch * (at.x() - own[0]), at.y() - own[1]);
    };
    x->resize(static_cast<Eigen::Index>(press.samples.size()));
    if (seen != SeenAt::kSpread) {
      Eigen::Index k = 0;
      for (const SpreadSample& sample : press.samples) {
        Eigen::Vector2d at = sample.position_mm;
        if (seen == SeenAt::kZ) at += sample.z_mm;
        if (seen == SeenAt::kSight) at += sample.sight_mm;
        (*x)[k++] = y.at(distance(at));
      }
      return;
    }
    const RadialProfile skirt = y.over_skirt(skirt_width_mm(spread, layer_mm_));
    Eigen::Index k = 0;
    for (const SpreadSample& sample : press.samples) {
      const ObliqueSpread oblique = oblique_spread(spread, sample.cos_sight);
      const double core = y.at(distance(sample.position_mm + oblique.core_shift * sample.sight_mm));
      const double neighbour =
          skirt.at(distance(sample.position_mm + oblique.skirt_shift * sample.sight_mm));
      (*x)[k++] = oblique.core * core + (1.0 - oblique.core) * neighbour;
    }
  }

  [[nodiscard]] static const SpreadSample& nearest_to(const SpreadPress& press,
                                                      const Eigen::Vector2d& at) {
    return *std::min_element(press.samples.begin(), press.samples.end(),
                             [&](const SpreadSample& a, const SpreadSample& b) {
                               return (a.position_mm - at).squaredNorm() <
                                      (b.position_mm - at).squaredNorm();
                             });
  }

 private:
  const std::vector<SpreadPress>& presses_;
  double layer_mm_, middle_mm_ = 0, half_mm_ = 1;
};

/// Normal equations at a state, and its cost.
struct Normal {
  Eigen::MatrixXd hessian;
  Eigen::VectorXd gradient;
  double cost = 0;
  double prior_cost = 0;            // contained in it
  std::vector<double> mean_square;  // robust, of the weighted residuals, by press
};

double soft_loss(double z) {
  const double q = z * z / (kLinearFrom * kLinearFrom);
  return kLinearFrom * kLinearFrom * 2.0 * (std::sqrt(1.0 + q) - 1.0);
}

/// `skip`: a press that does not count for the shared unknowns; -1: none. `fix_shared`: only balls.
class SpreadSolver {
 public:
  SpreadSolver(const SpreadModel& model, Hypothesis one, int skip = -1, bool fix_shared = false)
      : model_(model),
        hypothesis_(one),
        skip_(skip),
        shared_(fix_shared ? 0 : SpreadModel::count_of(one)) {}

  [[nodiscard]] int unknowns() const {
    return shared_ + kOwn * static_cast<int>(model_.presses().size());
  }
  [[nodiscard]] Normal evaluate(const FitState& state, bool with_derivatives) const {
    constexpr double kStep = 1e-4;
    Normal normal;
    const int n = unknowns();
    if (with_derivatives) {
      normal.hessian = Eigen::MatrixXd::Zero(n, n);
      normal.gradient = Eigen::VectorXd::Zero(n);
    }
    Eigen::VectorXd x, moved;
    for (std::size_t p = 0; p < model_.presses().size(); ++p) {
      const SpreadPress& press = model_.presses()[p];
      const bool is_skipped = static_cast<int>(p) == skip_;
      if (is_skipped) {
        normal.mean_square.push_back(0.0);
        if (with_derivatives)
          normal.hessian.diagonal()
              .segment(shared_ + kOwn * static_cast<Eigen::Index>(p), kOwn)
              .setOnes();
        continue;
      }
      model_.predict(press, hypothesis_, state.shared, state.own[p], &x);
      const auto count = static_cast<Eigen::Index>(press.samples.size());
      const double each = std::min(1.0, press.observations / static_cast<double>(count));
      Eigen::VectorXd residual(count), weight(count);
      double sum = 0;
      for (Eigen::Index k = 0; k < count; ++k) {
        const SpreadSample& sample = press.samples[static_cast<std::size_t>(k)];
        const double z = (x[k] - sample.x) / sample.sd;
        sum += soft_loss(z);
        const double robust = 1.0 / std::sqrt(1.0 + z * z / (kLinearFrom * kLinearFrom));
        residual[k] = z;
        weight[k] = each * robust;
      }
      normal.cost += each * sum;
      normal.mean_square.push_back(sum / static_cast<double>(count));
      if (with_derivatives) {
        Eigen::MatrixXd rows(count, shared_ + kOwn);
        for (int c = 0; c < shared_ + kOwn; ++c) {
          Eigen::VectorXd shared = state.shared;
          Eigen::Vector3d own = state.own[p];
          (c < shared_ ? shared[c] : own[c - shared_]) += kStep;
          model_.predict(press, hypothesis_, shared, own, &moved);
          for (Eigen::Index k = 0; k < count; ++k)
            rows(k, c) =
                (moved[k] - x[k]) / (kStep * press.samples[static_cast<std::size_t>(k)].sd);
        }
        const Eigen::MatrixXd weighted = weight.asDiagonal() * rows;
        add(rows.transpose() * weighted, weighted.transpose() * residual, p, &normal);
      }
      if (press.given_depth) {
        const double depth = std::exp(state.own[p][2]);
        const double z = (depth - press.given_depth->mm) / press.given_depth->sd_mm;
        normal.cost += soft_loss(z);
        if (with_derivatives) {
          const Eigen::Index i = shared_ + kOwn * static_cast<Eigen::Index>(p) + 2;
          const double row = depth / press.given_depth->sd_mm;
          const double robust = 1.0 / std::sqrt(1.0 + z * z / (kLinearFrom * kLinearFrom));
          normal.hessian(i, i) += robust * row * row;
          normal.gradient[i] += robust * row * z;
        }
      }
    }
    add_priors(state.shared, with_derivatives, &normal);
    return normal;
  }

  /// Levenberg-Marquardt. nullopt where no step leads to finite values.
  [[nodiscard]] std::optional<FitState> solve(FitState state, int max_steps, const Job& job) const {
    double damping = 1e-2;
    Normal here = evaluate(state, true);
    if (!std::isfinite(here.cost)) return std::nullopt;
    for (int step = 0; step < max_steps && !job.stop_requested(); ++step) {
      Eigen::MatrixXd damped = here.hessian;
      damped.diagonal() *= 1.0 + damping;
      damped.diagonal().array() += 1e-12;
      const Eigen::VectorXd by = damped.ldlt().solve(-here.gradient);
      FitState next = state;
      const double longest = by.cwiseAbs().maxCoeff();
      const double limited = longest > 0.7 ? 0.7 / longest : 1.0;
      for (int i = 0; i < shared_; ++i) next.shared[i] += limited * by[i];
      for (std::size_t p = 0; p < next.own.size(); ++p)
        next.own[p] += limited * by.segment<kOwn>(shared_ + kOwn * static_cast<Eigen::Index>(p));
      Normal there = by.allFinite() ? evaluate(next, true) : Normal{};
      if (by.allFinite() && std::isfinite(there.cost) && there.cost < here.cost) {
        const double gained = here.cost - there.cost;
        state = std::move(next);
        here = std::move(there);
        damping = std::max(1e-9, damping / 5.0);
        if (gained < 1e-4 * (1.0 + 1e-3 * here.cost)) break;
      } else {
        damping *= 6.0;
        if (damping > 1e8) break;
      }
    }
    return state;
  }

 private:
  void add_priors(const Eigen::VectorXd& shared, bool with_derivatives, Normal* normal) const {
    const bool is_local = hypothesis_.seen != SeenAt::kSpread;
    const auto add_prior = [&](double z, int i, double by_i, int j, double by_j) {
      normal->cost += z * z;
      normal->prior_cost += z * z;
      if (!with_derivatives) return;
      normal->gradient[i] += by_i * z;
      normal->hessian(i, i) += by_i * by_i;
      if (j < 0) return;
      normal->gradient[j] += by_j * z;
      normal->hessian(j, j) += by_j * by_j;
      normal->hessian(i, j) += by_i * by_j;
      normal->hessian(j, i) += by_i * by_j;
    };
    for (int i = 0; i < shared_; ++i) {
      const UnknownPrior prior = prior_of(i, is_local);
      add_prior((shared[i] - prior.mean) / prior.sd, i, 1.0 / prior.sd, -1, 0.0);
    }
    if (!is_local && shared_ > 0)
      add_prior((shared[kLogB] - std::log(kBOfT) - kBPower * shared[kLogScattering]) / kLogBSd,
                kLogB, 1.0 / kLogBSd, kLogScattering, -kBPower / kLogBSd);
  }
  void add(const Eigen::MatrixXd& block, const Eigen::VectorXd& pull, std::size_t p,
           Normal* normal) const {
    const Eigen::Index own = shared_ + kOwn * static_cast<Eigen::Index>(p);
    const Eigen::Index s = shared_;
    normal->hessian.topLeftCorner(s, s) += block.topLeftCorner(s, s);
    normal->hessian.block(0, own, s, kOwn) += block.topRightCorner(s, kOwn);
    normal->hessian.block(own, 0, kOwn, s) += block.bottomLeftCorner(kOwn, s);
    normal->hessian.block<kOwn, kOwn>(own, own) += block.bottomRightCorner<kOwn, kOwn>();
    normal->gradient.head(s) += pull.head(s);
    normal->gradient.segment<kOwn>(own) += pull.tail<kOwn>();
  }

  const SpreadModel& model_;
  Hypothesis hypothesis_;
  int skip_;
  int shared_;
};

std::optional<Eigen::Vector2d> face_position(const FaceShape& shape,
                                             const Eigen::Vector3d& view_point) {
  const auto pixel = shape.camera().project(view_point);
  if (!pixel) return std::nullopt;
  return shape.position_mm(pixel->x(), pixel->y());
}

/// Change of the normal's direction per mm along the face.
double curvature_at(const FaceShape& shape, const Eigen::Vector2d& pixel) {
  constexpr double kStepPx = 12.0;
  const auto before = shape.at(pixel.x() - kStepPx, pixel.y()),
             after = shape.at(pixel.x() + kStepPx, pixel.y());
  if (!before || !after) return 0.0;
  const Eigen::Vector3d step = after->view_point_mm - before->view_point_mm;
  return (after->normal - before->normal).dot(step) / step.squaredNorm();
}

std::optional<SpreadPress> spread_press(const BallStart& ball, const Face& face) {
  const Press& press = *ball.press;
  const auto contact = ball_on_face(press.shape, face, ball.centre_mm, press.ball_radius_mm);
  if (!contact || !(contact->depth_mm > 0)) return std::nullopt;
  const Eigen::Vector3d view_point = contact->middle_mm - face.layer_mm * contact->normal;
  const auto pixel = press.shape.camera().project(view_point);
  const auto position = face_position(press.shape, view_point);
  if (!pixel || !position) return std::nullopt;
  SpreadPress made;
  made.radius_mm = press.ball_radius_mm;
  made.curvature_per_mm = curvature_at(press.shape, *pixel);
  made.given_depth = press.given_depth;
  made.start << *position, std::log(std::clamp(contact->depth_mm, 0.05, 0.9 * face.layer_mm));
  const double reach = std::min(kMaxReachMm, contact->radius_mm + kReachLayers * face.layer_mm);
  const PressSamples around = sample_around(press, face, contact->middle_mm, reach, kSamplesAround);
  double area = 0;
  for (const Sample& sample : around.samples) {
    const auto sight = sight_in_layer(press.shape, sample.pixel.x(), sample.pixel.y());
    if (!sight) continue;
    SpreadSample one;
    one.position_mm = sample.position_mm;
    one.sight_mm = sight->displacement_mm;
    const Eigen::Vector3d off = sample.untouched_z - sample.untouched_n;
    const double along = (off - off.dot(sample.normal) * sample.normal).norm();
    one.z_mm = {sample.normal.x() < 0 ? along : -along, 0.0};
    if (!press.shape.base_at_low_u()) one.z_mm = -one.z_mm;
    one.cos_sight = sight->cos_sight;
    one.cos_incline = sample.cos_incline;
    one.x = sample.x;
    one.sd = std::hypot(around.x_sd, std::hypot(kModelFloor, kModelPart * sample.x));
    area += sample.by_u.cross(sample.by_v).norm() * around.block_px * around.block_px;
    made.reach_mm =
        std::max(made.reach_mm, (one.position_mm - *position).norm() + one.sight_mm.norm());
    made.samples.push_back(one);
  }
  made.observations = std::max(8.0, area / (kCorrelatedLayers2 * face.layer_mm * face.layer_mm));
  made.reach_mm += 1.0;
  if (made.samples.size() < 50) return std::nullopt;
  return made;
}

/// The best of some starts.
std::optional<std::pair<FitState, Normal>> best_fit(const SpreadModel& model, Hypothesis one,
                                                    const FitState& start, const Job& job) {
  constexpr int kSteps = 60;
  const SpreadSolver solver(model, one);
  std::optional<std::pair<FitState, Normal>> best;
  const std::vector<double> scatterings =
      one.seen == SeenAt::kSpread ? std::vector{0.15, 0.5, 1.2} : std::vector{0.5};
  for (const double scattering : scatterings) {
    FitState from = start;
    from.shared[kLogScattering] = std::log(scattering);
    from.shared[kLogB] = std::log(kBOfT) + kBPower * std::log(scattering);
    const auto state = solver.solve(from, kSteps, job);
    if (!state) continue;
    Normal normal = solver.evaluate(*state, true);
    if (!best || normal.cost < best->second.cost) best = {*state, std::move(normal)};
  }
  return best;
}

/// Whether a layer and a skin may be so: unusual skin is else explained by an impossible layer. A
/// weaker skirt cannot be separated from skin.
bool is_plausible(const Eigen::VectorXd& shared) {
  constexpr double kPlausibleSd = 2.5;
  constexpr double kLeastLogScattering = -1.05;  // 0.35: three tenths of the light
  constexpr double kLeastRho = 0.875, kMostRho = 1.15;
  for (const int i : {kRise, kLogWidth}) {
    const UnknownPrior prior = prior_of(i, false);
    if (std::abs(shared[i] - prior.mean) > kPlausibleSd * prior.sd) return false;
  }
  const double rho = std::exp(shared[kLogRho]);
  return shared[kLogScattering] > kLeastLogScattering && rho > kLeastRho && rho < kMostRho;
}

/// Mean squares of the residuals that the better hypothesis leaves: the data's own noise.
double scale_of(const Normal& normal) {
  double sum = 0, count = 0;
  for (const double square : normal.mean_square)
    if (square > 0) sum += square, ++count;
  return count > 0 ? std::max(sum / count, 0.05) : 1.0;
}

/// A hypothesis with its best fit.
struct FittedSpread {
  Hypothesis hypothesis;
  FitState state;
  Normal normal;
};

constexpr std::array kBeds{Bed::kMembrane, Bed::kHalfSpace};

/// nullopt: no fit, or the job was stopped.
std::optional<FittedSpread> best_spread(const SpreadModel& model, const FitState& start,
                                        const Job& job) {
  std::optional<FittedSpread> best;
  for (const Bed bed : kBeds) {
    const Hypothesis one{SeenAt::kSpread, bed};
    auto fitted = best_fit(model, one, start, job);
    if (job.stop_requested()) return std::nullopt;
    if (fitted && (!best || fitted->second.cost < best->normal.cost))
      best = {one, std::move(fitted->first), std::move(fitted->second)};
  }
  return best;
}

/// How much more probable spread light is than the best local light.
struct Evidence {
  double log_ratio = std::numeric_limits<double>::infinity();
  double presses = 1;  ///< part of the presses that show it
};
Evidence evidence_of(const SpreadModel& model, const FittedSpread& spread, const FitState& start,
                     const Job& job) {
  Evidence least;
  for (const SeenAt seen : {SeenAt::kNormal, SeenAt::kZ, SeenAt::kSight})
    for (const Bed bed : kBeds) {
      const auto local = best_fit(model, {seen, bed}, start, job);
      if (!local) continue;
      // What is implausible a priori needs as much more evidence.
      Evidence one{0.5 * (local->second.prior_cost - spread.normal.prior_cost), 0};
      for (std::size_t p = 0; p < model.presses().size(); ++p) {
        const double gained = 0.5 * model.presses()[p].observations *
                              std::log(local->second.mean_square[p] / spread.normal.mean_square[p]);
        one.log_ratio += gained;
        if (gained > 0) one.presses += 1.0 / static_cast<double>(model.presses().size());
      }
      if (one.log_ratio < least.log_ratio) least = one;
    }
  return least;
}

bool is_seen(const Evidence& evidence) {
  constexpr double kSignificant = 2.2;  // 9 to 1
  constexpr double kMostPresses = 0.6;
  return evidence.log_ratio > kSignificant && evidence.presses >= kMostPresses;
}

/// The mapping of the presses' mean angle of sight; those of other angles are converted to it.
MappingParameters mapping_of(const SpreadModel& model, const FitState& state,
                             const Eigen::MatrixXd& covariance) {
  MappingParameters mapping;
  mapping.kind = MappingKind::kMoebius;
  mapping.along = MappingAlong::kNormal;
  mapping.spread = model.spread_by(state.shared);
  mapping.spread.scattering_sd =
      mapping.spread.scattering *
      std::sqrt(std::max(0.0, covariance(kLogScattering, kLogScattering)));
  double b_factor = 0;
  for (std::size_t p = 0; p < model.presses().size(); ++p) {
    const SpreadSample& nearest =
        SpreadModel::nearest_to(model.presses()[p], state.own[p].head<2>());
    b_factor += oblique_spread(mapping.spread, nearest.cos_sight).b_factor /
                static_cast<double>(model.presses().size());
  }
  mapping.b = mapping.spread.b_straight * b_factor;
  const double thickness_mm = std::exp(state.shared[kLogRho]) * model.layer_mm();
  mapping.a_mm = thickness_mm * (1.0 + mapping.b);
  Eigen::MatrixXd by_stored = Eigen::MatrixXd::Zero(2, covariance.rows());
  by_stored(0, kLogRho) = mapping.a_mm;
  by_stored(0, kLogB) = thickness_mm * mapping.b;
  by_stored(1, kLogB) = mapping.b;
  const Eigen::MatrixXd stored = by_stored * covariance * by_stored.transpose();
  mapping.covariance = 0.5 * (stored + stored.transpose());
  return mapping;
}

/// False where a ball lies off its face.
bool add_balls(const std::vector<BallStart>& balls, const SpreadModel& model, const FitState& state,
               const Eigen::MatrixXd& covariance, LightSpreadFit* fit) {
  fit->centre_covariance = Eigen::MatrixXd::Zero(3 * static_cast<Eigen::Index>(balls.size()), 3);
  for (std::size_t p = 0; p < balls.size(); ++p) {
    const FaceShape& shape = balls[p].press->shape;
    const auto pixel = pixel_of_position(shape, state.own[p].head<2>());
    const auto local = pixel ? shape.at(pixel->x(), pixel->y()) : std::nullopt;
    if (!local) return false;
    const double depth = std::exp(state.own[p][2]);
    fit->depth_mm.push_back(depth);
    fit->centres_mm.push_back(untouched_point_mm(*local, model.layer_mm(), MappingAlong::kNormal) +
                              (model.presses()[p].radius_mm - depth) * local->normal);
    const Eigen::Index at = kSharedCount + kOwn * static_cast<Eigen::Index>(p);
    const double variance = depth * depth * std::max(0.0, covariance(at + 2, at + 2));
    fit->centre_covariance.block<3, 3>(3 * static_cast<Eigen::Index>(p), 0) =
        variance * local->normal * local->normal.transpose();
  }
  return true;
}

/// Change of each ball's depth where the other presses alone give what all share.
std::vector<double> held_out_mm(const SpreadModel& model, const FittedSpread& spread,
                                const Job& job) {
  constexpr int kAgain = 25;
  std::vector<double> changes_mm;
  for (std::size_t p = 0; p < model.presses().size() && !job.stop_requested(); ++p) {
    const double depth_mm = std::exp(spread.state.own[p][2]);
    changes_mm.push_back(depth_mm);  // where nothing is found out
    const auto others = SpreadSolver(model, spread.hypothesis, static_cast<int>(p))
                            .solve(spread.state, kAgain, job);
    if (!others) continue;
    FitState ball = *others;
    ball.own = spread.state.own;
    const auto alone = SpreadSolver(model, spread.hypothesis, -1, true).solve(ball, kAgain, job);
    if (alone) changes_mm.back() = std::abs(std::exp(alone->own[p][2]) - depth_mm);
  }
  return changes_mm;
}

}  // namespace

std::optional<LightSpreadFit> fit_light_spread(const std::vector<BallStart>& balls,
                                               const Face& face, const Job& job) {
  if (balls.size() < kMinPresses) return std::nullopt;
  std::vector<SpreadPress> presses;
  for (const BallStart& ball : balls) {
    auto press = spread_press(ball, face);
    if (!press) return std::nullopt;
    presses.push_back(std::move(*press));
  }
  const SpreadModel model(presses, face.layer_mm);
  FitState start;
  for (int i = 0; i < kSharedCount; ++i) start.shared[i] = prior_of(i, false).mean;
  for (const SpreadPress& press : presses) start.own.push_back(press.start);

  const auto spread = best_spread(model, start, job);
  if (!spread) return std::nullopt;
  LightSpreadFit fit;
  if (!is_plausible(spread->state.shared)) return fit;
  const Evidence evidence = evidence_of(model, *spread, start, job);
  if (job.stop_requested()) return std::nullopt;
  fit.log_evidence = evidence.log_ratio;
  if (!is_seen(evidence)) return fit;
  const Eigen::Index n = spread->normal.hessian.rows();
  const Eigen::MatrixXd covariance =
      scale_of(spread->normal) *
      spread->normal.hessian.ldlt().solve(Eigen::MatrixXd::Identity(n, n));
  if (!covariance.allFinite()) return fit;
  fit.mapping = mapping_of(model, spread->state, covariance);
  if (!add_balls(balls, model, spread->state, covariance, &fit)) return fit;
  if (spread->hypothesis.bed == Bed::kMembrane)
    fit.lift_mm = std::exp(spread->state.shared[kLogLift]);
  fit.held_out_mm = held_out_mm(model, *spread, job);
  fit.is_seen = true;
  return fit;
}

Press without_light_spread(const Press& press, const MappingParameters& mapping) {
  Press local = press;
  remove_light_spread(mapping, press.shape, &local.difference);
  return local;
}

}  // namespace alltact
