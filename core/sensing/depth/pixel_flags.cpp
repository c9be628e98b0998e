#include "core/sensing/depth/pixel_flags.h"

#include "core/numerics/blocks.h"
#include "core/numerics/dispatch.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace alltact {
namespace {

constexpr int kMaxAtOnce = 255 * kBlock;  // more would overflow the counts of single bytes

ALLTACT_WIDE int count_of(const std::uint8_t* flags, int count, std::uint8_t flag) {
  std::array<std::uint8_t, kBlock> found{};  // by lane of a block
  int u = 0;
  for (; u + kBlock <= count; u += kBlock)
    for (std::size_t k = 0; k < kBlock; ++k)
      found[k] =
          static_cast<std::uint8_t>(found[k] + (flags[static_cast<std::size_t>(u) + k] == flag));
  int all = std::accumulate(found.begin(), found.end(), 0);
  for (; u < count; ++u) all += flags[u] == flag ? 1 : 0;
  return all;
}

}  // namespace

FlagFractions flag_fractions(const cv::Mat& flags, int every_row) {
  CV_Assert(flags.type() == CV_8UC1);
  std::array<double, kPixelFlagCount> counts{};
  for (int v = every_row / 2; v < flags.rows; v += every_row)
    for (int u = 0; u < flags.cols; u += kMaxAtOnce)
      for (std::size_t k = 0; k < counts.size(); ++k)
        counts[k] += count_of(flags.ptr<std::uint8_t>(v) + u,
                              std::min(kMaxAtOnce, flags.cols - u),
                              static_cast<std::uint8_t>(k));
  counts[kOffFace] = 0;
  double face = 0;
  for (const double count : counts) face += count;
  FlagFractions shares{};
  if (face > 0)
    for (std::size_t k = 0; k < counts.size(); ++k) shares.of[k] = counts[k] / face;
  return shares;
}

void flag_hidden(const std::vector<HiddenColumn>& columns, cv::Mat* flags) {
  CV_Assert(flags->type() == CV_8UC1);
  for (const HiddenColumn& column : columns) {
    const int first = std::max(0, static_cast<int>(std::ceil(column.upper_v)));
    const int last = std::min(flags->rows - 1, static_cast<int>(std::floor(column.lower_v)));
    for (int v = first; v <= last; ++v) {
      std::uint8_t& flag = flags->at<std::uint8_t>(v, column.u);
      if (flag == kOffFace) flag = kHiddenEnd;
    }
  }
}

}  // namespace alltact
