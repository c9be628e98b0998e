// Settings as people call them, in the window's language.
#pragma once

#include "core/sensing/pipeline_settings.h"

#include <QString>

namespace alltact {

/// "nearest recorded picture, no smoothing": what of `choice` is other than in `base`; empty where
/// nothing is.
[[nodiscard]] QString difference_words(const PipelineSettings& choice,
                                       const PipelineSettings& base);

}  // namespace alltact
