// Which settings a study looks at, and what they are called.
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

/// The base first, then the others, each once, in a fixed order; of settings that trade something
/// on this finger (trades_on()).
[[nodiscard]] std::vector<PipelineSettings> study_choices(const PipelineSettings& base,
                                                          StudyExtent extent,
                                                          const Finger& finger);

/// What differs: "reference-method nearest, smoothing-px 0"; "as it is" where nothing does.
[[nodiscard]] Message words_of(const PipelineSettings& choice, const PipelineSettings& base);

/// The same as flags of the command line: "--reference-method nearest --smoothing-px 0".
[[nodiscard]] std::string flags_of(const PipelineSettings& choice, const PipelineSettings& base);

/// False: the study's pictures do not show what a value in it, other than the base's, loses: their
/// light is that of the recording.
[[nodiscard]] bool is_proven(const PipelineSettings& choice, const PipelineSettings& base);

/// All settings with their values, by which choices are told apart.
[[nodiscard]] std::string key_of(const PipelineSettings& choice);

}  // namespace alltact
