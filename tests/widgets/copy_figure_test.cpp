// Images and plots are copied as images: by Ctrl+C, and by the menu that the views open.
#include "widgets/copy_figure.h"

#include "widgets/image/image_view.h"
#include "widgets/image/overlays.h"
#include "widgets/plots/calibration_plots.h"

#include <QApplication>
#include <QClipboard>
#include <QContextMenuEvent>
#include <QMenu>
#include <QTest>

#include <gtest/gtest.h>

namespace alltact {
namespace {

QImage copied() { return QApplication::clipboard()->image(); }

class Copied : public testing::Test {
 protected:
  Copied() { QApplication::clipboard()->clear(); }
  static bool opens_menu(QWidget& widget, QContextMenuEvent::Reason reason) {
    QContextMenuEvent event(reason, {5, 5}, widget.mapToGlobal(QPoint(5, 5)));
    QApplication::sendEvent(&widget, &event);
    const auto menus = widget.findChildren<QMenu*>();
    for (QMenu* menu : menus) menu->close();
    return !menus.isEmpty();
  }
};

TEST_F(Copied, ImageHasItsSizeAndItsColourBar) {
  ImageView view;
  view.resize(300, 200);
  view.show();
  QTest::keyClick(&view, Qt::Key_C, Qt::ControlModifier);
  EXPECT_TRUE(copied().isNull()) << "there is no image yet";
  view.show_image(cv::Mat(400, 640, CV_8UC1, cv::Scalar(90)), {});
  QTest::keyClick(&view, Qt::Key_C, Qt::ControlModifier);
  const QImage bare = copied();
  EXPECT_EQ(bare.size(), QSize(640, 400));
  EXPECT_EQ(bare.pixelColor(5, 5), QColor(90, 90, 90));
  view.show_image(view.image(), {colour_bar_overlay(depth_scale(1), "Depth, mm")});
  QTest::keyClick(&view, Qt::Key_C, Qt::ControlModifier);
  EXPECT_EQ(copied().size(), bare.size());
  EXPECT_NE(copied(), bare);
}

TEST_F(Copied, PlotIsAsShownAndTwiceAsSharp) {
  ContrastPlot plot;
  plot.set_data({1, 0.8, 0.5, 0.2, 0.1});
  plot.resize(300, 240);
  plot.show();
  QTest::qWait(30);
  QTest::keyClick(&plot, Qt::Key_C, Qt::ControlModifier);
  EXPECT_EQ(copied().size(), QSize(600, 480));
}

TEST_F(Copied, FromTheMenuOfTheView) {
  ImageView view;
  view.show_image(cv::Mat(40, 60, CV_8UC1, cv::Scalar(90)), {});
  view.show();
  QContextMenuEvent event(QContextMenuEvent::Mouse, {5, 5}, view.mapToGlobal(QPoint(5, 5)));
  QApplication::sendEvent(&view, &event);
  auto* menu = view.findChild<QMenu*>();
  ASSERT_NE(menu, nullptr);
  ASSERT_EQ(menu->actions().size(), 1);
  menu->actions().front()->trigger();
  EXPECT_EQ(copied().size(), QSize(60, 40));
}

TEST_F(Copied, MenuLeavesTheRightButtonToViewsThatUseIt) {
  ImageView both, keys(nullptr, CopyFigure::Menu::kByKeysOnly);
  for (ImageView* view : {&both, &keys}) {
    view->show();
    EXPECT_TRUE(opens_menu(*view, QContextMenuEvent::Keyboard));
    QTest::qWait(30);
  }
  EXPECT_TRUE(opens_menu(both, QContextMenuEvent::Mouse));
  EXPECT_FALSE(opens_menu(keys, QContextMenuEvent::Mouse));
}

}  // namespace
}  // namespace alltact
