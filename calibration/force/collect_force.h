// A force table from a recording and the simultaneous readings of a gauge.
#pragma once

#include "calibration/force/force_table.h"
#include "core/base/job.h"
#include "core/base/message.h"
#include "core/base/result.h"
#include "core/finger/finger_store.h"
#include "core/sensing/markers/markers.h"

#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

namespace alltact {

struct GaugeReading {
  double time_s = std::numeric_limits<double>::quiet_NaN();
  std::string frame;
  bool has_force = true;  ///< false: none from its time on (over range, unplugged)
  Eigen::Vector3d force_N = Eigen::Vector3d::Zero();
  double sd_N = std::numeric_limits<double>::quiet_NaN();  ///< of the gauge's last digit
  /// Typed by a person while the finger rests. It applies to the frames around its time in which
  /// the markers stand still; other readings apply to one moment.
  bool holds = false;
  std::optional<Eigen::Vector2d> position_mm;
  std::string block, day, indenter;
};

/// Properties of a gauge's file that the file does not contain.
struct GaugeFileOptions {
  double unit_N = 1;  ///< newtons per unit of columns without a unit
  Eigen::Vector3d direction =
      Eigen::Vector3d::UnitX();  ///< of a file with one force, a unit vector
};

/// Readings of a force gauge. Its file is
///   NAME.gauge.csv of `alltact record --gauge`; or
///   a table of any form that core/base/table.h describes, with fx_n, fy_n[, fz_n] or force_n
///   alone,
///     and either t_s or frame (readings typed with an image's name), and optionally sd_n, holds,
///     along_mm and across_mm, block, day, indenter. Many other names ("Zeit [ms]", "Load (lbF)")
///     and time stamps are read too. Lines with empty forces mean that there is none from then on;
///     or
///   truth.json of `alltact simulate`: the forces of a frame's contacts, summed; a frame without a
///     contact has none, and the position is that of the greatest force.
/// Errors name the line: those of Table; a force or time that is missing or impossible; times that
/// do not ascend.
struct ForceGauge {
  int axes = 2;
  bool by_time = false;                ///< ascending time_s; false: by frame
  bool is_on_frame_clock = false;      ///< recorded with the frames; false: the clock is estimated
  std::vector<GaugeReading> readings;  ///< not empty
  bool has_block = false, has_day = false, has_indenter = false;
  std::filesystem::path origin;
  Message understood;            ///< Table::understood(); empty: no table
  std::vector<Message> remarks;  ///< Table::remarks()
  std::string time_column;       ///< empty: none, or time stamps
  double time_unit_s = 1;        ///< as understood

  static Result<ForceGauge> load(const std::filesystem::path& file,
                                 const GaugeFileOptions& options = {});
  static Result<ForceGauge> parse_csv(std::string_view csv, const std::filesystem::path& origin,
                                      const GaugeFileOptions& options = {});
  static Result<ForceGauge> parse_truth(std::string_view json, const std::filesystem::path& origin);
};

/// Markers of one frame.
struct MarkerFrame {
  std::string name;
  std::optional<double> time_s;
  Markers markers;
  std::optional<Eigen::Vector2d> position_mm;  ///< of the first contact region
};

/// Markers of a recording: results.jsonl of `alltact reconstruct`, truth.json of `alltact
/// simulate`, or any input of open_source(), measured now. Frames without markers are left out.
/// `remarks`: those of the source.
[[nodiscard]] Result<std::vector<MarkerFrame>> marker_frames(
    const std::vector<std::filesystem::path>& inputs, const FingerSnapshot& finger, const Job& job,
    std::vector<Message>* remarks = nullptr);

/// Relation of the gauge's clock to the frames': gauge = frame + shift_s + drift (frame - first_s).
/// A delayed gauge has a shift above 0.
struct GaugeClock {
  enum class Source {
    kAssumed = 1,  ///< the same clock and no delay, or both started together
    kGiven,
    kMotion,  ///< by the markers' motion
  };
  Source source = Source::kAssumed;
  double shift_s = 0, drift = 0, first_s = 0;
  double sd_s = std::numeric_limits<double>::quiet_NaN();  ///< of shift_s, where by motion
  /// fraction of the force's fast changes that the markers' motion explains at this shift
  double r2 = 0;

  [[nodiscard]] double gauge_time_s(double frame_s) const {
    return frame_s + shift_s + drift * (frame_s - first_s);
  }
  [[nodiscard]] double frame_time_s(double gauge_s) const {
    return (gauge_s - shift_s + drift * first_s) / (1 + drift);
  }
};

struct CollectOptions {
  /// Given by a person; otherwise estimated by the markers' motion where that is possible. A drift
  /// without a shift is an input of the estimate.
  std::optional<double> shift_s, drift;
};

struct CollectedForce {
  ForceTable table;          ///< valid for ForceTable::parse_part
  std::size_t frames = 0;    ///< with markers
  std::size_t left_out = 0;  ///< of these without a reading
  GaugeClock clock;
  double reading_sd_N = std::numeric_limits<double>::quiet_NaN();  ///< median of the known ones
  std::vector<Message> remarks;
};

/// Assigns readings by name or by time. By time it interpolates the two readings around the frame,
/// at most `kLongestGaugeGapS` apart, or takes the one that is held. Where the gauge has no blocks,
/// the presses are blocks: from one moment without load to the next. Errors: markers without times
/// for a gauge that has only times; times of the gauge in another unit than its column states, by
/// the spans of both and the distance of the readings; no frame with a reading, and why.
[[nodiscard]] Result<CollectedForce> collect_force(const std::vector<MarkerFrame>& frames,
                                                   const ForceGauge& gauge,
                                                   const CollectOptions& options = {});
inline constexpr double kLongestGaugeGapS = 0.5;

// Delay of a force gauge, from the motion of the markers.
//
// METHOD At a shift s the force at a frame's time plus s is estimated, by least squares, from the
// first principal components of the markers' layouts. Both are taken less their mean over
// kClockWindowS around (creep and drift are slow). R2 over s is a cross-correlation of several
// channels (the generalised form of Knapp and Carter, IEEE Trans. ASSP 1976, without weighting).
// The shift is its maximum, refined by a parabola. Its standard deviation is that of a jackknife
// over kClockStretches stretches of the frames (Efron and Stein, Annals of Statistics 1981).

inline constexpr double kClockWindowS = 3.0;
inline constexpr int kClockStretches = 8;
/// Of gauges on the frames' own clock: no gauge and no USB line has a longer delay.
inline constexpr double kLongestDelayS = 0.8;

/// frames with times, ascending; gauge by time. `remarks` receives what was estimated or assumed.
/// Never fails: the clock is assumed where the motion does not determine it (too little motion,
/// ambiguous, R2 below 0.3, an sd above 50 ms).
[[nodiscard]] GaugeClock estimate_gauge_clock(const std::vector<MarkerFrame>& frames,
                                              const ForceGauge& gauge,
                                              const CollectOptions& options,
                                              std::vector<Message>& remarks);

}  // namespace alltact
