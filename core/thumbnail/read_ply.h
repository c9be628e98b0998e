// Meshes as PLY, of any program.
#pragma once

#include "core/io/triangles.h"

#include <optional>
#include <string_view>

namespace alltact {

/// PLY (Turk, "The PLY polygon file format", 1994), as text or binary of either byte order: of the
/// element `vertex` x, y, z and, where there is one, depth_mm, of `face` the polygons, each cut
/// into triangles around its first corner (right for convex ones). Everything else is passed over.
/// Reading ends after the first face beyond `most_triangles`, so that more of them come back than
/// that. nullopt: the header is none, the data end before all is there that it tells of, a
/// polygon has more than 2^20 corners, or there are more than 3 `most_triangles` points. Corners
/// and coordinates are as they lie in the file: whether a corner's point is there, and finite, is
/// the caller's to check.
[[nodiscard]] std::optional<Triangles> read_ply(std::string_view bytes, std::size_t most_triangles);

}  // namespace alltact
