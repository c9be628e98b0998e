// What somebody says of presses: made with which ball, and, by their names, what single ones were
// made with, how deep they are, which not to use.
#pragma once

#include "calibration/presses/placed_ball.h"
#include "calibration/presses/press.h"
#include "core/result.h"

#include <algorithm>
#include <set>
#include <string>
#include <vector>

namespace alltact {

/// A press that is kept but not used.
struct ExcludedPress {
  std::string name;
  std::string because;  ///< empty: not told
  bool operator==(const ExcludedPress&) const = default;
};

/// A press that was made with a ball of another size.
struct OtherBall {
  std::string name;
  double radius_mm = 0;
  bool operator==(const OtherBall&) const = default;
};

/// A press whose depth a stage or a feeler gauge tells.
struct PressDepth {
  std::string name;
  ToldDepth depth;
  bool operator==(const PressDepth&) const = default;
};

/// A press that was made with a flat punch that has a step, not with a ball.
struct PressStep {
  std::string name;
  double step_mm = 0;  ///< its height
  bool operator==(const PressStep&) const = default;
};

struct SaidOfPresses {
  double ball_radius_mm = 0;  ///< of all presses but those in other_balls; 0: not told yet
  std::vector<OtherBall> other_balls;
  std::vector<PressDepth> depths;
  std::vector<PressStep> steps;
  std::vector<PlacedBall> balls;  ///< put by hand
  std::vector<ExcludedPress> excluded;
  bool operator==(const SaidOfPresses&) const = default;

  /// Of which presses something is said.
  [[nodiscard]] std::set<std::string> names() const;
  /// Without what is said of presses that are not among these.
  [[nodiscard]] SaidOfPresses only(const std::set<std::string>& presses) const;
  /// The same in an order that does not depend on when it was said.
  [[nodiscard]] SaidOfPresses by_name() const;
  /// Of the ball that a press was made with.
  [[nodiscard]] double radius_of(const std::string& press) const;
};

/// nullptr where nothing is said of the press.
template <class T>
[[nodiscard]] const T* said_of(const std::vector<T>& list, const std::string& press) {
  const auto found =
      std::find_if(list.begin(), list.end(), [&](const T& one) { return one.name == press; });
  return found == list.end() ? nullptr : &*found;
}
/// How many entries went: nothing is said of the press any more.
template <class T>
std::size_t unsay(std::vector<T>& list, const std::string& press) {
  return std::erase_if(list, [&](const T& one) { return one.name == press; });
}
/// In place of what was said of the same press before.
template <class T>
void say(std::vector<T>& list, T one) {
  unsay(list, one.name);
  list.push_back(std::move(one));
}

// As the command line writes them. Errors say what the form is.
/// NAME=R.
[[nodiscard]] Result<OtherBall> other_ball_from(const std::string& text);
[[nodiscard]] std::string to_text(const OtherBall& ball);
/// NAME=MM or NAME=MM+-SD; without a standard deviation kUsualDepthSdMm.
[[nodiscard]] Result<PressDepth> press_depth_from(const std::string& text);
[[nodiscard]] std::string to_text(const PressDepth& depth);
/// NAME=MM.
[[nodiscard]] Result<PressStep> press_step_from(const std::string& text);
[[nodiscard]] std::string to_text(const PressStep& step);
/// NAME or NAME=WHY.
[[nodiscard]] ExcludedPress excluded_press_from(const std::string& text);
[[nodiscard]] std::string to_text(const ExcludedPress& press);

inline constexpr double kLargestBallMm = 1000;   ///< radius; a larger one is a slip of the pen
inline constexpr double kDeepestMm = 100;        ///< and so is a deeper press or a higher step
inline constexpr double kUsualDepthSdMm = 0.02;  ///< of a dial gauge and a hand

}  // namespace alltact
