// Boards of a live picture: which frames are worth keeping, on painted boards whose poses are
// known.
#include "calibration/lens/board_views.h"
#include "tests/support/boards.h"

#include <gtest/gtest.h>

namespace alltact {
namespace {

class LiveBoard {
 public:
  LiveBoard()
      : board_(made::chessboard(8, 6, 4)),
        camera_(Camera::create(made::board_lens()).value()),
        painter_(camera_) {}

  /// A frame with the board's middle shifted sideways, seen from 80 mm.
  FramePtr frame(double right_mm, double blur_px = 0) {
    BoardPose pose;
    pose.turn = Eigen::Vector3d::Zero();
    pose.shift_mm = Eigen::Vector3d(right_mm - 14, -10, 80);
    const auto ink = [&](double x, double y) { return made::chessboard_ink(board_, x, y); };
    auto frame = std::make_shared<Frame>();
    frame->grey = painter_.paint(pose, ink, ++seed_);
    if (blur_px > 0) cv::GaussianBlur(frame->grey, frame->grey, {}, blur_px);
    frame->sequence = seed_;
    return frame;
  }
  [[nodiscard]] const Board& board() const { return board_; }

 private:
  Board board_;
  Camera camera_;
  made::BoardPainter painter_;
  std::uint64_t seed_ = 0;
};

TEST(BoardCollector, AsksForABoardThatIsNewStillAndSharp) {
  LiveBoard live;
  BoardCollector collector(live.board());
  BoardAnalysis analysis = collector.analyse(live.frame(0));
  ASSERT_TRUE(analysis.view) << analysis.no_board_reason.english();
  EXPECT_TRUE(analysis.is_new);
  EXPECT_TRUE(analysis.is_sharp);
  EXPECT_FALSE(analysis.is_still) << "nothing tells yet";
  analysis = collector.analyse(live.frame(0.02));
  EXPECT_TRUE(analysis.is_useful());
  collector.add(analysis);
  ASSERT_EQ(collector.views().size(), 1U);
  EXPECT_EQ(collector.views()[0].name, "board_01");
  EXPECT_EQ(collector.frames()[0]->name, "board_01");
  analysis = collector.analyse(live.frame(0.02));
  EXPECT_TRUE(analysis.is_still);
  EXPECT_FALSE(analysis.is_new) << "it is there already";
  analysis = collector.analyse(live.frame(9));
  EXPECT_FALSE(analysis.is_still) << "it moved";
  EXPECT_TRUE(analysis.is_new);
  EXPECT_TRUE(collector.analyse(live.frame(9)).is_useful());
  const BoardAnalysis blurred = collector.analyse(live.frame(9, 3));
  EXPECT_FALSE(blurred.view && blurred.is_sharp);
}

TEST(BoardCollector, SaysWhyThereIsNoneAndForgetsWhatIsLeftOut) {
  LiveBoard live;
  BoardCollector collector(live.board());
  auto empty = std::make_shared<Frame>();
  empty->grey = cv::Mat(480, 640, CV_8UC1, cv::Scalar(90));
  EXPECT_FALSE(collector.analyse(empty).view);
  EXPECT_FALSE(collector.analyse(empty).no_board_reason.empty());
  for (const double right : {-9.0, 0.0, 9.0}) collector.add(collector.analyse(live.frame(right)));
  const auto all = collector.cells();
  int corners = 0;
  for (const auto& row : all)
    for (const int cell : row) corners += cell;
  EXPECT_EQ(corners, 3 * 8 * 6);
  collector.forget("board_02");
  ASSERT_EQ(collector.views().size(), 2U);
  EXPECT_EQ(collector.views()[1].name, "board_03");
  collector.add(collector.analyse(live.frame(0)));
  EXPECT_EQ(collector.views().back().name, "board_04") << "no name twice";
}

}  // namespace
}  // namespace alltact
