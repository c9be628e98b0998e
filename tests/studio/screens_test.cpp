// Pictures of every place, for people to look at: below the build's folder, screens/.
#include "tests/studio/studio_rig.h"

#include <QComboBox>
#include <QPixmap>
#include <QPushButton>

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
    Dresser dresser;
    dresser.wear({GetParam().theme, QLatin1String(GetParam().language)});
    QTest::qWait(400);
    const QPixmap picture = studio.window().grab();
    const std::filesystem::path folder = std::filesystem::path(ALLTACT_SCREENS);
    std::filesystem::create_directories(folder);
    const double ratio = studio.window().devicePixelRatioF();
    const std::string file =
        (folder / (name + "_" + GetParam().name + (ratio > 1 ? "_2x" : "") + ".png")).string();
    ASSERT_TRUE(picture.save(QString::fromStdString(file)));
    EXPECT_EQ(picture.size(), QSize(1280, 800) * ratio);
  }
};
INSTANTIATE_TEST_SUITE_P(Theme,
                         Screens,
                         testing::Values(Look{"light", Theme::kLight},
                                         Look{"dark", Theme::kDark},
                                         Look{"contrast", Theme::kHighContrast},
                                         Look{"german", Theme::kLight, "de"}),
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
    return view && !view->depth_layer.empty();
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
  auto& place = *studio.window().findChild<InspectPlace*>();
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
