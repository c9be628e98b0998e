// Pictures of every place, for people to look at: below the build's folder, screens/. In each no
// text is cut, nothing lies over another, and no image or plot is blank.
#include "tests/studio/calibrate_rig.h"
#include "tests/studio/layout_rig.h"
#include "tests/studio/measured_finger.h"
#include "tests/support/made_meshes.h"
#include "widgets/pages/accuracy_page.h"

#include <QComboBox>
#include <QPixmap>
#include <QPushButton>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace alltact::test {
namespace {

struct Look {
  const char* name;
  Theme theme;
  const char* language = "en";
};

class Screens : public testing::TestWithParam<Look> {
 protected:
  void save(Studio& studio, const std::string& name) {
    ProgramAppearance appearance;
    appearance.apply({GetParam().theme, QLatin1String(GetParam().language)});
    QTest::qWait(400);
    const QPixmap image = studio.window().grab();
    const std::filesystem::path folder = std::filesystem::path(ALLTACT_SCREENS);
    std::filesystem::create_directories(folder);
    const double ratio = studio.window().devicePixelRatioF();
    const std::string file =
        (folder / (name + "_" + GetParam().name + (ratio > 1 ? "_2x" : "") + ".png")).string();
    ASSERT_TRUE(image.save(QString::fromStdString(file)));
    EXPECT_EQ(image.size(), QSize(1280, 800) * ratio);
    const QWidget& window = studio.window();
    wait_until([&] { return cut_texts(window).empty() && overlaps(window).empty(); }, 1000);
    EXPECT_THAT(cut_texts(window), testing::IsEmpty()) << name;
    EXPECT_THAT(overlaps(window), testing::IsEmpty()) << name;
    EXPECT_THAT(blank_pictures(window), testing::IsEmpty()) << name;
  }
};
/// All in thorough runs. Else one, and the light one at scale 2, where it is asked for by name.
std::vector<Look> looks() {
  if (!is_thorough() && qEnvironmentVariableIsSet("QT_SCALE_FACTOR"))
    return {Look{"light", Theme::kLight}};
  if (!is_thorough()) return {Look{"dark", Theme::kDark}, Look{"chinese", Theme::kLight, "zh_CN"}};
  return {Look{"light", Theme::kLight}, Look{"dark", Theme::kDark},
          Look{"contrast", Theme::kHighContrast}, Look{"german", Theme::kLight, "de"},
          Look{"chinese", Theme::kLight, "zh_CN"}};
}
INSTANTIATE_TEST_SUITE_P(Theme, Screens, testing::ValuesIn(looks()),
                         [](const auto& look) { return look.param.name; });

TEST_P(Screens, Start) {
  Studio studio;
  save(studio, "start");
}

TEST_P(Screens, Live) {
  StudioOptions options;
  options.finger = MadeFingers::get().calibrated();
  options.source = {MadeFingers::get().touched()};
  Studio studio(options);
  ASSERT_TRUE(wait_until([&] {
    const auto& view = studio.session().view();
    return view && view->depth_layer;
  }));
  save(studio, "live");
}

TEST_P(Screens, Record) {
  StudioOptions options;
  options.finger = MadeFingers::get().calibrated();
  options.source = {MadeFingers::get().bending()};
  Studio studio(options);
  ASSERT_TRUE(studio.wait_for_picture());
  studio.window().go_to("record");
  QTest::qWait(1500);
  save(studio, "record");
}

/// On a screen with OpenGL in 3D, else as a height map.
TEST_P(Screens, Inspect) {
  StudioOptions options;
  options.finger = MadeFingers::get().calibrated();
  Studio studio(options);
  studio.window().go_to("inspect");
  auto& place = *studio.window().findChild<InspectPage*>();
  QTest::qWait(300);
  save(studio, "inspect_empty");
  place.open(MadeFingers::get().touched_pictures());
  ASSERT_TRUE(wait_until([&] { return place.inspection().frame() != nullptr; }));
  for (const char* button : {"deepest", "across"})
    place.findChild<QPushButton*>(QLatin1String(button))->click();
  save(studio, "inspect");
  auto* comparison = place.findChild<QComboBox*>(QStringLiteral("comparison"));
  QTest::keyClick(comparison, Qt::Key_Down);
  ASSERT_TRUE(wait_until([&] { return place.inspection().frame()->other.has_value(); }));
  save(studio, "inspect_beside");
  QTest::keyClick(comparison, Qt::Key_Down);
  save(studio, "inspect_difference");
  const TemporaryFolder folder;
  write_stl(folder / "ball.stl", ball(4.0));
  InspectOptions inspected = place.options();
  inspected.with = {OtherMethod::kBody, {}, {}, 0, folder / "ball.stl"};
  place.restore(inspected, place.frame_number());
  ASSERT_TRUE(wait_until([&] { return place.inspection().frame()->body_rms_mm.has_value(); }));
  save(studio, "inspect_body");
}

TEST_P(Screens, Accuracy) {
  const MeasuredFinger& measured = MeasuredFinger::get();
  StudioOptions options;
  options.finger = measured.folder();
  options.source = {MadeFingers::get().touched()};
  Studio studio(options);
  ASSERT_TRUE(studio.wait_for_picture());
  studio.window().go_to("accuracy");
  auto& place = *studio.window().findChild<AccuracyPage*>();
  ASSERT_TRUE(wait_until([&] { return place.run().study() != nullptr; }));
  save(studio, "accuracy");
  place.findChild<QTabWidget*>()->setCurrentIndex(1);
  save(studio, "accuracy_table");
}

TEST_P(Screens, AccuracyFirst) {
  StudioOptions options;
  options.finger = MadeFingers::get().calibrated();
  Studio studio(options);
  studio.window().go_to("accuracy");
  save(studio, "accuracy_first");
}

TEST_P(Screens, CalibrateLens) {
  Studio studio;
  studio.click("Simulated finger");
  ASSERT_TRUE(wait_until([&] { return studio.session().status().finger.finger.has_value(); }));
  studio.window().go_to("calibrate");
  save(studio, "calibrate_lens");
}

TEST_P(Screens, CalibrateFinger) {
  StudioOptions options;
  options.finger = MadeFingers::get().described();
  options.source = {MadeFingers::get().bending()};
  Studio studio(options);
  ASSERT_TRUE(
      wait_until([&] { return studio.session().status().finger.state == FingerState::kReady; }));
  studio.window().go_to("calibrate");  // opens the step that is due
  save(studio, "calibrate_finger");
}

TEST_P(Screens, CalibratePresses) {
  CalibrateStudio rig(6);
  rig.open();
  rig.go_to_step("Presses");
  ASSERT_TRUE(wait_until([&] { return rig.collection().presses().size() == 6; }));
  save(rig.studio(), "calibrate_presses_first");
  rig.collection().set_radius(4);
  ASSERT_TRUE(rig.wait_until_looked_at(6));
  save(rig.studio(), "calibrate_presses");
  auto* list = rig.place().findChild<PressesPage*>()->findChild<QListView*>();
  list->setCurrentIndex(list->model()->index(2, 0));
  auto* editor = rig.place().findChild<OutlineEditor*>();
  const auto place = image_outline(*editor->ball()).value();
  const QPoint hand = editor->transform().to_widget({place.right_u, place.centre.y()}).toPoint();
  rig.collection().leave_out("press_05", "glove in the picture");
  QTest::mousePress(editor, Qt::LeftButton, {}, hand);
  QTest::mouseMove(editor, hand + QPoint(3, 1));
  save(rig.studio(), "calibrate_outline");
  QTest::mouseRelease(editor, Qt::LeftButton, {}, hand + QPoint(3, 1));
}

TEST_P(Screens, CalibrateMappingAndVerdict) {
  CalibrateStudio rig(6);
  rig.open();
  rig.go_to_step("Presses");
  rig.type_radius("4");
  ASSERT_TRUE(rig.wait_until_looked_at(6));
  rig.go_to_step("Mapping");
  save(rig.studio(), "calibrate_mapping_first");
  rig.run().start();
  QTest::qWait(300);
  save(rig.studio(), "calibrate_running");
  ASSERT_TRUE(wait_until([&] { return rig.run().result() != nullptr; }, 60000));
  save(rig.studio(), "calibrate_mapping");
  QTest::keyClick(rig.place().findChild<MappingPage*>()->findChild<PressErrorPlot*>(),
                  Qt::Key_Down);
  save(rig.studio(), "calibrate_mapping_press");
  rig.go_to_step("5");
  save(rig.studio(), "calibrate_verdict");
  rig.go_to_step("6");
  save(rig.studio(), "calibrate_check");
}

TEST_P(Screens, NoSuchSource) {
  StudioOptions options;
  options.source = {"/nowhere/video.mkv"};
  options.finger = "/nowhere/finger";
  Studio studio(options);
  ASSERT_TRUE(wait_until([&] { return !studio.problems().empty(); }));
  save(studio, "problem");
}

}  // namespace
}  // namespace alltact::test
