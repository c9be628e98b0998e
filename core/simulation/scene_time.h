// Times in a scene: points in time, and the frames in which an effect is present.
#pragma once

#include "core/base/result.h"
#include "core/base/yaml.h"

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace alltact {

/// The frames of a scene, from the top of its file (`frames`, `frames_per_s`). A source that plays
/// without end restarts after the last one.
struct SceneTime {
  int frames = 1;
  double frames_per_s = 30;

  /// For YamlFile::read(); `part` is any section of the scene.
  static SceneTime of(const YamlSection& part);

  /// A point in time as a number of frames: a plain number counts frames (`60`), and seconds have
  /// their unit (`2 s`). Not negative.
  [[nodiscard]] double point(YamlSection& section, const std::string& key) const;
};

/// The frames [first, end) of a scene. `from:` and `until:` give them as points in time: `from` is
/// the first frame with the effect, `until` the first one without it. An effect until 2 s and one
/// from 2 s thus follow each other. Defaults: the beginning and the end.
struct Presence {
  int first = 0, end = 1;

  /// For YamlFile::read(). An empty presence is refused.
  static Presence read(YamlSection& effect, const SceneTime& time);

  [[nodiscard]] bool holds(int frame) const { return frame >= first && frame < end; }
  [[nodiscard]] bool overlaps(const Presence& other) const {
    return first < other.end && other.first < end;
  }
};

// Numbers of a scene that vary from frame to frame.

/// A number that may vary from frame to frame:
///   3                     constant;
///   [3, 4, 5]             frame i takes entry i modulo its length;
///   {from: 3, to: 5}      each frame draws its own from this range;
///   - {at: 0 s, is: 40}   key frames: `is` is the value at the point in time `at`, a frame or
///   - {at: 2 s, is: 74, by: smooth}   seconds. `by` is the interpolation from the previous key
///                         frame: straight (the default), or smooth, along half a cosine. Before
///                         the first key frame and after the last one the value is constant.
/// A scene that plays without end repeats its key frames each time.
class Varying {
 public:
  explicit Varying(double constant = 0) : values_{constant} {}
  /// For YamlFile::read(), with every value within the limits.
  static Varying read(YamlSection& section, const std::string& key, Limits limits);
  /// The same, or a constant where the key is absent.
  static Varying read_or(YamlSection& section, const std::string& key, double otherwise,
                         Limits limits);

  [[nodiscard]] double at(std::uint64_t seed, int frame) const;
  [[nodiscard]] double min_value() const;
  [[nodiscard]] double max_value() const;

 private:
  enum class Kind { kList = 1, kRange, kKeyFrames };
  struct KeyFrame {
    double at;       // frames
    bool is_smooth;  // interpolation from the previous key frame
  };
  void read_key_frames(YamlSection& section, const std::string& key, Limits limits);
  [[nodiscard]] double between_key_frames(double frame) const;

  Kind kind_ = Kind::kList;
  std::vector<double> values_;        // of a range: its two ends
  std::vector<KeyFrame> key_frames_;  // of key frames: one for each value
  int frames_ = 1;                    // of key frames: the scene's
  std::string stream_;  // name of its random stream, independent of the rest of the scene
};

/// A degree of freedom of the finger, declared by the effect that applies it.
struct DegreeOfFreedom {
  std::string name;  ///< "q1_mm"
  double low, high;  ///< the range that a motion may use

  /// For YamlFile::read(): {from: a, to: b} with a < b.
  static DegreeOfFreedom read(YamlSection& section, const std::string& name, Limits limits);
};

/// For strengths: 0 is refused with a message, since an absent effect is left out of the scene.
[[nodiscard]] constexpr Limits strength_up_to(double high) { return {0, high, true, false, true}; }

// The motion of a simulated finger from frame to frame.

/// A pure function of (seed, frame): frames may be evaluated in any order.
///   hold:   the same pose in every frame, `pose: {q1_mm: 3}`; unnamed degrees of freedom are 0.
///   path:   each named degree of freedom follows its key frames, so that a finger
///           bends for a while and then holds still; unnamed ones are 0.
///   poses:  `poses: [{q1_mm: 3}, ...]`, frame i takes pose i modulo their number.
///   random: every frame draws each degree of freedom evenly and independently from its range.
///   wander: from rest (all 0) from one point of the ranges to the next in `frames_per_move` frames
///           each, with soft starts and stops; the points fill the ranges evenly (Halton sequence,
///           shifted by seed).
class Motion {
 public:
  /// The default motion of a scene: hold, everything 0.
  Motion() = default;
  static Motion read(YamlSection& section);

  [[nodiscard]] double value(const DegreeOfFreedom& dof, std::uint64_t seed, int frame) const;
  /// Error: a pose names a degree of freedom that no effect moves, or exceeds its range.
  [[nodiscard]] Status validate(const std::vector<DegreeOfFreedom>& dofs) const;

 private:
  enum class Kind { kPath = 1, kPoses, kRandom, kWander };
  [[nodiscard]] Status validate(const std::vector<DegreeOfFreedom>& dofs, const std::string& name,
                                double min_value, double max_value) const;
  using Pose = std::map<std::string, double>;

  Kind kind_ = Kind::kPoses;
  std::vector<Pose> poses_{Pose{}};
  std::map<std::string, Varying> path_;
  double frames_per_move_ = 1;
  std::string where_;
};

}  // namespace alltact
