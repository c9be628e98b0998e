#include "calibration/lens/board_collector.h"

#include "core/numerics/median.h"

#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>

namespace alltact {
namespace {

using CornerPixels = std::map<std::pair<double, double>, Eigen::Vector2d>;

/// Of the corners in both views, px; infinite where they share too few.
double median_shift_px(const CornerPixels& a, const CornerPixels& b) {
  std::vector<double> shifts;
  for (const auto& [corner, pixel] : b) {
    const auto same = a.find(corner);
    if (same != a.end()) shifts.push_back((same->second - pixel).norm());
  }
  constexpr std::size_t kFewest = 4;
  return shifts.size() < kFewest ? std::numeric_limits<double>::infinity() : upper_median(shifts);
}

/// Keys are numbers along and across; `turned`: as of a board turned by 180 degrees.
CornerPixels corner_pixels(const BoardView& view, const Board& board, bool turned) {
  CornerPixels corners;
  for (std::size_t i = 0; i < view.board_mm.size(); ++i) {
    double column = std::round(view.board_mm[i].x() / board.square_mm);
    double row = std::round(view.board_mm[i].y() / board.square_mm);
    if (turned) {
      column = board.columns - 1 - column;
      row = board.rows - 1 - row;
    }
    corners[{column, row}] = view.pixels[i];
  }
  return corners;
}

/// Many boards look the same turned by 180 degrees, and are found in either orientation.
double corner_shift_px(const BoardView& a, const BoardView& b, const Board& board) {
  const CornerPixels first = corner_pixels(a, board, false);
  return std::min(median_shift_px(first, corner_pixels(b, board, false)),
                  median_shift_px(first, corner_pixels(b, board, true)));
}

}  // namespace

BoardAnalysis BoardCollector::analyse(const FramePtr& frame) {
  BoardAnalysis analysis;
  analysis.frame = frame;
  auto found = find_board(frame->grey, board_);
  if (!found) {
    analysis.no_board_reason = found.error().what;
    last_.reset();
    return analysis;
  }
  const double min_px = kNew_part * frame->grey.cols;
  analysis.is_new = std::all_of(views_.begin(), views_.end(), [&](const BoardView& stored) {
    return corner_shift_px(stored, *found, board_) > min_px;
  });
  analysis.is_still = last_ && corner_shift_px(*last_, *found, board_) <= kStill_px;
  analysis.is_sharp = found->edge_px <= kSharp_px;
  last_ = *found;
  analysis.view = std::move(*found);
  return analysis;
}

void BoardCollector::add(BoardAnalysis analysis) {
  if (!analysis.view) return;
  auto frame = std::make_shared<Frame>(*analysis.frame);
  frame->name = fmt::format("board_{:02}", ++named_);
  frame->jpeg.reset();
  analysis.view->name = frame->name;
  views_.push_back(std::move(*analysis.view));
  frames_.push_back(std::move(frame));
}

void BoardCollector::forget(const std::string& name) {
  const auto is_it = [&](const auto& one) { return one.name == name; };
  std::erase_if(views_, is_it);
  std::erase_if(frames_, [&](const FramePtr& frame) { return is_it(*frame); });
}

BoardCollector::Cells BoardCollector::cells() const {
  Cells cells{};
  for (std::size_t i = 0; i < views_.size(); ++i) {
    const cv::Size size = frames_[i]->grey.size();
    for (const Eigen::Vector2d& pixel : views_[i].pixels) {
      const auto cell = [](double at, int length, int count) {
        return static_cast<std::size_t>(
            std::clamp(static_cast<int>((at + 0.5) / length * count), 0, count - 1));
      };
      ++cells[cell(pixel.y(), size.height, kRows)][cell(pixel.x(), size.width, kColumns)];
    }
  }
  return cells;
}

}  // namespace alltact
