// Cost of each effect of a scene in simulation, and the change in image and measurement without it.
#pragma once

#include "calibration/study/accuracy_study.h"
#include "calibration/study/study_world.h"
#include "core/base/job.h"
#include "core/base/message.h"
#include "core/base/result.h"
#include "core/finger/finger_store.h"
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
  std::string effect;  ///< as in Plan::effects(); empty: the full scene
  Message needed;      ///< why it cannot be left out; the other fields are then empty
  int frames = 0;
  std::optional<double> grey_rms;         ///< change of the image, grey levels
  std::optional<double> depth_change_mm;  ///< median change of depth where the full scene presses
  /// Error of depth against the scene's own truth, of pixels truly pressed deeper than 0.05 mm.
  std::optional<ErrorSpread> depth;
  double render_ms = 0;   ///< of a frame, on one thread of this computer, at that time
  double time_ratio = 1;  ///< to the full scene, median
};

struct SimulatingStudy {
  std::string scene;
  std::uint64_t world_checksum = 0;  ///< of the full scene's images
  Message no_depth_reason;           ///< why no finger measures these images; empty: one does
  std::vector<SimulatingRow> rows;   ///< the full scene first, then the effects in the file's order
};

/// Errors: those of the scene and of Plan::compile; stopped.
///   finger: that measures the images, calibrated, with its reference; null: none
///   max_frames: evenly over the scene; seed: of the scene
[[nodiscard]] Result<SimulatingStudy> study_simulating(const std::filesystem::path& scene,
                                                       const FingerPtr& finger, int max_frames,
                                                       std::uint64_t seed, const Job& job);

/// A line a row, with a header line; the change without an effect, and the time that it saves.
[[nodiscard]] std::string text_of(const SimulatingStudy& study);
[[nodiscard]] std::string csv_of(const SimulatingStudy& study);
[[nodiscard]] nlohmann::json json_of(const SimulatingStudy& study);
/// As study_plot.h: change without an effect over the time that it saves; the seven greatest named.
[[nodiscard]] std::string svg_of(const SimulatingStudy& study);

// Simulated images to compare settings on.

/// The scene study_presses (the demonstration's finger, pressed by a ball at random positions and
/// poses), measured by a finger that is recorded and calibrated from scenes as well.
///   folder: for that finger; those of earlier studies are removed
/// Errors: those of ExperimentBench; stopped.
[[nodiscard]] Result<StudyWorld> simulated_world(const std::filesystem::path& folder,
                                                 const StudyWorldOptions& options, const Job& job);

}  // namespace alltact
