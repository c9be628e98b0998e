#include "calibration/twin/twin_contact.h"

#include "calibration/twin/twin_scene.h"
#include "core/camera/camera.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <optional>
#include <vector>

#include <opencv2/imgproc.hpp>

namespace alltact {
namespace {

/// Parameters that are fitted together.
struct ContactChoice {
  bool coat = true, blur = true, light = true;
};

/// One unknown: its scaling, and how to store it in the scene.
struct ContactUnknown {
  double start, low, high;  // scaled
  int ball;                 // whose ball it is; -1: shared by all presses
  std::function<void(TwinScene&, double)> put;
  std::function<std::optional<double>*(ContactSpread&)> spread;
  std::function<double(double)> value_per_unit;  // derivative of the value by the scaled unknown
};

class ContactStudy {
 public:
  ContactStudy(const TwinScene& scene, const std::vector<TwinPatch>& patches,
               const std::vector<TwinPress>& presses, ContactChoice choice)
      : scene_(scene), patches_(patches), presses_(presses) {
    choose(choice);
    for (const TwinPatch& patch : patches) residuals_ += patch.target.size();
    for (std::size_t i = 0; i < presses.size(); ++i)
      if (presses[i].given_depth) given_depths_.push_back(i);
  }

  [[nodiscard]] Eigen::Index residuals() const {
    return residuals_ + static_cast<Eigen::Index>(given_depths_.size());
  }
  [[nodiscard]] TwinUnknowns unknowns() const {
    const auto n = static_cast<Eigen::Index>(unknowns_.size());
    TwinUnknowns u{Eigen::VectorXd(n), Eigen::VectorXd(n), Eigen::VectorXd(n)};
    for (Eigen::Index i = 0; i < n; ++i) {
      const ContactUnknown& one = unknowns_[static_cast<std::size_t>(i)];
      u.start[i] = one.start, u.low[i] = one.low, u.high[i] = one.high;
    }
    return u;
  }
  [[nodiscard]] TwinScene scene_at(const Eigen::VectorXd& x) const {
    TwinScene scene = scene_;
    for (std::size_t i = 0; i < unknowns_.size(); ++i)
      unknowns_[i].put(scene, x[static_cast<Eigen::Index>(i)]);
    // The brightness of the untouched face stays unchanged.
    const double t = scene.face.layer_mm;
    const double share = scene_.layer.reflectance(t) / scene.layer.reflectance(t);
    for (TwinLamp& lamp : scene.lamps) lamp.power *= share;
    scene.room_level *= share;
    return scene;
  }

  bool evaluate(const Eigen::VectorXd& x, Eigen::VectorXd& residuals,
                Eigen::MatrixXd* slopes) const;
  [[nodiscard]] std::vector<int> clusters() const;
  [[nodiscard]] ContactSpread spread_of(const TwinSolution& solution) const;

 private:
  void choose(ContactChoice choice);
  void add_log(double value, double low, double high, double& (*of)(TwinScene&),
               std::optional<double> ContactSpread::*sd);
  void add_linear(double value, double low, double high, double unit, double& (*of)(TwinScene&),
                  std::optional<double> ContactSpread::*sd);
  void add_ball(std::size_t ball, bool with_light);
  bool predict(const TwinScene& scene, std::size_t press, double* means) const;

  TwinScene scene_;
  const std::vector<TwinPatch>& patches_;
  const std::vector<TwinPress>& presses_;
  std::vector<ContactUnknown> unknowns_;
  std::vector<std::size_t> given_depths_;
  Eigen::Index residuals_ = 0;
};

// Weight of a given depth: grey levels a block per standard deviation, over all blocks of a sector.
constexpr double kGivenDepthGrey = 1.0;

void ContactStudy::add_log(double value, double low, double high, double& (*of)(TwinScene&),
                           std::optional<double> ContactSpread::*sd) {
  unknowns_.push_back({std::log(std::clamp(value, low, high)), std::log(low), std::log(high), -1,
                       [of](TwinScene& scene, double x) { of(scene) = std::exp(x); },
                       [sd](ContactSpread& spread) { return &(spread.*sd); },
                       [](double x) { return std::exp(x); }});
}

void ContactStudy::add_linear(double value, double low, double high, double unit,
                              double& (*of)(TwinScene&), std::optional<double> ContactSpread::*sd) {
  unknowns_.push_back({value / unit, low / unit, high / unit, -1,
                       [of, unit](TwinScene& scene, double x) { of(scene) = unit * x; },
                       [sd](ContactSpread& spread) { return &(spread.*sd); },
                       [unit](double) { return unit; }});
}

void ContactStudy::add_ball(std::size_t ball, bool with_light) {
  using Ball = ContactSpread::Ball;
  const auto add = [&](double value, double low, double high, double unit, double TwinBall::*of,
                       std::optional<double> Ball::*sd) {
    unknowns_.push_back({value / unit, low / unit, high / unit, static_cast<int>(ball),
                         [=](TwinScene& scene, double x) { scene.balls[ball].*of = unit * x; },
                         [=](ContactSpread& spread) { return &(spread.balls[ball].*sd); },
                         [unit](double) { return unit; }});
  };
  const TwinBall& b = scene_.balls[ball];
  const double disc = b.radius_mm;
  add(b.s_mm, b.s_mm - disc, b.s_mm + disc, 1, &TwinBall::s_mm, &Ball::s_mm);
  add(b.y_mm, b.y_mm - disc, b.y_mm + disc, 1, &TwinBall::y_mm, &Ball::y_mm);
  const double deepest = 0.98 * std::min(scene_.face.layer_mm, b.radius_mm);
  add(b.depth_mm, 0.02, deepest, 1, &TwinBall::depth_mm, &Ball::depth_mm);
  if (with_light) add(b.light, 0.9, 1.1, 0.1, &TwinBall::light, &Ball::light);
}

void ContactStudy::choose(ContactChoice choice) {
  using S = TwinScene;
  using D = ContactSpread;
  add_log(
      scene_.layer.scatter_per_mm, 0.02, 20, [](S& s) -> double& { return s.layer.scatter_per_mm; },
      &D::scatter_per_mm);
  if (choice.coat)
    add_linear(
        std::max(0.001, scene_.layer.coat), 1e-6, 0.95, 1,
        [](S& s) -> double& { return s.layer.coat; }, &D::coat);
  const bool is_hertz = scene_.rolloff == TwinRolloff::kHertz;
  add_log(
      scene_.rolloff_mm, is_hertz ? 0.01 : 0.02, is_hertz ? 100 : 2,
      [](S& s) -> double& { return s.rolloff_mm; }, &D::rolloff_mm);
  if (scene_.halo != TwinHalo::kNone) {
    add_linear(
        scene_.halo_share, 1e-6, 0.5, 0.1, [](S& s) -> double& { return s.halo_share; },
        &D::halo_share);
    add_log(
        scene_.halo_width_mm, 0.1, 10, [](S& s) -> double& { return s.halo_width_mm; },
        &D::halo_width_mm);
  }
  if (scene_.halo == TwinHalo::kExponential)
    add_log(
        scene_.halo_steepness, 0.5, 20, [](S& s) -> double& { return s.halo_steepness; },
        &D::halo_steepness);
  if (choice.blur)
    add_log(
        std::max(0.5, scene_.blur_px), 0.05, 20, [](S& s) -> double& { return s.blur_px; },
        &D::blur_px);
  for (std::size_t ball = 0; ball < scene_.balls.size(); ++ball) add_ball(ball, choice.light);
}

/// Block means of the twin's image of one press.
bool ContactStudy::predict(const TwinScene& scene, std::size_t press, double* means) const {
  const TwinPatch& patch = patches_[press];
  TwinScene one = scene.with_ball(scene.balls[press]);
  one.camera = cropped_camera(one.camera, patch.view);
  if (patch.is_coarse) {
    one.camera = downsampled_camera(one.camera, patch.side_px);
    one.blur_px /= patch.side_px;
  }
  const auto image = twin_image(one, 1);
  if (!image) return false;
  if (patch.is_coarse) {
    for (const cv::Point& corner : patch.corners)
      *means++ = image->at<float>((corner.y - patch.view.y) / patch.side_px,
                                  (corner.x - patch.view.x) / patch.side_px);
    return true;
  }
  for (const cv::Point& corner : patch.corners) {
    double sum = 0;
    for (int v = 0; v < patch.side_px; ++v) {
      const auto* row = image->ptr<float>(corner.y - patch.view.y + v) + corner.x - patch.view.x;
      for (int u = 0; u < patch.side_px; ++u) sum += row[u];
    }
    *means++ = sum / (patch.side_px * patch.side_px);
  }
  return true;
}

bool ContactStudy::evaluate(const Eigen::VectorXd& x, Eigen::VectorXd& residuals_out,
                            Eigen::MatrixXd* slopes) const {
  residuals_out.resize(residuals());
  if (slopes) *slopes = Eigen::MatrixXd::Zero(residuals(), x.size());
  const TwinScene scene = scene_at(x);
  Eigen::Index at = 0;
  for (std::size_t press = 0; press < patches_.size(); ++press) {
    const Eigen::Index n = patches_[press].target.size();
    Eigen::VectorXd means(n), moved_means(n);
    if (!predict(scene, press, means.data())) return false;
    residuals_out.segment(at, n) = means - patches_[press].target;
    for (std::size_t i = 0; slopes && i < unknowns_.size(); ++i) {
      const ContactUnknown& unknown = unknowns_[i];
      if (unknown.ball >= 0 && unknown.ball != static_cast<int>(press)) continue;
      const auto k = static_cast<Eigen::Index>(i);
      const double step = x[k] + kTwinStep > unknown.high ? -kTwinStep : kTwinStep;
      Eigen::VectorXd moved = x;
      moved[k] += step;
      if (!predict(scene_at(moved), press, moved_means.data())) return false;
      slopes->col(k).segment(at, n) = (moved_means - means) / step;
    }
    at += n;
  }
  for (const std::size_t press : given_depths_) {
    const GivenDepth& given = *presses_[press].given_depth;
    const double weight = kGivenDepthGrey *
                          std::sqrt(static_cast<double>(patches_[press].target.size())) /
                          (kTwinSectors * std::max(1e-3, given.sd_mm));
    const double upright = std::cos(scene.incline_rad);  // depth along z to depth along the normal
    residuals_out[at] = weight * (upright * scene.balls[press].depth_mm - given.mm);
    for (std::size_t i = 0; slopes && i < unknowns_.size(); ++i) {
      TwinScene moved = scene_;
      if (unknowns_[i].ball != static_cast<int>(press)) continue;
      const auto k = static_cast<Eigen::Index>(i);
      moved = scene;
      unknowns_[i].put(moved, x[k] + kTwinStep);
      (*slopes)(at, k) = weight * upright *
                         (moved.balls[press].depth_mm - scene.balls[press].depth_mm) / kTwinStep;
    }
    ++at;
  }
  return true;
}

std::vector<int> ContactStudy::clusters() const {
  std::vector<int> all;
  for (std::size_t press = 0; press < patches_.size(); ++press)
    for (const int sector : patches_[press].sectors)
      all.push_back(static_cast<int>(press) * kTwinSectors + sector);
  for (const std::size_t press : given_depths_)
    all.push_back(static_cast<int>((patches_.size() + press) * kTwinSectors));
  return all;
}

ContactSpread ContactStudy::spread_of(const TwinSolution& solution) const {
  ContactSpread spread;
  spread.balls.resize(scene_.balls.size());
  const auto sd = clustered_sd(solution, clusters());
  for (std::size_t i = 0; i < unknowns_.size(); ++i)
    if (sd[i])
      *unknowns_[i].spread(spread) =
          *sd[i] * unknowns_[i].value_per_unit(solution.x[static_cast<Eigen::Index>(i)]);
  return spread;
}

constexpr double kMaxKindResidual = 0.99;  // of the residual with the simpler kind
constexpr double kNothing_sd = 2;          // nearer to zero counts as zero
constexpr double kLeastBlur_px = 0.25;     // narrower is invisible

struct ContactRound {
  TwinScene scene;
  ContactSpread spread;
  double rms = 0;
};

class ContactSearch {
 public:
  ContactSearch(const std::vector<TwinPatch>& patches, const std::vector<TwinPress>& presses,
                const Job& job)
      : patches_(patches), presses_(presses), job_(job) {}

  [[nodiscard]] Result<ContactRound> solve(const TwinScene& from, ContactChoice choice,
                                           TwinEffort effort) const {
    if (job_.stop_requested()) return Error{en::say("stopped before the twin was found"), "", ""};
    const ContactStudy study(from, patches_, presses_, choice);
    auto solution =
        solve_twin([&](const Eigen::VectorXd& x, Eigen::VectorXd& r,
                       Eigen::MatrixXd* slopes) { return study.evaluate(x, r, slopes); },
                   study.unknowns(), study.residuals(), effort, job_);
    if (!solution) return solution.error();
    return ContactRound{study.scene_at(solution->x), study.spread_of(*solution), solution->rms()};
  }

  /// One kind of roll-off and halo, first with fixed light: a halo must not be explained by
  /// brighter lamps.
  [[nodiscard]] Result<ContactRound> solve_kind(TwinScene from, TwinRolloff rolloff,
                                                TwinHalo halo) const {
    if (from.rolloff != rolloff) from.rolloff_mm = 0.15;
    from.rolloff = rolloff;
    from.halo = halo;
    return solve(from, {true, true, false}, {40, 1e-5});
  }

 private:
  const std::vector<TwinPatch>& patches_;
  const std::vector<TwinPress>& presses_;
  const Job& job_;
};

bool is_nothing(double value, const std::optional<double>& sd) {
  return !sd || value < kNothing_sd * *sd;
}

/// The simplest scene with an equally small residual.
Result<ContactRound> simplify(const ContactSearch& search, ContactRound round) {
  ContactChoice choice;
  TwinScene simple = round.scene;
  choice.coat = !is_nothing(simple.layer.coat, round.spread.coat);
  choice.blur = simple.blur_px > kLeastBlur_px && !is_nothing(simple.blur_px, round.spread.blur_px);
  const bool no_halo = is_nothing(simple.halo_share, round.spread.halo_share);
  if (!choice.coat) simple.layer.coat = 0;
  if (!choice.blur) simple.blur_px = 0;
  if (no_halo) simple.halo = TwinHalo::kNone;
  if (choice.coat && choice.blur && !no_halo) return round;
  // The powers follow the layer.
  const double t = simple.face.layer_mm;
  const double share = round.scene.layer.reflectance(t) / simple.layer.reflectance(t);
  for (TwinLamp& lamp : simple.lamps) lamp.power *= share;
  simple.room_level *= share;
  auto last = search.solve(simple, choice, {});
  if (!last) return last.error();
  // A removed part was significant after all: the presses need it.
  if (last->rms > 1.02 * round.rms) return search.solve(round.scene, {}, {});
  return last;
}

}  // namespace

Result<TwinContact> fit_contact(const TwinScene& scene, const std::vector<TwinPatch>& coarse,
                                const std::vector<TwinPatch>& patches,
                                const std::vector<TwinPress>& presses, const Job& job) {
  const ContactSearch search(coarse, presses, job);
  job.report(0.0, en::say("fitting the presses"));
  // Starts over a black coat, with the visible halo or a typical one. Depth and scattering are
  // correlated, and a fit of all parameters at once may converge anywhere.
  std::optional<ContactRound> begun;
  TwinScene typical = scene;
  typical.halo_share = 0.06, typical.halo_width_mm = scene.face.layer_mm;
  for (const TwinScene& from : {scene, typical}) {
    auto round = search.solve(from, {false, true, false}, {40, 1e-4});
    if (!round) return round.error();
    if (!begun || round->rms < begun->rms) begun = std::move(*round);
  }
  auto hertz = search.solve_kind(begun->scene, TwinRolloff::kHertz, TwinHalo::kGaussian);
  if (!hertz) return hertz.error();
  auto exponential = search.solve_kind(hertz->scene, TwinRolloff::kHertz, TwinHalo::kExponential);
  if (!exponential) return exponential.error();
  const bool is_long = exponential->rms < kMaxKindResidual * hertz->rms;
  if (is_long) hertz = std::move(exponential);
  job.report(0.3, en::say("fitting the presses"));
  auto smooth = search.solve_kind(hertz->scene, TwinRolloff::kSmooth, hertz->scene.halo);
  if (!smooth) return smooth.error();
  const bool is_smooth = smooth->rms < kMaxKindResidual * hertz->rms;
  job.report(0.5, en::say("fitting the presses"));
  const ContactSearch closer(patches, presses, job);
  auto all = closer.solve((is_smooth ? smooth : hertz)->scene, {}, {40, 1e-5});
  if (!all) return all.error();
  auto best = simplify(closer, *all);
  if (!best) return best.error();
  return TwinContact{best->scene, best->spread, best->rms,
                     is_smooth ? TwinRolloff::kHertz : TwinRolloff::kSmooth,
                     (is_smooth ? hertz : smooth)->rms / (is_smooth ? smooth : hertz)->rms};
}

namespace {

constexpr int kBlocksAcross = 40;  // of a dark disc's diameter
constexpr int kBlurBorder_px = 20;

/// The blocks' part of the image with a border for blur; the full image where no camera model
/// covers a part so far from the axis.
cv::Rect view_of(const TwinPatch& patch, const CameraParameters& camera) {
  const cv::Rect full(0, 0, camera.width_px, camera.height_px);
  if (patch.corners.empty()) return full;
  const int side = patch.side_px, border = (kBlurBorder_px / side + 1) * side;
  cv::Rect view = cv::boundingRect(patch.corners);
  view = cv::Rect(view.x - border, view.y - border, view.width + side + 2 * border,
                  view.height + side + 2 * border);
  const int left = std::max(0, view.x), top = std::max(0, view.y);
  view = cv::Rect(left, top, view.br().x - left, view.br().y - top) & full;
  const CameraParameters seen = cropped_camera(camera, view);
  return Camera::create(seen) && Camera::create(downsampled_camera(seen, side)) ? view : full;
}

}  // namespace

TwinRings rings_of(const TwinPress& press) {
  const double reach = kTwinReach * press.disc_radius_px;
  std::vector<double> sum(static_cast<std::size_t>(reach) + 1), count(sum.size());
  for (int v = 0; v < press.grey.rows; ++v)
    for (int u = 0; u < press.grey.cols; ++u) {
      const double radius = std::hypot(u - press.disc_px.x(), v - press.disc_px.y());
      const float reference = press.reference.at<float>(v, u);
      if (!(radius < reach) || !(reference > 0)) continue;
      sum[static_cast<std::size_t>(radius)] +=
          static_cast<float>(press.grey.at<std::uint8_t>(v, u)) / reference - 1;
      count[static_cast<std::size_t>(radius)] += 1;
    }
  TwinRings rings;
  std::vector<double> mean(sum.size());  // over three rings
  for (std::size_t i = 1; i + 1 < sum.size(); ++i) {
    const double n = count[i - 1] + count[i] + count[i + 1];
    mean[i] = n > 0 ? (sum[i - 1] + sum[i] + sum[i + 1]) / n : 0;
  }
  const auto darkest = std::min_element(mean.begin(), mean.end());
  auto rim = std::find_if(darkest, mean.end(), [&](double x) { return x > 0.02 * *darkest; });
  if (rim == mean.end()) return rings;
  rings.rim_px = static_cast<double>(rim - mean.begin());
  const auto brightest = std::max_element(rim, mean.end());
  rings.halo_px = static_cast<double>(brightest - rim);
  rings.brightest = std::max(0.0, *brightest);
  return rings;
}

TwinPatch patch_of(const TwinPress& press, const cv::Mat& untouched, const CameraParameters& camera,
                   bool is_coarse) {
  TwinPatch patch;
  patch.is_coarse = is_coarse;
  const double across = is_coarse ? kBlocksAcross / 3.0 : kBlocksAcross;
  patch.side_px = std::max(1, static_cast<int>(2 * press.disc_radius_px / across));
  const int side = patch.side_px;
  const double reach = kTwinReach * press.disc_radius_px;
  std::vector<double> target;
  for (int v = 0; v + side <= press.grey.rows; v += side)
    for (int u = 0; u + side <= press.grey.cols; u += side) {
      const double du = u + 0.5 * (side - 1) - press.disc_px.x();
      const double dv = v + 0.5 * (side - 1) - press.disc_px.y();
      if (std::hypot(du, dv) > reach) continue;
      double live = 0, reference = 0, twin = 0;
      bool saturated = false;
      for (int i = 0; i < side; ++i)
        for (int j = 0; j < side; ++j) {
          const std::uint8_t level = press.grey.at<std::uint8_t>(v + i, u + j);
          saturated |= level >= 254;
          live += level;
          reference += press.reference.at<float>(v + i, u + j);
          twin += untouched.at<float>(v + i, u + j);
        }
      if (saturated || !(reference > 0) || !std::isfinite(reference)) continue;
      patch.corners.emplace_back(u, v);
      target.push_back(live / reference * twin / (side * side));
      const double turn = (std::atan2(dv, du) + std::numbers::pi) / (2 * std::numbers::pi);
      patch.sectors.push_back(std::min(kTwinSectors - 1, static_cast<int>(kTwinSectors * turn)));
    }
  patch.target =
      Eigen::Map<Eigen::VectorXd>(target.data(), static_cast<Eigen::Index>(target.size()));
  patch.view = view_of(patch, camera);
  return patch;
}

}  // namespace alltact
