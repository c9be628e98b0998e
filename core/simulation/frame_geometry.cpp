#include "core/simulation/frame_geometry.h"

#include "core/numerics/dispatch.h"
#include "core/simulation/ruled_surface.h"

#include <algorithm>
#include <limits>

#include <opencv2/imgproc.hpp>

namespace alltact {
namespace {

// Directions tabulated for a camera with distortion: 0.0005 apart at most, so that linear
// interpolation stays within 1e-5 mm.
constexpr double kTableStep = 5e-4;
constexpr float kNoEdge = 1e30F;  // half width of a face without edges

// y of the face's points and each pixel's coverage: exact along v, because the edges are straight
// within a pixel.
ALLTACT_WIDE void cover_row(int first, int last, float origin_y, float direction_y,
                            float half_width, const float* __restrict z,
                            const float* __restrict shift, const float* __restrict per_mm,
                            const float* __restrict end, float* __restrict y,
                            float* __restrict coverage, float* __restrict light) {
  for (int u = first; u < last; ++u) {
    y[u] = origin_y + direction_y * z[u];
    const float inside = (half_width - std::abs(y[u] - shift[u])) * per_mm[u] + 0.5F;
    const float part = std::min(std::max(inside, 0.0F), 1.0F);
    coverage[u] = part * end[u];
    light[u] = 1.0F;
  }
}

ALLTACT_WIDE void set_all(int n, int value, int* __restrict numbers) {
  for (int i = 0; i < n; ++i) numbers[i] = value;
}

ALLTACT_WIDE void interpolate(int n, const int* __restrict cell, const float* __restrict part,
                              const float* __restrict table, float* __restrict out) {
  for (int i = 0; i < n; ++i)
    out[i] = table[cell[i]] + part[i] * (table[cell[i] + 1] - table[cell[i]]);
}

}  // namespace

void FrameGeometry::Columns::resize(std::size_t n) {
  for (auto* array : {&x, &z, &sin, &cos, &luf, &shift, &s, &end, &per_mm, &normal_z, &zero})
    array->assign(n, 0.0F);
}

FrameGeometry::FrameGeometry(const PixelRays& rays, const Face& face,
                             std::optional<FaceCurve> curve)
    : rays_(rays), face_(face), curve_(std::move(curve)) {
  const cv::Size size = rays.camera().size();
  if (!is_column_wise()) return;
  if (rays.linear()) {
    std::vector<double> origins, directions;
    for (int u = 0; u < size.width; ++u) {
      origins.push_back(rays.origin_x(u));
      directions.push_back(rays.direction_x(u));
    }
    set_columns(origins, directions);
    find_bands();
    return;
  }
  const auto [low, high] = rays.direction_x_range();
  const int cells = static_cast<int>((high - low) / kTableStep) + 3;
  table_per_direction_ = 1 / kTableStep;
  table_first_ = low - kTableStep;
  const auto n = static_cast<std::size_t>(cells) + 1;
  std::vector<double> directions;
  for (std::size_t i = 0; i < n; ++i)
    directions.push_back(table_first_ + static_cast<double>(i) * kTableStep);
  set_columns(std::vector<double>(n, 0.0), directions);
}

void FrameGeometry::set_columns(const std::vector<double>& origin_x,
                                const std::vector<double>& direction_x) {
  const std::size_t n = direction_x.size();
  columns_.resize(n);
  FaceCurve::Node p;
  if (!curve_) {
    p.z_mm = face_.plane_z_mm;
    for (std::size_t i = 0; i < n; ++i) {
      p.x_mm = origin_x[i] + direction_x[i] * p.z_mm;
      set_column(i, direction_x[i], p.x_mm, p);
    }
    return;
  }
  const FaceCurve::Intersections hit = curve_->intersect_all(origin_x, direction_x);
  for (std::size_t i = 0; i < n; ++i) {
    p.x_mm = hit.x_mm[i], p.z_mm = hit.z_mm[i];
    p.x_s = hit.x_s[i], p.z_s = hit.z_s[i];
    p.shift_mm = hit.shift_mm[i];
    set_column(i, direction_x[i], hit.s_mm[i], p);
  }
}

void FrameGeometry::set_column(std::size_t i, double direction_x, double s,
                               const FaceCurve::Node& p) {
  double end = 1;
  if (curve_) {
    const bool hit = std::isfinite(s);
    const CameraParameters& camera = rays_.camera().parameters();
    const double px_u = rays_.camera().is_perspective() ? p.z_mm / camera.fx_px : camera.mm_per_px;
    const double s_per_px = px_u / std::max(0.02, p.x_s - direction_x * p.z_s);
    const double inside = std::min(s, curve_->length_mm() - s) / s_per_px + 0.5;
    // A direction that misses the face has no coverage; its numbers only have to be finite.
    end = hit ? std::clamp(inside, 0.0, 1.0) : 0.0;
    if (!hit) s = kNoHit_mm;
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

// The column blocks that the face can cover in each row; the others are skipped.
void FrameGeometry::find_bands() {
  const int width = static_cast<int>(columns_.x.size());
  const auto height = static_cast<std::size_t>(rays_.camera().size().height);
  row_first_.assign(height, 0);
  row_last_.assign(height, 0);
  const auto half = static_cast<float>(face_.width_mm / 2);
  const PixelRays::RowRay ray_0 = rays_.row_ray(0);
  std::vector<float> block_top, block_bottom;
  for (int from = 0; from < width; from += kBlock) {
    float top = kNoEdge, bottom = -kNoEdge;
    for (int u = from; u < std::min(from + kBlock, width); ++u) {
      const auto i = static_cast<std::size_t>(u);
      if (columns_.end[i] <= 0) continue;
      if (!curve_) {
        top = -1;
        bottom = static_cast<float>(height);
        continue;
      }
      const float y_0 = ray_0.origin_y + ray_0.direction_y * columns_.z[i];
      top = std::min(top, (columns_.shift[i] - half - y_0) * columns_.per_mm[i] - 1);
      bottom = std::max(bottom, (columns_.shift[i] + half - y_0) * columns_.per_mm[i] + 1);
    }
    block_top.push_back(top);
    block_bottom.push_back(bottom);
  }
  // The last block that reaches a row sets its end last, the first one its beginning.
  const auto set_rows = [&](std::size_t block, std::vector<int>& rows, int u) {
    const auto row_at = [&](float v) {
      return static_cast<std::ptrdiff_t>(std::clamp(v, 0.0F, static_cast<float>(height)));
    };
    const auto top = row_at(std::ceil(block_top[block]));
    const auto end = row_at(std::floor(block_bottom[block]) + 1);
    if (top < end) set_all(static_cast<int>(end - top), u, rows.data() + top);
  };
  const std::size_t blocks = block_top.size();
  for (std::size_t i = 0; i < blocks; ++i)
    set_rows(i, row_last_, std::min(static_cast<int>(i + 1) * kBlock, width));
  for (std::size_t i = blocks; i-- > 0;) set_rows(i, row_first_, static_cast<int>(i) * kBlock);
}

bool FrameGeometry::is_column_wise() const {
  return rays_.are_simple() && !(curve_ && curve_->is_twisted());
}

void FrameGeometry::fill(RowView& row) const {
  const Surface face = is_column_wise() ? fill_by_columns(row) : fill_by_rays(row);
  if (!layer_changes.empty()) {
    float* luf = row.scratch.floats();
    std::copy(row.face.luf_mm + row.face.first, row.face.luf_mm + row.face.last,
              luf + row.face.first);
    for (const auto& change : layer_changes) change(row.face, row.scratch, luf);
    row.face.luf_mm = luf;
  }
  row.surfaces.assign(1, face);
  row.hollow_mm = nullptr;
  fill_presses(row);
}

Surface FrameGeometry::fill_by_columns(RowView& row) const {
  float* light = row.scratch.floats();
  if (rays_.linear())
    fill_linear(row, light);
  else
    fill_by_table(row, light);
  Surface face;
  face.first = row.face.first;
  face.last = row.face.last;
  face.x_mm = row.face.x_mm;
  face.y_mm = row.face.y_mm;
  face.z_mm = row.face.z_mm;
  face.normal_x = row.face.sin_incline;
  face.coverage = row.face.coverage;
  face.light = light;
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

void FrameGeometry::fill_linear(RowView& row, float* light) const {
  const auto v = static_cast<std::size_t>(row.v);
  const int first = row_first_[v], last = row_last_[v];
  float *y = row.scratch.floats(), *coverage = row.scratch.floats();
  FaceRow& face = row.face;
  face.first = first < last ? first : 0;
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
  cover_row(face.first, face.last, ray.origin_y, ray.direction_y,
            curve_ ? static_cast<float>(face_.width_mm / 2) : kNoEdge, columns_.z.data(),
            columns_.shift.data(), columns_.per_mm.data(), columns_.end.data(), y, coverage, light);
}

void FrameGeometry::fill_by_table(RowView& row, float* light) const {
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
  const auto column = [&](const AlignedFloats& table) {
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
    light[u] = 1.0F;
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
        [](const auto& p) { return 1.1 * p.reach_mm() + 2 * p.pose.depth_mm + 1; }, press));
    const auto s_0 =
        static_cast<float>(std::visit([](const auto& p) { return p.pose.s_mm; }, press));
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

namespace {

constexpr double kMinStep_mm = 0.05;
constexpr double kMaxSteps = 600;
constexpr double kMaxHalf_mm = 100;  // of half the body's size

}  // namespace

SampledPress sample_press(const BodyPress& press, const FrameGeometry& geometry) {
  SampledPress grid;
  grid.pose = press.pose;
  grid.rotation_rad = press.rotation_rad;
  // A slanted line leaves the body's outline by up to twice the depth.
  const double margin = 2 * press.pose.depth_mm + 2 * kMinStep_mm;
  const Eigen::Vector2d half = (press.body->half_size_mm().array() + margin).min(kMaxHalf_mm);
  grid.step_mm = std::max(kMinStep_mm, 2 * half.maxCoeff() / kMaxSteps);
  const Eigen::Vector2i steps = (half / grid.step_mm).array().ceil().cast<int>();
  grid.depth_mm.create(2 * steps.y() + 1, 2 * steps.x() + 1);
  const double c = std::cos(press.rotation_rad), s = std::sin(press.rotation_rad);
  for (int row = 0; row < grid.depth_mm.rows; ++row)
    for (int column = 0; column < grid.depth_mm.cols; ++column) {
      const double x = (column - steps.x()) * grid.step_mm, y = (row - steps.y()) * grid.step_mm;
      const Eigen::Vector3d luf =
          geometry.luf_point_mm(press.pose.s_mm + c * x - s * y, press.pose.y_mm + s * x + c * y);
      const double lowest = press.posed(luf.x(), luf.y(), luf.z());
      grid.depth_mm(row, column) =
          std::isfinite(lowest) ? static_cast<float>(luf.z() - lowest) : 0.0F;
    }
  grid.in_contact = grid.depth_mm > 0;
  return grid;
}

void sample_bodies(FrameGeometry& geometry) {
  for (auto& press : geometry.presses)
    if (const auto* body = std::get_if<BodyPress>(&press)) press = sample_press(*body, geometry);
}

void pad_grid(SampledPress& press, int steps) {
  cv::Mat_<float> depth;
  cv::copyMakeBorder(press.depth_mm, depth, steps, steps, steps, steps, cv::BORDER_CONSTANT,
                     cv::Scalar(0));
  cv::Mat_<std::uint8_t> in_contact;
  cv::copyMakeBorder(press.in_contact, in_contact, steps, steps, steps, steps, cv::BORDER_CONSTANT,
                     cv::Scalar(0));
  press.depth_mm = depth;
  press.in_contact = in_contact;
}

namespace {

constexpr double kStep_mm = 1e-3;  // step of the differences for a twisted face's slopes

// The layer's thickness along z over a point of a twisted face, whose normal varies across it.
double twisted_t0_mm(const FaceCurve::Node& p, double across_mm, double layer_mm) {
  const Eigen::Vector3d across = FaceCurve::across(p), along(p.x_s, 0, p.z_s);
  const Eigen::Vector3d point_s =
      along + p.shift_s * Eigen::Vector3d::UnitY() +
      across_mm * (p.twist_s * FaceCurve::normal(p) - std::sin(p.twist) * p.theta_s * along);
  return layer_mm / point_s.cross(across).normalized().z();
}

}  // namespace

FrameGeometry::BodyPoint FrameGeometry::body_point(double s_mm, double across_mm,
                                                   double behind_mm) const {
  if (!curve_)
    return {{s_mm, across_mm, face_.plane_z_mm - behind_mm},
            Eigen::Vector3d::UnitX(),
            Eigen::Vector3d::UnitZ()};
  const FaceCurve::Node p = curve_->at(s_mm);
  const Eigen::Vector3d along(p.x_s, 0, p.z_s), middle(p.x_mm, p.shift_mm, p.z_mm);
  if (!curve_->is_twisted()) {
    const Eigen::Vector3d normal(-p.z_s, 0, p.x_s);
    return {{p.x_mm + behind_mm * p.z_s, p.shift_mm + across_mm, p.z_mm - behind_mm * p.x_s},
            along,
            normal};
  }
  const Eigen::Vector3d normal = FaceCurve::normal(p);
  return {middle + across_mm * FaceCurve::across(p) - behind_mm * normal, along, normal};
}

Eigen::Vector3d FrameGeometry::luf_point_mm(double s_mm, double across_mm) const {
  if (!curve_) return {s_mm, across_mm, face_.plane_z_mm + face_.layer_mm};
  const FaceCurve::Node p = curve_->at(s_mm);
  if (!curve_->is_twisted())
    return {p.x_mm, p.shift_mm + across_mm, p.z_mm + face_.layer_mm / p.x_s};
  const Eigen::Vector3d middle(p.x_mm, p.shift_mm, p.z_mm);
  return middle + across_mm * FaceCurve::across(p) +
         Eigen::Vector3d(0, 0, twisted_t0_mm(p, across_mm, face_.layer_mm));
}

PressPose FrameGeometry::press_pose(double s_mm, double y_mm, double depth_mm) const {
  PressPose pose;
  pose.s_mm = s_mm;
  pose.y_mm = y_mm;
  pose.depth_mm = depth_mm;
  pose.layer_mm = face_.layer_mm;
  pose.luf_mm = luf_point_mm(s_mm, y_mm);
  pose.across = Eigen::Vector3d::UnitY();
  if (!curve_) {
    pose.normal = Eigen::Vector3d::UnitZ();
    pose.along = Eigen::Vector3d::UnitX();
    return pose;
  }
  if (curve_->is_twisted()) {
    const Eigen::Vector3d by_s =
        luf_point_mm(s_mm + kStep_mm, y_mm) - luf_point_mm(s_mm - kStep_mm, y_mm);
    const Eigen::Vector3d by_y =
        luf_point_mm(s_mm, y_mm + kStep_mm) - luf_point_mm(s_mm, y_mm - kStep_mm);
    pose.normal = by_s.cross(by_y).normalized();
    pose.along = by_s.normalized();
    pose.across = pose.normal.cross(pose.along);
    return pose;
  }
  const FaceCurve::Node p = curve_->at(s_mm);
  const double sin = p.z_s, cos = p.x_s;
  // dz/dx of the LUF: the view face's slope, plus the layer's growth along z where the face bends.
  const double slope = sin / cos + face_.layer_mm * sin * p.theta_s / (cos * cos * cos);
  pose.normal = Eigen::Vector3d(-slope, 0, 1).normalized();
  pose.along = Eigen::Vector3d(1, 0, slope).normalized();
  return pose;
}

double FrameGeometry::max_thickness_mm() const {
  if (!columns_.luf.empty()) return *std::max_element(columns_.luf.begin(), columns_.luf.end());
  if (!curve_) return face_.layer_mm;
  double max_value = 0;
  for (int i = 0; i <= FaceCurve::kCells; ++i)
    for (const double across : {-face_.width_mm / 2, 0.0, face_.width_mm / 2})
      max_value =
          std::max(max_value, twisted_t0_mm(curve_->at(curve_->s_mm(i)), across, face_.layer_mm));
  return max_value;
}

namespace {

// Buffers of the face's row.
struct FaceArrays {
  explicit FaceArrays(RowScratch& scratch) {
    for (float** array :
         {&x, &y, &z, &normal_x, &normal_y, &normal_z, &cos, &luf, &shift, &s, &coverage, &light})
      *array = scratch.floats();
  }
  float *x, *y, *z, *normal_x, *normal_y, *normal_z, *cos, *luf, *shift, *s, *coverage, *light;

  void set(int u, const Eigen::Vector3d& point, const Eigen::Vector3d& normal) {
    x[u] = static_cast<float>(point.x());
    y[u] = static_cast<float>(point.y());
    z[u] = static_cast<float>(point.z());
    normal_x[u] = static_cast<float>(-normal.x());
    normal_y[u] = static_cast<float>(-normal.y());
    normal_z[u] = static_cast<float>(-normal.z());
    cos[u] = static_cast<float>(normal.z());
    light[u] = 1;
  }
  // No coverage; the numbers only have to be finite.
  void miss(int u) {
    set(u, Eigen::Vector3d::UnitZ(), Eigen::Vector3d::UnitZ());
    luf[u] = 1;
    s[u] = kNoHit_mm;
    shift[u] = coverage[u] = 0;
  }
};

double share(double inside_px) { return std::clamp(inside_px + 0.5, 0.0, 1.0); }

}  // namespace

Surface FrameGeometry::fill_by_rays(RowView& row) const {
  FaceArrays arrays(row.scratch);
  const auto n = static_cast<std::size_t>(row.width);
  std::vector<Ray> rays(n);
  for (int u = 0; u < row.width; ++u) rays[static_cast<std::size_t>(u)] = rays_.ray(u, row.v);
  std::optional<RuledSurface::IntersectionRow> intersections;
  if (curve_)
    intersections = RuledSurface::view_face(*curve_).intersect_row(rays, std::vector<char>(n, 1));
  for (int u = 0; u < row.width; ++u) {
    const auto i = static_cast<std::size_t>(u);
    const Ray& ray = rays[i];
    if (!intersections) {
      arrays.set(u, ray.point_at(face_.plane_z_mm), Eigen::Vector3d::UnitZ());
      arrays.luf[u] = static_cast<float>(face_.layer_mm);
      arrays.s[u] = arrays.x[u];
      arrays.shift[u] = 0;
      arrays.coverage[u] = 1;
      continue;
    }
    if (!intersections->is_hit(i)) {
      arrays.miss(u);
      continue;
    }
    const RuledSurface::Intersection here = intersections->at(i);
    arrays.set(u, ray.point_at(here.z_mm), here.normal);
    arrays.luf[u] = static_cast<float>(face_.layer_mm / here.normal.z());
    arrays.s[u] = static_cast<float>(here.s_mm);
    arrays.shift[u] = arrays.y[u] - static_cast<float>(here.r_mm);
    const double ends = std::min(here.s_mm, curve_->length_mm() - here.s_mm);
    const double edges = face_.width_mm / 2 - std::abs(here.r_mm);
    const double margin_mm = kEdgeMargin_px * rays_.camera().mm_per_px_at(here.z_mm);
    if (const double inside = std::min(ends, edges); std::abs(inside) > margin_mm) {
      arrays.coverage[u] = inside > 0 ? 1 : 0;
      continue;
    }
    const double s_per_px = std::abs(here.s_by(ray, rays_.right_of(u, row.v)));
    const double r_per_px = std::abs(here.r_by(ray, rays_.below(u, row.v)));
    arrays.coverage[u] = static_cast<float>(share(ends / s_per_px) * share(edges / r_per_px));
  }
  row.face = {0,          row.width,  arrays.x,     arrays.y, arrays.z,       arrays.normal_x,
              arrays.cos, arrays.luf, arrays.shift, arrays.s, arrays.coverage};
  return {0,
          row.width,
          arrays.x,
          arrays.y,
          arrays.z,
          arrays.normal_x,
          arrays.normal_y,
          arrays.normal_z,
          arrays.coverage,
          arrays.light};
}

}  // namespace alltact
