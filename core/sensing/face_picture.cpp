#include "core/sensing/face_picture.h"

#include "core/numerics/dispatch.h"

#include <cstring>

namespace alltact {
namespace {

// out += the weighted sum of four rows at a time: one pass over `out` for each four frames.
ALLTACT_WIDE void add_rows(
    const std::uint8_t* const* rows, const float* weights, int count, int n, float* out) {
  int k = 0;
  for (; k + 4 <= count; k += 4) {
    const std::uint8_t *a = rows[k], *b = rows[k + 1], *c = rows[k + 2], *d = rows[k + 3];
    const float wa = weights[k], wb = weights[k + 1], wc = weights[k + 2], wd = weights[k + 3];
    for (int i = 0; i < n; ++i)
      out[i] += (wa * static_cast<float>(a[i]) + wb * static_cast<float>(b[i])) +
                (wc * static_cast<float>(c[i]) + wd * static_cast<float>(d[i]));
  }
  for (; k < count; ++k) {
    const std::uint8_t* a = rows[k];
    const float wa = weights[k];
    for (int i = 0; i < n; ++i) out[i] += wa * static_cast<float>(a[i]);
  }
}

// Where one row's pixels of every frame are, walked along run by run.
struct Cursor {
  const FacePicture* frame = nullptr;
  std::size_t run = 0, end = 0;  // of the row

  [[nodiscard]] const FaceRun& current() const { return frame->runs[run]; }
  [[nodiscard]] const std::uint8_t* at(int column) const {
    return frame->grey.data() + frame->offsets[run] + (column - current().first);
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
      const FaceRun& run = cursors[k].current();
      first = std::max(first, run.first);
      if (run.end < end) end = run.end, ends_first = k;
    }
    if (first < end) visit(first, end);
    ++cursors[ends_first].run;
  }
}

}  // namespace

FacePicture keep_face(const cv::Mat& grey, const FaceShape& shape, double margin_px) {
  const int width = std::min(grey.cols, shape.width_px());
  std::vector<FaceShape::Rows> rows(static_cast<std::size_t>(width));
  for (int u = 0; u < width; ++u) {
    auto& r = rows[static_cast<std::size_t>(u)] = shape.rows(u, margin_px);
    r.first = std::max(r.first, 0);
    r.last = std::min(r.last, grey.rows - 1);
  }
  FacePicture face;
  face.row_begin.push_back(0);
  for (int v = 0; v < grey.rows; ++v) {
    for (int u = 0; u < width;) {
      const auto shows = [&](int c) {
        const auto& r = rows[static_cast<std::size_t>(c)];
        return v >= r.first && v <= r.last;
      };
      while (u < width && !shows(u)) ++u;
      const int first = u;
      while (u < width && shows(u)) ++u;
      if (first == u) break;
      face.runs.push_back({v, first, u});
      face.offsets.push_back(face.grey.size());
      const std::uint8_t* row = grey.ptr<std::uint8_t>(v);
      face.grey.insert(face.grey.end(), row + first, row + u);
    }
    face.row_begin.push_back(face.runs.size());
  }
  face.grey.shrink_to_fit();
  face.runs.shrink_to_fit();
  face.offsets.shrink_to_fit();
  return face;
}

void mix_faces(const std::vector<const FacePicture*>& frames,
               const std::vector<float>& weights,
               const cv::Size& size,
               cv::Mat& grey,
               cv::Mat& valid) {
  // A picture that somebody else holds is theirs to keep.
  if (grey.u && grey.u->refcount > 1) grey.release();
  if (valid.u && valid.u->refcount > 1) valid.release();
  grey.create(size, CV_32FC1);
  valid.create(size, CV_8UC1);
  std::vector<Cursor> cursors(frames.size());
  std::vector<const std::uint8_t*> rows(frames.size());
  for (int v = 0; v < size.height; ++v) {
    auto* out = grey.ptr<float>(v);
    auto* mask = valid.ptr<std::uint8_t>(v);
    std::memset(out, 0, sizeof(float) * static_cast<std::size_t>(size.width));
    std::memset(mask, 0, static_cast<std::size_t>(size.width));
    for (std::size_t k = 0; k < frames.size(); ++k) {
      const auto row = static_cast<std::size_t>(v);
      cursors[k] = {frames[k], frames[k]->row_begin[row], frames[k]->row_begin[row + 1]};
    }
    for_common_stretches(cursors, [&](int first, int end) {
      for (std::size_t k = 0; k < cursors.size(); ++k) rows[k] = cursors[k].at(first);
      add_rows(
          rows.data(), weights.data(), static_cast<int>(rows.size()), end - first, out + first);
      std::memset(mask + first, 255, static_cast<std::size_t>(end - first));
    });
  }
}

}  // namespace alltact
