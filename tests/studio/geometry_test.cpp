// Every place and every step of Calibrate in every size, language and theme: no text is cut,
// nothing lies over another, pictures take the room, and no half of a page stands empty.
// One theme and a few sizes by default; everything with ALLTACT_SLOW, at three scales of the
// screen, with pictures of all below the build's folder, screens/pages. ALLTACT_RENEW_GALLERY=1
// keeps them, reduced, a sheet a page in tests/gallery/pages: look at them before committing.
// ALLTACT_DRESSES="1024x700 de" looks at those alone whose name has these words.
#include "app/studio/session.h"
#include "core/base/atomic_file.h"
#include "tests/studio/calibrate_rig.h"
#include "tests/studio/layout_rig.h"
#include "tests/studio/measured_finger.h"
#include "tests/support/child_tests.h"
#include "tests/support/same_everywhere.h"
#include "widgets/inspect/finger_pair.h"
#include "widgets/pages/accuracy_page.h"
#include "widgets/shell/export_dialog.h"
#include "widgets/shell/new_finger_dialog.h"
#include "widgets/shell/settings_dialog.h"

#include <QElapsedTimer>
#include <QPainter>
#include <QProcess>
#include <set>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace alltact::test {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

constexpr double kLeastPictured = 0.6, kMostEmpty = 1.0 / 3;
constexpr int kSettling_ms = 40, kPatience_ms = 1200;
constexpr int kSizes = 4;  // on a sheet beside each other
constexpr QSize kTile(320, 200);

struct Dress {
  QSize size;
  const char* language;
  Theme theme = Theme::kLight;
  [[nodiscard]] std::string name() const {
    const char* themes[] = {"", "system", "light", "dark", "contrast"};
    return fmt::format("{}x{} {} {}", size.width(), size.height(), language,
                       themes[static_cast<std::size_t>(theme)]);
  }
};

bool is_slow_run() { return qEnvironmentVariableIsSet("ALLTACT_SLOW"); }

const std::vector<Dress>& dresses() {
  static const std::vector<Dress> all = [] {
    const QSize small(1024, 700), middle(1280, 800), wide(1440, 900), large(1920, 1080);
    if (!is_slow_run())
      return std::vector<Dress>{{small, "en"}, {small, "de"},   {small, "zh_CN"}, {wide, "en"},
                                {wide, "de"},  {wide, "zh_CN"}, {large, "en"}};
    std::vector<Dress> every;
    for (const Theme theme : {Theme::kLight, Theme::kDark, Theme::kHighContrast})
      for (const char* language : {"en", "de", "zh_CN"})
        for (const QSize size : {small, middle, wide, large})
          if (const Dress dress{size, language, theme};
              dress.name().find(qgetenv("ALLTACT_DRESSES").toStdString()) != std::string::npos)
            every.push_back(dress);
    return every;
  }();
  return all;
}

/// What a page is held to beside texts and overlaps.
struct Wanted {
  double pictured = kLeastPictured;
  double empty = kMostEmpty;
};

class Geometry : public testing::Test {
 protected:
  ~Geometry() override { ProgramAppearance().apply({Theme::kLight, QStringLiteral("en")}); }

  void look(Studio& studio, const char* name, const QWidget& page, const Wanted& wanted = {}) {
    std::set<std::string> found;
    double least = 1, most = 0;
    std::string where_least, where_most;
    ProgramAppearance appearance;
    QImage sheet(kSizes * kTile.width(),
                 (static_cast<int>(dresses().size()) + kSizes - 1) / kSizes * kTile.height(),
                 QImage::Format_RGB32);
    sheet.fill(Qt::white);
    for (const Dress& dress : dresses()) {
      appearance.apply({dress.theme, QLatin1String(dress.language)});
      studio.window().resize(dress.size);
      settle(studio.window());
      EXPECT_EQ(studio.window().size(), dress.size) << name << " does not fit, " << dress.name();
      for (const auto& faults :
           {cut_texts(studio.window()), overlaps(studio.window()), blank_pictures(studio.window())})
        for (const std::string& fault : faults)
          if (found.insert(fault).second)
            ADD_FAILURE() << name << ", " << dress.name() << ": " << fault;
      if (const double part = pictured_part(page); part < least) {
        least = part;
        where_least = dress.name();
      }
      if (const double part = empty_part(page); part > most) {
        most = part;
        where_most = dress.name();
      }
      if (is_slow_run()) keep_picture(studio.window(), name, dress, sheet);
    }
    if (is_slow_run()) keep_sheet(name, sheet);
    appearance.apply({Theme::kLight, QStringLiteral("en")});
    QTest::qWait(kSettling_ms);
    std::printf("[ figures  ] %-20s pictured %.2f (%s), empty %.2f (%s)\n", name, least,
                where_least.c_str(), most, where_most.c_str());
    EXPECT_GE(least, wanted.pictured) << name << ", " << where_least;
    EXPECT_LE(most, wanted.empty) << name << ", " << where_most;
  }

  template <class Dialog>
  void look_at_dialog(const char* name, Dialog& dialog) {
    ProgramAppearance appearance;
    for (const char* language : {"en", "de", "zh_CN"}) {
      appearance.apply({Theme::kLight, QLatin1String(language)});
      dialog.show();
      dialog.adjustSize();
      settle(dialog);
      EXPECT_THAT(cut_texts(dialog), IsEmpty()) << name << ", " << language;
      EXPECT_THAT(overlaps(dialog), IsEmpty()) << name << ", " << language;
    }
  }

  static CalibratePage& open_step(CalibrateStudio& rig, const char* step) {
    rig.go_to_step(QLatin1String(step));
    return rig.place();
  }

 private:
  /// Layouts follow with the next turns of the loop, one within the other; what is still cut then
  /// is a fault.
  static void settle(const QWidget& window) {
    QElapsedTimer clock;
    clock.start();
    std::vector<QRect> before, now;
    do {
      before = std::move(now);
      QTest::qWait(kSettling_ms);
      now = places_in(window);
    } while (now != before && clock.elapsed() < kPatience_ms);
    wait_until([&] { return cut_texts(window).empty() && overlaps(window).empty(); }, kPatience_ms);
  }
  static std::vector<QRect> places_in(const QWidget& window) {
    std::vector<QRect> places;
    for (const QWidget* widget : window.findChildren<QWidget*>())
      places.push_back(widget->geometry());
    return places;
  }
  /// Each as it is, and all reduced on one sheet: sizes beside each other, languages and themes
  /// below.
  static void keep_picture(QWidget& window, const char* name, const Dress& dress, QImage& sheet) {
    const QImage image = window.grab().toImage();
    const std::filesystem::path folder = std::filesystem::path(ALLTACT_SCREENS) / "pages";
    std::filesystem::create_directories(folder);
    std::string file = fmt::format("{} {}.png", name, dress.name());
    std::replace(file.begin(), file.end(), ' ', '_');
    ASSERT_TRUE(image.save(QString::fromStdString((folder / file).string())));
    const auto at = static_cast<int>(&dress - dresses().data());
    const QImage tile = image.scaled(kTile, Qt::KeepAspectRatio, Qt::SmoothTransformation);
    QPainter(&sheet).drawImage(QPoint(at % kSizes * kTile.width(), at / kSizes * kTile.height()),
                               tile);
  }
  static void keep_sheet(const char* name, const QImage& sheet) {
    if (!qEnvironmentVariableIsSet("ALLTACT_RENEW_GALLERY") ||
        qEnvironmentVariableIsSet("QT_SCALE_FACTOR"))
      return;
    const std::filesystem::path folder =
        std::filesystem::path(ALLTACT_SOURCE_DIR) / "tests/gallery/pages";
    std::filesystem::create_directories(folder);
    constexpr int kQuality = 70;
    ASSERT_TRUE(sheet.save(QString::fromStdString((folder / (std::string(name) + ".jpg")).string()),
                           "JPG", kQuality));
  }
  const SameEverywhere same_;
};

TEST_F(Geometry, OfTheFirstPage) {
  Studio studio;
  look(studio, "start_first", *studio.window().findChild<LivePage*>(), {0.3, kMostEmpty});
}

TEST_F(Geometry, OfTheFirstPageWithFingers) {
  const TemporaryFolder folder;
  SessionState state;
  state.finger = MadeFingers::get().calibrated();
  state.source = {MadeFingers::get().touched()};
  state.recent_fingers = {MadeFingers::get().calibrated(), MadeFingers::get().described()};
  std::filesystem::create_directories(folder / "session");
  must(write_file_atomically(folder / "session/session.json", session_to_json(state)));
  StudioOptions options;
  options.session_folder = folder / "session";
  Studio studio(options);
  auto* cards = studio.window().findChild<FingerCards*>();
  ASSERT_TRUE(wait_until([&] { return cards->cards().size() == 2; }));
  look(studio, "start", *studio.window().findChild<LivePage*>(), {0, kMostEmpty});
}

TEST_F(Geometry, OfLive) {
  Studio studio(simulated());
  ASSERT_TRUE(wait_until([&] {
    const auto& view = studio.session().view();
    return view && view->depth_layer;
  }));
  look(studio, "live", *studio.window().findChild<LivePage*>());
}

TEST_F(Geometry, OfRecord) {
  StudioOptions options;
  options.finger = MadeFingers::get().calibrated();
  options.source = {MadeFingers::get().bending()};
  Studio studio(options);
  ASSERT_TRUE(studio.wait_for_picture());
  studio.window().go_to("record");
  QTest::qWait(500);
  look(studio, "record", *studio.window().findChild<RecordPage*>());
}

TEST_F(Geometry, OfInspect) {
  StudioOptions options;
  options.finger = MadeFingers::get().calibrated();
  Studio studio(options);
  studio.window().go_to("inspect");
  auto& place = *studio.window().findChild<InspectPage*>();
  place.open(MadeFingers::get().touched_pictures());
  ASSERT_TRUE(wait_until([&] { return place.inspection().frame() != nullptr; }));
  QTest::qWait(300);
  look(studio, "inspect", place);
}

TEST_F(Geometry, OfAccuracy) {
  StudioOptions options;
  options.finger = MeasuredFinger::get().folder();
  Studio studio(options);
  studio.window().go_to("accuracy");
  auto& place = *studio.window().findChild<AccuracyPage*>();
  ASSERT_TRUE(wait_until([&] { return place.run().study() != nullptr; }));
  look(studio, "accuracy", place);
}

TEST_F(Geometry, OfTheFirstSteps) {
  Studio studio;
  studio.click("Simulated finger");
  ASSERT_TRUE(wait_until([&] { return studio.session().status().finger.finger.has_value(); }));
  ASSERT_TRUE(studio.wait_for_picture());
  studio.window().go_to("calibrate");
  auto& place = *studio.window().findChild<CalibratePage*>();
  look(studio, "calibrate_lens", place);
  studio.window().open_finger(MadeFingers::get().described());
  ASSERT_TRUE(
      wait_until([&] { return studio.session().status().finger.state == FingerState::kReady; }));
  place.begin_next_step();
  look(studio, "calibrate_finger", place);
}

TEST_F(Geometry, OfTheStepsWithPresses) {
  CalibrateStudio rig(6);
  rig.open();
  look(rig.studio(), "presses_first", open_step(rig, "Presses"));
  rig.type_radius("4");
  ASSERT_TRUE(rig.wait_until_looked_at(6));
  auto* list = rig.place().findChild<PressesPage*>()->findChild<QListView*>();
  list->setCurrentIndex(list->model()->index(2, 0));
  // What is known of the press stands below its image.
  look(rig.studio(), "presses", rig.place(), {0.48, kMostEmpty});
  ProgramAppearance().apply({Theme::kLight, QStringLiteral("en")});
  look(rig.studio(), "mapping_first", open_step(rig, "4"));
  rig.run().start();
  ASSERT_TRUE(wait_until([&] { return rig.run().result() != nullptr; }, 60000));
  QTest::keyClick(rig.place().findChild<MappingPage*>()->findChild<PressErrorPlot*>(),
                  Qt::Key_Down);
  look(rig.studio(), "mapping", rig.place());
  look(rig.studio(), "verdict", open_step(rig, "5"));
  look(rig.studio(), "check", open_step(rig, "6"));
}

TEST_F(Geometry, OfDialogs) {
  NewFingerDialog finger;
  look_at_dialog("new finger", finger);
  SettingsDialog settings({}, nullptr);
  look_at_dialog("settings", settings);
  ExportDialog exported(MadeFingers::get().calibrated());
  look_at_dialog("export", exported);
  GripperDialog gripper("left-07", RigidTransform{});
  look_at_dialog("gripper", gripper);
  SecondFingerDialog second(SecondFinger{"/fingers/right-03", "/recordings/grasp_right.mkv"});
  look_at_dialog("second finger", second);
}

/// The same at other scales of the screen, which a program takes on when it starts.
TEST_F(Geometry, AtOtherScales) {
  if (!is_slow_run()) GTEST_SKIP() << "takes minutes: set ALLTACT_SLOW";
  if (qEnvironmentVariableIsSet("QT_SCALE_FACTOR")) GTEST_SKIP() << "is at another scale";
  for (const char* scale : {"1.5", "2"}) {
    QProcess child;
    QProcessEnvironment environment = environment_of_child_tests();
    environment.insert("QT_SCALE_FACTOR", scale);
    child.setProcessEnvironment(environment);
    child.setProcessChannelMode(QProcess::MergedChannels);
    child.start("/proc/self/exe", {"--gtest_filter=Geometry.*"});
    ASSERT_TRUE(child.waitForFinished(3600000));
    EXPECT_EQ(child.exitCode(), 0) << scale << "\n" << child.readAll().toStdString();
  }
}

/// What the looks above find, in windows that are made for it.
class LayoutFaults : public testing::Test {
 protected:
  LayoutFaults() {
    page_.setAttribute(Qt::WA_DontShowOnScreen);
    page_.resize(800, 400);
  }
  template <class Widget>
  Widget& put(Widget* widget, const QRect& where) {
    widget->setParent(&page_);
    widget->setGeometry(where);
    return *widget;
  }
  void show() {
    page_.show();
    QTest::qWait(20);
  }
  QWidget page_;
};

TEST_F(LayoutFaults, ATextThatFitsIsNone) {
  put(new QLabel("short"), {10, 10, 200, 30});
  put(new QPushButton("press"), {10, 60, 120, 40});
  show();
  EXPECT_THAT(cut_texts(page_), IsEmpty());
  EXPECT_THAT(overlaps(page_), IsEmpty());
}

TEST_F(LayoutFaults, CutTextsAreFound) {
  put(new QLabel("a text that is wider than its label"), {10, 10, 60, 30});
  put(new QPushButton("a text that is wider than its button"), {10, 60, 60, 30});
  auto& wrapped =
      put(new QLabel("a text of several lines that has room for one"), {10, 110, 90, 16});
  wrapped.setWordWrap(true);
  put(new QLineEdit("/a/path/that/is/longer/than/its/field"), {10, 150, 80, 30});
  show();
  EXPECT_THAT(cut_texts(page_), SizeIs(4));
}

TEST_F(LayoutFaults, ATextWithAnEllipsisAndATipIsNone) {
  auto& line = put(new ElidedLabel, {10, 10, 60, 20});
  line.set_text("a text that is wider than its line");
  auto& field = put(new QLineEdit("/a/path/that/is/longer/than/its/field"), {10, 50, 80, 30});
  field.setToolTip(field.text());
  show();
  EXPECT_THAT(cut_texts(page_), IsEmpty());
  line.setToolTip({});
  EXPECT_THAT(cut_texts(page_), SizeIs(1));
}

TEST_F(LayoutFaults, WhatStandsOutOfItsParentIsFound) {
  put(new QLabel("whole, but its parent ends"), {700, 10, 300, 30});
  show();
  ASSERT_THAT(cut_texts(page_), SizeIs(1));
  EXPECT_THAT(cut_texts(page_).front(), HasSubstr("cut off by 200 x 0"));
}

TEST_F(LayoutFaults, OverlapsAreFound) {
  put(new QPushButton("one"), {10, 10, 100, 40});
  put(new QPushButton("two"), {100, 40, 100, 40});
  show();
  ASSERT_THAT(overlaps(page_), SizeIs(1));
  EXPECT_THAT(overlaps(page_).front(), HasSubstr("share 10 x 10 px"));
}

TEST_F(LayoutFaults, TheLargestEmptyRectangleIsFound) {
  put(new QPushButton("one"), {0, 0, 400, 400});
  put(new QPushButton("two"), {400, 0, 400, 200});
  show();
  EXPECT_EQ(largest_empty(page_), QRect(400, 200, 400, 200));
  EXPECT_NEAR(empty_part(page_), 0.25, 1e-12);
  EXPECT_EQ(pictured_part(page_), 0);
}

TEST_F(LayoutFaults, APictureCountsWhereItShowsOne) {
  auto& view = put(new ImageView, {0, 0, 600, 400});
  show();
  EXPECT_NEAR(pictured_part(page_), 0.75, 1e-12);
  EXPECT_EQ(empty_part(page_), 1);
  view.show_image(cv::Mat(40, 60, CV_8UC1, cv::Scalar(90)), {});
  EXPECT_NEAR(empty_part(page_), 0.25, 0.01);
}

}  // namespace
}  // namespace alltact::test
