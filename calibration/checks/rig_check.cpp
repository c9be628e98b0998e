#include "calibration/checks/rig_check.h"

#include "core/numerics/median.h"

#include <algorithm>
#include <cmath>

namespace alltact {
namespace {

constexpr int kReach_px = 10;  // to either side of an edge
constexpr std::size_t kFewestEdges = 6;
constexpr double kNewShare = 0.2;  // weight of a frame in the smoothed figures
constexpr double kMoved_px = 1.5;  // motion of the finger that ends a watch
constexpr int kStride = 4;         // px: sampling step for brightness
constexpr int kSaturated = 250;

/// Width of one edge, down a column: contrast over the steepest slope.
std::optional<double> width_at(const cv::Mat& grey, double u, double v) {
  const int column = static_cast<int>(std::lround(u)), row = static_cast<int>(std::lround(v));
  if (column < 0 || column >= grey.cols || row - kReach_px < 1 || row + kReach_px >= grey.rows - 1)
    return std::nullopt;
  double low = 255, high = 0, steepest = 0;
  for (int y = row - kReach_px; y <= row + kReach_px; ++y) {
    const auto at = [&](int line) {
      return static_cast<double>(grey.at<std::uint8_t>(line, column));
    };
    low = std::min(low, at(y));
    high = std::max(high, at(y));
    steepest = std::max(steepest, 0.5 * std::abs(at(y + 1) - at(y - 1)));
  }
  constexpr double kMinContrast = 10;
  if (high - low < kMinContrast) return std::nullopt;
  return (high - low) / steepest;
}

void smooth(std::optional<double>& shown, const std::optional<double>& next) {
  if (next && shown)
    *shown += kNewShare * (*next - *shown);
  else
    shown = next;
}

struct Brightness {
  double mean = 0;
  double saturated = 0;  ///< fraction of the pixels
  double bright = 0;     ///< mean of the brightest tenth
};

std::optional<Brightness> face_brightness(const FrameResult& result) {
  if (!result.shape) return std::nullopt;
  std::vector<std::uint8_t> values;
  for (int u = 0; u < result.grey.cols; u += kStride) {
    const auto rows = result.shape->rows(u, 2);
    for (int v = rows.first; v <= rows.last; v += kStride)
      values.push_back(result.grey.at<std::uint8_t>(v, u));
  }
  constexpr std::size_t kFewest = 100;
  if (values.size() < kFewest) return std::nullopt;
  std::sort(values.begin(), values.end());
  const auto mean_from = [&](std::size_t first) {
    double sum = 0;
    for (std::size_t i = first; i < values.size(); ++i) sum += values[i];
    return sum / static_cast<double>(values.size() - first);
  };
  const auto saturated = values.end() - std::lower_bound(values.begin(), values.end(), kSaturated);
  return Brightness{mean_from(0),
                    static_cast<double>(saturated) / static_cast<double>(values.size()),
                    mean_from(values.size() - values.size() / 10)};
}

/// Median displacement of the markers seen in both; 0 where none is.
double shift_px(const Markers& a, const Markers& b) {
  std::vector<double> shifts;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
    if (a[i].seen && b[i].seen) shifts.push_back(std::hypot(a[i].u - b[i].u, a[i].v - b[i].v));
  return shifts.empty() ? 0 : upper_median(shifts);
}

/// The pixel of the face's end at the tip.
Eigen::Vector2d end_of(const FaceShape& shape) {
  const int u = shape.base_at_low_u() ? shape.width_px() - 1 : 0;
  const auto middle = shape.middle_at(u);
  if (!middle) return Eigen::Vector2d::Zero();
  const auto& column = shape.columns()[static_cast<std::size_t>(std::lround(middle->u))];
  return {middle->u, 0.5 * (column.upper_v + column.lower_v)};
}

RigState state_by(bool is_fine, bool is_usable) {
  return is_fine ? RigState::kFine : is_usable ? RigState::kDoubtful : RigState::kBad;
}

Message end_name(RigItem item) {
  return item == RigItem::kFocusTip ? en::say("tip") : en::say("base");
}

}  // namespace

std::optional<double> edge_sharpness_px(const FrameResult& result, bool at_tip) {
  if (!result.edges || !result.shape || result.edges->u.empty()) return std::nullopt;
  const FaceEdges& edges = *result.edges;
  const double first = edges.u.front(), third = (edges.u.back() - first) / 3;
  const bool at_high_u = at_tip == result.shape->base_at_low_u();
  std::vector<double> widths;
  for (std::size_t i = 0; i < edges.u.size(); ++i) {
    const bool is_there = at_high_u ? edges.u[i] > first + 2 * third : edges.u[i] < first + third;
    if (!is_there) continue;
    for (const Edge* edge : {&edges.upper, &edges.lower})
      if (edge->valid[i] != 0)
        if (const auto width = width_at(result.grey, edges.u[i], edge->v[i]))
          widths.push_back(*width);
  }
  if (widths.size() < kFewestEdges) return std::nullopt;
  return upper_median(widths);
}

void RigCheck::add(const FrameResult& result, double time_s) {
  has_frame_ = true;
  smooth(base_px_, edge_sharpness_px(result, false));
  smooth(tip_px_, edge_sharpness_px(result, true));
  seen_dots_ = static_cast<int>(result.dots.size());
  if (result.markers)
    seen_dots_ = static_cast<int>(std::count_if(result.markers->begin(), result.markers->end(),
                                                [](const Marker& one) { return one.seen; }));
  watch_lamp(result, time_s);
}

void RigCheck::watch_lamp(const FrameResult& result, double time_s) {
  const auto light = face_brightness(result);
  has_face_ = light.has_value();
  if (!light) return lights_.clear();
  saturated_ += kNewShare * (light->saturated - saturated_);
  bright_ = light->bright;
  const Markers markers = result.markers.value_or(Markers());
  const Eigen::Vector2d end = end_of(*result.shape);
  const bool has_moved = shift_px(markers, last_markers_) > kMoved_px ||
                         (last_end_ && (end - *last_end_).norm() > 2 * kMoved_px);
  if (lights_.empty() || has_moved) {
    lights_.clear();
    last_markers_ = markers;
    last_end_ = end;
  }
  lights_.push_back({time_s, light->mean});
  while (lights_.front().time_s < time_s - kLamp_s) lights_.pop_front();
}

double RigCheck::lamp_part() const {
  if (lights_.empty()) return 0;
  // Frames are a little apart, so that the oldest one is never quite kLamp_s old.
  constexpr double kNearly = 0.98;
  return std::min(1.0, (lights_.back().time_s - lights_.front().time_s) / (kNearly * kLamp_s));
}

std::vector<RigFinding> RigCheck::findings(int expected_dots) const {
  return {focus(RigItem::kFocusBase, base_px_), focus(RigItem::kFocusTip, tip_px_), brightness(),
          lamp(), dots(expected_dots)};
}

RigFinding RigCheck::focus(RigItem item, const std::optional<double>& width_px) const {
  RigFinding found;
  found.item = item;
  if (!width_px) {
    found.sentence = en::say("the edges at the {} are not visible", end_name(item));
    if (has_frame_) {
      found.state = RigState::kBad;
      found.advice = en::say("bring the entire face into the image, lit, with dark next to it");
    }
    return found;
  }
  found.sentence = en::say("edges at the {} are {:.1f} px wide", end_name(item), *width_px);
  found.state = state_by(*width_px <= kSharp_px, *width_px <= kBlurred_px);
  if (found.state != RigState::kFine)
    found.advice = en::say("turn the lens until the {} is sharp, and let the other end stay so",
                           end_name(item));
  return found;
}

RigFinding RigCheck::brightness() const {
  RigFinding found;
  found.item = RigItem::kBrightness;
  found.sentence = en::say("no face is visible");
  if (!has_face_) return found;
  if (saturated_ > kFewSaturated) {
    found.state = state_by(false, saturated_ <= kManySaturated);
    found.sentence = en::say("{:.1f} % of the face is too bright to measure", 100 * saturated_);
    found.advice = en::say("dim the lamp, or shorten the exposure");
    return found;
  }
  found.sentence = en::say("the face has brightness {:.0f} of 255, nothing is too bright", bright_);
  found.state = state_by(bright_ >= kDark, bright_ >= kTooDark);
  if (found.state != RigState::kFine)
    found.advice = en::say("turn the lamp up, or lengthen the exposure");
  return found;
}

RigFinding RigCheck::lamp() const {
  RigFinding found;
  found.item = RigItem::kLamp;
  const double part = lamp_part();
  if (part < 1) {
    found.sentence = has_face_ ? en::say("hold the finger still: {:.0f} of {:.0f} s",
                                         std::floor(part * kLamp_s), kLamp_s)
                               : en::say("no face is visible");
    return found;
  }
  const auto [darkest, brightest] =
      std::minmax_element(lights_.begin(), lights_.end(),
                          [](const Light& a, const Light& b) { return a.mean < b.mean; });
  const double change = (brightest->mean - darkest->mean) / brightest->mean;
  found.sentence = en::say("brightness changes by {:.1f} % in {:.0f} s", 100 * change, kLamp_s);
  found.state = state_by(change <= kSteady, change <= kUnsteady);
  if (found.state != RigState::kFine)
    found.advice = en::say(
        "let the lamp warm up for ten minutes, shade the finger from the room's light, and "
        "lock the brightness");
  return found;
}

RigFinding RigCheck::dots(int expected) const {
  RigFinding found;
  found.item = RigItem::kDots;
  if (!has_frame_) {
    found.sentence = en::say("no image yet");
    return found;
  }
  if (expected == 0) {
    found.sentence = en::say("{} dots are found", seen_dots_);
    found.state = RigState::kFine;
    return found;
  }
  found.sentence = en::say("{} of {} dots are found", seen_dots_, expected);
  found.state = state_by(seen_dots_ == expected, 2 * seen_dots_ >= expected);
  if (found.state != RigState::kFine)
    found.advice = en::say(
        "light the dots evenly, keep both rows in the image, and check how many the finger has");
  return found;
}

}  // namespace alltact
