// A flat, rigid sensor in the place Calibrate: one untouched picture instead of a recording.
#include "core/finger/finger_store.h"
#include "core/finger/mapping.h"
#include "tests/studio/calibrate_rig.h"
#include "tests/support/flat_sensor.h"

#include <gtest/gtest.h>

namespace alltact::test {
namespace {

namespace fs = std::filesystem;

TEST(CalibrateFlat, TakesItsUntouchedPictureFromTheLiveOne) {
  const TemporaryFolder folder;
  const std::vector<fs::path> presses = write_flat_sensor(folder.path());
  NewFinger sensor;
  sensor.finger = folder / "sensor";
  sensor.camera = folder / "camera.yaml";
  sensor.kind = FaceKind::kFlat;
  sensor.layer_mm = FlatSensor::kLayerMm;
  ASSERT_TRUE(make_finger(sensor).ok());
  fs::create_directories(folder / "untouched");
  fs::copy(folder / "ref.png", folder / "untouched/ref.png");
  StudioOptions options;
  options.finger = sensor.finger;
  options.source = {folder / "untouched"};
  Studio studio(options);
  ASSERT_TRUE(studio.wait_for_picture());
  studio.window().go_to("calibrate");
  auto* place = studio.window().findChild<CalibratePage*>();
  EXPECT_FALSE(studio.find<QPushButton>("Next: Presses")->isEnabled());
  studio.click("Take the untouched image now");
  ASSERT_TRUE(wait_until([&] { return studio.session().status().finger.has_reference; }, 20000))
      << studio.problems();
  studio.click("Next: Presses");
  ASSERT_TRUE(wait_until([&] { return place->collection().is_ready(); }));
  place->collection().set_radius(FlatSensor::kBallRadiusMm);
  // The last ones while the first are being read.
  place->collection().add_files({presses[0], presses[1]});
  place->collection().add_files({presses[2], presses[3]});
  ASSERT_TRUE(wait_until([&] { return place->collection().usable_count() == 4; }, 20000));
  studio.click("Next: Mapping");  // calibrates
  ASSERT_TRUE(wait_until([&] { return place->run().result() != nullptr; }, 60000))
      << studio.problems();
  const Mapping mapping = Mapping::create(place->run().result()->calibration.mapping).value();
  for (double x = 0.05; x < 0.9 * mapping.x_max(); x += 0.05)
    EXPECT_NEAR(mapping.depth_mm(x), FlatSensor::kA * x / (1 + FlatSensor::kB * x), 0.04) << x;
}

}  // namespace
}  // namespace alltact::test
