// What somebody says of a finger's presses: made with which ball and, by their names, what single
// ones were made with, how deep they are, which not to use. Kept in press_notes.yaml beside
// presses/, which holds their pictures:
//   format: alltact-press-notes/1
//   operator: Ada                     # absent: not told
//   ball_radius_mm: 4.0               # absent: not told yet
//   other_balls: [press_5]            # presses made with a ball of another radius,
//   other_balls_mm: [6.0]             # and which
//   depths: [press_2]                 # presses whose depth a stage or a gauge told,
//   depths_mm: [[1.2, 0.01]]          # normal to the face, with its standard deviation
//   steps: [press_7]                  # presses made with a flat punch that has a step,
//   steps_mm: [0.5]                   # and its height
//   balls: [press_4]                  # presses whose ball was put by hand, and where, mm
//   balls_mm: [[1.5, -2.0, 48.0]]
//   excluded: [press_3]               # by name, and why
//   excluded_because: [glove in the picture]
#pragma once

#include "core/finger/quantity.h"
#include "core/result.h"
#include "core/yaml/yaml_reader.h"
#include "core/yaml/yaml_writer.h"

#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>

#include <Eigen/Core>

namespace alltact {

/// How deep a ball was pressed in where that was measured: normal to the untouched face, from where
/// the ball first touches it to its deepest point.
struct ToldDepth {
  double mm = 0;
  double sd_mm = 0;  ///< standard deviation of the measurement
  bool operator==(const ToldDepth&) const = default;
};

/// What is said of one press; absent: nothing.
struct PressNote {
  std::optional<double> ball_radius_mm;    ///< of a ball of another size than all others'
  std::optional<ToldDepth> depth;          ///< as a stage or a feeler gauge tells it
  std::optional<double> step_mm;           ///< of a flat punch with a step this high, not a ball
  std::optional<Eigen::Vector3d> ball_mm;  ///< the ball's centre put by hand, camera frame
  std::optional<std::string> excluded;     ///< kept but not used, and why; empty: not told why
  bool operator==(const PressNote&) const = default;
};

struct PressSet {
  static constexpr const char* kFormat = "alltact-press-notes/1";
  static constexpr const char* kFileName = "press_notes.yaml";

  double ball_radius_mm = 0;               ///< of all presses without one of their own; 0: not told
  std::string operator_name;               ///< empty: not told
  std::map<std::string, PressNote> notes;  ///< by the presses' names; none says nothing
  bool operator==(const PressSet&) const = default;

  /// Says nothing of a press that is not among the notes.
  [[nodiscard]] const PressNote& of(const std::string& press) const;
  /// In place of what was said of it before.
  void say(const std::string& press, PressNote note);
  /// Of the ball that a press was made with.
  [[nodiscard]] double radius_of(const std::string& press) const;
  /// A press was made with a ball of another size.
  [[nodiscard]] bool has_other_balls() const;
  /// Without what is said of presses that are not among these.
  [[nodiscard]] PressSet only(const std::set<std::string>& presses) const;

  /// The file that tells of a folder's presses: press_notes.yaml or, where there is none, what its
  /// calibration was made from.
  [[nodiscard]] static std::filesystem::path file_in(const std::filesystem::path& finger_folder);
  /// What file_in() says; empty where there is no such file. Errors: the file cannot be read,
  /// impossible values.
  static Result<PressSet> load(const std::filesystem::path& finger_folder);
  static Result<PressSet> parse(const std::string& yaml, const std::filesystem::path& origin);
  [[nodiscard]] std::string to_yaml() const;
  /// Whole or not at all.
  [[nodiscard]] Status save(const std::filesystem::path& finger_folder) const;
};

/// All keys but `format`, of a file that holds more than these as well. Refuses lists of different
/// lengths, impossible values and, where it must be told, a missing radius.
[[nodiscard]] PressSet read_press_set(YamlSection& top, bool must_tell_radius = false);
/// `ball_radius_mm` and `operator`.
void add_all_presses(const PressSet& presses, YamlBlock& block);
/// The rest.
void add_single_presses(const PressSet& presses, YamlBlock& block);

inline constexpr double kLargestBallMm = kBallRadius.possible.high;
inline constexpr double kDeepestMm = kPressDepth.possible.high;  ///< of steps of punches too
inline constexpr double kUsualDepthSdMm = 0.02;                  ///< of a dial gauge and a hand

}  // namespace alltact
