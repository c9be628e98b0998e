// Numbers of a scene that vary from frame to frame.
#pragma once

#include "core/yaml/yaml_reader.h"

#include <cstdint>
#include <string>
#include <vector>

namespace alltact {

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
  static Varying read_or(YamlSection& section,
                         const std::string& key,
                         double otherwise,
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
[[nodiscard]] constexpr Limits strength_up_to(double high) {
  return {0, high, true, false, true};
}

}  // namespace alltact
