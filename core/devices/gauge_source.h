// Readings of a force gauge: typed by a person, from a serial line or a HID device.
#pragma once

#include "core/base/message.h"
#include "core/base/result.h"

#include <array>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

namespace alltact {

// Parser for one line of text from a gauge.

enum class GaugeFormat {
  /// Numbers with or without units: "+0.123 N", "-18.78 lbF" (Mark-10), "1.2 0.3 -0.1",
  /// "0.5,0.25"; and Imada's "+01.23KT0" or "+12.34NTO": unit O (lbf), K (kgf) or N, mode T or P,
  /// judgement, of which E is over range.
  kPlain = 1,
  /// "0011.70": for Sauter's FH and FL the first digit is the sign, 0 minus and 1 plus.
  kSauter,
};
inline constexpr std::array<std::string_view, 2> kGaugeFormats{"plain", "sauter"};

struct GaugeLineRules {
  GaugeFormat format = GaugeFormat::kPlain;
  double unit_N = 1;              ///< newtons per unit of a line without a unit
  bool is_comma_decimal = false;  ///< "1,25" is one number; else a comma separates two
};

struct GaugeLine {
  enum class Kind {
    kValues = 1,
    kOverRange,  ///< the gauge reports that it is out of range: OL, OVER, HELP, ----
    kNoise,      ///< neither: a broken line, a greeting, an error code
  };
  Kind kind = Kind::kNoise;
  int count = 0;                    ///< 1 to 3 values
  std::array<double, 3> force_N{};  ///< finite, at most 1e5 N
  std::array<double, 3> digit_N{};  ///< value of the last digit
  std::array<int, 3> decimals{};    ///< digits behind the point
};

/// Parses a line without its end. Each value is a complete number of the line: "0.12+0.123" and
/// "1.2.3" give none.
[[nodiscard]] GaugeLine read_gauge_line(std::string_view line, const GaugeLineRules& rules);

/// A reading of a gauge at one moment.
struct GaugeSample {
  double time_s = 0;  ///< this computer's monotonic clock, like Frame::time_ns of a camera
  /// False: the gauge is over range, or the value that was valid until now is no longer valid.
  bool has_force = false;
  Eigen::Vector3d force_N = Eigen::Vector3d::Zero();
  /// Standard deviation of rounding to the last digit, step / sqrt(12), of the coarsest value; NaN:
  /// unknown.
  double sd_N = std::numeric_limits<double>::quiet_NaN();
  bool holds = false;  ///< a typed value: valid for the stationary finger around its time; false:
                       ///< of one moment
  std::string block, indenter;  ///< as typed; without commas and line ends
};

struct GaugeUpdate {
  std::vector<GaugeSample> samples;  ///< in time order
  std::vector<Message> remarks;      ///< for the person at the gauge
  bool is_over = false;              ///< nothing will follow
};

/// One thread. Times never decrease.
class GaugeSource {
 public:
  virtual ~GaugeSource() = default;
  /// Returns new readings; waits for them no longer than the timeout. Error: the device is gone; it
  /// may come back when it is opened again.
  [[nodiscard]] virtual Result<GaugeUpdate> read(int timeout_ms) = 0;
  /// Number of values of each reading; 0: it varies.
  [[nodiscard]] virtual int axes() const = 0;
};

/// Directions of a gauge's values in the axes of the force table: the columns of a 3 x 3 matrix.
struct GaugeDirections {
  std::array<Eigen::Vector3d, 3> of{Eigen::Vector3d::UnitX(), Eigen::Vector3d::UnitY(),
                                    Eigen::Vector3d::UnitZ()};
  int count = 0;  ///< number of values with a direction; 0: the axes in their order

  /// Parses "x", "-y", "0.6,0.8,0" (normalised), and several for several values: "y/-x/z". Error:
  /// not of that form.
  static Result<GaugeDirections> parse(const std::string& text);
  [[nodiscard]] Eigen::Vector3d force_N(const GaugeLine& line) const;
};

/// "x", "-z": nullopt for anything else.
[[nodiscard]] std::optional<Eigen::Vector3d> axis_named(std::string_view name);

/// The sample of a line with values.
[[nodiscard]] GaugeSample sample_of(const GaugeLine& line, const GaugeDirections& directions,
                                    double time_s);

/// The clock of GaugeSample::time_s.
[[nodiscard]] double gauge_clock_s();

using GaugeOpener = std::function<Result<std::unique_ptr<GaugeSource>>()>;

// Units of force that gauges use.

/// Newtons in one N, mN, kN, g, gf, kg, kgf, lb, lbf, oz, ozf, in upper or lower case (gauges write
/// "lbF" and "KN"), as core/base/units.h defines them. nullopt: no unit of force.
[[nodiscard]] std::optional<double> newtons_in(std::string_view unit);

// Readings that a person types, one per line.

/// A line is
///   1.23   1,23   1.23 N   250 g    the gauge's display, along the current direction
///   0.5 1.2                         Fx and Fy; three numbers: Fz too
///   y 1.23                          along y from now on
///   block NAME   indenter NAME      for the readings from now on
///   nothing                         the last reading is no longer valid
/// The time of a reading is that of its Enter; it is valid around that time. Without named blocks
/// each reading is a block: "typed 1", "typed 2".
class TypedGauge : public GaugeSource {
 public:
  /// `descriptor`: usually standard input; the caller owns it.
  TypedGauge(int descriptor, const GaugeLineRules& rules, const GaugeDirections& directions);

  /// Remarks report each line that is not understood and confirm each other one. The source is over
  /// at the input's end.
  [[nodiscard]] Result<GaugeUpdate> read(int timeout_ms) override;
  [[nodiscard]] int axes() const override { return 0; }

 private:
  void take(std::string line, double time_s, GaugeUpdate& update);
  bool take_name(const std::string& line, GaugeUpdate& update);

  int descriptor_;
  GaugeLineRules rules_;
  GaugeDirections directions_;
  std::string unfinished_, block_, indenter_;
  int count_ = 0;
  double last_s_ = 0;
  bool is_over_ = false;
};

}  // namespace alltact
