#include "calibration/twin/twin.h"
#include "calibration/twin/twin_contact.h"
#include "calibration/twin/twin_figures.h"
#include "calibration/twin/twin_image.h"
#include "calibration/twin/twin_lamps.h"
#include "calibration/twin/twin_noise.h"
#include "calibration/twin/twin_pose.h"
#include "calibration/twin/twin_residual.h"
#include "core/simulation/plan.h"

#include <algorithm>
#include <cmath>

namespace alltact {
namespace {

constexpr double kPlane_mm = 30;  // plane of an orthographic camera; images do not determine it
constexpr double kMinLightChange = 5e-4;  // smaller changes of the lamps count as none

Error stopped_twin() {
  return {en::say("stopped before the twin was found"), "", ""};
}

Result<TwinScene> start_scene(const TwinInput& input) {
  if (input.presses.empty())
    return Error{en::say("there is no pressed picture"),
                 "",
                 en::say("pictures of a ball of known radius pressed into the face")};
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

Status take_poses(const TwinInput& input,
                  TwinScene& scene,
                  std::vector<TwinPose>& poses,
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
void initialise_balls(const TwinInput& input,
                      const std::vector<TwinPose>& poses,
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
    scene.balls.push_back(
        {press.name,
         radius,
         position.x(),
         position.y(),
         std::clamp(
             press.given_depth ? press.given_depth->mm : depth, 0.05, 0.9 * scene.face.layer_mm),
         1,
         poses[i]});
    if (rings.brightest <= brightest) continue;
    brightest = rings.brightest;
    // First estimate of the layer from a change of brightness: t dR / (R dt) = 1 / (1 + St).
    const double st = scene.layer.scatter_per_mm * scene.face.layer_mm;
    scene.halo_share = std::clamp(brightest * (1 + st), 0.005, 0.45);
    scene.halo_width_mm = std::clamp(mm_per_px * rings.halo_px, 0.2, 5.0);
  }
}

/// The reference images, each once; presses of a flat sensor share theirs.
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
    return measure_noise(untouched,
                         untouched,
                         en::say("noise is told from {} untouched pictures", untouched.size()));
  const std::vector<NoisyImage> alike{untouched.front(),
                                      {first.grey, outside_contact(first, kTwinReach)}};
  const Message from = en::say(
      "noise in time is told from one untouched picture and {} beside its contact", first.name);
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
          en::say("{}: too little around the contact can be compared", input.presses[i].name),
          "",
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
