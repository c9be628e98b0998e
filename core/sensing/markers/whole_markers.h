// Markers found in a reduced picture, where they lie in the whole one.
#pragma once

#include "core/camera/reduced_picture.h"
#include "core/sensing/markers/dot.h"

namespace alltact {

/// `by`: pixels a side in one of theirs.
[[nodiscard]] inline Markers whole_markers(Markers markers, int by) {
  for (Marker& marker : markers)
    marker = {whole_px(marker.u, by), whole_px(marker.v, by), marker.seen, marker.sd_px * by};
  return markers;
}

}  // namespace alltact
