#include "core/sensing/face/face_shape.h"

#include "core/numerics/chebyshev.h"
#include "core/numerics/robust_polynomial.h"
#include "core/sensing/face/outline_jump.h"

#include <algorithm>
#include <cmath>

namespace alltact {
namespace {

constexpr double kMinimumWidthPx = 8.0;  // below it 1/width is biased by percents
constexpr double kWidthBiasPx = 0.03;    // of an edge that is not exactly a blurred step
constexpr int kLensDegrees = 4;
// Fraction of the columns: a smaller part beyond a jump is omitted
constexpr double kShortFraction = 1.0 / 12;

/// The outermost column of an end: at one of the face's corners, or where it turns.
double outermost(const FaceEnd& end, double upper_v, double lower_v, int outwards) {
  const double turn =
      end.bow_per_px != 0.0
          ? std::clamp(end.v_px - 0.5 * end.slope / end.bow_per_px, upper_v, lower_v)
          : upper_v;
  const auto [lowest, highest] = std::minmax({end.at(upper_v), end.at(lower_v), end.at(turn)});
  return outwards > 0 ? highest : lowest;
}

Error no_shape(Message what) {
  return {
      std::move(what),
      en::say("the face's edges"),
      en::say(
          "a picture in which both long edges of the bright face are visible and lit evenly; check "
          "that the lamps are on and that the lens is clean")};
}

}  // namespace

Result<FaceShape> FaceShape::fit(const FaceEdges& edges,
                                 const Camera& camera,
                                 const Face& face,
                                 int degree,
                                 double z_sd_limit_mm) {
  if (!camera.is_perspective())
    return no_shape(
        en::say("the shape of a Fin Ray needs a perspective camera, not an orthographic one"));
  if (const auto jump = outline_jump(edges)) {
    if (jump->shorter_fraction < kShortFraction)
      return fit(longer_side(edges, *jump), camera, face, degree, z_sd_limit_mm);
    return Error{en::say("no smooth shape fits the outline of the face: it jumps at column {:.0f}",
                         jump->u_px),
                 en::say("the face's edges"),
                 en::say("bending the finger less, until no part of it hides another")};
  }
  const CameraParameters& lens = camera.parameters();
  const int width = lens.width_px;

  // Lens distortion needs a few more coefficients.
  const int edge_degree = camera.is_linear() ? degree : degree + kLensDegrees;
  const ScaledColumn scale{0.5 * (width - 1.0), 0.5 * (width - 1.0)};
  std::vector<double> along;
  for (const double u : edges.u) along.push_back(scale.at(u));
  const auto upper =
      fit_robust_polynomial(along, edges.upper.v, edges.upper.sd, edges.upper.valid, edge_degree);
  const auto lower =
      fit_robust_polynomial(along, edges.lower.v, edges.lower.sd, edges.lower.valid, edge_degree);
  if (!upper || !lower) {
    const Message side = !upper ? en::say("upper") : en::say("lower");
    return no_shape(en::say("the {} edge of the face was seen in too few columns", side));
  }
  // Columns beyond the face's ends are not extrapolated, nor beyond the trusted edges where no end
  // was found. At the border of the image the last sample counts up to its half width.
  const double step = edges.u.size() > 1 ? edges.u[1] - edges.u[0] : 1.0;
  const auto column_of = [&](double t) {
    return edges.u[static_cast<std::size_t>(std::lower_bound(along.begin(), along.end(), t) -
                                            along.begin())];
  };
  double first = column_of(std::max(upper->first, lower->first));
  double last = column_of(std::min(upper->last, lower->last));
  if (first <= edges.u.front()) first = std::max(0.0, first - step);
  if (last >= edges.u.back()) last = std::min(width - 1.0, last + step);
  const double seen_first = first - step, seen_last = last + step;
  const auto corner = [&](const FaceEnd& end, int outwards) {
    const double t = scale.at(end.u_px);
    return outermost(end, upper->value(t), lower->value(t), outwards);
  };
  if (edges.ends.first) first = std::max(0.0, corner(*edges.ends.first, -1));
  if (edges.ends.last) last = std::min(width - 1.0, corner(*edges.ends.last, 1));
  if (!(last - first >= 4.0 * step))
    return no_shape(en::say("the two edges were never seen together"));

  FaceShape shape(camera, face);
  shape.ends_ = edges.ends;
  shape.columns_.resize(static_cast<std::size_t>(width));
  const double t_step = scale.at(1.0) - scale.at(0.0);
  const std::vector<double> upper_v = upper->values(scale.at(0.0), t_step, width);
  const std::vector<double> lower_v = lower->values(scale.at(0.0), t_step, width);
  for (int u = 0; u < width; ++u) {
    FaceColumn& column = shape.columns_[static_cast<std::size_t>(u)];
    column.upper_v = upper_v[static_cast<std::size_t>(u)];
    column.lower_v = lower_v[static_cast<std::size_t>(u)];
    column.valid = u >= first && u <= last && column.lower_v - column.upper_v >= kMinimumWidthPx;
  }
  shape.scale_ = scale;
  // Between the trusted edges and a dark end the edges are extrapolated and may be far off.
  const bool is_fitted =
      camera.is_linear() ? shape.set_edges(*upper, *lower)
                         : shape.fit_inverse_depth(
                               std::max(first, seen_first), std::min(last, seen_last), edge_degree);
  if (!is_fitted) return no_shape(en::say("no smooth shape fits them"));

  constexpr int kSdStep = 8;  // the standard deviation changes slowly along the face
  std::vector<double> width_sd;
  for (int u = kSdStep / 2; u < width + kSdStep; u += kSdStep)
    width_sd.push_back(std::hypot(upper->sd(scale.at(u)), lower->sd(scale.at(u)), kWidthBiasPx));
  int valid = 0;
  for (int u = 0; u < width; ++u) {
    FaceColumn& column = shape.columns_[static_cast<std::size_t>(u)];
    if (!column.valid) continue;
    const double z_mm = shape.z_of_column(u);
    const double width_sd_px = width_sd[static_cast<std::size_t>(u / kSdStep)];
    column.valid = z_mm > 0.0 && std::isfinite(z_mm);
    if (!column.valid) continue;
    column.z_mm = z_mm;
    column.z_sd_mm = camera.ray_origin_z_mm(z_mm) * width_sd_px / (column.lower_v - column.upper_v);
    column.valid = column.z_sd_mm <= z_sd_limit_mm;
    valid += column.valid;
  }
  if (valid < 5)
    return no_shape(en::say("the distance of the face is too uncertain in every column"));
  shape.finish();
  return shape;
}

double FaceShape::z_of_column(int u) const {
  const auto k = static_cast<std::size_t>(u);
  if (!across_.empty()) return across_[k].z_mm;  // constant within a column
  const double middle = 0.5 * (columns_[k].upper_v + columns_[k].lower_v);
  const auto ray = camera_.unproject({static_cast<double>(u), middle});
  const double inverse_z = ray ? inverse_z_of(*ray) : 0.0;
  return inverse_z > 0.0 ? 1.0 / inverse_z : 0.0;
}

double FaceShape::x_of_column(double u) const {
  const CameraParameters& lens = camera_.parameters();
  return (u - lens.cx_px) / lens.fx_px;
}

double FaceShape::column_of(double x) const {
  const CameraParameters& lens = camera_.parameters();
  return lens.cx_px + lens.fx_px * x;
}

FaceShape::InverseDepth FaceShape::inverse_depth_at(double x) const {
  const double u = column_of(x), t = scale_.at(u);
  const double per_x = camera_.parameters().fx_px / scale_.half_px;
  InverseDepth inverse;
  inverse.a = chebyshev_value(inverse_z_, t);
  inverse.a_slope = per_x * chebyshev_value(inverse_z_slope_, t);
  if (!twist_) return inverse;
  inverse.b = chebyshev_value(inverse_z_by_y_, t);
  inverse.d = chebyshev_value(inverse_z_by_y2_, t);
  inverse.b_slope = per_x * chebyshev_value(inverse_z_by_y_slope_, t);
  inverse.d_slope = per_x * chebyshev_value(inverse_z_by_y2_slope_, t);
  return inverse;
}

double FaceShape::inverse_z_at(const Eigen::Vector2d& direction) const {
  const double t = scale_.at(column_of(direction.x())), y = direction.y();
  const double inverse_z = chebyshev_value(inverse_z_, t);
  if (!twist_) return inverse_z;
  return inverse_z +
         y * (chebyshev_value(inverse_z_by_y_, t) + y * chebyshev_value(inverse_z_by_y2_, t));
}

FaceShape FaceShape::plane(const Camera& camera, const Face& face) {
  FaceShape shape(camera, face);
  FaceColumn column;
  column.upper_v = -0.5 - 1e-9;
  column.lower_v = camera.size().height - 0.5 + 1e-9;
  column.z_mm = face.plane_z_mm;
  column.valid = true;
  shape.columns_.assign(static_cast<std::size_t>(camera.size().width), column);
  if (camera.is_perspective()) {
    shape.inverse_z_ = Eigen::VectorXd::Constant(1, 1.0 / face.plane_z_mm);
    shape.compute_across();
  }
  shape.full_image_ = true;
  shape.finish();
  return shape;
}

void FaceShape::finish() {
  const auto valid = [](const FaceColumn& c) { return c.valid; };
  const auto first = std::find_if(columns_.begin(), columns_.end(), valid);
  const auto last = std::find_if(columns_.rbegin(), columns_.rend(), valid);
  base_at_low_u_ = first->z_mm <= last->z_mm;

  compute_lengths();
  along_z_per_normal_.assign(columns_.size(), 1.0F);
  for (int u = 0; u < width_px(); ++u) {
    const auto k = static_cast<std::size_t>(u);
    const FaceColumn& column = columns_[k];
    if (!across_.empty()) {
      if (column.valid && across_[k].z_mm > 0.0)
        along_z_per_normal_[k] = static_cast<float>(1.0 / across_[k].normal.z());
    } else if (const auto local = at(u, 0.5 * (column.upper_v + column.lower_v))) {
      along_z_per_normal_[k] = static_cast<float>(1.0 / local->cos_incline);
    }
  }
}

std::optional<FaceShape::RayHit> FaceShape::ray_hit_at(double u, double v) const {
  const auto nearest = static_cast<long>(std::lround(u));
  if (nearest < 0 || nearest >= width_px() || !columns_[static_cast<std::size_t>(nearest)].valid)
    return std::nullopt;
  const auto ray = camera_.unproject({u, v});
  if (!ray) return std::nullopt;
  if (!camera_.is_perspective())
    return RayHit{*ray, {face_.plane_z_mm, 1.0, 1.0, Eigen::Vector3d::UnitZ()}};
  const auto found =
      across_of(*ray,
                u == static_cast<double>(nearest) ? std::optional(static_cast<std::size_t>(nearest))
                                                  : std::nullopt);
  if (!found || !(found->z_mm > 0.0)) return std::nullopt;
  return RayHit{*ray, *found};
}

std::optional<FaceShape::Local> FaceShape::at(double u, double v) const {
  const auto seen = ray_hit_at(u, v);
  if (!seen) return std::nullopt;
  const Across& across = seen->across;
  return Local{seen->ray.point_at(across.z_mm), across.normal, across.normal.z()};
}

std::optional<FaceShape::PixelArea> FaceShape::pixel_area(double u, double v) const {
  const auto seen = ray_hit_at(u, v);
  if (!seen) return std::nullopt;
  const CameraParameters& lens = camera_.parameters();
  if (!camera_.is_perspective()) {
    const double area = lens.mm_per_px * lens.mm_per_px;
    return PixelArea{area, area};
  }
  const double z = seen->across.z_mm;
  const double pixel = ray_area(seen->ray, u, v, 1.0 / z) * z * z * z;
  return PixelArea{pixel * seen->across.length, pixel * seen->across.along};
}

// With q = 1/z a function of x and y the tangent plane of the face is q_x X + q_y Y + c Z = 1, c =
// q - x q_x - y q_y: its normal needs no division by a slope and no cosine.
std::optional<FaceShape::Across> FaceShape::across_from(double x,
                                                        double y,
                                                        const InverseDepth& inverse) {
  const double q = inverse.at(y);
  if (!(q > 0.0)) return std::nullopt;
  const double q_x = inverse.a_slope + y * (inverse.b_slope + y * inverse.d_slope);
  const double q_y = inverse.b + 2.0 * y * inverse.d;
  const double along = q - x * q_x - y * q_y;
  const double length = std::sqrt(q_x * q_x + q_y * q_y + along * along);
  if (!(length > 0.0) || !(along > 0.0)) return std::nullopt;
  return Across{1.0 / q, along, length, Eigen::Vector3d(q_x, q_y, along) / length};
}

// Without lens distortion the values of integer columns are cached.
std::optional<FaceShape::Across> FaceShape::across_of(const Ray& ray,
                                                      std::optional<std::size_t> column) const {
  if (column && !across_.empty()) return across_[*column];
  if (column && !by_column_.empty())
    return across_from(ray.direction.x(), ray.direction.y(), by_column_[*column]);
  const Eigen::Vector2d seen = seen_from(ray, inverse_z_of(ray));
  return across_from(seen.x(), seen.y(), inverse_depth_at(seen.x()));
}

double FaceShape::ray_area(const Ray& ray, double u, double v, double inverse_z) const {
  const CameraParameters& lens = camera_.parameters();
  if (camera_.is_linear()) return 1.0 / (lens.fx_px * lens.fy_px);
  constexpr double kStep = 0.5;
  const auto right = camera_.unproject({u + kStep, v});
  const auto below = camera_.unproject({u, v + kStep});
  if (!right || !below) return 1.0 / (lens.fx_px * lens.fy_px);
  const Eigen::Vector2d here = seen_from(ray, inverse_z);
  const Eigen::Vector2d du = seen_from(*right, inverse_z) - here;
  const Eigen::Vector2d dv = seen_from(*below, inverse_z) - here;
  return std::abs(du.x() * dv.y() - du.y() * dv.x()) / (kStep * kStep);
}

Eigen::Vector3d untouched_point_mm(const FaceShape::Local& local,
                                   double layer_mm,
                                   MappingAlong along) {
  if (along == MappingAlong::kNormal) return local.view_point_mm + layer_mm * local.normal;
  constexpr double kCosLimit = 0.25881904510252074;  // of 75 degrees
  const double thickness = layer_mm / std::max(local.cos_incline, kCosLimit);
  return local.view_point_mm + Eigen::Vector3d(0.0, 0.0, thickness);
}

}  // namespace alltact
