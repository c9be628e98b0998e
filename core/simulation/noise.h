// Normal random numbers for whole rows of pixels, as a pure function of who draws and where.
#pragma once

#include <cstdint>
#include <string_view>

namespace alltact {

/// Draws under one effect's name. Making one builds a table of 64 Ki quantiles (once a program).
class RowNoise {
 public:
  explicit RowNoise(std::string_view who);

  /// n numbers of mean 0 and standard deviation 1 (at most 4.2 from 0) for one row of one frame.
  void normals(std::uint64_t seed, int frame, int row, int n, float* out) const;

 private:
  std::uint32_t who_;
};

}  // namespace alltact
