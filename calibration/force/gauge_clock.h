// How late a gauge tells its forces, from how the markers move with them.
//
// METHOD
// At a shift s the force at a frame's time plus s is told, by least squares, from the first
// principal components of the markers' layouts, both less their mean over kClockWindowS around
// (creep and drift are slow). R2 over s is a cross-correlation of several channels (the generalised
// form of Knapp and Carter, IEEE Trans. ASSP 1976, without weighting); its greatest value, refined
// by a parabola, is the shift. Its standard deviation is that of a jackknife over kClockStretches
// stretches of the frames (Efron and Stein, Annals of Statistics 1981).
#pragma once

#include "calibration/force/collect_force.h"

#include <vector>

namespace alltact {

inline constexpr double kClockWindowS = 3.0;
inline constexpr int kClockStretches = 8;
/// Of gauges on the frames' own clock: no gauge and no USB line is later.
inline constexpr double kLongestDelayS = 0.8;

/// frames with times, ascending; gauge by time. What was found or assumed is told in `remarks`.
/// Never fails: where the motion tells nothing (too little of it, ambiguous, R2 below 0.3, an sd
/// above 50 ms), the clock is assumed.
[[nodiscard]] GaugeClock settle_gauge_clock(const std::vector<MarkerFrame>& frames,
                                            const ForceGauge& gauge,
                                            const CollectOptions& options,
                                            std::vector<Message>& remarks);

}  // namespace alltact
