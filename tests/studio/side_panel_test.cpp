// The panel at the right of Live and Inspect has the width that the user gave it, also next time.
#include "tests/studio/studio_rig.h"

#include <QSettings>
#include <QSplitter>

#include <gtest/gtest.h>

namespace alltact::test {
namespace {

QSplitter& splitter_of(MainWindow& window, const char* page) {
  window.go_to(page);
  QTest::qWait(100);
  for (auto* splitter : window.findChildren<QSplitter*>())
    if (splitter->isVisible()) return *splitter;
  throw std::runtime_error(page);
}

void drag(QSplitter& splitter, int by_px) {
  QWidget* handle = splitter.handle(1);
  const QPoint middle = handle->rect().center();
  QTest::mousePress(handle, Qt::LeftButton, {}, middle);
  QTest::mouseMove(handle, middle + QPoint(by_px, 0));
  QTest::mouseRelease(handle, Qt::LeftButton, {}, middle + QPoint(by_px, 0));
  QTest::qWait(50);
}

class SidePanels : public testing::TestWithParam<const char*> {
 protected:
  SidePanels() { QSettings().remove("panels"); }
  ~SidePanels() override { QSettings().remove("panels"); }
};
INSTANTIATE_TEST_SUITE_P(Page, SidePanels, testing::Values("live", "inspect"));

TEST_P(SidePanels, AreResizedRememberedAndReset) {
  int first_px = 0, wide_px = 0;
  {
    Studio studio(simulated());
    ASSERT_TRUE(studio.wait_for_picture());
    studio.window().resize(1440, 900);
    QSplitter& splitter = splitter_of(studio.window(), GetParam());
    first_px = splitter.sizes().at(1);
    EXPECT_LT(first_px, 400);
    drag(splitter, -150);
    wide_px = splitter.sizes().at(1);
    EXPECT_GT(wide_px, first_px + 100);
    studio.window().resize(1300, 900);
    QTest::qWait(50);
    EXPECT_EQ(splitter.sizes().at(1), wide_px) << "the image takes the change";
    drag(splitter, 1000);
    EXPECT_GE(splitter.sizes().at(1), first_px - 1) << "never narrower than its content";
    drag(splitter, first_px - wide_px);
  }
  Studio again(simulated());
  ASSERT_TRUE(again.wait_for_picture());
  again.window().resize(1440, 900);
  QSplitter& splitter = splitter_of(again.window(), GetParam());
  EXPECT_EQ(splitter.sizes().at(1), wide_px);
  QTest::mouseDClick(splitter.handle(1), Qt::LeftButton);
  QTest::qWait(50);
  EXPECT_EQ(splitter.sizes().at(1), first_px);
}

}  // namespace
}  // namespace alltact::test
