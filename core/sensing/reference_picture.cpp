#include "core/sensing/reference_picture.h"

#include "core/numerics/dispatch.h"
#include "core/sensing/picture_pool.h"

#include <algorithm>
#include <limits>

namespace alltact {
namespace {

// out = the weighted sum of up to four rows, or that added to what out holds: one pass over `out`
// for each four frames.
template <bool kFirst>
[[gnu::always_inline]] inline void four_rows(const std::uint8_t* const* rows,
                                             const float* weights,
                                             int n,
                                             float* __restrict out) {
  const std::uint8_t *a = rows[0], *b = rows[1], *c = rows[2], *d = rows[3];
  const float wa = weights[0], wb = weights[1], wc = weights[2], wd = weights[3];
  for (int i = 0; i < n; ++i) {
    const float sum = (wa * static_cast<float>(a[i]) + wb * static_cast<float>(b[i])) +
                      (wc * static_cast<float>(c[i]) + wd * static_cast<float>(d[i]));
    out[i] = kFirst ? sum : out[i] + sum;
  }
}

// The weighted sum of `count` rows, a multiple of four.
ALLTACT_WIDE void mix_rows(
    const std::uint8_t* const* rows, const float* weights, int count, int n, float* out) {
  four_rows<true>(rows, weights, n, out);
  for (int k = 4; k < count; k += 4) four_rows<false>(rows + k, weights + k, n, out);
}

}  // namespace

ReferencePicture::ReferencePicture(cv::Mat grey) : single_(std::move(grey)), size_(single_.size()) {
  CV_Assert(single_.type() == CV_32FC1);
}

ReferencePicture::ReferencePicture(std::shared_ptr<const void> owner,
                                   std::vector<const FacePicture*> faces,
                                   std::vector<float> weights,
                                   const cv::Size& size)
    : owner_(std::move(owner)),
      faces_(std::move(faces)),
      weights_(std::move(weights)),
      size_(size) {
  CV_Assert(!faces_.empty() && faces_.size() == weights_.size());
  weights_.resize((weights_.size() + 3) / 4 * 4, 0.0F);
}

cv::Mat ReferencePicture::grey() const {
  if (!single_.empty() || size_.empty()) return single_;
  cv::Mat grey = pooled_picture(size_, CV_32FC1);
  Reader reader(*this);
  for (int v = 0; v < size_.height; ++v)
    std::copy_n(reader.row(v), size_.width, grey.ptr<float>(v));
  return grey;
}

ReferencePicture::Reader::Reader(const ReferencePicture& picture)
    : picture_(picture),
      cursors_(picture.faces_.size()),
      rows_(picture.weights_.size()),
      buffer_(static_cast<std::size_t>(picture.size_.width)) {}

void ReferencePicture::Reader::mix(int first, int end) {
  // What fills the weights up is any row at all.
  for (std::size_t k = 0; k < rows_.size(); ++k)
    rows_[k] = cursors_[std::min(k, cursors_.size() - 1)].at(first);
  mix_rows(rows_.data(),
           picture_.weights_.data(),
           static_cast<int>(rows_.size()),
           end - first,
           buffer_.data() + first);
}

const float* ReferencePicture::Reader::row(int v) {
  if (!picture_.single_.empty()) return picture_.single_.ptr<float>(v);
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
      fill_nan(buffer_.data() + written, first - written);
      mix(first, end);
      written = end;
    }
    if (more) ++cursors_[ends_first].run;
  }
  fill_nan(buffer_.data() + written, picture_.size_.width - written);
  return buffer_.data();
}

}  // namespace alltact
