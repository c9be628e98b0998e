// The settings that a study compares, and their names.
#pragma once

#include "core/finger/finger.h"
#include "core/message.h"
#include "core/sensing/pipeline_settings.h"

#include <string>
#include <vector>

namespace alltact {

enum class StudyExtent {
  kQuick = 1,  ///< every value that is worth trying (Trade::tried), one setting at a time
  kPairs,      ///< and every two of them at a time, and the cheapest of all
};

/// The base first, then the others, each once, in a fixed order. Only settings that trade accuracy
/// for time on this finger (has_trade_off()).
[[nodiscard]] std::vector<PipelineSettings> study_choices(const PipelineSettings& base,
                                                          StudyExtent extent,
                                                          const Finger& finger);

/// The differences: "reference-method nearest, smoothing-px 0"; "as it is" where there is none.
[[nodiscard]] Message words_of(const PipelineSettings& choice, const PipelineSettings& base);

/// The same as flags of the command line: "--reference-method nearest --smoothing-px 0".
[[nodiscard]] std::string flags_of(const PipelineSettings& choice, const PipelineSettings& base);

/// False: the choice has a value, different from the base's, whose loss the study's images do not
/// show: their light is that of the recording.
[[nodiscard]] bool is_proven(const PipelineSettings& choice, const PipelineSettings& base);

/// All settings with their values; unique for each choice.
[[nodiscard]] std::string key_of(const PipelineSettings& choice);

}  // namespace alltact
