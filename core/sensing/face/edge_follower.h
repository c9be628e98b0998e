// One edge of the face along the whole picture, followed from where it is plainest.
#pragma once

#include "core/sensing/face/edge_reader.h"
#include "core/sensing/face/face_edges.h"
#include "core/sensing/face/rough_edges.h"

#include <vector>

namespace alltact {

/// Follows the edge from the sample of most contrast; from the next, some way off, where that leads
/// along only a part of the picture or leaves gaps, as dots' own borders do. The rough path alone
/// may leave the face for a side face's outer border where that has more contrast. Dots beside the
/// edge are kept from drawing it, and strays beyond its ends are left out. path: that edge's of
/// `rough`; columns: of the samples (FaceEdges::u).
[[nodiscard]] Edge find_edge(const EdgeReader& reader,
                             const RoughEdges& rough,
                             const RoughEdges::Path& path,
                             const std::vector<double>& columns);

}  // namespace alltact
