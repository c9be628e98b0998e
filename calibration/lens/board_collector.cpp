#include "calibration/lens/board_collector.h"

#include "core/numerics/median.h"

#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>

namespace alltact {
namespace {

using Places = std::map<std::pair<double, double>, Eigen::Vector2d>;

/// Of the corners that both show, px; infinite where they share too few to tell.
double median_way_px(const Places& a, const Places& b) {
  std::vector<double> ways;
  for (const auto& [place, pixel] : b) {
    const auto same = a.find(place);
    if (same != a.end()) ways.push_back((same->second - pixel).norm());
  }
  constexpr std::size_t kFewest = 4;
  return ways.size() < kFewest ? std::numeric_limits<double>::infinity() : upper_median(ways);
}

/// By their numbers along and across; `turned`: as of a board that is turned by half a circle.
Places places_of(const BoardView& view, const Board& board, bool turned) {
  Places places;
  for (std::size_t i = 0; i < view.board_mm.size(); ++i) {
    double column = std::round(view.board_mm[i].x() / board.square_mm);
    double row = std::round(view.board_mm[i].y() / board.square_mm);
    if (turned) {
      column = board.columns - 1 - column;
      row = board.rows - 1 - row;
    }
    places[{column, row}] = view.pixels[i];
  }
  return places;
}

/// Many boards look the same turned by half a circle, and are found either way.
double corner_way_px(const BoardView& a, const BoardView& b, const Board& board) {
  const Places first = places_of(a, board, false);
  return std::min(median_way_px(first, places_of(b, board, false)),
                  median_way_px(first, places_of(b, board, true)));
}

}  // namespace

BoardLook BoardCollector::look(const FramePtr& frame) {
  BoardLook look;
  look.frame = frame;
  auto found = find_board(frame->grey, board_);
  if (!found) {
    look.why_none = found.error().what;
    last_.reset();
    return look;
  }
  const double least = kNew_part * frame->grey.cols;
  look.is_new = std::all_of(views_.begin(), views_.end(), [&](const BoardView& kept) {
    return corner_way_px(kept, *found, board_) > least;
  });
  look.is_still = last_ && corner_way_px(*last_, *found, board_) <= kStill_px;
  look.is_sharp = found->edge_px <= kSharp_px;
  last_ = *found;
  look.view = std::move(*found);
  return look;
}

void BoardCollector::keep(BoardLook look) {
  if (!look.view) return;
  auto frame = std::make_shared<Frame>(*look.frame);
  frame->name = fmt::format("board_{:02}", ++named_);
  frame->jpeg.reset();
  look.view->name = frame->name;
  views_.push_back(std::move(*look.view));
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
