// Pictures whose content is always the same, compared with those that were looked at and kept in
// tests/studio/baselines. ALLTACT_RENEW_BASELINES=1 keeps what is seen now instead: look at every
// picture that changed before committing it.
#include "tests/gallery/gallery.h"
#include "tests/studio/studio_rig.h"
#include "tests/support/picture_match.h"
#include "tests/support/same_everywhere.h"

#include <QPainter>

#include <gtest/gtest.h>

namespace alltact::test {
namespace {

namespace fs = std::filesystem;

QString text_of(const fs::path& path) { return QString::fromStdString(path.string()); }

void expect_as_kept(const QImage& seen, const std::string& name) {
  const fs::path kept = fs::path(ALLTACT_SOURCE_DIR) / "tests/studio/baselines" / (name + ".png");
  const QImage image = seen.convertToFormat(QImage::Format_RGB888);
  if (qEnvironmentVariableIsSet("ALLTACT_RENEW_BASELINES")) {
    fs::create_directories(kept.parent_path());
    ASSERT_TRUE(image.save(text_of(kept), "PNG", 0));
    GTEST_SKIP() << "kept anew: " << kept.string();
  }
  const QImage expected(text_of(kept));
  ASSERT_FALSE(expected.isNull()) << kept << " is missing";
  const std::string difference = what_differs(image, expected);
  if (difference.empty()) return;
  fs::create_directories(ALLTACT_SCREENS);
  const fs::path now = fs::path(ALLTACT_SCREENS) / (name + "_differs.png");
  image.save(text_of(now));
  ADD_FAILURE() << difference << "; compare " << now << " with " << kept;
}

struct Kept {
  const char* widget;
  QSize size;
  Theme theme = Theme::kLight;
};

class Baseline : public testing::TestWithParam<Kept> {};

INSTANTIATE_TEST_SUITE_P(
    Gallery, Baseline,
    testing::Values(
        Kept{"control_panel", {320, 150}}, Kept{"control_panel", {320, 150}, Theme::kDark},
        Kept{"convergence_plot", {420, 240}}, Kept{"convergence_plot", {420, 240}, Theme::kDark},
        Kept{"coverage_view", {300, 300}}, Kept{"coverage_view", {300, 300}, Theme::kHighContrast},
        Kept{"empty_recording", {900, 600}}, Kept{"empty_recording", {900, 600}, Theme::kDark},
        Kept{"export_dialog", {620, 460}}, Kept{"export_dialog", {620, 460}, Theme::kDark},
        Kept{"gripper_dialog", {560, 190}}, Kept{"image_view", {480, 270}},
        Kept{"mapping_plot", {420, 280}}, Kept{"mapping_plot", {420, 280}, Theme::kDark},
        Kept{"new_finger_dialog", {560, 420}}, Kept{"outline_editor", {480, 270}},
        Kept{"press_error_plot", {420, 200}}, Kept{"problem_list", {480, 160}},
        Kept{"problem_list", {480, 160}, Theme::kDark}, Kept{"second_finger_dialog", {560, 190}},
        Kept{"settings_dialog", {400, 210}}, Kept{"start_panel", {560, 560}},
        Kept{"step_list", {640, 60}}, Kept{"step_list", {640, 60}, Theme::kDark}),
    [](const auto& kept) {
      const std::string name = kept.param.widget;
      return name + (kept.param.theme == Theme::kLight  ? "_light"
                     : kept.param.theme == Theme::kDark ? "_dark"
                                                        : "_contrast");
    });

TEST_P(Baseline, LooksAsItDid) {
  const SameEverywhere same;
  ProgramAppearance appearance;
  appearance.apply({GetParam().theme, QStringLiteral("en")});
  const auto widget = gallery().at(GetParam().widget)();
  widget->setAttribute(Qt::WA_DontShowOnScreen);
  widget->resize(GetParam().size);
  widget->show();
  QTest::qWait(50);
  std::string name = testing::UnitTest::GetInstance()->current_test_info()->name();
  expect_as_kept(widget->grab().toImage(), name.substr(name.find('/') + 1));
}

TEST(Baseline, TheFirstPageLooksAsItDid) {
  const SameEverywhere same;
  Studio studio;
  QTest::qWait(200);
  expect_as_kept(studio.window().grab().toImage(), "window_start");
}

TEST(Baseline, EveryWidgetOfTheGalleryHasOne) {
  std::set<std::string> kept;
  for (const auto& entry : fs::directory_iterator(ALLTACT_SOURCE_DIR "/tests/studio/baselines")) {
    kept.insert(entry.path().stem().string());
    EXPECT_LT(fs::file_size(entry.path()), 100'000U) << entry.path();
  }
  for (const auto& [name, make] : gallery()) EXPECT_EQ(kept.count(name + "_light"), 1U) << name;
}

QImage page(const QString& word, int grey_levels_off = 0) {
  QImage image(320, 200, QImage::Format_RGB888);
  image.fill(QColor(240 - grey_levels_off, 240, 240));
  QPainter painter(&image);
  painter.setFont(QFont(QStringLiteral("DejaVu Sans"), 9));
  painter.drawText(20, 40, word);
  return image;
}

TEST(PictureMatch, SeesAWordAndNoShade) {
  const QImage kept = page(QStringLiteral("Start recording"));
  EXPECT_EQ(what_differs(kept, kept), "");
  EXPECT_EQ(what_differs(page(QStringLiteral("Start recording"), 8), kept), "");
  EXPECT_NE(what_differs(page(QStringLiteral("Stop recording")), kept), "");
  EXPECT_NE(what_differs(page(QString()), kept), "");
  EXPECT_NE(what_differs(kept.copy(0, 0, 319, 200), kept), "");
  QImage moved(kept.size(), kept.format());
  moved.fill(QColor(240, 240, 240));
  QPainter(&moved).drawImage(3, 0, kept);
  EXPECT_NE(what_differs(moved, kept), "");
}

}  // namespace
}  // namespace alltact::test
