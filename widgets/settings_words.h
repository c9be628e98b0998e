// Settings as text in the window's language.
#pragma once

#include "core/sensing/pipeline_settings.h"

#include <QString>

namespace alltact {

/// "nearest recorded image, no smoothing": the settings of `choice` that differ from `base`; empty
/// where none does.
[[nodiscard]] QString difference_words(const PipelineSettings& choice,
                                       const PipelineSettings& base);

}  // namespace alltact
