// Converts markers of a reduced image to the full-size image.
#pragma once

#include "core/camera/reduced_image.h"
#include "core/sensing/markers/dot.h"

namespace alltact {

/// `by`: full-size pixels a side of one reduced pixel.
[[nodiscard]] inline Markers full_size_markers(Markers markers, int by) {
  for (Marker& marker : markers)
    marker = {full_px(marker.u, by), full_px(marker.v, by), marker.seen, marker.sd_px * by};
  return markers;
}

}  // namespace alltact
