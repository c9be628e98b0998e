#include "core/sensing/face_picture.h"

#include "core/numerics/dispatch.h"
#include "core/sensing/picture_pool.h"

#include <algorithm>

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

// Where one row's pixels of every frame are, walked along run by run.
struct Cursor {
  const FaceRun* run = nullptr;
  const FaceRun* end = nullptr;  // of the row
  const std::uint8_t* grey = nullptr;

  [[nodiscard]] const std::uint8_t* at(int column) const {
    return grey + run->before + (column - run->first);
  }
};

// Stretches of the row that every frame shows, one after the other.
template <class Visit>
void for_common_stretches(std::vector<Cursor>& cursors, Visit visit) {
  for (;;) {
    int first = 0, end = std::numeric_limits<int>::max();
    std::size_t ends_first = 0;
    for (std::size_t k = 0; k < cursors.size(); ++k) {
      if (cursors[k].run == cursors[k].end) return;
      const FaceRun& run = *cursors[k].run;
      first = std::max(first, run.first);
      if (run.end < end) end = run.end, ends_first = k;
    }
    if (first < end) visit(first, end);
    ++cursors[ends_first].run;
  }
}

}  // namespace

FacePicture keep_face(const cv::Mat& grey, const FaceShape& shape, double margin_px) {
  FacePicture picture{face_runs(shape, margin_px, grey.size()), {}};
  picture.grey.reserve(picture.face.pixels());
  for (const FaceRun& run : picture.face.runs) {
    const std::uint8_t* row = grey.ptr<std::uint8_t>(run.row);
    picture.grey.insert(picture.grey.end(), row + run.first, row + run.end);
  }
  return picture;
}

cv::Mat mix_faces(const std::vector<const FacePicture*>& frames,
                  const std::vector<float>& weights,
                  const cv::Size& size) {
  cv::Mat grey = pooled_picture(size, CV_32FC1);
  // Filled up with the last frame at weight 0.
  const std::size_t padded = (frames.size() + 3) / 4 * 4;
  std::vector<float> all_weights(weights);
  all_weights.resize(padded, 0.0F);
  std::vector<const std::uint8_t*> rows(padded);
  std::vector<Cursor> cursors(frames.size());
  for (int v = 0; v < size.height; ++v) {
    auto* out = grey.ptr<float>(v);
    for (std::size_t k = 0; k < frames.size(); ++k) {
      const auto runs = frames[k]->face.of_row(v);
      cursors[k] = {runs.data(), runs.data() + runs.size(), frames[k]->grey.data()};
    }
    int written = 0;
    for_common_stretches(cursors, [&](int first, int end) {
      for (std::size_t k = 0; k < padded; ++k)
        rows[k] = cursors[std::min(k, cursors.size() - 1)].at(first);
      fill_nan(out + written, first - written);
      mix_rows(rows.data(), all_weights.data(), static_cast<int>(padded), end - first, out + first);
      written = end;
    });
    fill_nan(out + written, size.width - written);
  }
  return grey;
}

}  // namespace alltact
