// Numbers of a scene that differ from frame to frame.
#pragma once

#include "core/yaml/yaml_reader.h"

#include <cstdint>
#include <string>
#include <vector>

namespace alltact {

/// A number that may differ from frame to frame:
///   3                     always the same;
///   [3, 4, 5]             frame i takes entry i modulo its length;
///   {from: 3, to: 5}      each frame draws its own from this range;
///   - {at: 0 s, is: 40}   key frames: `is` is the value at the point in time `at`, a frame or
///   - {at: 2 s, is: 74, by: smooth}   seconds. `by` says how it gets there from the key frame
///                         before: straight (unless said), or smooth, which sets out and arrives
///                         softly, along half a cosine. Before the first key frame and after the
///                         last one the value stays.
/// A scene that is played without end goes through its key frames again each time.
class Varying {
 public:
  explicit Varying(double constant = 0) : values_{constant} {}
  /// For YamlFile::read(), with every value within the limits.
  static Varying read(YamlSection& section, const std::string& key, Limits limits);
  /// The same, or a constant where the key is absent.
  static Varying read_or(YamlSection& section,
                         const std::string& key,
                         double otherwise,
                         Limits limits);

  [[nodiscard]] double at(std::uint64_t seed, int frame) const;
  [[nodiscard]] double least() const;
  [[nodiscard]] double greatest() const;

 private:
  enum class Kind { kList = 1, kRange, kKeyFrames };
  struct Way {
    double at;       // frames
    bool is_smooth;  // on the way here from the one before
  };
  void read_key_frames(YamlSection& section, const std::string& key, Limits limits);
  [[nodiscard]] double between_key_frames(double frame) const;

  Kind kind_ = Kind::kList;
  std::vector<double> values_;  // of a range: its two ends
  std::vector<Way> ways_;       // of key frames: to each of the values
  int frames_ = 1;              // of key frames: the scene's
  std::string who_;             // draws under this name, whatever else the scene holds
};

/// Something of the finger that a motion can move, declared by the effect that does it.
struct DegreeOfFreedom {
  std::string name;  ///< "q1_mm"
  double low, high;  ///< the range that a motion may use

  /// For YamlFile::read(): {from: a, to: b} with a < b.
  static DegreeOfFreedom read(YamlSection& section, const std::string& name, Limits limits);
};

/// For strengths: what is absent is not named, so 0 is refused with a sentence saying so.
[[nodiscard]] constexpr Limits strength_up_to(double high) {
  return {0, high, true, false, true};
}

}  // namespace alltact
