#include "calibration/lens/board_views.h"

#include "core/numerics/median.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

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

/// Keys are positions in hundredths of a square; `turned`: as of a board turned by 180 degrees.
CornerPixels corner_pixels(const BoardView& view, const Board& board, bool turned) {
  double right_mm = 0, bottom_mm = 0;
  for (int i = 0; i < board.point_count(); ++i) {
    right_mm = std::max(right_mm, board.point_mm(i).x());
    bottom_mm = std::max(bottom_mm, board.point_mm(i).y());
  }
  const auto key = [&](double mm) { return std::round(100 * mm / board.square_mm); };
  CornerPixels corners;
  for (std::size_t i = 0; i < view.board_mm.size(); ++i) {
    const double x_mm = view.board_mm[i].x(), y_mm = view.board_mm[i].y();
    corners[{key(turned ? right_mm - x_mm : x_mm), key(turned ? bottom_mm - y_mm : y_mm)}] =
        view.pixels[i];
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

Status BoardCollector::recognise(const cv::Mat& grey) {
  if (!board_.has_markers() || board_.print) return {};
  recogniser_.add(grey);
  const auto print = recogniser_.print();
  if (!print) return print.error();
  board_.print = *print;
  return {};
}

BoardAnalysis BoardCollector::analyse(const FramePtr& frame) {
  BoardAnalysis analysis;
  analysis.frame = frame;
  if (const Status recognised = recognise(frame->grey); !recognised) {
    analysis.no_board_reason = recognised.error().what;
    last_.reset();
    return analysis;
  }
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

void BoardCollector::add_corner(const Eigen::Vector2d& pixel, cv::Size size, Cells& cells) {
  const auto cell = [](double at, int length, int count) {
    return static_cast<std::size_t>(
        std::clamp(static_cast<int>((at + 0.5) / length * count), 0, count - 1));
  };
  ++cells[cell(pixel.y(), size.height, kRows)][cell(pixel.x(), size.width, kColumns)];
}

BoardCollector::Cells BoardCollector::cells() const {
  Cells cells{};
  for (std::size_t i = 0; i < views_.size(); ++i)
    for (const Eigen::Vector2d& pixel : views_[i].pixels)
      add_corner(pixel, frames_[i]->grey.size(), cells);
  return cells;
}

namespace {

constexpr std::size_t kLong = 100;  // frames; above, numbered images count as a recording

bool shows_the_same(const BoardView& a, const BoardView& b, cv::Size size) {
  if (a.pixels.size() != b.pixels.size()) return false;
  double sum = 0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i) sum += (a.pixels[i] - b.pixels[i]).norm();
  return sum < 0.03 * std::hypot(size.width, size.height) * static_cast<double>(a.pixels.size());
}

Error none_found(const LensViews& views, const std::vector<cv::Mat>& first, const Board& board) {
  if (auto other = other_board(first, board)) return *other;
  Message what = en::say("no board was found in any of {} images", views.analysed);
  if (!views.refused.empty())
    what = en::say("{} (the first: {})", what, views.refused.front().second);
  return {what, "",
          en::say("--board and --pattern that match the board, and all of it in the image")};
}

}  // namespace

Result<LensViews> find_boards(Source& source, const Board& board, Orientation orientation,
                              const Job& job) {
  const std::size_t count = source.count().value_or(0);
  const bool is_long = source.is_continuous() && count > kLong;
  const std::size_t step = is_long ? (count + kMaxImages - 1) / kMaxImages : 1;
  LensViews views;
  views.board = board;
  cv::Size raw;
  std::vector<cv::Mat> first;  // images, for a diagnosis
  constexpr std::size_t kDiagnosed = 3;
  std::set<std::string> names;
  MarkerPrintRecogniser recogniser(board);
  std::vector<FramePtr> waiting;  // until the print of the markers is certain
  const auto search = [&](const FramePtr& frame) {
    auto view = find_board(frame->grey, views.board);
    if (!view) {
      views.refused.emplace_back(frame->name, view.error().what);
      if (first.size() < kDiagnosed) first.push_back(frame->grey);
      return;
    }
    if (is_long && std::any_of(views.views.begin(), views.views.end(), [&](const BoardView& seen) {
          return shows_the_same(seen, *view, raw);
        })) {
      ++views.repeats;
      return;
    }
    view->name = frame->name;
    views.views.push_back(std::move(*view));
  };
  /// Error: the board contradicts what was given.
  const auto search_waiting = [&]() -> Status {
    if (waiting.empty()) return {};
    if (const auto print = recogniser.print())
      views.board.print = *print;
    else if (!print.error().where.empty())
      return print.error();
    for (const FramePtr& frame : waiting) search(frame);
    waiting.clear();
    return {};
  };
  for (std::size_t index = 0;; ++index) {
    if (job.stop_requested())
      return Error{en::say("stopped while looking for boards; nothing was written"), "", ""};
    const auto next = source.next();
    if (!next) {
      const Error& error = next.error();
      views.refused.emplace_back(error.where, error.what);
      ++views.analysed;
      continue;
    }
    if (!*next) break;
    if (index % step != 0) continue;
    const Frame& frame = **next;
    if (count > 0)
      job.report(0.9 * static_cast<double>(index) / static_cast<double>(count),
                 en::say("looking for the board in {}", frame.name));
    if (raw.empty()) raw = frame.grey.size();
    if (frame.grey.size() != raw)
      return Error{
          en::say("is {} x {} px, the images before it {} x {}", frame.grey.cols, frame.grey.rows,
                  raw.width, raw.height),
          frame.origin,
          en::say("images from one camera in one mode; the lens changes with the image size")};
    if (!names.insert(frame.name).second)
      return Error{en::say("another image is called '{}' as well", frame.name), frame.origin,
                   en::say("giving the images different names")};
    ++views.analysed;
    if (!board.has_markers() || views.board.print) {
      search(*next);
      continue;
    }
    recogniser.add(frame.grey);
    waiting.push_back(*next);
    constexpr std::size_t kMaxWaiting = 40;
    const bool is_recognised = recogniser.is_certain() && recogniser.print();
    if (!is_recognised && waiting.size() < kMaxWaiting) continue;
    if (const Status status = search_waiting(); !status) return status.error();
  }
  if (const Status status = search_waiting(); !status) return status.error();
  if (views.views.empty()) return none_found(views, first, board);
  for (BoardView& view : views.views)
    for (Eigen::Vector2d& pixel : view.pixels) pixel = oriented_pixel(pixel, raw, orientation);
  const bool is_turned =
      orientation == Orientation::kRotate90 || orientation == Orientation::kRotate270;
  views.size = is_turned ? cv::Size(raw.height, raw.width) : raw;
  return views;
}

}  // namespace alltact
