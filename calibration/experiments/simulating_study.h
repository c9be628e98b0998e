// What each effect of a scene costs to simulate, and what leaving it out changes: in the picture,
// and in what a finger measures in it.
#pragma once

#include "calibration/study/accuracy_study.h"
#include "core/finger/finger_store.h"
#include "core/job.h"
#include "core/message.h"
#include "core/result.h"
#include "core/sensing/reference/reference_library.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

namespace alltact {

/// The scene without one effect.
struct SimulatingRow {
  std::string effect;  ///< as Plan::effects() names it; empty: the whole scene
  Message needed;      ///< why it cannot be left out; nothing else is known then
  int frames = 0;
  std::optional<double> grey_rms;   ///< change of the picture, grey levels
  std::optional<double> answer_mm;  ///< change of depth where the whole scene presses, median
  /// Error of depth against the scene's own truth, of pixels truly pressed deeper than 0.05 mm.
  std::optional<ErrorSpread> depth;
  double render_ms = 0;   ///< of a frame, on one thread of this computer, then
  double time_ratio = 1;  ///< to the whole scene, median
};

struct SimulatingStudy {
  std::string scene;
  std::uint64_t world_checksum = 0;  ///< of the whole scene's pictures
  Message no_answer;                 ///< why no finger measures these pictures; empty: one does
  std::vector<SimulatingRow> rows;   ///< the whole scene first, then as the file names its effects
};

struct SimulatingOptions {
  int frames = 12;         ///< at most, evenly over the scene
  std::uint64_t seed = 1;  ///< of the scene
};

/// Errors: those of the scene and of Plan::compile; stopped.
///   finger: that measures the pictures, calibrated, with its reference; null: nobody does
[[nodiscard]] Result<SimulatingStudy> study_simulating(const std::filesystem::path& scene,
                                                       const FingerPtr& finger,
                                                       const SimulatingOptions& options,
                                                       const Job& job);

/// A line a row, with a headline; what leaving out changes, beside what it saves.
[[nodiscard]] std::string text_of(const SimulatingStudy& study);
[[nodiscard]] std::string csv_of(const SimulatingStudy& study);
[[nodiscard]] nlohmann::json json_of(const SimulatingStudy& study);
/// As study_plot.h: what leaving out changes over the time it saves; the seven greatest named.
[[nodiscard]] std::string svg_of(const SimulatingStudy& study);

}  // namespace alltact
