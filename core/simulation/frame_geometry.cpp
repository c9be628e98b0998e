#include "core/simulation/frame_geometry.h"

#include "core/numerics/dispatch.h"

#include <limits>

namespace alltact {

namespace {

// Directions tabulated for a camera with distortion: 0.0005 apart at most, so that linear
// interpolation stays within 1e-5 mm.
constexpr double kTableStep = 5e-4;
constexpr float kNoEdge = 1e30F;  // half width of a face that has no edges

// y of the face's points and what part of each pixel the face covers: exact along v, because the
// edges are straight within a pixel.
ALLTACT_WIDE void cover_row(int first,
                            int last,
                            float origin_y,
                            float direction_y,
                            float half_width,
                            const float* __restrict z,
                            const float* __restrict shift,
                            const float* __restrict per_mm,
                            const float* __restrict end,
                            float* __restrict y,
                            float* __restrict coverage) {
  for (int u = first; u < last; ++u) {
    y[u] = origin_y + direction_y * z[u];
    const float inside = (half_width - std::abs(y[u] - shift[u])) * per_mm[u] + 0.5F;
    const float part = std::min(std::max(inside, 0.0F), 1.0F);
    coverage[u] = part * end[u];
  }
}

ALLTACT_WIDE void interpolate(int n,
                              const int* __restrict cell,
                              const float* __restrict part,
                              const float* __restrict table,
                              float* __restrict out) {
  for (int i = 0; i < n; ++i)
    out[i] = table[cell[i]] + part[i] * (table[cell[i] + 1] - table[cell[i]]);
}

}  // namespace

void FrameGeometry::Columns::resize(std::size_t n) {
  for (auto* array : {&x, &z, &sin, &cos, &luf, &shift, &s, &end, &per_mm, &normal_z, &zero})
    array->assign(n, 0.0F);
}

FrameGeometry::FrameGeometry(const PixelRays& rays,
                             const Face& face,
                             std::optional<FaceCurve> curve)
    : rays_(rays), face_(face), curve_(std::move(curve)) {
  const cv::Size size = rays.camera().size();
  if (!meets_columns()) return;
  if (rays.linear()) {
    columns_.resize(static_cast<std::size_t>(size.width));
    for (int u = 0; u < size.width; ++u)
      set_column(static_cast<std::size_t>(u), rays.origin_x(u), rays.direction_x(u));
    find_bands();
    return;
  }
  const auto [low, high] = rays.direction_x_range();
  const int cells = static_cast<int>((high - low) / kTableStep) + 3;
  table_per_direction_ = 1 / kTableStep;
  table_first_ = low - kTableStep;
  columns_.resize(static_cast<std::size_t>(cells) + 1);
  for (int i = 0; i <= cells; ++i)
    set_column(static_cast<std::size_t>(i), 0, table_first_ + i * kTableStep);
}

void FrameGeometry::set_column(std::size_t i, double origin_x, double direction_x) {
  FaceCurve::Node p;
  double s = 0, end = 1;
  if (curve_) {
    s = curve_->meet(origin_x, direction_x);
    const bool met = std::isfinite(s);
    // A direction that misses the face sees nothing; its numbers only have to be finite.
    if (!met) s = curve_->length_mm();
    p = curve_->at(s);
    const CameraParameters& camera = rays_.camera().parameters();
    const double px_u = rays_.camera().is_perspective() ? p.z_mm / camera.fx_px : camera.mm_per_px;
    const double s_per_px = px_u / std::max(0.02, p.x_s - direction_x * p.z_s);
    const double inside = std::min(s, curve_->length_mm() - s) / s_per_px + 0.5;
    end = met ? std::clamp(inside, 0.0, 1.0) : 0.0;
  } else {
    p.z_mm = face_.plane_z_mm;
    p.x_mm = s = origin_x + direction_x * p.z_mm;
  }
  columns_.x[i] = static_cast<float>(p.x_mm);
  columns_.z[i] = static_cast<float>(p.z_mm);
  columns_.sin[i] = static_cast<float>(p.z_s);
  columns_.cos[i] = static_cast<float>(p.x_s);
  columns_.luf[i] = static_cast<float>(face_.layer_mm / p.x_s);
  columns_.shift[i] = static_cast<float>(p.shift_mm);
  columns_.s[i] = static_cast<float>(s);
  columns_.end[i] = static_cast<float>(end);
  columns_.normal_z[i] = -columns_.cos[i];
  columns_.per_mm[i] = static_cast<float>(1 / rays_.camera().mm_per_px_at(p.z_mm));
}

// For each block of columns the rows between which the face can be, so that the rest is skipped.
void FrameGeometry::find_bands() {
  const int width = static_cast<int>(columns_.x.size());
  const PixelRays::RowRay ray_0 = rays_.row_ray(0);
  for (int from = 0; from < width; from += kBlock) {
    float top = kNoEdge, bottom = -kNoEdge;
    for (int u = from; u < std::min(from + kBlock, width); ++u) {
      const auto i = static_cast<std::size_t>(u);
      if (columns_.end[i] <= 0) continue;
      if (!curve_) {
        top = -1;
        bottom = static_cast<float>(rays_.camera().size().height);
        continue;
      }
      const auto half = static_cast<float>(face_.width_mm / 2);
      const float y_0 = ray_0.origin_y + ray_0.direction_y * columns_.z[i];
      top = std::min(top, (columns_.shift[i] - half - y_0) * columns_.per_mm[i] - 1);
      bottom = std::max(bottom, (columns_.shift[i] + half - y_0) * columns_.per_mm[i] + 1);
    }
    block_top_.push_back(top);
    block_bottom_.push_back(bottom);
  }
}

bool FrameGeometry::meets_columns() const {
  return rays_.are_simple() && !(curve_ && curve_->is_twisted());
}

void FrameGeometry::fill(RowView& row) const {
  const Surface face = meets_columns() ? fill_by_columns(row) : fill_by_rays(row);
  if (!layer_changes.empty()) {
    float* luf = row.scratch.floats();
    std::copy(
        row.face.luf_mm + row.face.first, row.face.luf_mm + row.face.last, luf + row.face.first);
    for (const auto& change : layer_changes) change->row(row.face, row.scratch, luf);
    row.face.luf_mm = luf;
  }
  row.surfaces.assign(1, face);
  row.hollow_mm = nullptr;
  fill_presses(row);
}

Surface FrameGeometry::fill_by_columns(RowView& row) const {
  if (rays_.linear())
    fill_linear(row);
  else
    fill_by_table(row);
  Surface face;
  face.first = row.face.first;
  face.last = row.face.last;
  face.x_mm = row.face.x_mm;
  face.y_mm = row.face.y_mm;
  face.z_mm = row.face.z_mm;
  face.normal_x = row.face.sin_incline;
  face.coverage = row.face.coverage;
  face.light = row.scratch.floats();
  std::fill(face.light + face.first, face.light + face.last, 1.0F);
  if (rays_.linear()) {
    face.normal_y = columns_.zero.data();
    face.normal_z = columns_.normal_z.data();
    return face;
  }
  float *zero = row.scratch.floats(), *normal_z = row.scratch.floats();
  for (int u = 0; u < row.width; ++u) {
    zero[u] = 0;
    normal_z[u] = -row.face.cos_incline[u];
  }
  face.normal_y = zero;
  face.normal_z = normal_z;
  return face;
}

void FrameGeometry::fill_linear(RowView& row) const {
  int first = -1, last = -1;
  for (std::size_t block = 0; block < block_top_.size(); ++block) {
    if (row.v < block_top_[block] || row.v > block_bottom_[block]) continue;
    if (first < 0) first = static_cast<int>(block) * kBlock;
    last = std::min(static_cast<int>(block + 1) * kBlock, row.width);
  }
  float *y = row.scratch.floats(), *coverage = row.scratch.floats();
  FaceRow& face = row.face;
  face.first = std::max(first, 0);
  face.last = std::max(last, face.first);
  face.x_mm = columns_.x.data();
  face.y_mm = y;
  face.z_mm = columns_.z.data();
  face.sin_incline = columns_.sin.data();
  face.cos_incline = columns_.cos.data();
  face.luf_mm = columns_.luf.data();
  face.shift_mm = columns_.shift.data();
  face.s_mm = columns_.s.data();
  face.coverage = coverage;
  const PixelRays::RowRay ray = rays_.row_ray(row.v);
  cover_row(face.first,
            face.last,
            ray.origin_y,
            ray.direction_y,
            curve_ ? static_cast<float>(face_.width_mm / 2) : kNoEdge,
            columns_.z.data(),
            columns_.shift.data(),
            columns_.per_mm.data(),
            columns_.end.data(),
            y,
            coverage);
}

void FrameGeometry::fill_by_table(RowView& row) const {
  const int n = row.width;
  std::vector<int> cell(static_cast<std::size_t>(n));
  float* part = row.scratch.floats();
  const int cells = static_cast<int>(columns_.x.size()) - 2;
  const RayRow rays = rays_.row(row.v, row.scratch);
  for (int u = 0; u < n; ++u) {
    const double at = (rays.direction_x[u] - table_first_) * table_per_direction_;
    cell[static_cast<std::size_t>(u)] = std::clamp(static_cast<int>(at), 0, cells);
    part[u] = static_cast<float>(at - cell[static_cast<std::size_t>(u)]);
  }
  const auto column = [&](const std::vector<float>& table) {
    float* out = row.scratch.floats();
    interpolate(n, cell.data(), part, table.data(), out);
    return out;
  };
  FaceRow& face = row.face;
  face.first = 0;
  face.last = n;
  face.x_mm = column(columns_.x);
  const float* z = face.z_mm = column(columns_.z);
  face.sin_incline = column(columns_.sin);
  face.cos_incline = column(columns_.cos);
  face.luf_mm = column(columns_.luf);
  face.shift_mm = column(columns_.shift);
  face.s_mm = column(columns_.s);
  const float* end = column(columns_.end);
  float *y = row.scratch.floats(), *coverage = row.scratch.floats();
  const float half = curve_ ? static_cast<float>(face_.width_mm / 2) : kNoEdge;
  for (int u = 0; u < n; ++u) {
    y[u] = rays.direction_y[u] * z[u];
    const float step = rays.step_y[u] * z[u];
    const float inside = (half - std::abs(y[u] - face.shift_mm[u])) / step + 0.5F;
    coverage[u] = std::clamp(inside, 0.0F, 1.0F) * end[u];
  }
  face.y_mm = y;
  face.coverage = coverage;
}

void FrameGeometry::fill_presses(RowView& row) const {
  row.press_first = row.press_last = 0;
  if (presses.empty()) return;
  const FaceRow& face = row.face;
  float* depth = row.scratch.floats();
  std::fill(depth + face.first, depth + face.last, 0.0F);
  int first = face.last, last = face.first;
  for (const auto& press : presses) {
    int from = face.first, to = face.last;
    const auto reach = static_cast<float>(std::visit(
        [](const auto& p) { return 1.1 * p.reach_mm() + 2 * p.place.depth_mm + 1; }, press));
    const auto s_0 =
        static_cast<float>(std::visit([](const auto& p) { return p.place.s_mm; }, press));
    while (from < to && std::abs(face.s_mm[from] - s_0) > reach) ++from;
    while (to > from && std::abs(face.s_mm[to - 1] - s_0) > reach) --to;
    if (from >= to) continue;
    std::visit([&](const auto& p) { press_row(p, face, from, to, depth); }, press);
    first = std::min(first, from);
    last = std::max(last, to);
  }
  if (first >= last) return;
  row.press_first = first;
  row.press_last = last;
  row.press_depth_mm = depth;
}

}  // namespace alltact
