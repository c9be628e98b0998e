// Boards as different programs print them, painted by own code: corners are found where the camera
// projects them, whatever the layout, the dictionary or the side from which a board is seen.
#include "calibration/lens/board_views.h"
#include "calibration/lens/marker_board.h"
#include "core/numerics/median.h"
#include "tests/support/boards.h"

#include <functional>
#include <map>
#include <random>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <opencv2/aruco.hpp>

namespace alltact {
namespace {

using testing::HasSubstr;

using Ink = std::function<double(double, double)>;

constexpr double kBlack = 25, kWhite = 200, kTable = 60;

/// The cells of a marker with its border, 1 pixel each.
cv::Mat marker_cells(int dictionary, int id, int border_bits) {
  const auto markers = cv::aruco::getPredefinedDictionary(dictionary);
  cv::Mat cells;
  cv::aruco::drawMarker(markers, id, markers->markerSize + 2 * border_bits, cells, border_bits);
  return cells;
}

double ink_of(const cv::Mat& cells, double x_part, double y_part) {
  const int u = std::min(static_cast<int>(x_part * cells.cols), cells.cols - 1);
  const int v = std::min(static_cast<int>(y_part * cells.rows), cells.rows - 1);
  return cells.at<std::uint8_t>(v, u) > 127 ? kWhite : kBlack;
}

/// A ChArUco board, its markers numbered row by row from `first_id`.
Ink charuco_ink(const Board& board, bool first_white, int dictionary, int first_id = 0) {
  const int across = board.columns + 1, down = board.rows + 1;
  std::map<std::pair<int, int>, cv::Mat> markers;
  int id = first_id;
  for (int y = 0; y < down; ++y)
    for (int x = 0; x < across; ++x)
      if (((x + y) % 2 == 0) == first_white) markers[{x, y}] = marker_cells(dictionary, id++, 1);
  return [=](double x_mm, double y_mm) {
    const double x = x_mm / board.square_mm + 1, y = y_mm / board.square_mm + 1;
    if (x < -1 || y < -1 || x > across + 1 || y > down + 1) return kTable;
    if (x < 0 || y < 0 || x >= across || y >= down) return kWhite;
    const int column = static_cast<int>(x), row = static_cast<int>(y);
    const auto marker = markers.find({column, row});
    if (marker == markers.end()) return kBlack;
    const double u = (x - column - 0.5) / board.marker_part + 0.5,
                 v = (y - row - 0.5) / board.marker_part + 0.5;
    return u < 0 || v < 0 || u >= 1 || v >= 1 ? kWhite : ink_of(marker->second, u, v);
  };
}

/// An AprilGrid of Kalibr: numbered from the bottom left, black squares at the corners of its tags,
/// a border of two cells, tags turned by 180 degrees.
Ink kalibr_ink(const Board& board) {
  std::map<std::pair<int, int>, cv::Mat> tags;
  for (int y = 0; y < board.rows; ++y)
    for (int x = 0; x < board.columns; ++x) {
      cv::Mat cells =
          marker_cells(cv::aruco::DICT_APRILTAG_36h11, (board.rows - 1 - y) * board.columns + x, 2);
      cv::rotate(cells, cells, cv::ROTATE_180);
      tags[{x, y}] = cells;
    }
  return [=](double x_mm, double y_mm) {
    const double cell_mm = board.square_mm * (1 + board.tag_spacing),
                 gap_mm = board.square_mm * board.tag_spacing;
    const double x = x_mm + gap_mm, y = y_mm + gap_mm;  // a corner square begins at 0
    const double right = board.columns * cell_mm + gap_mm, bottom = board.rows * cell_mm + gap_mm;
    if (x < -gap_mm || y < -gap_mm || x > right + gap_mm || y > bottom + gap_mm) return kTable;
    if (x < 0 || y < 0 || x >= right || y >= bottom) return kWhite;
    const int column = static_cast<int>(x / cell_mm), row = static_cast<int>(y / cell_mm);
    const double u = (x - column * cell_mm - gap_mm) / board.square_mm,
                 v = (y - row * cell_mm - gap_mm) / board.square_mm;
    if (u < 0 && v < 0) return kBlack;
    const auto tag = tags.find({column, row});
    return u < 0 || v < 0 || tag == tags.end() ? kWhite : ink_of(tag->second, u, v);
  };
}

Ink asymmetric_ink(const Board& board) {
  return [=](double x_mm, double y_mm) {
    const Eigen::Vector3d far = made::far_corner_mm(board);
    const double border = 2 * board.square_mm;
    if (x_mm < -border || y_mm < -border || x_mm > far.x() + border || y_mm > far.y() + border)
      return kTable;
    const double row = std::round(y_mm / board.square_mm);
    const double shift = std::fmod(row, 2);
    const double column = std::round((x_mm / board.square_mm - shift) / 2);
    if (row < 0 || row >= board.rows || column < 0 || column >= board.columns) return kWhite;
    const double x = (2 * column + shift) * board.square_mm, y = row * board.square_mm;
    if (std::hypot(x_mm - x, y_mm - y) < 0.35 * board.square_mm) return kBlack;
    return kWhite;
  };
}

Board board_of(BoardPattern pattern, int columns, int rows, double square_mm = 4) {
  Board board = made::chessboard(columns, rows, square_mm);
  board.pattern = pattern;
  return board;
}

/// Frames of a board in other poses.
class Frames : public Source {
 public:
  Frames(const Board& board, const Ink& ink, int count, int seed = 5) {
    const Camera camera = Camera::create(made::board_lens()).value();
    const made::BoardPainter painter(camera);
    std::mt19937 random(seed);
    scene_ = made::board_scene(camera, board, count, 35, 0, random);
    for (std::size_t i = 0; i < scene_.poses.size(); ++i) {
      auto frame = std::make_shared<Frame>();
      frame->grey = painter.paint(scene_.poses[i], ink, 50 + i);
      frame->name = scene_.views[i].name;
      frames_.push_back(std::move(frame));
    }
  }

  template <class Change>
  void change(const Change& change) {
    for (auto& frame : frames_) change(frame->grey);
  }

  Result<FramePtr> next() override {
    return at_ < frames_.size() ? FramePtr(frames_[at_++]) : FramePtr();
  }
  [[nodiscard]] std::optional<std::size_t> count() const override { return frames_.size(); }
  [[nodiscard]] bool is_continuous() const override { return false; }
  [[nodiscard]] const made::BoardScene& scene() const { return scene_; }

 private:
  made::BoardScene scene_;
  std::vector<std::shared_ptr<Frame>> frames_;
  std::size_t at_ = 0;
};

/// Median distance of the found corners to those that the camera projects, px.
double corner_error_px(const LensViews& found, const made::BoardScene& scene, bool is_mirrored) {
  const Camera camera = Camera::create(made::board_lens()).value();
  std::vector<double> errors;
  for (const BoardView& view : found.views) {
    const auto scene_view =
        std::find_if(scene.views.begin(), scene.views.end(),
                     [&](const BoardView& other) { return other.name == view.name; });
    const BoardPose& pose = scene.poses[static_cast<std::size_t>(scene_view - scene.views.begin())];
    for (std::size_t i = 0; i < view.pixels.size(); ++i) {
      Eigen::Vector2d expected = camera.project(pose(view.board_mm[i])).value();
      if (is_mirrored) expected.x() = 639 - expected.x();
      errors.push_back((view.pixels[i] - expected).norm());
    }
  }
  return upper_median(errors);
}

LensViews found_in(Frames& frames, const Board& board, double within_px, double min_part = 0.75,
                   bool is_mirrored = false) {
  auto found = find_boards(frames, board, Orientation::kNone, {});
  EXPECT_TRUE(found) << (found ? "" : found.error().sentence());
  if (!found) return {};
  std::size_t corners = 0;
  for (const BoardView& view : found->views) corners += view.pixels.size();
  EXPECT_GE(static_cast<double>(corners),
            min_part * static_cast<double>(frames.scene().poses.size()) * board.point_count());
  EXPECT_LT(corner_error_px(*found, frames.scene(), is_mirrored), within_px);
  return std::move(*found);
}

std::string all_of(const std::vector<Message>& messages) {
  std::string text;
  for (const Message& message : messages) text += message.english() + "; ";
  return text;
}

constexpr double kCharucoPx = 0.12;  // short edges between markers

TEST(OtherBoards, BothCharucoLayoutsInAllParities) {
  for (const auto& [columns, rows] : {std::pair{8, 5}, {7, 5}, {8, 6}, {7, 6}, {5, 3}})
    for (const bool first_white : {false, true}) {
      SCOPED_TRACE(fmt::format("{} x {}, first white: {}", columns, rows, first_white));
      const Board board = board_of(BoardPattern::kCharuco, columns, rows);
      Frames frames(board, charuco_ink(board, first_white, cv::aruco::DICT_4X4_250), 3);
      const LensViews found = found_in(frames, board, kCharucoPx);
      ASSERT_TRUE(found.board.print);
      EXPECT_EQ(found.board.print->first_white, first_white);
      const std::string remarks = all_of(print_remarks(found.board));
      const bool has_two_layouts = rows % 2 == 1;
      if (first_white) {
        EXPECT_THAT(remarks, HasSubstr(has_two_layouts ? "before 4.6" : "is white"));
      } else {
        EXPECT_EQ(remarks.find("4.6") != std::string::npos, has_two_layouts) << remarks;
      }
    }
}

TEST(OtherBoards, EveryDictionaryIsFoundAndNamed) {
  const Board board = board_of(BoardPattern::kCharuco, 6, 4);
  for (const auto& [number, family] :
       {std::pair{cv::aruco::DICT_4X4_50, MarkerDictionary::k4x4},
        {cv::aruco::DICT_4X4_1000, MarkerDictionary::k4x4},
        {cv::aruco::DICT_5X5_100, MarkerDictionary::k5x5},
        {cv::aruco::DICT_6X6_250, MarkerDictionary::k6x6},
        {cv::aruco::DICT_7X7_1000, MarkerDictionary::k7x7},
        {cv::aruco::DICT_ARUCO_ORIGINAL, MarkerDictionary::kOriginal},
        {cv::aruco::DICT_APRILTAG_16h5, MarkerDictionary::kApril16h5},
        {cv::aruco::DICT_APRILTAG_25h9, MarkerDictionary::kApril25h9},
        {cv::aruco::DICT_APRILTAG_36h10, MarkerDictionary::kApril36h10},
        {cv::aruco::DICT_APRILTAG_36h11, MarkerDictionary::kApril36h11}}) {
    SCOPED_TRACE(to_string(family));
    Frames frames(board, charuco_ink(board, false, number), 2);
    const LensViews found = found_in(frames, board, kCharucoPx);
    ASSERT_TRUE(found.board.print);
    EXPECT_EQ(found.board.print->dictionary, family);
    if (family != MarkerDictionary::k4x4) {
      EXPECT_THAT(all_of(print_remarks(found.board)), HasSubstr(to_string(family)));
    }
  }
}

TEST(OtherBoards, AGivenDictionaryThatTheImagesContradictIsRefused) {
  Board board = board_of(BoardPattern::kCharuco, 6, 4);
  Frames frames(board, charuco_ink(board, false, cv::aruco::DICT_5X5_250), 2);
  board.dictionary = MarkerDictionary::k6x6;
  const auto found = find_boards(frames, board, Orientation::kNone, {});
  ASSERT_FALSE(found);
  EXPECT_THAT(found.error().what.english(), HasSubstr("dictionary 5x5, not 6x6"));
  EXPECT_THAT(found.error().advice.english(), HasSubstr("--dictionary 5x5"));
}

TEST(OtherBoards, MarkersThatAreNotCountedFromZero) {
  const Board board = board_of(BoardPattern::kCharuco, 7, 5);
  Frames frames(board, charuco_ink(board, true, cv::aruco::DICT_6X6_250, 50), 3);
  const LensViews found = found_in(frames, board, kCharucoPx);
  EXPECT_THAT(all_of(print_remarks(found.board)), HasSubstr("counted from 50"));
}

TEST(OtherBoards, MirroredAndInvertedBoards) {
  const Board board = board_of(BoardPattern::kCharuco, 8, 5);
  Frames mirrored(board, charuco_ink(board, true, cv::aruco::DICT_5X5_100), 3);
  mirrored.change([](cv::Mat& grey) { cv::flip(grey.clone(), grey, 1); });
  const LensViews found = found_in(mirrored, board, kCharucoPx, 0.75, true);
  EXPECT_THAT(all_of(print_remarks(found.board)), HasSubstr("mirrored"));
  Frames inverted(board, charuco_ink(board, false, cv::aruco::DICT_4X4_50), 3);
  inverted.change([](cv::Mat& grey) { grey = 255 - grey; });
  EXPECT_THAT(all_of(print_remarks(found_in(inverted, board, kCharucoPx).board)),
              HasSubstr("exchanged"));
  const Board chessboard = made::chessboard(8, 6, 4);
  Frames squares(
      chessboard, [&](double x, double y) { return made::chessboard_ink(chessboard, x, y); }, 2);
  squares.change([](cv::Mat& grey) { grey = 255 - grey; });
  const auto views = find_boards(squares, chessboard, Orientation::kNone, {});
  ASSERT_TRUE(views);
  EXPECT_EQ(views->views.size(), 2U);
}

TEST(OtherBoards, AsymmetricDots) {
  const Board board = board_of(BoardPattern::kAsymmetricDots, 4, 11, 3);
  Frames frames(board, asymmetric_ink(board), 4);
  found_in(frames, board, 0.3);  // of tilted dots without the correction of perspective
}

TEST(OtherBoards, AprilGridsOfKalibr) {
  const Board board = board_of(BoardPattern::kAprilGrid, 5, 4, 6);
  Frames frames(board, kalibr_ink(board), 4);
  const LensViews found = found_in(frames, board, 0.1, 0.6);
  ASSERT_TRUE(found.board.print);
  EXPECT_TRUE(found.board.print->from_bottom);
  EXPECT_EQ(found.board.print->border_bits, 2);
}

std::string refusal(Frames& frames, const Board& board) {
  const auto found = find_boards(frames, board, Orientation::kNone, {});
  EXPECT_FALSE(found);
  return found ? "" : found.error().sentence();
}

TEST(OtherBoards, AnotherSizeIsNamed) {
  const Board chessboard = made::chessboard(9, 6, 4);
  const Ink squares = [&](double x, double y) { return made::chessboard_ink(chessboard, x, y); };
  for (const auto& [columns, rows] : {std::pair{10, 7}, {8, 5}, {8, 6}, {12, 4}}) {
    Frames frames(chessboard, squares, 3);
    EXPECT_THAT(refusal(frames, made::chessboard(columns, rows, 4)),
                HasSubstr(fmt::format("9 x 6 inner corners, not {} x {}", columns, rows)));
  }
  const Board charuco = board_of(BoardPattern::kCharuco, 8, 5);
  for (const auto& [columns, rows] : {std::pair{9, 6}, {5, 8}, {7, 5}}) {
    Frames frames(charuco, charuco_ink(charuco, true, cv::aruco::DICT_4X4_250), 3);
    EXPECT_THAT(refusal(frames, board_of(BoardPattern::kCharuco, columns, rows)),
                HasSubstr(fmt::format("8 x 5 inner corners, not {} x {}", columns, rows)));
  }
  const Board dots = board_of(BoardPattern::kAsymmetricDots, 4, 11, 3);
  Frames swapped(dots, asymmetric_ink(dots), 3);
  EXPECT_THAT(refusal(swapped, board_of(BoardPattern::kAsymmetricDots, 11, 4, 3)),
              HasSubstr("4 x 11 asymmetric dots, not 11 x 4"));
  const Board grid = board_of(BoardPattern::kAprilGrid, 5, 4, 6);
  Frames tags(grid, kalibr_ink(grid), 3);
  EXPECT_THAT(refusal(tags, board_of(BoardPattern::kAprilGrid, 4, 5, 6)),
              HasSubstr("5 x 4 tags, not 4 x 5"));
}

TEST(OtherBoards, AnotherPatternIsNamed) {
  const Board dots = board_of(BoardPattern::kAsymmetricDots, 4, 11, 3);
  Frames asymmetric(dots, asymmetric_ink(dots), 2);
  EXPECT_THAT(refusal(asymmetric, board_of(BoardPattern::kDots, 4, 11, 3)),
              HasSubstr("--pattern asymmetric_dots --board 4x11"));
  const Board chessboard = made::chessboard(8, 6, 4);
  const Ink squares = [&](double x, double y) { return made::chessboard_ink(chessboard, x, y); };
  for (const BoardPattern pattern : {BoardPattern::kDots, BoardPattern::kAprilGrid}) {
    Frames frames(chessboard, squares, 2);
    EXPECT_THAT(refusal(frames, board_of(pattern, 8, 6)),
                HasSubstr("--pattern chessboard --board 8x6"));
  }
  const Board charuco = board_of(BoardPattern::kCharuco, 8, 5);
  Frames markers(charuco, charuco_ink(charuco, true, cv::aruco::DICT_4X4_250), 2);
  EXPECT_THAT(refusal(markers, board_of(BoardPattern::kDots, 8, 5)),
              HasSubstr("--pattern charuco"));
  const Board grid = board_of(BoardPattern::kAprilGrid, 5, 4, 6);
  Frames tags(grid, kalibr_ink(grid), 2);
  EXPECT_THAT(refusal(tags, board_of(BoardPattern::kCharuco, 8, 5)),
              HasSubstr("--pattern aprilgrid"));
}

}  // namespace
}  // namespace alltact
