// Normal random numbers for full rows of pixels, as a pure function of stream name and position.
#pragma once

#include <cstdint>
#include <string_view>

namespace alltact {

/// Draws from one effect's stream. The first object builds a table of 64 Ki quantiles (once a
/// program).
class RowNoise {
 public:
  explicit RowNoise(std::string_view stream);

  /// n numbers of mean 0 and standard deviation 1 (at most 4.2 from 0) for one row of one frame.
  void normals(std::uint64_t seed, int frame, int row, int n, float* out) const;

 private:
  std::uint32_t stream_;
};

}  // namespace alltact
