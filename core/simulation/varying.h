// Numbers of a scene that differ from frame to frame.
#pragma once

#include "core/yaml/yaml_reader.h"

#include <cstdint>
#include <string>
#include <vector>

namespace alltact {

/// A number that may differ from frame to frame: `3`, a list `[3, 4, 5]` (frame i takes entry
/// i modulo its length), or a range `{from: 3, to: 5}` from which each frame draws its own.
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
  std::vector<double> values_;  // of a range: its two ends
  bool is_range_ = false;
  std::string who_;  // draws under this name, whatever else the scene holds
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
