// Views and boards that are outliers, and why.
#pragma once

#include "calibration/lens/lens_fit.h"
#include "core/message.h"

#include <vector>

namespace alltact {

struct OutlierView {
  std::size_t index = 0;
  Message reason;
};

/// Views in which more than a quarter of the corners are outliers, or that scatter 2.5 times as
/// much as the median view, in order of their index.
[[nodiscard]] std::vector<OutlierView> outlier_views(const std::vector<BoardView>& views,
                                                     const LensFit& fit);

/// Fits again with a board that may be stretched and bent. Returns the board's defect in words;
/// empty when there is none, and with fewer than six views.
[[nodiscard]] Message board_problem(const std::vector<BoardView>& views,
                                    const LensFit& fit,
                                    const LensFitOptions& options,
                                    const Job& job);

}  // namespace alltact
