// Where the markers of a recording's frames are: what is kept beside its video.
#pragma once

#include "core/result.h"
#include "core/sensing/markers/markers.h"

#include <filesystem>
#include <vector>

#include <Eigen/Core>

namespace alltact {

/// Marker table of a recording (reference.csv). First a line of column names, then one line a
/// marker of `frame,number,u,v,seen,radius,contrast` (px, grey levels; the last two typical of the
/// marker and the same in every frame), all markers of a frame together in the order of their
/// numbers. The last line, `end,FRAMES`, tells a whole table from one that was cut off.
struct MarkerTable {
  std::vector<int> frames;  ///< number of each row in the video, ascending
  Eigen::MatrixXd layouts;  ///< one row a frame, (u0, v0, ...), px, estimates where not seen
  std::vector<std::vector<char>> seen;  ///< one row a frame, by marker
  std::vector<Dot> typical;  ///< mean radius and contrast of each marker, at its mean position

  /// Strict: any line that is not as above is an error that names it.
  static Result<MarkerTable> load(const std::filesystem::path& file, int marker_count);
  [[nodiscard]] Status save(const std::filesystem::path& file) const;
};

/// Only some of its rows.
[[nodiscard]] MarkerTable rows_of(const MarkerTable& table, const std::vector<std::size_t>& rows);

/// Of the same recording reduced by `by` pixels a side (reduced_picture.h).
[[nodiscard]] MarkerTable reduced_table(MarkerTable table, int by);

/// A row of layouts (u0, v0, ...) as markers, with the uncertainty that recorded ones have.
[[nodiscard]] Markers markers_of(const Eigen::MatrixXd& layouts,
                                 Eigen::Index row,
                                 const std::vector<char>& seen);

}  // namespace alltact
