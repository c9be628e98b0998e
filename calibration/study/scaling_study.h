// Growth of time and memory with pixels, recorded frames, markers, presses and length of
// recordings.
//
// Times are processor times, without the load of other programs. The exponent is the slope of
// log(time) over log(size), by least squares over the upper half of the sizes. It is 1 where twice
// the size takes twice the time.
#pragma once

#include "core/base/job.h"
#include "core/base/message.h"
#include "core/base/result.h"
#include "core/finger/finger_store.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

namespace alltact {

struct ScalingPoint {
  double size = 0;
  double time_ms = 0;
  std::optional<std::size_t> memory_bytes;  ///< that is held while it works
};

struct ScalingCurve {
  std::string key;                   ///< in files: "pixels"
  Message what;                      ///< a phrase: the operation that is timed
  Message of;                        ///< a phrase: the unit of the sizes
  std::vector<ScalingPoint> points;  ///< sizes ascending
  std::optional<double> exponent;    ///< of time; absent: fewer than two sizes
  Message note;                      ///< a further observation, a sentence; may be empty
};

struct ScalingStudy {
  Message about;
  std::vector<ScalingCurve> curves;
};

struct ScalingOptions {
  std::uint64_t seed = 1;
  bool quick = false;  ///< a part of the sizes
  int threads = 1;     ///< that a recording is measured with
};

/// Of a calibrated finger's own images, enlarged and reduced, and of synthetic layouts of markers.
/// Errors: those of untouched_images() and Pipeline; stopped.
[[nodiscard]] Result<ScalingStudy> study_scaling(const FingerPtr& finger,
                                                 const ScalingOptions& options, const Job& job);

/// Slope of log(y) over log(x) by least squares, over points with x at or above the geometric mean
/// of the smallest and the greatest x. nullopt: fewer than two such points, or a value that is not
/// positive.
[[nodiscard]] std::optional<double> exponent_of(const std::vector<double>& x,
                                                const std::vector<double>& y);

[[nodiscard]] std::string text_of(const ScalingStudy& study);
[[nodiscard]] std::string csv_of(const ScalingStudy& study);
[[nodiscard]] nlohmann::json json_of(const ScalingStudy& study);

}  // namespace alltact
