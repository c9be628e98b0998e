// A recording inspected by a recipe: the readings of each frame, their decisions, and a summary of
// each reading over all frames.
#pragma once

#include "core/base/job.h"
#include "core/base/result.h"
#include "core/inspection/inspection_recipe.h"
#include "core/sensing/pipeline.h"
#include "core/sources/source.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace alltact {

struct InspectedReading {
  FaceReading reading;
  Conformity conformity = Conformity::kNotMeasured;
};

struct InspectedRow {
  std::size_t index = 0;  ///< of the frame in the recording
  std::string frame;      ///< its name
  std::optional<double> time_s;
  std::vector<InspectedReading> readings;  ///< one for each of the recipe
};

/// Of one reading over all frames. Values at the layer's limit are left out of all figures.
struct ReadingSummary {
  std::size_t measured = 0, passed = 0, failed = 0, undecided = 0;  ///< frames
  /// Of the values; empty without any.
  std::optional<double> mean, sd, min, max;
  /// Change of the value: per second, or per frame where the recording has no times, by a straight
  /// line through the values, with its standard deviation. Empty with fewer than three values.
  std::optional<MeasuredValue> trend;
  bool is_trend_per_second = false;
};

struct InspectionLog {
  InspectionRecipe recipe;
  std::vector<InspectedRow> rows;  ///< in the order of the frames
  std::vector<Message> remarks;    ///< of the source

  /// A line for each frame and reading:
  ///   index,frame,time_s,reading,what,value,sd,unit,lower,upper,decision,remark
  [[nodiscard]] std::string to_csv() const;
  /// In the order of the recipe.
  [[nodiscard]] std::vector<ReadingSummary> summaries() const;
  /// kFail if any reading of any frame fails, else kUndecided or kNotMeasured if any is that, else
  /// kPass; kNoTolerance where no reading has one.
  [[nodiscard]] Conformity verdict() const;
};

/// Measures all frames. `pipelines`: of the calibrated finger that has this mapping, one for each
/// thread; the log is the same for any number of them. Errors: those of measure_batch(); no frames;
/// stopped.
[[nodiscard]] Result<InspectionLog> inspect(Source& source, std::vector<Pipeline>& pipelines,
                                            const Mapping& mapping, const InspectionRecipe& recipe,
                                            const Job& job);

/// The readings of one measured frame. A frame without depth has none, with the reason.
[[nodiscard]] std::vector<InspectedReading> inspect_frame(const MeasuredFace& face,
                                                          const InspectionRecipe& recipe);

}  // namespace alltact
