#include "tests/support/simulated_fault.h"

#include "core/sensing/pipeline.h"
#include "core/simulation/plan.h"

#include <fmt/format.h>
#include <opencv2/imgproc.hpp>

namespace alltact {
namespace {

constexpr double kBallRadiusMm = 4.0;
constexpr double kRadiusError = 1.1;
constexpr double kMoreLight = 1.05;
constexpr double kGains[] = {1.0, 1.06, 0.95, 1.03};
constexpr double kMovedPx[] = {4.0, 2.0};

/// The lamps are uneven, so that a motion of the camera shows.
std::string scene_text(Fault fault, bool pressed) {
  std::string text = fmt::format(
      "name: typical fault {}\n"
      "why: Shows what a fault does to a calibration.\n"
      "frames: {}\n"
      "finger:\n"
      "  camera: {{model: orthographic, size: [240, 180], mm_per_px: 0.1, cx: 119.5, cy: 89.5}}\n"
      "  face: {{kind: flat, layer_mm: 1.5, plane_z_mm: 30.0}}\n"
      "effects:\n",
      pressed ? "presses" : "reference", pressed ? 4 : 1);
  if (pressed) {
    const bool loose = fault == Fault::kLooseSkin;
    text += fmt::format(
        "  - use: ball\n"
        "    radius_mm: {}\n"
        "    s_mm: [-4.5, 4.0, -3.0, 4.5]\n"
        "    y_mm: [-2.5, -2.0, 3.0, 2.5]\n"
        "    depth_mm: [0.9, 0.5, 1.1, 0.7]\n"
        "  - {{use: rolloff, kind: hertz, length_mm: {}}}\n"
        "  - {{use: bulge, share: {}, width_mm: 1.2}}\n",
        kBallRadiusMm, loose ? 1.6 : 0.6, loose ? 0.15 : 0.03);
  }
  const double light = fault == Fault::kBrighterLight && pressed ? kMoreLight : 1.0;
  return text + fmt::format(
                    "  - {{use: layer, scatter_per_mm: 0.6, along: normal}}\n"
                    "  - use: leds\n"
                    "    lamps:\n"
                    "      - {{at_mm: [-20.0, 0.0, 0.0], power: {}}}\n"
                    "      - {{at_mm: [20.0, 0.0, 0.0], power: {}}}\n"
                    "  - {{use: read, sd: 1.0}}\n"
                    "  - {{use: quantisation}}\n",
                    260000.0 * light, 160000.0 * light);
}

Result<Plan> plan_of(Fault fault, bool pressed, std::uint64_t seed) {
  const auto scene = Scene::parse(scene_text(fault, pressed), "a typical fault");
  if (!scene) return scene.error();
  return Plan::compile(*scene, seed);
}

cv::Mat with_fault(cv::Mat image, Fault fault, int frame) {
  cv::Mat changed = image;
  if (fault == Fault::kAutomaticExposure) image.convertTo(changed, CV_8U, kGains[frame % 4]);
  if (fault == Fault::kMovedCamera) {
    const cv::Matx23d shift(1, 0, kMovedPx[0], 0, 1, kMovedPx[1]);
    cv::warpAffine(image, changed, shift, image.size(), cv::INTER_LINEAR, cv::BORDER_REPLICATE);
  }
  return changed;
}

}  // namespace

Result<SimulatedCalibration> simulate_calibration(Fault fault, std::uint64_t seed,
                                                  bool correct_light, const Job& job) {
  const auto untouched = plan_of(fault, false, seed);
  if (!untouched) return untouched.error();
  const auto pressed = plan_of(fault, true, seed);
  if (!pressed) return pressed.error();
  const auto finger = FingerSnapshot::of({}, pressed->finger());
  if (!finger) return finger.error();
  auto library = ReferenceLibrary::single(untouched->render(0));
  if (!library) return library.error();
  PipelineSettings settings;
  settings.correct_light = correct_light;
  Pipeline pipeline = Pipeline::with_library(std::move(*library), *finger, settings);

  const double radius_mm = kBallRadiusMm * (fault == Fault::kWrongRadius ? kRadiusError : 1.0);
  SimulatedCalibration made;
  std::vector<Press> presses;
  for (int i = 0; i < pressed->frame_count(); ++i) {
    if (job.stop_requested()) return Error{en::say("stopped"), "", ""};
    auto frame = std::make_shared<Frame>();
    frame->grey = with_fault(pressed->render(i), fault, i);
    frame->name = fmt::format("press_{}", i);
    auto result = pipeline(frame);
    if (!result) return result.error();
    if (!result->difference || !result->shape) continue;
    made.signs.push_back({result->difference->light.change(), true});
    presses.push_back(
        {frame->name, std::move(*result->difference), std::move(*result->shape), radius_mm});
  }
  CalibrationSettings simple;  // the faults show with any curve
  simple.family = FamilyChoice::kMoebius;
  simple.along = AlongChoice::kZ;
  auto calibration = calibrate(presses, finger->camera, finger->finger.face, simple, job);
  if (!calibration) return calibration.error();
  made.calibration = std::move(calibration).value();
  std::vector<const Press*> all;
  for (const Press& press : presses) all.push_back(&press);
  made.residuals = press_residuals(all, finger->finger.face, made.calibration);
  return made;
}

}  // namespace alltact
