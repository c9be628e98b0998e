// Twins of fingers whose every number is known: what can be seen in their pictures comes out.
#include "calibration/twin/twin.h"

#include "calibration/twin/twin_scene.h"
#include "core/finger/finger_store.h"
#include "core/image/image_file.h"
#include "core/simulation/plan.h"
#include "core/simulation/scene.h"
#include "tests/support/temporary_folder.h"

#include <cmath>
#include <cstdio>
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace alltact {
namespace {

using test::TemporaryFolder;
using testing::HasSubstr;

/// Numbers drawn alike on every computer.
class Draws {
 public:
  explicit Draws(unsigned seed) : random_(seed) {}
  double between(double low, double high) {
    return low + (high - low) * (static_cast<double>(random_()) + 0.5) / 4294967296.0;
  }

 private:
  std::mt19937 random_;
};

/// A finger of the simulator with hidden numbers: a small camera over a Fin Ray finger.
TwinScene hidden_finger(unsigned seed) {
  Draws draw(seed);
  TwinScene scene;
  scene.name = "hidden";
  scene.why = "a world to find a twin of";
  scene.camera.width_px = 300, scene.camera.height_px = 240;
  scene.camera.fx_px = scene.camera.fy_px = 260;
  scene.camera.cx_px = 169.5, scene.camera.cy_px = 119.5;
  scene.face.kind = FaceKind::kFinRay;
  scene.face.width_mm = 24, scene.face.layer_mm = 1.5;
  scene.base_mm = {-18, draw.between(-1, 1), draw.between(30, 34)};
  scene.incline_rad = draw.between(0.2, 0.4);
  scene.length_mm = 60;
  scene.rest = {draw.between(-2, 2), draw.between(-2, 2), draw.between(-1, 1)};
  scene.layer.scatter_per_mm = draw.between(0.4, 1.2);
  scene.rolloff = TwinRolloff::kHertz;
  scene.rolloff_mm = draw.between(0.5, 1.2);
  scene.halo = TwinHalo::kGaussian;
  scene.halo_share = draw.between(0.05, 0.1);
  scene.halo_width_mm = draw.between(1.2, 1.8);
  scene.blur_px = draw.between(0.9, 1.6);
  scene.read_sd = draw.between(0.6, 1.2);
  const double power = 1.8e5 / scene.layer.reflectance(1.5);
  scene.lamps = {{{draw.between(-6, 6), draw.between(-5, -2), draw.between(-8, 2)}, 0.55 * power},
                 {{draw.between(-6, 6), draw.between(2, 5), draw.between(-8, 2)}, 0.45 * power}};
  for (const double s : {20.0})
    scene.balls.push_back({"press_" + std::to_string(scene.balls.size()), 4,
                           s + draw.between(-2, 2), draw.between(-3, 3), draw.between(0.7, 1.1), 1,
                           scene.rest});
  return scene;
}

/// Its pictures as files and frames, and its folder.
struct HiddenWorld {
  explicit HiddenWorld(const TwinScene& truth, std::uint64_t seed = 5) : scene(truth) {
    const Plan plan =
        Plan::compile(Scene::parse(truth.to_yaml(true), "hidden").value(), seed).value();
    for (int frame = 0; frame < plan.frame_count(); ++frame) {
      const cv::Mat grey = plan.render(frame);
      if (frame == 0) {
        EXPECT_TRUE(write_image(untouched(), grey).ok());
        continue;
      }
      Frame press;
      press.grey = grey;
      press.name = truth.balls[static_cast<std::size_t>(frame) - 1].press;
      files.presses.frames.push_back(std::make_shared<const Frame>(press));
    }
    files.untouched = {untouched()};
    files.press_set.ball_radius_mm = truth.balls.front().radius_mm;
    finger.name = "hidden";
    finger.camera = truth.camera;
    finger.face = truth.face;
  }
  [[nodiscard]] std::filesystem::path untouched() const { return folder / "untouched.png"; }
  [[nodiscard]] Result<TwinMeasured> measure() const {
    return measure_for_twin(FingerSnapshot::of(folder.path(), finger).value(), files, Job());
  }

  TemporaryFolder folder;
  TwinScene scene;
  Finger finger;
  TwinFiles files;
};

/// A figure is what it is in truth, within four of its standard deviations and a part of itself
/// that the lamps' and the face's misfit may take.
void expect_found(const Twin& twin, const std::string& key, double truth, double part,
                  unsigned seed) {
  for (const TwinFigure& figure : twin.figures) {
    if (figure.key != key) continue;
    ASSERT_TRUE(figure.sd.has_value()) << key << ' ' << seed;
    EXPECT_NEAR(figure.value, truth, 4 * *figure.sd + part * truth) << key << ' ' << seed;
    EXPECT_LT(*figure.sd, 0.5 * truth) << key << ' ' << seed;
    return;
  }
  ADD_FAILURE() << "no figure " << key << " in world " << seed;
}

/// RMS between two float pictures within `reach` pixels of a place, where the first is above 0.
double rms_between(const cv::Mat& a, const cv::Mat& b, Eigen::Vector2d at, double reach) {
  double sum = 0, count = 0;
  for (int v = 0; v < a.rows; ++v)
    for (int u = 0; u < a.cols; ++u) {
      if (std::hypot(u - at.x(), v - at.y()) > reach) continue;
      sum += std::pow(a.at<float>(v, u) - b.at<float>(v, u), 2);
      count += 1;
    }
  return std::sqrt(sum / count);
}

TEST(TwinScene, SaysTheLensThatItHas) {
  TwinScene twin = hidden_finger(3);
  twin.camera.model = CameraModel::kBrown;
  twin.camera.distortion = {-0.12, 0.02, 0.001};
  twin.camera.port = FlatPort{2, 3, 1.5, 1.4};
  const auto scene = Scene::parse(twin.to_yaml(true), "twin.yaml");
  ASSERT_TRUE(scene) << scene.error().sentence();
  const auto plan = Plan::compile(*scene, 1);
  ASSERT_TRUE(plan) << plan.error().sentence();
  EXPECT_EQ(plan->finger().camera, twin.camera);
}

TEST(Twin, OfHiddenFingersIsFound) {
  for (unsigned seed = 1; seed <= 6; ++seed) {
    const HiddenWorld world(hidden_finger(seed));
    const auto measured = world.measure();
    ASSERT_TRUE(measured.ok()) << seed << ' ' << measured.error().sentence();
    for (const Message& reason : measured->left_out) ADD_FAILURE() << reason.english();
    ASSERT_EQ(measured->input.presses.size(), world.scene.balls.size()) << seed;
    const auto twin = fit_twin(measured->input, Job());
    ASSERT_TRUE(twin.ok()) << seed << ' ' << twin.error().sentence();
    const TwinScene& truth = world.scene;
    std::printf(
        "world %2u: scatter %.3f (%.3f), roll-off %.3f (%.3f), halo %.4f (%.4f) %.3f (%.3f), "
        "blur %.3f (%.3f), read %.3f (%.3f), depth %.3f (%.3f), untouched %.2f\n",
        seed, twin->scene.layer.scatter_per_mm, truth.layer.scatter_per_mm, twin->scene.rolloff_mm,
        truth.rolloff_mm, twin->scene.halo_share, truth.halo_share, twin->scene.halo_width_mm,
        truth.halo_width_mm, twin->scene.blur_px, truth.blur_px, twin->scene.read_sd, truth.read_sd,
        twin->scene.balls[0].depth_mm, truth.balls[0].depth_mm, twin->untouched_rms);
    EXPECT_EQ(twin->scene.rolloff, TwinRolloff::kHertz) << seed;
    expect_found(*twin, "scatter_per_mm", truth.layer.scatter_per_mm, 0.05, seed);
    expect_found(*twin, "rolloff length_mm", truth.rolloff_mm, 0.05, seed);
    expect_found(*twin, "bulge share", truth.halo_share, 0.05, seed);
    expect_found(*twin, "bulge width_mm", truth.halo_width_mm, 0.05, seed);
    expect_found(*twin, "blur_px", truth.blur_px, 0.05, seed);
    EXPECT_LT(twin->untouched_rms, 2.0) << seed;
    EXPECT_NEAR(twin->scene.read_sd, truth.read_sd, 0.05) << seed;
    for (std::size_t i = 0; i < truth.balls.size(); ++i) {
      EXPECT_NEAR(twin->scene.balls[i].depth_mm, truth.balls[i].depth_mm, 0.05) << seed;
      EXPECT_NEAR(twin->scene.balls[i].y_mm, truth.balls[i].y_mm, 0.1) << seed;
      const auto real = twin_image(truth, static_cast<int>(i) + 1);
      const auto made = twin_image(twin->scene, static_cast<int>(i) + 1);
      ASSERT_TRUE(real.ok() && made.ok());
      const TwinPress& press = measured->input.presses[i];
      EXPECT_LT(rms_between(*real, *made, press.disc_px, 2 * press.disc_radius_px), 1.0)
          << seed << ' ' << i;
    }
  }
}

}  // namespace
}  // namespace alltact
