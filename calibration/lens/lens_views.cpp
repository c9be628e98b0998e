#include "calibration/lens/lens_views.h"

#include <set>

namespace alltact {
namespace {

constexpr std::size_t kLong = 100;  // frames; above, numbered images count as a recording

bool shows_the_same(const BoardView& a, const BoardView& b, cv::Size size) {
  if (a.pixels.size() != b.pixels.size()) return false;
  double sum = 0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i) sum += (a.pixels[i] - b.pixels[i]).norm();
  return sum < 0.03 * std::hypot(size.width, size.height) * static_cast<double>(a.pixels.size());
}

Error none_found(const LensViews& views, const cv::Mat& first, const Board& board) {
  Message what = en::say("no board was found in any of {} pictures", views.analysed);
  if (!views.refused.empty())
    what = en::say("{} (the first: {})", what, views.refused.front().second);
  if (!first.empty())
    if (const std::string other = other_size_found(first, board); !other.empty())
      return {en::say("no board with {} was found, but one with {}", board.words(), other),
              views.refused.empty() ? Where() : views.refused.front().first,
              en::say("--board with {}: inner corners are counted, not squares", other)};
  return {what,
          "",
          en::say("--board and --pattern as the board is, and the whole board in the picture")};
}

}  // namespace

Result<LensViews> find_boards(Source& source,
                              const Board& board,
                              Orientation orientation,
                              const Job& job) {
  const std::size_t count = source.count().value_or(0);
  const bool is_long = source.is_continuous() && count > kLong;
  const std::size_t step = is_long ? (count + kMaxImages - 1) / kMaxImages : 1;
  LensViews views;
  cv::Size raw;
  cv::Mat first;
  std::set<std::string> names;
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
    if (raw.empty()) {
      raw = frame.grey.size();
      first = frame.grey;
    }
    if (frame.grey.size() != raw)
      return Error{
          en::say("is {} x {} px, the pictures before it {} x {}",
                  frame.grey.cols,
                  frame.grey.rows,
                  raw.width,
                  raw.height),
          frame.origin,
          en::say("pictures of one camera in one mode; a lens differs with the picture's size")};
    if (!names.insert(frame.name).second)
      return Error{en::say("another picture is called '{}' as well", frame.name),
                   frame.origin,
                   en::say("giving the pictures different names")};
    ++views.analysed;
    auto view = find_board(frame.grey, board);
    if (!view) {
      views.refused.emplace_back(frame.name, view.error().what);
      continue;
    }
    if (is_long && std::any_of(views.views.begin(), views.views.end(), [&](const BoardView& seen) {
          return shows_the_same(seen, *view, raw);
        })) {
      ++views.repeats;
      continue;
    }
    view->name = frame.name;
    views.views.push_back(std::move(*view));
  }
  if (views.views.empty()) return none_found(views, first, board);
  for (BoardView& view : views.views)
    for (Eigen::Vector2d& pixel : view.pixels) pixel = oriented_pixel(pixel, raw, orientation);
  const bool is_turned =
      orientation == Orientation::kRotate90 || orientation == Orientation::kRotate270;
  views.size = is_turned ? cv::Size(raw.height, raw.width) : raw;
  return views;
}

}  // namespace alltact
