#include "calibration/presses/guided_presses.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace alltact {

std::optional<PressTaker::Taken> PressTaker::request(double time_s) {
  if (is_enough()) return take(alike_);
  if (state_ != State::kWaits) {
    requested_s_ = time_s;
    contact_.begin();
  }
  state_ = State::kWaits;
  return std::nullopt;
}

std::optional<PressTaker::Taken> PressTaker::see(const FramePtr& frame,
                                                 const std::optional<DarkPatch>& contact,
                                                 double time_s) {
  if (!frame || frame == newest_) return std::nullopt;
  const bool goes_on =
      newest_ && frame->origin == newest_->origin && frame->sequence > newest_->sequence;
  if (!goes_on) held_.clear();  // another source, or the same from its beginning
  held_.add(frame);
  newest_ = frame;
  const auto before = std::exchange(alike_, held_.alike());
  if (state_ != State::kWaits) return std::nullopt;
  if (is_enough()) return take(alike_);
  const bool has_ended = alike_.size() < before.size();
  if (has_ended && before.size() >= kFewest) return take(before);
  if (contact_.add(contact, time_s)) return take(alike_);
  if (time_s - requested_s_ >= kTimeout_s) state_ = State::kRefused;
  return std::nullopt;
}

std::optional<PressTaker::Taken> PressTaker::end() {
  if (state_ != State::kWaits || alike_.empty()) return std::nullopt;
  return take(alike_);
}

void PressTaker::forget() { *this = PressTaker(); }

double PressTaker::held_part() const {
  // The first frame always equals itself.
  const double burst = alike_.size() < 2 ? 0.0 : static_cast<double>(alike_.size()) / kBurst;
  return std::min(1.0, burst);
}

bool PressTaker::is_enough() const {
  if (alike_.size() < kFewest) return false;
  const double span_s =
      time_s(*alike_.back()).value_or(0.0) - time_s(*alike_.front()).value_or(0.0);
  return alike_.size() >= kBurst || span_s >= kHeld_s;
}

PressTaker::Taken PressTaker::take(const std::vector<FramePtr>& frames) {
  state_ = State::kIdle;
  return {mean_frame(frames), frames.size()};
}

namespace {

constexpr double kAcross = 1.0 / 7;  // of the face's width, to either side
constexpr double kEnough = 0.85, kTooDeep = 1.4, kMaxOfLayer = 0.8;

struct Planned {
  double along, across, depth;  // fractions of the seen length, of kAcross, of the layer
};
constexpr std::array<Planned, 6> kPlan{{{0.50, 1, 0.55},
                                        {0.20, -1, 0.55},
                                        {0.80, 1, 0.40},
                                        {0.50, -1, 0.70},
                                        {0.20, 1, 0.40},
                                        {0.80, -1, 0.70}}};

/// First and last column that show the face.
std::optional<std::pair<int, int>> seen_columns(const FaceShape& shape) {
  const auto& columns = shape.columns();
  const auto is_valid = [](const FaceColumn& column) { return column.valid; };
  const auto first = std::find_if(columns.begin(), columns.end(), is_valid);
  if (first == columns.end()) return std::nullopt;
  const auto last = std::find_if(columns.rbegin(), columns.rend(), is_valid);
  return std::pair(static_cast<int>(first - columns.begin()),
                   static_cast<int>(columns.rend() - last) - 1);
}

double width_mm(const FaceShape& shape, int u) {
  const auto rows = shape.rows(u, 0);
  if (rows.first > rows.last) return 0;
  return std::abs(shape.position_mm(u, rows.last).y() - shape.position_mm(u, rows.first).y());
}

/// Solves a monotonic function between `from` and `to` for a value, by bisection; the nearest end
/// where there is no solution.
template <class Function>
double solve_monotonic(double value, double from, double to, const Function& function) {
  if (function(from) > function(to)) std::swap(from, to);
  for (int i = 0; i < 40; ++i) {
    const double middle = 0.5 * (from + to);
    (function(middle) < value ? from : to) = middle;
  }
  return 0.5 * (from + to);
}

}  // namespace

std::vector<PressTarget> first_presses(const FaceShape& shape) {
  const auto seen = seen_columns(shape);
  if (!seen) return {};
  const double a = shape.length_at(seen->first), b = shape.length_at(seen->second);
  const double from = std::min(a, b), length = std::abs(b - a);
  const double width = width_mm(shape, (seen->first + seen->second) / 2);
  std::vector<PressTarget> targets;
  for (const Planned& one : kPlan)
    targets.push_back({{from + one.along * length, one.across * kAcross * width},
                       one.depth * shape.face().layer_mm});
  return targets;
}

std::optional<PressTarget> next_press(const std::vector<PressTarget>& targets,
                                      const std::vector<Eigen::Vector2d>& made_mm) {
  std::vector<bool> is_made(targets.size(), false);
  for (const Eigen::Vector2d& made : made_mm) {
    const auto nearest = std::min_element(
        targets.begin(), targets.end(), [&](const PressTarget& a, const PressTarget& b) {
          return (a.position_mm - made).squaredNorm() < (b.position_mm - made).squaredNorm();
        });
    if (nearest != targets.end())
      is_made[static_cast<std::size_t>(nearest - targets.begin())] = true;
  }
  const auto next = std::find(is_made.begin(), is_made.end(), false);
  if (next == is_made.end()) return std::nullopt;
  return targets[static_cast<std::size_t>(next - is_made.begin())];
}

std::optional<Eigen::Vector2d> pixel_of_position(const FaceShape& shape,
                                                 const Eigen::Vector2d& position_mm) {
  const auto seen = seen_columns(shape);
  if (!seen) return std::nullopt;
  const double u = solve_monotonic(position_mm.x(), seen->first, seen->second,
                                   [&](double column) { return shape.length_at(column); });
  const auto rows = shape.rows(static_cast<int>(std::lround(u)), 0);
  if (rows.first > rows.last) return std::nullopt;
  const double v = solve_monotonic(position_mm.y(), rows.first, rows.last,
                                   [&](double row) { return shape.position_mm(u, row).y(); });
  return Eigen::Vector2d(u, v);
}

PressProgress press_progress(double depth_mm, double target_mm, double layer_mm) {
  if (depth_mm > std::min(kTooDeep * target_mm, kMaxOfLayer * layer_mm) &&
      depth_mm > kEnough * target_mm)
    return PressProgress::kTooDeep;
  return depth_mm >= kEnough * target_mm ? PressProgress::kEnough : PressProgress::kDeeper;
}

}  // namespace alltact
