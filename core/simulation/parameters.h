// Strict reading of a YAML map: every key is asked for, what was not asked for is an error.
#pragma once

#include "core/result.h"

#include <cstdint>
#include <initializer_list>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <yaml-cpp/yaml.h>

namespace alltact {

/// A number that may differ from frame to frame: `3`, a list `[3, 4, 5]` (frame i takes entry
/// i modulo its length), or a range `{from: 3, to: 5}` from which each frame draws its own.
class Varying {
 public:
  explicit Varying(double constant = 0) : values_{constant} {}
  static Varying list(std::vector<double> values);
  static Varying range(double from, double to, std::string who);

  [[nodiscard]] double at(std::uint64_t seed, int frame) const;
  [[nodiscard]] double least() const;
  [[nodiscard]] double greatest() const;

 private:
  std::vector<double> values_;  // of a range: its two ends
  bool is_range_ = false;
  std::string who_;  // draws under this name
};

/// Something of the finger that a motion can move, declared by the effect that does it.
struct DegreeOfFreedom {
  std::string name;  ///< "q1_mm"
  double low, high;  ///< the range that a motion may use
};

/// Inclusive limits of a number; `low_open` and `high_open` take the ends away.
struct Limits {
  double low, high;
  bool low_open = false, high_open = false;
};
/// For strengths: what is absent is not named, so 0 is refused with a sentence saying so.
[[nodiscard]] inline Limits strength_up_to(double high) {
  return {0, high, true, false};
}

/// One map of a scene file. Readers return something harmless after the first error; status()
/// tells of it, or of the first key that nobody asked for.
class Parameters {
 public:
  Parameters(const YAML::Node& map, std::string origin, std::string path);

  [[nodiscard]] bool has(const char* key);
  [[nodiscard]] double number(const char* key, Limits limits);
  [[nodiscard]] double number_or(const char* key, double otherwise, Limits limits);
  [[nodiscard]] int integer(const char* key, int low, int high);
  [[nodiscard]] int integer_or(const char* key, int otherwise, int low, int high);
  [[nodiscard]] Varying varying(const char* key, Limits limits);
  [[nodiscard]] Varying varying_or(const char* key, double otherwise, Limits limits);
  /// {from: a, to: b} with a < b.
  [[nodiscard]] DegreeOfFreedom degree_of_freedom(const char* name, Limits limits);
  [[nodiscard]] std::string text(const char* key);
  [[nodiscard]] std::string word(const char* key, std::initializer_list<const char*> allowed);
  [[nodiscard]] std::vector<double> numbers(const char* key, int at_least, int at_most);
  [[nodiscard]] Parameters map(const char* key);
  [[nodiscard]] std::vector<Parameters> maps(const char* key);
  /// All keys, in the file's order, for maps whose keys are names.
  [[nodiscard]] std::vector<std::string> keys();

  /// What errors and draws call this map from now on.
  void rename(std::string path);

  /// Takes note of an error about a key (or the whole map when `key` is empty).
  void refuse(const std::string& key, std::string what, std::string advice);
  /// The first error, else the first key (here or in any map read from the same file) that nobody
  /// asked for.
  [[nodiscard]] Status status() const;
  /// Where errors point: "file:line: path.key".
  [[nodiscard]] std::string where(const std::string& key) const;
  [[nodiscard]] const std::string& origin() const { return shared_->origin; }
  /// For draws: "ball.depth_mm" names the parameter whatever else the scene holds.
  [[nodiscard]] const std::string& path() const { return here_->path; }

 private:
  struct Visited {
    YAML::Node map;
    std::string path;
    std::vector<std::string> asked;
  };
  struct Shared {
    std::string origin;
    std::unique_ptr<Error> error;
    std::vector<std::shared_ptr<Visited>> maps;
  };
  Parameters(const YAML::Node& map, std::shared_ptr<Shared> shared, std::string path);
  [[nodiscard]] YAML::Node take(const char* key);
  [[nodiscard]] YAML::Node take_required(const char* key);
  [[nodiscard]] double checked(const YAML::Node& node, const std::string& key, Limits limits);
  [[nodiscard]] Varying checked_varying(const YAML::Node& node,
                                        const std::string& key,
                                        Limits limits);

  std::shared_ptr<Shared> shared_;
  std::shared_ptr<Visited> here_;
};

}  // namespace alltact
