// One edge of the face along the full image, followed from its clearest sample.
#pragma once

#include "core/sensing/face/edge_reader.h"
#include "core/sensing/face/face_edges.h"
#include "core/sensing/face/rough_edges.h"

#include <vector>

namespace alltact {

/// Follows the edge from the sample of highest contrast. Further seeds are tried where that edge
/// covers only a part of the image or has gaps, as borders of dots have. The rough path alone may
/// leave the face for the outer border of a side face where that has more contrast. Dots next to
/// the edge are corrected for, and strays beyond its ends are removed. path: of this edge, from
/// `rough`; columns: of the samples (FaceEdges::u).
[[nodiscard]] Edge find_edge(const EdgeReader& reader,
                             const RoughEdges& rough,
                             const RoughEdges::Path& path,
                             const std::vector<double>& columns);

}  // namespace alltact
