// Readings of a force gauge: typed by a person, from a serial line or a HID device.
#pragma once

#include "core/message.h"
#include "core/result.h"
#include "core/sources/gauge/gauge_line.h"

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
  std::array<Eigen::Vector3d, 3> of{
      Eigen::Vector3d::UnitX(), Eigen::Vector3d::UnitY(), Eigen::Vector3d::UnitZ()};
  int count = 0;  ///< number of values with a direction; 0: the axes in their order

  /// Parses "x", "-y", "0.6,0.8,0" (normalised), and several for several values: "y/-x/z". Error:
  /// not of that form.
  static Result<GaugeDirections> parse(const std::string& text);
  [[nodiscard]] Eigen::Vector3d force_N(const GaugeLine& line) const;
};

/// "x", "-z": nullopt for anything else.
[[nodiscard]] std::optional<Eigen::Vector3d> axis_named(std::string_view name);

/// The sample of a line with values.
[[nodiscard]] GaugeSample sample_of(const GaugeLine& line,
                                    const GaugeDirections& directions,
                                    double time_s);

/// The clock of GaugeSample::time_s.
[[nodiscard]] double gauge_clock_s();

using GaugeOpener = std::function<Result<std::unique_ptr<GaugeSource>>()>;

}  // namespace alltact
