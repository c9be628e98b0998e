// Readings of a force gauge as they come, whatever it is: typed by a person, on a serial line, a
// HID device.
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

/// What a gauge said at one moment.
struct GaugeSample {
  double time_s = 0;  ///< of this computer's monotonic clock, as Frame::time_ns of a camera
  /// No force: it is over range, or what held until now holds no longer.
  bool has_force = false;
  Eigen::Vector3d force_N = Eigen::Vector3d::Zero();
  /// Of rounding to the last digit, step / sqrt(12), of the coarsest value; NaN: not known.
  double sd_N = std::numeric_limits<double>::quiet_NaN();
  bool holds = false;  ///< of the rest of the finger around its time, as typed; else of a moment
  std::string block, indenter;  ///< as typed; without commas and line ends
};

struct GaugeNews {
  std::vector<GaugeSample> samples;  ///< in the order of time
  std::vector<Message> remarks;      ///< for the person at the gauge
  bool is_over = false;              ///< nothing will follow
};

/// One thread. Times never go back.
class GaugeSource {
 public:
  virtual ~GaugeSource() = default;
  /// What came; waits for it at most so long. Error: the device is gone; it may come back when it
  /// is opened again.
  [[nodiscard]] virtual Result<GaugeNews> read(int timeout_ms) = 0;
  /// How many values each reading has; 0: differs.
  [[nodiscard]] virtual int axes() const = 0;
};

/// Where a gauge's values point, in the axes of the force table: the columns of a 3 x 3 matrix.
struct GaugeDirections {
  std::array<Eigen::Vector3d, 3> of{
      Eigen::Vector3d::UnitX(), Eigen::Vector3d::UnitY(), Eigen::Vector3d::UnitZ()};
  int told = 0;  ///< for how many values; 0: the axes in their order

  /// "x", "-y", "0.6,0.8,0" (made a unit vector), and several for several values: "y/-x/z". Error:
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
