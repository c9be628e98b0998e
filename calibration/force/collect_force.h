// A force table from a recording and the readings of a gauge beside it.
#pragma once

#include "calibration/force/force_table.h"
#include "core/finger/finger_store.h"
#include "core/job.h"
#include "core/message.h"
#include "core/result.h"
#include "core/sensing/markers/markers.h"

#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

namespace alltact {

/// What a gauge said. Its file is
///   a CSV with fx_n, fy_n[, fz_n] and either t_s or frame (readings typed beside a picture's
///   name),
///     and as it likes along_mm and across_mm, block, day, indenter; or
///   truth.json of `alltact simulate`: the forces of a frame's contacts, summed; a frame without a
///     contact has none, and the place is that of the greatest force.
struct GaugeReading {
  double time_s = std::numeric_limits<double>::quiet_NaN();
  std::string frame;
  Eigen::Vector3d force_N = Eigen::Vector3d::Zero();
  std::optional<Eigen::Vector2d> place_mm;
  std::string block, day, indenter;
};
struct ForceGauge {
  int axes = 2;
  bool by_time = false;                ///< ascending time_s; else by frame
  std::vector<GaugeReading> readings;  ///< not empty
  bool has_block = false, has_day = false, has_indenter = false;

  static Result<ForceGauge> load(const std::filesystem::path& file);
  static Result<ForceGauge> parse_csv(std::string_view csv, const std::filesystem::path& origin);
  static Result<ForceGauge> parse_truth(std::string_view json, const std::filesystem::path& origin);
};

/// Markers of one frame.
struct MarkerFrame {
  std::string name;
  std::optional<double> time_s;
  Markers markers;
  std::optional<Eigen::Vector2d> place_mm;  ///< of the largest contact region
};

/// Markers of a recording: results.jsonl of `alltact reconstruct`, truth.json of `alltact
/// simulate`, or whatever open_source() opens, measured now. Frames without markers are left out.
[[nodiscard]] Result<std::vector<MarkerFrame>> marker_frames(
    const std::vector<std::filesystem::path>& inputs, const FingerSnapshot& finger, const Job& job);

struct CollectedForce {
  ForceTable table;
  std::size_t frames = 0;    ///< with markers
  std::size_t left_out = 0;  ///< of these without a reading
  std::vector<Message> remarks;
};

/// By name, or by time: the reading between the two readings around the frame, which are at most
/// `kLongestGaugeGapS` apart. Where no frame lies between the gauge's readings, both beginnings
/// count as one moment. Errors: markers without times for a gauge that has only times; fewer than
/// ForceTable::kLeastRows rows; what ForceTable::parse refuses.
[[nodiscard]] Result<CollectedForce> collect_force(const std::vector<MarkerFrame>& frames,
                                                   const ForceGauge& gauge);
inline constexpr double kLongestGaugeGapS = 0.5;

}  // namespace alltact
