// Resolution of depth where the presses of a calibration are.
#pragma once

#include "calibration/presses/press.h"
#include "calibration/report/press_errors.h"
#include "core/base/message.h"
#include "core/finger/mapping.h"
#include "core/sensing/depth/depth_resolution.h"
#include "core/sensing/depth/smoothing.h"

#include <optional>
#include <vector>

namespace alltact {

/// Sets the resolution at each contact whose press is among `presses`.
void set_resolutions(const std::vector<const Press*>& presses, const MappingParameters& mapping,
                     const Smoothing& smoothing, std::vector<PressResiduals>* contacts);

/// The worst of all contacts in every figure; nullopt where none has one.
[[nodiscard]] std::optional<DepthResolution> worst_resolution(
    const std::vector<PressResiduals>& contacts);

/// "two points are resolved from 0.98 mm on, ...", of the worst figures; empty without any.
/// `halo`: where more depth is measured next to contacts than the mapping explains, the figures
/// hold only if light does not scatter sideways.
[[nodiscard]] Message resolution_sentence(const std::vector<PressResiduals>& contacts,
                                          const Halo& halo);

}  // namespace alltact
