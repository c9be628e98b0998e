// Notes of a person about a finger's presses: ball radius, and for single presses, by their names,
// other radius, depth or exclusion. Stored in press_notes.yaml next to presses/, which holds their
// images:
//   format: alltact-press-notes/1
//   operator: Ada                     # absent: not given
//   ball_radius_mm: 4.0               # absent: not given yet
//   other_balls: [press_5]            # presses made with a ball of another radius,
//   other_balls_mm: [6.0]             # and the radius
//   depths: [press_2]                 # presses with a depth measured by a stage or a gauge,
//   depths_mm: [[1.2, 0.01]]          # normal to the face, with its standard deviation
//   steps: [press_7]                  # presses made with a flat punch that has a step,
//   steps_mm: [0.5]                   # and its height
//   bodies: [press_8]                 # presses made with another body of known shape,
//   body_files: [bodies/rod.stl]      # and its mesh in mm, from this folder
//   balls: [press_4]                  # presses whose ball was positioned by hand, and where, mm
//   balls_mm: [[1.5, -2.0, 48.0]]
//   excluded: [press_3]               # by name, and the reason
//   excluded_because: [glove in view]
#pragma once

#include "core/base/result.h"
#include "core/base/typed_number.h"

#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>

#include <Eigen/Core>

namespace alltact {

class Fields;

/// A measured press depth: normal to the face without contact, from the ball's first contact to its
/// deepest point.
struct GivenDepth {
  double mm = 0;
  double sd_mm = 0;  ///< standard deviation of the measurement
  bool operator==(const GivenDepth&) const = default;
};

/// Notes about one press; absent: none.
struct PressNote {
  std::optional<double> ball_radius_mm;    ///< of a ball of another size than all others'
  std::optional<GivenDepth> depth;         ///< measured by a stage or a feeler gauge
  std::optional<double> step_mm;           ///< of a flat punch with a step this high, not a ball
  std::optional<std::string> body;         ///< the mesh of another body: STL or OBJ, in mm
  std::optional<Eigen::Vector3d> ball_mm;  ///< the ball's centre positioned by hand, camera frame
  std::optional<std::string> excluded;     ///< the press is unused, and why; empty: no reason given
  [[nodiscard]] bool is_ball() const { return !step_mm && !body; }
  bool operator==(const PressNote&) const = default;
};

struct PressSet {
  static constexpr const char* kFormat = "alltact-press-notes/1";
  static constexpr const char* kFileName = "press_notes.yaml";

  double ball_radius_mm = 0;               ///< of all presses without one of their own; 0: not
                                           ///< given
  std::string operator_name;               ///< empty: not given
  std::map<std::string, PressNote> notes;  ///< by the presses' names; without empty notes
  bool operator==(const PressSet&) const = default;

  /// The notes about a press; empty ones where there are none.
  [[nodiscard]] const PressNote& of(const std::string& press) const;
  /// Replaces the notes about a press.
  void say(const std::string& press, PressNote note);
  /// Radius of the ball that a press was made with, mm.
  [[nodiscard]] double radius_of(const std::string& press) const;
  /// True when a press was made with a ball of another size.
  [[nodiscard]] bool has_other_balls() const;
  /// Without the notes about presses that are not among these.
  [[nodiscard]] PressSet only(const std::set<std::string>& presses) const;

  /// The file with a folder's notes: press_notes.yaml or, where there is none, the inputs of its
  /// calibration.
  [[nodiscard]] static std::filesystem::path file_in(const std::filesystem::path& finger_folder);
  /// Loads file_in(); empty where there is no such file. Errors: the file cannot be read,
  /// impossible values.
  static Result<PressSet> load(const std::filesystem::path& finger_folder);
  static Result<PressSet> parse(const std::string& yaml, const std::filesystem::path& origin);
  [[nodiscard]] std::string to_yaml() const;
  /// Writes the file atomically.
  [[nodiscard]] Status save(const std::filesystem::path& finger_folder) const;
};

// The keys of a file with presses, but `format`. Reading refuses lists of different lengths and
// impossible values.

/// `operator` and `ball_radius_mm`, which `requires_radius` demands.
void describe_all_presses(Fields& fields, PressSet& presses, bool requires_radius);
/// The notes about single presses.
void describe_single_presses(Fields& fields, PressSet& presses);

inline constexpr double kLargestBallMm = kBallRadius.possible.high;
inline constexpr double kDeepestMm = kPressDepth.possible.high;  ///< also of steps of punches
inline constexpr double kTypicalDepthSdMm = 0.02;                ///< of a dial gauge read by hand

}  // namespace alltact
