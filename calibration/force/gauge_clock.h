// Estimates the delay of a force gauge from the motion of the markers.
//
// METHOD At a shift s the force at a frame's time plus s is estimated, by least squares, from the
// first principal components of the markers' layouts. Both are taken less their mean over
// kClockWindowS around (creep and drift are slow). R2 over s is a cross-correlation of several
// channels (the generalised form of Knapp and Carter, IEEE Trans. ASSP 1976, without weighting).
// The shift is its maximum, refined by a parabola. Its standard deviation is that of a jackknife
// over kClockStretches stretches of the frames (Efron and Stein, Annals of Statistics 1981).
#pragma once

#include "calibration/force/collect_force.h"

#include <vector>

namespace alltact {

inline constexpr double kClockWindowS = 3.0;
inline constexpr int kClockStretches = 8;
/// Of gauges on the frames' own clock: no gauge and no USB line has a longer delay.
inline constexpr double kLongestDelayS = 0.8;

/// frames with times, ascending; gauge by time. `remarks` receives what was estimated or assumed.
/// Never fails: the clock is assumed where the motion does not determine it (too little motion,
/// ambiguous, R2 below 0.3, an sd above 50 ms).
[[nodiscard]] GaugeClock estimate_gauge_clock(const std::vector<MarkerFrame>& frames,
                                              const ForceGauge& gauge,
                                              const CollectOptions& options,
                                              std::vector<Message>& remarks);

}  // namespace alltact
