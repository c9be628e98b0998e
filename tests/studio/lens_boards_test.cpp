// A lens measured with a board held before a camera that is made up, its pictures painted.
#include "tests/studio/studio_rig.h"
#include "tests/support/boards.h"
#include "widgets/calibrating/lens_page.h"

#include <QCheckBox>
#include <QListWidget>
#include <QSpinBox>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <opencv2/imgcodecs.hpp>

namespace alltact::test {
namespace {

/// Boards in several poses, each for a second.
std::vector<std::vector<std::uint8_t>> painted_boards(const Board& board) {
  const Camera camera = Camera::create(made::board_lens()).value();
  const made::BoardPainter painter(camera);
  const auto ink = [&](double x, double y) { return made::chessboard_ink(board, x, y); };
  std::mt19937 random(23);
  std::vector<std::vector<std::uint8_t>> packets;
  int poses = 0;
  while (poses < 6) {
    const BoardPose pose = made::random_pose(board, 30, 1.5, random);
    if (!made::seen_by(camera, board, pose, 0, random)) continue;
    ++poses;
    std::vector<std::uint8_t> jpeg;
    cv::imencode(".jpg", painter.paint(pose, ink, static_cast<std::uint64_t>(poses)), jpeg);
    for (int i = 0; i < 30; ++i) packets.push_back(jpeg);
  }
  return packets;
}

TEST(LensBoards, AreTakenByThemselvesAndMeasureTheLens) {
  const Board board = made::chessboard(8, 6, 4);
  FakeOptions made_up;
  made_up.sizes = {{640, 480}};
  made_up.packets = painted_boards(board);
  FakeCamera fake(made_up);
  StudioOptions options;
  options.opener = with_camera(fake);
  options.source = {"camera"};
  Studio studio(options);
  ASSERT_TRUE(studio.wait_for_picture());
  studio.window().go_to("calibrate");
  studio.find<QSpinBox>("Inner corners in a row")->setValue(8);
  studio.find<QSpinBox>("Inner corners in a column")->setValue(6);
  studio.find<QDoubleSpinBox>("Side of a square")->setValue(4);
  auto* by_itself = studio.find<QCheckBox>("Automatically when new and still");
  ASSERT_TRUE(wait_until([&] { return by_itself->isEnabled(); }));
  by_itself->click();
  auto* page = studio.window().findChild<LensPage*>();
  auto* views = page->findChild<QListWidget*>();
  ASSERT_TRUE(wait_until([&] { return views->count() >= 5; }, 40000))
      << "only " << views->count() << " boards were taken";
  ASSERT_TRUE(
      wait_until([&] { return views->item(0)->text().contains(QLatin1String("error 0.")); }, 20000))
      << views->item(0)->text().toStdString();
  by_itself->click();
  studio.click("Measure the lens");
  ASSERT_TRUE(wait_until([&] { return !page->camera_file().empty(); }, 60000)) << studio.problems();
  const auto camera = load_camera(page->camera_file());
  ASSERT_TRUE(camera) << camera.error().sentence();
  EXPECT_NEAR(camera->parameters.fx_px, made::board_lens().fx_px, 12);
  EXPECT_NE(studio.find<QPushButton>("Next: Finger"), nullptr);
  EXPECT_TRUE(studio.find<QPushButton>("Next: Finger")->isEnabled());
}

}  // namespace
}  // namespace alltact::test
