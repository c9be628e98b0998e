// Marker positions in the frames of a recording, stored in a file next to its video.
#pragma once

#include "core/base/result.h"
#include "core/sensing/markers/markers.h"

#include <filesystem>
#include <vector>

#include <Eigen/Core>

namespace alltact {

/// Marker table of a recording (reference.csv). First a line of column names, then one line per
/// marker, `frame,number,u,v,seen,radius,contrast` (px, grey levels). The last two are typical of
/// the marker and the same in every frame. All markers of a frame stand together in the order of
/// their numbers. The last line, `end,FRAMES`, distinguishes a complete table from one that was cut
/// off.
struct MarkerTable {
  std::vector<int> frames;  ///< number of each row in the video, ascending
  Eigen::MatrixXd layouts;  ///< one row per frame, (u0, v0, ...), px, estimates where not seen
  std::vector<std::vector<char>> seen;  ///< one row per frame, by marker
  std::vector<Dot> typical;  ///< mean radius and contrast of each marker, at its mean position

  /// Strict: any line that does not match is an error that names it.
  static Result<MarkerTable> load(const std::filesystem::path& file, int marker_count);
  [[nodiscard]] Status save(const std::filesystem::path& file) const;
};

/// A table of the given rows only.
[[nodiscard]] MarkerTable rows_of(const MarkerTable& table, const std::vector<std::size_t>& rows);

/// The table of the same recording reduced by `by` pixels a side.
[[nodiscard]] MarkerTable reduced_table(MarkerTable table, int by);

/// A row of layouts (u0, v0, ...) as markers, with the uncertainty of recorded ones.
[[nodiscard]] Markers markers_of(const Eigen::MatrixXd& layouts, Eigen::Index row,
                                 const std::vector<char>& seen);

}  // namespace alltact
