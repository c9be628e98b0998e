#include "calibration/twin/twin.h"

#include "calibration/twin/twin_contact.h"
#include "calibration/twin/twin_scene.h"
#include "calibration/twin/twin_untouched.h"
#include "core/simulation/plan.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Dense>
#include <fmt/format.h>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

namespace alltact {
namespace {

constexpr double kMaxRelativeSd = 0.5;  // sd over value

std::string with_sd(const TwinFigure& figure) {
  return figure.sd ? fmt::format("{:.4g} +- {:.2g}", figure.value, *figure.sd)
                   : fmt::format("{:.4g}", figure.value);
}

/// `positive`: half its own size is a large uncertainty of the number.
void add_figure(Twin& twin, const std::string& key, const Message& what, double value,
                const std::optional<double>& sd, bool positive = true) {
  TwinFigure figure{key, what, value, sd, ""};
  if (!sd)
    figure.remark = en::say("not observable: at its limit, or another number has the same effect");
  else if (positive && *sd > kMaxRelativeSd * value)
    figure.remark = en::say("hardly observable in these images");
  twin.figures.push_back(std::move(figure));
}

/// Comments an effect of the scene with the last `count` figures.
void comment_effect(Twin& twin, const std::string& effect, const std::string& what,
                    std::size_t count) {
  std::string text = what;
  const std::size_t first = twin.figures.size() - count;
  for (std::size_t i = first; i < twin.figures.size(); ++i)
    text += fmt::format("{} {} {}", i == first ? ":" : ",", twin.figures[i].key,
                        with_sd(twin.figures[i]));
  twin.scene.comments[effect] = text;
}

void write_layer(const TwinContact& contact, Twin& twin) {
  const TwinScene& scene = twin.scene;
  const ContactSpread& sd = contact.spread;
  add_figure(twin, "scatter_per_mm", en::say("scattering of the layer, per mm"),
             scene.layer.scatter_per_mm, sd.scatter_per_mm);
  std::size_t count = 1;
  if (scene.layer.coat > 0) {
    add_figure(twin, "coat", en::say("reflection of the coat below the layer"), scene.layer.coat,
               sd.coat);
    ++count;
  } else {
    twin.remarks.push_back(
        en::say("the coat below the layer is assumed to be black: the presses show nothing else"));
  }
  comment_effect(twin, "layer", "told by how the presses darken", count);
  twin.remarks.push_back(en::say(
      "absorption in the layer is not observable: scattering and coat change the same curve"));
  add_figure(twin, "rolloff length_mm", en::say("roll-off length, mm"), scene.rolloff_mm,
             sd.rolloff_mm);
  comment_effect(
      twin, "rolloff",
      fmt::format("told by the rims of the contacts, where kind {} leaves {:.2f} times as much",
                  contact.other_rolloff == TwinRolloff::kHertz ? "hertz" : "smooth",
                  contact.other_factor),
      1);
}

void write_halo(const TwinContact& contact, Twin& twin) {
  const TwinScene& scene = twin.scene;
  const ContactSpread& sd = contact.spread;
  if (scene.halo == TwinHalo::kNone) {
    twin.remarks.push_back(en::say("no swelling is visible around the contacts"));
  } else {
    std::size_t count = 2;
    add_figure(twin, "bulge share", en::say("height of the swelling, fraction of the layer"),
               scene.halo_share, sd.halo_share);
    add_figure(twin, "bulge width_mm", en::say("its distance from the rim, mm"),
               scene.halo_width_mm, sd.halo_width_mm);
    if (scene.halo == TwinHalo::kExponential) {
      add_figure(twin, "bulge steepness", en::say("steepness of its slope"), scene.halo_steepness,
                 sd.halo_steepness);
      ++count;
    }
    comment_effect(twin, "bulge", "told by the bright halos", count);
  }
  if (scene.blur_px > 0) {
    add_figure(twin, "blur_px", en::say("blur, standard deviation in pixels"), scene.blur_px,
               sd.blur_px);
    comment_effect(twin, "defocus", "told by the steepest edges of the presses", 1);
  } else {
    twin.remarks.push_back(en::say("no blur is visible apart from the roll-off"));
  }
}

void write_balls(const TwinContact& contact, Twin& twin) {
  for (std::size_t i = 0; i < twin.scene.balls.size(); ++i) {
    const TwinBall& ball = twin.scene.balls[i];
    const ContactSpread::Ball& sd = contact.spread.balls[i];
    add_figure(twin, ball.press + " depth_mm", en::say("{}: depth, mm", ball.press), ball.depth_mm,
               sd.depth_mm);
    add_figure(twin, ball.press + " s_mm", en::say("{}: position along the face, mm", ball.press),
               ball.s_mm, sd.s_mm, false);
    add_figure(twin, ball.press + " y_mm", en::say("{}: position across the face, mm", ball.press),
               ball.y_mm, sd.y_mm, false);
    std::size_t count = 3;
    if (ball.light != 1) {
      add_figure(twin, ball.press + " light",
                 en::say("{}: light, relative to its untouched image", ball.press), ball.light,
                 sd.light);
      ++count;
    }
    comment_effect(twin, "ball " + ball.press, ball.press, count);
  }
}

void write_lamps(const TwinLamps& lamps, Twin& twin) {
  int hardly = 0;
  double least = 0, most = 0;
  for (std::size_t i = 0; i < lamps.lamps.size(); ++i) {
    // The powers follow the layer, which the presses determine.
    const double power = twin.scene.lamps[i].power;
    std::optional<double> sd = lamps.spread[i].power;
    if (sd) *sd *= power / lamps.lamps[i].power;
    add_figure(twin, fmt::format("lamp {} power", i + 1), en::say("lamp {}: power", i + 1), power,
               sd);
    const std::optional<Eigen::Vector3d>& at_sd = lamps.spread[i].at_mm;
    const double distance = twin.scene.face.kind == FaceKind::kFlat
                                ? twin.scene.face.plane_z_mm - lamps.lamps[i].at_mm.z()
                                : lamps.lamps[i].at_mm.norm();
    std::optional<double> distance_sd;
    if (at_sd) distance_sd = twin.scene.face.kind == FaceKind::kFlat ? at_sd->z() : at_sd->norm();
    add_figure(twin, fmt::format("lamp {} distance_mm", i + 1),
               twin.scene.face.kind == FaceKind::kFlat
                   ? en::say("lamp {}: distance from the face, mm", i + 1)
                   : en::say("lamp {}: distance from the camera, mm", i + 1),
               distance, distance_sd);
    if (!distance_sd || *distance_sd > kMaxRelativeSd * distance) ++hardly;
    least = i == 0 ? distance : std::min(least, distance);
    most = std::max(most, distance);
  }
  twin.scene.comments["leds"] = fmt::format(
      "{} that light the untouched face as it is lit, to {:.2f} grey levels; they need not be the "
      "real ones",
      lamps.lamps.size() == 1 ? "one lamp" : fmt::format("{} lamps", lamps.lamps.size()),
      lamps.rms);
  if (lamps.room_level > 0) twin.scene.comments["ambient"] = "even light that no lamp gives";
  twin.remarks.push_back(
      en::say("the lamps reproduce the light on the face, not the positions of the real ones: {} "
              "of {} positions are not observable",
              hardly, lamps.lamps.size()));
}

void write_noise(const TwinNoise& noise, Twin& twin) {
  if (noise.read_sd > 0) {
    add_figure(twin, "read sd", en::say("read noise, grey levels"), noise.read_sd,
               noise.read_sd_sd);
    comment_effect(twin, "read", noise.from.english(), 1);
  }
  if (noise.shot_gain > 0) {
    add_figure(twin, "shot gain", en::say("shot noise, grey levels"), noise.shot_gain,
               noise.shot_gain_sd);
    comment_effect(twin, "shot", noise.from.english(), 1);
  } else {
    twin.remarks.push_back(
        en::say("shot noise and read noise cannot be separated: the face is too evenly lit, or "
                "shot noise is absent"));
  }
  if (noise.prnu > 0) {
    add_figure(twin, "fixed-pattern prnu", en::say("fixed pattern, fraction"), noise.prnu,
               noise.prnu_sd);
    comment_effect(twin, "fixed-pattern", noise.from.english(), 1);
  }
  twin.remarks.push_back(noise.from);
}

/// Fills figures, remarks, and the comments of the scene. The scene's numbers and residuals are
/// final.
void write_figures(const TwinLamps& lamps, const TwinContact& contact, const TwinNoise& noise,
                   Twin& twin) {
  write_layer(contact, twin);
  write_halo(contact, twin);
  write_balls(contact, twin);
  write_lamps(lamps, twin);
  write_noise(noise, twin);
  if (twin.scene.face.kind == FaceKind::kFinRay)
    twin.remarks.push_back(
        en::say("the scene contains the face only: no side faces, no dots, no twist"));
}

/// Sums over one ring.
struct RingSums {
  double count = 0, radius = 0, real = 0, twin = 0, difference2 = 0, ratio = 0;
};

/// `twin`, `twin_untouched`: CV_32FC1, of the press and of the untouched finger in its pose;
/// `middle_px`: of the contact.
TwinResidual residual_of(const TwinPress& press, const cv::Mat& twin, const cv::Mat& twin_untouched,
                         const Eigen::Vector2d& middle_px) {
  TwinResidual result;
  result.press = press.name;
  result.reach_px = kTwinReach * press.disc_radius_px;
  std::vector<RingSums> rings(static_cast<std::size_t>(result.reach_px) + 1);
  double count = 0, sum2 = 0, ratio_sum2 = 0;
  for (int v = 0; v < press.grey.rows; ++v)
    for (int u = 0; u < press.grey.cols; ++u) {
      const double radius = std::hypot(u - middle_px.x(), v - middle_px.y());
      const float reference = press.reference.at<float>(v, u);
      if (!(radius < result.reach_px) || !(reference > 0)) continue;
      const double real = press.grey.at<std::uint8_t>(v, u), made = twin.at<float>(v, u);
      const double by_ratio = made - real / reference * twin_untouched.at<float>(v, u);
      RingSums& ring = rings[static_cast<std::size_t>(radius)];
      ring.count += 1;
      ring.radius += radius;
      ring.real += real;
      ring.twin += made;
      ring.difference2 += (made - real) * (made - real);
      ring.ratio += by_ratio;
      count += 1;
      sum2 += (made - real) * (made - real);
      ratio_sum2 += by_ratio * by_ratio;
    }
  if (count == 0) return result;
  result.rms = std::sqrt(sum2 / count);
  result.ratio_rms = std::sqrt(ratio_sum2 / count);
  double profile2 = 0, ratio_profile2 = 0;
  for (const RingSums& ring : rings) {
    if (ring.count == 0) continue;
    const double n = ring.count, difference = (ring.twin - ring.real) / n;
    const double variance = std::max(0.0, ring.difference2 / n - difference * difference);
    result.profile.push_back({ring.radius / n, ring.real / n, ring.twin / n,
                              std::sqrt(variance / std::max(1.0, n - 1))});
    profile2 += difference * difference;
    ratio_profile2 += (ring.ratio / n) * (ring.ratio / n);
  }
  result.profile_rms = std::sqrt(profile2 / static_cast<double>(result.profile.size()));
  result.ratio_profile_rms = std::sqrt(ratio_profile2 / static_cast<double>(result.profile.size()));
  return result;
}

constexpr double kMaskPower = 36;        // sum of the squares of the second differences' weights
constexpr double kQuantised = 1.0 / 12;  // variance of rounding to integer grey levels
constexpr int kLevels = 12;              // groups by brightness
constexpr double kCut = 3.5;             // sd; larger second differences are structure, not noise
constexpr double kCutVariance = 0.9939;  // of a normal distribution truncated there

/// One second difference: its square as a variance, and the grey level.
struct Wiggle {
  double level, variance;
};

void collect(const cv::Mat& values, const cv::Mat& used, const cv::Mat& levels, double share,
             std::vector<Wiggle>& wiggles) {
  cv::Mat_<float> second;
  const cv::Mat mask = (cv::Mat_<float>(3, 3) << 1, -2, 1, -2, 4, -2, 1, -2, 1);
  cv::filter2D(values, second, CV_32F, mask);
  cv::Mat inner;
  cv::erode(used, inner, cv::Mat(), cv::Point(-1, -1), 1, cv::BORDER_CONSTANT, 0);
  for (int v = 1; v + 1 < second.rows; ++v)
    for (int u = 1; u + 1 < second.cols; ++u) {
      const float level = levels.at<float>(v, u);
      if (inner.at<std::uint8_t>(v, u) == 0 || level < 3 || level > 250) continue;
      const double wiggle = second(v, u);
      wiggles.push_back({level, share * wiggle * wiggle / kMaskPower});
    }
}

/// Removes dots, edges and scratches.
void cut(std::vector<Wiggle>& wiggles) {
  for (int round = 0; round < 4 && !wiggles.empty(); ++round) {
    double mean = 0;
    for (const Wiggle& one : wiggles) mean += one.variance / static_cast<double>(wiggles.size());
    std::erase_if(wiggles, [&](const Wiggle& one) { return one.variance > kCut * kCut * mean; });
  }
}

struct NoiseLaw {
  double constant = 0, per_level = 0, constant_sd = 0, per_level_sd = 0;
  double variance = 0, level = 0;  // at the mean brightness
  double count = 0;
};

/// variance = constant + per_level * level, from groups of equal number. A group's variance has a
/// relative sd of sqrt(2 / n), times the correlation of neighbouring second differences.
NoiseLaw law_of(std::vector<Wiggle> wiggles, double rounding) {
  cut(wiggles);
  NoiseLaw law;
  law.count = static_cast<double>(wiggles.size());
  if (wiggles.size() < 400) return law;
  std::sort(wiggles.begin(), wiggles.end(),
            [](const Wiggle& a, const Wiggle& b) { return a.level < b.level; });
  Eigen::Matrix2d normal = Eigen::Matrix2d::Zero();
  Eigen::Vector2d right = Eigen::Vector2d::Zero();
  for (std::size_t group = 0; group < kLevels; ++group) {
    const std::size_t first = wiggles.size() * group / kLevels;
    const std::size_t end = wiggles.size() * (group + 1) / kLevels;
    double level = 0, variance = 0;
    for (std::size_t i = first; i < end; ++i) {
      level += wiggles[i].level;
      variance += wiggles[i].variance / kCutVariance;
    }
    const auto n = static_cast<double>(end - first);
    level /= n, variance /= n;
    law.level += level / kLevels;
    law.variance += variance / kLevels;
    // 36^2 over the sum of the mask's squared autocorrelation: fewer independent values by 4900 /
    // 1296.
    const double sd = std::max(1e-3, variance) * std::sqrt(2 * 4900.0 / 1296 / n);
    const Eigen::Vector2d row(1, level);
    normal += row * row.transpose() / (sd * sd);
    right += row * (variance - rounding) / (sd * sd);
  }
  law.variance -= rounding;
  const Eigen::Matrix2d covariance = normal.inverse();
  const Eigen::Vector2d x = covariance * right;
  law.constant = x[0], law.per_level = x[1];
  law.constant_sd = std::sqrt(covariance(0, 0)), law.per_level_sd = std::sqrt(covariance(1, 1));
  return law;
}

cv::Mat as_float(const cv::Mat& grey) {
  cv::Mat result;
  grey.convertTo(result, CV_32F);
  return result;
}

cv::Mat smooth_levels(const cv::Mat& values) {
  cv::Mat result;
  cv::boxFilter(values, result, CV_32F, cv::Size(7, 7));
  return result;
}

void put_law(const NoiseLaw& law, TwinNoise& noise) {
  const double flat_sd = law.variance * std::sqrt(2 * 4900.0 / 1296 / std::max(1.0, law.count));
  noise.sd = std::sqrt(std::max(0.0, law.variance));
  if (law.per_level > 2.5 * law.per_level_sd && law.constant > -2 * law.constant_sd) {
    noise.shot_gain = law.per_level;
    noise.shot_gain_sd = law.per_level_sd;
    noise.read_sd = std::sqrt(std::max(0.0, law.constant));
    if (noise.read_sd > 0) noise.read_sd_sd = law.constant_sd / (2 * noise.read_sd);
    return;
  }
  noise.read_sd = noise.sd;
  if (noise.sd > 0) noise.read_sd_sd = flat_sd / (2 * noise.sd);
}

}  // namespace

TwinNoise measure_noise(const std::vector<NoisyImage>& alike,
                        const std::vector<NoisyImage>& singles, const Message& what_is_alike) {
  TwinNoise noise;
  std::vector<Wiggle> single;
  for (const NoisyImage& one : singles) {
    const cv::Mat values = as_float(one.grey);
    collect(values, one.used, smooth_levels(values), 1, single);
  }
  const NoiseLaw spatial = law_of(single, kQuantised);
  if (alike.size() < 2) {
    put_law(spatial, noise);
    noise.from = en::say(
        "noise is estimated from single images: fixed pattern and temporal noise of the camera "
        "cannot be separated");
    return noise;
  }
  std::vector<Wiggle> pairs;
  for (std::size_t i = 0; i + 1 < alike.size(); ++i) {
    const cv::Mat a = as_float(alike[i].grey), b = as_float(alike[i + 1].grey);
    cv::Mat used;
    cv::bitwise_and(alike[i].used, alike[i + 1].used, used);
    collect(a - b, used, smooth_levels(a), 0.5, pairs);
  }
  const NoiseLaw in_time = law_of(pairs, kQuantised);
  put_law(in_time, noise);
  noise.from = what_is_alike;
  const double fixed = spatial.variance - in_time.variance;
  const double fixed_sd = std::sqrt(2 * 4900.0 / 1296 / std::max(1.0, in_time.count)) *
                          std::hypot(spatial.variance, in_time.variance);
  if (fixed > 2 * fixed_sd && in_time.level > 0) {
    noise.prnu = std::sqrt(fixed) / in_time.level;
    noise.prnu_sd = fixed_sd / (2 * std::sqrt(fixed)) / in_time.level;
  }
  return noise;
}

namespace {

constexpr double kPlane_mm = 30;  // plane of an orthographic camera; images do not determine it
constexpr double kMinLightChange = 5e-4;  // smaller changes of the lamps count as none

Error stopped_twin() { return {en::say("stopped before the twin was found"), "", ""}; }

Result<TwinScene> start_scene(const TwinInput& input) {
  if (input.presses.empty())
    return Error{en::say("there is no image of a press"), "",
                 en::say("images of a ball of known radius pressed into the face")};
  TwinScene scene;
  scene.name = input.name + " twin";
  scene.why =
      "What was fitted to pictures of the finger " + input.name +
      ": frame 0 is untouched, the others show its presses. Change a ball to rehearse another.";
  scene.camera = input.camera;
  scene.camera.orientation = Orientation::kNone;
  scene.face = input.face;
  if (scene.face.kind == FaceKind::kFlat && scene.face.plane_z_mm < 0.1)
    scene.face.plane_z_mm = kPlane_mm;
  return scene;
}

Status take_poses(const TwinInput& input, TwinScene& scene, std::vector<TwinPose>& poses,
                  const Job& job) {
  poses.assign(input.presses.size(), TwinPose{});
  if (scene.face.kind == FaceKind::kFlat) return {};
  std::vector<const FaceShape*> shapes;
  for (const TwinPress& press : input.presses) shapes.push_back(&press.shape);
  const auto fitted = fit_poses(shapes, job);
  if (!fitted) return fitted.error();
  scene.base_mm = fitted->base_mm;
  scene.incline_rad = fitted->incline_rad;
  scene.length_mm = fitted->length_mm;
  poses = fitted->poses;
  scene.rest = poses.front();
  return {};
}

/// mm per px on the face at a press, approximate.
double mm_per_px_at(const TwinScene& scene, const TwinPress& press) {
  return scene.camera.model == CameraModel::kOrthographic
             ? scene.camera.mm_per_px
             : std::max(1.0, press.ball_mm.z() - press.ball_radius_mm) / scene.camera.fx_px;
}

/// Initial values of the fit: ball depths from their rims, the halo from the press that shows most.
void initialise_balls(const TwinInput& input, const std::vector<TwinPose>& poses,
                      TwinScene& scene) {
  double brightest = 0;
  for (std::size_t i = 0; i < input.presses.size(); ++i) {
    const TwinPress& press = input.presses[i];
    const double radius = press.ball_radius_mm, mm_per_px = mm_per_px_at(scene, press);
    const TwinRings rings = rings_of(press);
    const double rim =
        std::min(0.95 * radius, mm_per_px * std::max(rings.rim_px, press.disc_radius_px));
    const double depth = radius - std::sqrt(radius * radius - rim * rim);
    const Eigen::Vector2d position = position_under(scene, poses[i], press.ball_mm);
    scene.balls.push_back({press.name, radius, position.x(), position.y(),
                           std::clamp(press.given_depth ? press.given_depth->mm : depth, 0.05,
                                      0.9 * scene.face.layer_mm),
                           1, poses[i]});
    if (rings.brightest <= brightest) continue;
    brightest = rings.brightest;
    // First estimate of the layer from a change of brightness: t dR / (R dt) = 1 / (1 + St).
    const double st = scene.layer.scatter_per_mm * scene.face.layer_mm;
    scene.halo_share = std::clamp(brightest * (1 + st), 0.005, 0.45);
    scene.halo_width_mm = std::clamp(mm_per_px * rings.halo_px, 0.2, 5.0);
  }
}

/// The reference images, each once; presses of a flat sensor share one image.
std::vector<TwinUntouched> untouched_of(const TwinInput& input,
                                        const std::vector<TwinPose>& poses) {
  std::vector<TwinUntouched> all;
  for (std::size_t i = 0; i < input.presses.size(); ++i)
    if (i == 0 || input.presses[i].reference.data != input.presses[i - 1].reference.data)
      all.push_back({poses[i], input.presses[i].reference});
  return all;
}

double rms_of(const cv::Mat& real, const cv::Mat& twin) {
  double sum = 0, count = 0;
  for (int v = 0; v < real.rows; ++v)
    for (int u = 0; u < real.cols; ++u) {
      const double difference = double{twin.at<float>(v, u)} - real.at<float>(v, u);
      if (!std::isfinite(difference)) continue;
      sum += difference * difference;
      count += 1;
    }
  return count > 0 ? std::sqrt(sum / count) : 0;
}

/// 255 where a press shows the untouched face. Flat sensors only, whose pixels show the same skin
/// in all images.
cv::Mat outside_contact(const TwinPress& press, double times) {
  cv::Mat used(press.grey.size(), CV_8UC1, cv::Scalar(255));
  for (int v = 0; v < used.rows; ++v)
    for (int u = 0; u < used.cols; ++u)
      if (std::hypot(u - press.disc_px.x(), v - press.disc_px.y()) < times * press.disc_radius_px ||
          !(press.reference.at<float>(v, u) > 0))
        used.at<std::uint8_t>(v, u) = 0;
  return used;
}

TwinNoise noise_of(const TwinInput& input) {
  const TwinPress& first = input.presses.front();
  const bool is_flat = input.face.kind == FaceKind::kFlat;
  std::vector<NoisyImage> untouched;
  for (const cv::Mat& grey : input.untouched) {
    cv::Mat used(grey.size(), CV_8UC1, cv::Scalar(255));
    if (!is_flat) used = first.reference > 0;
    untouched.push_back({grey, used});
  }
  if (untouched.empty()) {
    std::vector<NoisyImage> pressed;
    for (const TwinPress& press : input.presses)
      pressed.push_back({press.grey, outside_contact(press, 0)});
    return measure_noise({}, pressed, "");
  }
  if (untouched.size() > 1 || !is_flat)
    return measure_noise(untouched, untouched,
                         en::say("noise is estimated from {} untouched images", untouched.size()));
  const std::vector<NoisyImage> alike{untouched.front(),
                                      {first.grey, outside_contact(first, kTwinReach)}};
  const Message from =
      en::say("temporal noise is estimated from one untouched image and {} outside its contact",
              first.name);
  return measure_noise(alike, untouched, from);
}

/// Pixel of the twin's contact.
Eigen::Vector2d contact_px(const TwinScene& scene, const TwinBall& ball, const TwinPress& press) {
  const auto parsed = Scene::parse(scene.with_ball(ball).to_yaml(false), "the twin's scene");
  if (!parsed) return press.disc_px;
  const auto plan = Plan::compile(*parsed, 1);
  if (!plan) return press.disc_px;
  const Truth truth = plan->truth(1, TruthDetail::kWithoutImages);
  if (truth.balls.empty()) return press.disc_px;
  const Eigen::Vector3d deepest =
      truth.balls.front().centre_mm - Eigen::Vector3d(0, 0, truth.balls.front().radius_mm);
  const auto camera = Camera::create(scene.camera);
  const auto pixel = camera ? camera->project(deepest) : std::nullopt;
  return pixel ? *pixel : press.disc_px;
}

Status compute_residuals(const TwinInput& input, const std::vector<TwinPose>& poses, Twin& twin) {
  for (std::size_t i = 0; i < input.presses.size(); ++i) {
    const TwinPress& press = input.presses[i];
    const TwinBall& ball = twin.scene.balls[i];
    const auto untouched = twin_image(twin.scene.untouched(poses[i]), 0);
    if (!untouched) return untouched.error();
    const auto pressed = twin_image(twin.scene, static_cast<int>(i) + 1);
    if (!pressed) return pressed.error();
    twin.untouched_rms = std::max(twin.untouched_rms, rms_of(press.reference, *untouched));
    twin.residuals.push_back(
        residual_of(press, *pressed, *untouched, contact_px(twin.scene, ball, press)));
  }
  return {};
}

}  // namespace

Result<Twin> fit_twin(const TwinInput& input, const Job& job) {
  auto start = start_scene(input);
  if (!start) return start.error();
  TwinScene scene = std::move(*start);
  std::vector<TwinPose> poses;
  if (const Status status = take_poses(input, scene, poses, job); !status) return status.error();
  const auto lamps = fit_lamps(scene, untouched_of(input, poses), Job(job, 0.0, 0.3));
  if (!lamps) return lamps.error();
  scene.lamps = lamps->lamps;
  scene.room_level = lamps->room_level;
  initialise_balls(input, poses, scene);

  std::vector<TwinPatch> coarse, patches;
  for (std::size_t i = 0; i < input.presses.size(); ++i) {
    const auto untouched = twin_image(scene.untouched(poses[i]), 0);
    if (!untouched) return untouched.error();
    coarse.push_back(patch_of(input.presses[i], *untouched, scene.camera, true));
    patches.push_back(patch_of(input.presses[i], *untouched, scene.camera, false));
    if (patches.back().target.size() < 100)
      return Error{
          en::say("{}: too little around the contact can be compared", input.presses[i].name), "",
          en::say("a press further from the face's edges")};
  }
  auto contact = fit_contact(scene, coarse, patches, input.presses, Job(job, 0.3, 0.95));
  if (!contact) return contact.error();
  if (job.stop_requested()) return stopped_twin();

  Twin twin;
  twin.scene = contact->scene;
  for (std::size_t i = 0; i < twin.scene.balls.size(); ++i) {
    double& light = twin.scene.balls[i].light;
    const auto& sd = contact->spread.balls[i].light;
    if (std::abs(light - 1) < std::max(kMinLightChange, sd ? 2 * *sd : 0.0)) light = 1;
  }
  const TwinNoise noise = noise_of(input);
  twin.scene.read_sd = noise.read_sd;
  twin.scene.shot_gain = noise.shot_gain;
  twin.scene.prnu = noise.prnu;
  if (const Status status = compute_residuals(input, poses, twin); !status) return status.error();
  write_figures(*lamps, *contact, noise, twin);
  twin.yaml = twin.scene.to_yaml(true);
  job.report(1.0, en::say("done"));
  return twin;
}

}  // namespace alltact
