#include "core/sensing/reference_picture.h"

#include "core/numerics/blocks.h"
#include "core/numerics/dispatch.h"
#include "core/sensing/grey_steps.h"
#include "core/sensing/picture_pool.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace alltact {
namespace {

constexpr int kWeightBits = 14;  // weights reach 2
constexpr double kMostWeight = 3.0;

// (grey 2^7) (weight 2^14) / 2^15 = grey weight 2^6. Sums may wrap around on the way: what comes
// out in the end fits.
ALLTACT_WIDE void mix_rows(const std::uint8_t* const* rows,
                           const std::int16_t* weights,
                           int count,
                           int n,
                           std::int16_t* __restrict out) {
  constexpr int kFactor = 1 << 7;
  static_assert(kGreySteps << (15 - kWeightBits) == kFactor);
  in_blocks(
      n, [=](int first, auto size) __attribute__((always_inline)) {
        // Widened in a loop of its own: inside the sum the compiler would carry 32-bit numbers.
        std::array<std::int16_t, kBlock> sum, wide;
        for (int i = 0; i < size; ++i) sum[static_cast<std::size_t>(i)] = 0;
        for (int k = 0; k < count; ++k) {
          const std::uint8_t* grey = rows[k] + first;
          const std::int16_t weight = weights[k];
          for (int i = 0; i < size; ++i)
            wide[static_cast<std::size_t>(i)] = static_cast<std::int16_t>(grey[i] * kFactor);
          for (int i = 0; i < size; ++i) {
            std::int16_t& here = sum[static_cast<std::size_t>(i)];
            here =
                static_cast<std::int16_t>(here + times(wide[static_cast<std::size_t>(i)], weight));
          }
        }
        for (int i = 0; i < size; ++i) out[first + i] = sum[static_cast<std::size_t>(i)];
      });
}

// Rounded so that they still sum to 1: what is left over goes to the largest.
std::vector<std::int16_t> whole_weights(const std::vector<float>& weights) {
  constexpr double kOne = 1 << kWeightBits;
  std::vector<std::int16_t> whole(weights.size());
  double left = kOne, magnitude = 0;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    const double weight = static_cast<double>(weights[i]);
    whole[i] = static_cast<std::int16_t>(std::clamp(std::round(kOne * weight), -32767.0, 32767.0));
    left -= whole[i];
    magnitude += std::abs(weight);
  }
  CV_Assert(magnitude <= kMostWeight && std::abs(left) < 0.01 * kOne);
  std::int16_t& largest = *std::max_element(whole.begin(), whole.end());
  largest = static_cast<std::int16_t>(std::min(largest + left, 32767.0));
  return whole;
}

}  // namespace

ReferencePicture::ReferencePicture(const cv::Mat& grey)
    : single_(grey.size(), CV_16SC1), size_(grey.size()) {
  CV_Assert(grey.type() == CV_32FC1);
  for (int v = 0; v < grey.rows; ++v)
    std::transform(
        grey.ptr<float>(v), grey.ptr<float>(v) + grey.cols, single_.ptr<std::int16_t>(v), to_steps);
}

ReferencePicture::ReferencePicture(std::shared_ptr<const void> owner,
                                   std::vector<const FacePicture*> faces,
                                   const std::vector<float>& weights,
                                   const cv::Size& size)
    : owner_(std::move(owner)),
      faces_(std::move(faces)),
      weights_(whole_weights(weights)),
      size_(size) {
  CV_Assert(!faces_.empty() && faces_.size() == weights.size());
}

cv::Mat ReferencePicture::grey() const {
  if (size_.empty()) return {};
  cv::Mat grey = pooled_picture(size_, CV_32FC1);
  Reader reader(*this);
  const auto level = [](std::int16_t steps) {
    return steps == kNoGrey ? std::numeric_limits<float>::quiet_NaN()
                            : static_cast<float>(steps) / static_cast<float>(kGreySteps);
  };
  for (int v = 0; v < size_.height; ++v) {
    const std::int16_t* row = reader.row(v);
    std::transform(row, row + size_.width, grey.ptr<float>(v), level);
  }
  return grey;
}

ReferencePicture::Reader::Reader(const ReferencePicture& picture)
    : picture_(picture),
      cursors_(picture.faces_.size()),
      rows_(picture.weights_.size()),
      buffer_(static_cast<std::size_t>(picture.size_.width)) {}

void ReferencePicture::Reader::fetch_ahead(int count) {
  // Eight faces come from eight places, a page or less at a time: too many and too short for the
  // processor to see them coming. What a row needs is asked for while the one before is mixed.
  constexpr int kLine = 64;
  for (std::size_t k = 0; k < cursors_.size(); ++k) {
    const std::vector<std::uint8_t>& grey = picture_.faces_[k]->grey;
    const std::uint8_t* end = grey.data() + grey.size();
    const std::uint8_t* next = rows_[k] + count;
    for (int i = 0; i < count && next + i < end; i += kLine) __builtin_prefetch(next + i);
  }
}

void ReferencePicture::Reader::mix(int first, int end) {
  for (std::size_t k = 0; k < rows_.size(); ++k) rows_[k] = cursors_[k].at(first);
  fetch_ahead(end - first);
  mix_rows(rows_.data(),
           picture_.weights_.data(),
           static_cast<int>(rows_.size()),
           end - first,
           buffer_.data() + first);
}

const std::int16_t* ReferencePicture::Reader::row(int v) {
  if (!picture_.single_.empty()) return picture_.single_.ptr<std::int16_t>(v);
  for (std::size_t k = 0; k < cursors_.size(); ++k) {
    const FacePicture& face = *picture_.faces_[k];
    const auto runs = face.face.of_row(v);
    cursors_[k] = {runs.data(), runs.data() + runs.size(), face.grey.data()};
  }
  // Stretches that every face shows, one after the other.
  int written = 0;
  for (bool more = true; more;) {
    int first = 0, end = std::numeric_limits<int>::max();
    std::size_t ends_first = 0;
    for (std::size_t k = 0; k < cursors_.size() && more; ++k) {
      more = cursors_[k].run != cursors_[k].end;
      if (!more) break;
      first = std::max(first, cursors_[k].run->first);
      if (cursors_[k].run->end < end) end = cursors_[k].run->end, ends_first = k;
    }
    if (more && first < end) {
      std::fill_n(buffer_.data() + written, first - written, kNoGrey);
      mix(first, end);
      written = end;
    }
    if (more) ++cursors_[ends_first].run;
  }
  std::fill_n(buffer_.data() + written, picture_.size_.width - written, kNoGrey);
  return buffer_.data();
}

}  // namespace alltact
