#include "core/sensing/face/face_shape.h"

#include "core/numerics/chebyshev.h"
#include "core/numerics/linear_algebra.h"
#include "core/sensing/face/face_edges.h"

#include <algorithm>
#include <array>
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
  // Continued beyond what was seen of them, the edges may cross.
  const auto [top_v, bottom_v] = std::minmax(upper_v, lower_v);
  const double turn = end.bow_per_px != 0.0
                          ? std::clamp(end.v_px - 0.5 * end.slope / end.bow_per_px, top_v, bottom_v)
                          : upper_v;
  const auto [lowest, highest] = std::minmax({end.at(upper_v), end.at(lower_v), end.at(turn)});
  return outwards > 0 ? highest : lowest;
}

/// Numbers of the first and the last valid column; the first exceeds the last where none is valid.
std::pair<long, long> valid_columns(const std::vector<FaceColumn>& columns) {
  const auto is_valid = [](const FaceColumn& c) { return c.valid; };
  return {std::find_if(columns.begin(), columns.end(), is_valid) - columns.begin(),
          columns.rend() - std::find_if(columns.rbegin(), columns.rend(), is_valid) - 1};
}

Error no_shape(Message what, ErrorKind kind = ErrorKind::kOther) {
  return {std::move(what), en::say("the face's edges"),
          en::say("an image in which both long edges of the bright face are visible and lit "
                  "evenly; check that the lamps are on and that the lens is clean"),
          kind};
}

}  // namespace

Result<FaceShape> FaceShape::fit(const FaceEdges& edges, const Camera& camera, const Face& face,
                                 int degree, double z_sd_limit_mm) {
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
  const bool is_fitted = camera.is_linear()
                             ? shape.set_edges(*upper, *lower)
                             : shape.fit_inverse_depth(std::max(first, seen_first),
                                                       std::min(last, seen_last), edge_degree);
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
    return no_shape(en::say("the distance of the face is too uncertain in every column"),
                    ErrorKind::kUncertainFace);
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

namespace {

/// Of 75 degrees. Lengths along z of a steeper face are those of this incline: where the fit turns
/// a face on its edge, as edges drawn outwards by dots do, they would grow without limit.
constexpr double kMinCosIncline = 0.25881904510252074;

}  // namespace

void FaceShape::finish() {
  const auto [first, last] = valid_columns(columns_);
  base_at_low_u_ = columns_[static_cast<std::size_t>(first)].z_mm <=
                   columns_[static_cast<std::size_t>(last)].z_mm;

  compute_lengths();
  along_z_per_normal_.assign(columns_.size(), 1.0F);
  for (int u = 0; u < width_px(); ++u) {
    const auto k = static_cast<std::size_t>(u);
    const FaceColumn& column = columns_[k];
    if (!across_.empty()) {
      if (column.valid && across_[k].z_mm > 0.0)
        along_z_per_normal_[k] =
            static_cast<float>(1.0 / std::max(across_[k].normal.z(), kMinCosIncline));
    } else if (const auto local = at(u, 0.5 * (column.upper_v + column.lower_v))) {
      along_z_per_normal_[k] =
          static_cast<float>(1.0 / std::max(local->cos_incline, kMinCosIncline));
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
  const auto found = across_of(*ray, u == static_cast<double>(nearest)
                                         ? std::optional(static_cast<std::size_t>(nearest))
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
std::optional<FaceShape::Across> FaceShape::across_from(double x, double y,
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

Eigen::Vector3d untouched_point_mm(const FaceShape::Local& local, double layer_mm,
                                   MappingAlong along) {
  if (along == MappingAlong::kNormal) return local.view_point_mm + layer_mm * local.normal;
  const double thickness = layer_mm / std::max(local.cos_incline, kMinCosIncline);
  return local.view_point_mm + Eigen::Vector3d(0.0, 0.0, thickness);
}

std::optional<Eigen::Vector2d> pixel_of_position(const FaceShape& shape,
                                                 const Eigen::Vector2d& position_mm) {
  const auto& columns = shape.columns();
  auto [low, high] = valid_columns(columns);
  if (high <= low) return std::nullopt;
  // Lengths increase from base to tip, which may be from right to left.
  const auto ahead_mm = [&](long u) {
    const double by = position_mm.x() - shape.length_at(static_cast<double>(u));
    return shape.base_at_low_u() ? by : -by;
  };
  if (!(ahead_mm(low) >= 0.0) || !(ahead_mm(high) <= 0.0)) return std::nullopt;
  while (high - low > 1) {
    const long middle = low + (high - low) / 2;
    (ahead_mm(middle) >= 0.0 ? low : high) = middle;
  }
  const double span_mm = ahead_mm(low) - ahead_mm(high);
  const double u = static_cast<double>(low) + (span_mm > 0.0 ? ahead_mm(low) / span_mm : 0.0);
  const FaceColumn& column = columns[static_cast<std::size_t>(std::lround(u))];
  if (!column.valid) return std::nullopt;
  return Eigen::Vector2d(u, 0.5 * (column.upper_v + column.lower_v) +
                                position_mm.y() / shape.camera().mm_per_px_at(column.z_mm));
}

// Distance of the face, computed from its edges: 1/z as a curve over the columns.

namespace {

constexpr int kMaxWindowSteps = 60;  // each reduces the error of z by a factor of 5 or more

}  // namespace

// Without distortion a column's rays share their x. Then y and 1/z are polynomials of the column
// with the degree of the edges. Values at as many Chebyshev nodes as coefficients determine them
// exactly.
bool FaceShape::set_edges(const RobustPolynomial& upper, const RobustPolynomial& lower) {
  const Eigen::Index n = upper.coefficients.size();
  upper_y_ = lower_y_ = Eigen::VectorXd::Zero(n);
  for (Eigen::Index j = 0; j < n; ++j) {
    const double angle = M_PI * (static_cast<double>(j) + 0.5) / static_cast<double>(n);
    const double t = std::cos(angle), u = scale_.middle_px + scale_.half_px * t;
    const auto a = camera_.unproject({u, upper.value(t)}),
               b = camera_.unproject({u, lower.value(t)});
    if (!a || !b) return false;
    for (Eigen::Index k = 0; k < n; ++k) {
      const double part =
          (k == 0 ? 1.0 : 2.0) / static_cast<double>(n) * std::cos(static_cast<double>(k) * angle);
      upper_y_[k] += part * a->direction.y();
      lower_y_[k] += part * b->direction.y();
    }
  }
  inverse_z_ = (lower_y_ - upper_y_) / face_.width_mm;
  compute_across();
  return inverse_z_.allFinite();
}

bool FaceShape::fit_inverse_depth(double first, double last, int degree) {
  // Samples the fitted edges at Chebyshev nodes.
  const Eigen::Index n = degree + 1;
  const int samples = 8 * static_cast<int>(n);
  std::vector<Ray> uppers, lowers;
  for (int i = 0; i < samples; ++i) {
    const double node = -std::cos(M_PI * (i + 0.5) / samples);
    const double u = 0.5 * (first + last) + 0.5 * (last - first) * node;
    const auto& left = columns_[static_cast<std::size_t>(u)];
    const auto& right = columns_[std::min(static_cast<std::size_t>(u) + 1, columns_.size() - 1)];
    const double part = u - std::floor(u);
    const auto a = camera_.unproject({u, left.upper_v + part * (right.upper_v - left.upper_v)});
    const auto b = camera_.unproject({u, left.lower_v + part * (right.lower_v - left.lower_v)});
    if (!a || !b) continue;
    uppers.push_back(*a), lowers.push_back(*b);
  }
  if (uppers.size() < 2 * static_cast<std::size_t>(n)) return false;
  // Behind a window the apparent direction of a point depends on its distance.
  const int rounds = camera_.is_central() ? 1 : kMaxWindowSteps;
  for (int round = 0; round < rounds; ++round) {
    const Eigen::VectorXd before = inverse_z_;
    if (!fit_to_rays(uppers, lowers, n)) return false;
    if (before.size() > 0 && (inverse_z_ - before).norm() < 1e-15) break;
  }
  compute_across();
  return inverse_z_.allFinite();
}

bool FaceShape::fit_to_rays(const std::vector<Ray>& uppers, const std::vector<Ray>& lowers,
                            Eigen::Index n) {
  const auto used = static_cast<Eigen::Index>(uppers.size());
  Eigen::VectorXd upper_x(used), upper_y(used), lower_x(used), lower_y(used);
  for (Eigen::Index i = 0; i < used; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const Eigen::Vector2d a = seen_from(uppers[k], inverse_z_of(uppers[k])),
                          b = seen_from(lowers[k], inverse_z_of(lowers[k]));
    upper_x[i] = a.x(), upper_y[i] = a.y();
    lower_x[i] = b.x(), lower_y[i] = b.y();
  }
  const auto curve = [&](const Eigen::VectorXd& x, const Eigen::VectorXd& y) -> Eigen::VectorXd {
    Eigen::MatrixXd design(used, n);
    for (Eigen::Index i = 0; i < used; ++i)
      design.row(i) = chebyshev_row(scale_.at(column_of(x[i])), n);
    return least_squares(design, y);
  };
  upper_y_ = curve(upper_x, upper_y);
  lower_y_ = curve(lower_x, lower_y);
  inverse_z_ = (lower_y_ - upper_y_) / face_.width_mm;
  return inverse_z_.allFinite();
}

// 0 before the first fit: the point of the ray is then assumed to be far away.
double FaceShape::inverse_z_of(const Ray& ray) const {
  if (inverse_z_.size() == 0) return 0.0;
  double inverse_z = inverse_z_at(ray.direction.head<2>());
  if (camera_.is_central()) return inverse_z;
  for (int step = 0; step < kMaxWindowSteps; ++step) {
    const double before = inverse_z;
    inverse_z = inverse_z_at(seen_from(ray, inverse_z));
    if (std::abs(inverse_z - before) <= 1e-15) break;
  }
  return inverse_z;
}

void FaceShape::compute_across() {
  inverse_z_slope_ = chebyshev_derivative(inverse_z_);
  if (twist_) {
    inverse_z_by_y_slope_ = chebyshev_derivative(inverse_z_by_y_);
    inverse_z_by_y2_slope_ = chebyshev_derivative(inverse_z_by_y2_);
  }
  across_.clear();
  by_column_.clear();
  if (!camera_.is_linear() || !camera_.is_perspective()) return;
  if (twist_)
    by_column_.resize(columns_.size());
  else
    across_.resize(columns_.size());
  const CameraParameters& lens = camera_.parameters();
  const auto along = [&](const Eigen::VectorXd& series) {
    std::vector<double> values(columns_.size(), 0.0);
    if (series.size() > 0)
      chebyshev_values(series, scale_.at(0.0), 1.0 / scale_.half_px, width_px(), values.data());
    return values;
  };
  const double per_x = lens.fx_px / scale_.half_px;
  const auto a = along(inverse_z_), a_slope = along(inverse_z_slope_);
  const auto b = along(inverse_z_by_y_), b_slope = along(inverse_z_by_y_slope_);
  const auto d = along(inverse_z_by_y2_), d_slope = along(inverse_z_by_y2_slope_);
  for (std::size_t u = 0; u < columns_.size(); ++u) {
    if (!columns_[u].valid) continue;
    InverseDepth inverse{
        a[u], b[u], d[u], per_x * a_slope[u], per_x * b_slope[u], per_x * d_slope[u]};
    if (twist_)
      by_column_[u] = inverse;
    else if (const auto here = across_from(x_of_column(static_cast<double>(u)), 0.0, inverse))
      across_[u] = *here;
  }
}

// Face shapes with turned cross-sections (twist).

namespace {

// Terms in addition to those without twist, of 1/z on the line y = 0
constexpr Eigen::Index kExtraTerms = 2;
constexpr Eigen::Index kTermsByY = 7, kTermsByY2 = 4;
constexpr int kRounds = 4;  // each turns the cross-sections by the curve of the previous round
constexpr std::array<double, 5> kAcross{-1.0, -0.5, 0.0, 0.5, 1.0};

}  // namespace

/// Cross-sections from end to end: their middles, and unit vectors across.
struct FaceShape::Rulings {
  std::vector<double> x;         // of the directions of the middles, ascending
  std::vector<double> length_t;  // argument of the twist polynomial, -1 to 1 along the face
  std::vector<Eigen::Vector3d> middle_mm, across;
};

FaceShape::Rulings FaceShape::rulings_of(const FaceTwist& twist) const {
  constexpr int kCount = 48;
  const auto [first, last] = valid_columns(columns_);
  const double half_mm = 0.5 * face_.width_mm;
  Rulings rulings;
  for (int i = 0; i < kCount; ++i) {
    const double u =
        static_cast<double>(first) + static_cast<double>(last - first) * i / (kCount - 1);
    const auto seen = middle_within(u);
    if (!seen) return {};
    // Direction without the lens's distortion or a window: the curves are functions of it.
    const double x = seen->point_mm.x() / seen->point_mm.z(), t = scale_.at(column_of(x));
    const double z = 1.0 / chebyshev_value(inverse_z_, t);
    const double y = 0.5 * (chebyshev_value(upper_y_, t) + chebyshev_value(lower_y_, t));
    rulings.x.push_back(x);
    rulings.length_t.push_back(seen->t);
    rulings.middle_mm.emplace_back(x * z, y * z, z);
  }
  rulings.across.resize(rulings.x.size());
  for (int round = 0; round < kRounds; ++round) {
    for (std::size_t i = 0; i < rulings.x.size(); ++i) {
      const std::size_t before = i == 0 ? 0 : i - 1, after = std::min(i + 1, rulings.x.size() - 1);
      const Eigen::Vector3d chord_mm = rulings.middle_mm[after] - rulings.middle_mm[before];
      const double ds = std::hypot(chord_mm.x(), chord_mm.z());
      const double cos = chord_mm.x() / ds, sin = chord_mm.z() / ds,
                   yaw = twist.yaw_per_slope * chord_mm.y() / ds;
      const double tangent = twist.at(rulings.length_t[i]);
      rulings.across[i] =
          Eigen::Vector3d(-yaw * cos - tangent * sin, 1.0, -yaw * sin + tangent * cos).normalized();
    }
    // Both ends P = M -+ h e of a cross-section are on the edges: P_y = P_z edge(P_x / P_z).
    for (std::size_t i = 0; i < rulings.x.size(); ++i) {
      Eigen::Vector3d& middle = rulings.middle_mm[i];
      const Eigen::Vector3d half = half_mm * rulings.across[i];
      const auto edge_of = [&](const Eigen::VectorXd& edge, const Eigen::Vector3d& end) {
        return chebyshev_value(edge, scale_.at(column_of(end.x() / end.z())));
      };
      const double upper = edge_of(upper_y_, middle - half),
                   lower = edge_of(lower_y_, middle + half);
      const double z = (2.0 * half.y() - (upper + lower) * half.z()) / (lower - upper);
      const double y = 0.5 * ((upper + lower) * z + (lower - upper) * half.z());
      middle = {rulings.x[i] * z, y, z};
    }
  }
  return rulings;
}

bool FaceShape::fit_to_rulings(const Rulings& rulings) {
  if (rulings.x.empty()) return false;
  const Eigen::Index terms = inverse_z_.size() + kExtraTerms;
  const auto rows = static_cast<Eigen::Index>(rulings.x.size() * kAcross.size());
  Eigen::MatrixXd design(rows, terms + kTermsByY + kTermsByY2);
  Eigen::VectorXd inverse_z(rows);
  Eigen::Index row = 0;
  for (std::size_t i = 0; i < rulings.x.size(); ++i)
    for (const double part : kAcross) {
      const Eigen::Vector3d point =
          rulings.middle_mm[i] + 0.5 * face_.width_mm * part * rulings.across[i];
      if (!(point.z() > 0.0) || !point.allFinite()) return false;
      const double y = point.y() / point.z();
      const Eigen::RowVectorXd along =
          chebyshev_row(scale_.at(column_of(point.x() / point.z())), terms);
      design.row(row) << along, y * along.head(kTermsByY), y * y * along.head(kTermsByY2);
      inverse_z[row++] = 1.0 / point.z();
    }
  const Eigen::VectorXd series = least_squares(design, inverse_z);
  inverse_z_ = series.head(terms);
  inverse_z_by_y_ = series.segment(terms, kTermsByY);
  inverse_z_by_y2_ = series.tail(kTermsByY2);
  return series.allFinite();
}

void FaceShape::compute_columns(const FaceTwist& twist) {
  for (int u = 0; u < width_px(); ++u) {
    FaceColumn& column = columns_[static_cast<std::size_t>(u)];
    if (!column.valid) continue;
    const double z_mm = z_of_column(u);
    column.valid = z_mm > 0.0 && std::isfinite(z_mm);
    if (!column.valid) continue;
    // Combines the uncertainty of the edges with the shift of the column's middle by the twist. The
    // middle of a column is not that of a cross-section.
    const auto middle = middle_within(u);
    const double off_axis = middle ? middle->point_mm.y() * middle->tangent_x : 0.0;
    const double turned = middle ? off_axis * std::sqrt(twist.variance_at(middle->t)) : 0.0;
    column.z_sd_mm = std::hypot(column.z_sd_mm * z_mm / column.z_mm, turned);
    column.z_mm = z_mm;
  }
}

std::optional<FaceShape> FaceShape::twisted(const FaceTwist& twist) const {
  if (full_image_) return std::nullopt;
  FaceShape shape = *this;
  if (!shape.fit_to_rulings(rulings_of(twist))) return std::nullopt;
  shape.twist_ = twist;
  shape.compute_across();
  shape.compute_columns(twist);
  const auto valid = std::count_if(shape.columns_.begin(), shape.columns_.end(),
                                   [](const FaceColumn& c) { return c.valid; });
  if (valid < 5) return std::nullopt;
  shape.finish();
  return shape;
}

// Mapping between pixels and positions on the face.

namespace {

/// -1 at the base end of the face, 1 at the tip end.
double length_position(const FaceShape& shape, double u) {
  const double all_mm = shape.length_at(shape.base_at_low_u() ? shape.width_px() - 1.0 : 0.0);
  return all_mm > 0.0 ? 2.0 * shape.length_at(u) / all_mm - 1.0 : 0.0;
}

/// Narrows rows [first, last] of column u to those on the face's side of an end, `margin_px` off.
/// Where a bent end leaves rows at both edges, the larger group remains.
void stop_at(const FaceEnd& end, int outwards, int u, double margin_px, int& first, int& last) {
  // outwards (end.at(v) - u) >= 0.5 + margin_px, with x = v - v_px: a + b x + c x^2 >= 0
  const double a = outwards * (end.u_px - u) - 0.5 - margin_px;
  const double b = outwards * end.slope, c = outwards * end.bow_per_px;
  const auto raise_first = [&](double x) {
    first = std::max(first, static_cast<int>(std::ceil(std::clamp(end.v_px + x, -1e6, 1e6))));
  };
  const auto lower_last = [&](double x) {
    last = std::min(last, static_cast<int>(std::floor(std::clamp(end.v_px + x, -1e6, 1e6))));
  };
  constexpr double kUpright = 1e-9, kStraight = 1e-12;
  if (std::abs(c) < kStraight) {
    if (std::abs(b) < kUpright) {
      if (a < 0.0) last = first - 1;
    } else if (b > 0.0) {
      raise_first(-a / b);
    } else {
      lower_last(-a / b);
    }
    return;
  }
  const double square = b * b - 4.0 * a * c;
  if (!(square > 0.0)) {
    if (c < 0.0) last = first - 1;
    return;
  }
  // Adds terms of equal sign first, which loses no digits.
  const double sum = -0.5 * (b + std::copysign(std::sqrt(square), b));
  const auto [low, high] = std::minmax({sum / c, sum != 0.0 ? a / sum : 0.0});
  if (c < 0.0) {
    raise_first(low);
    lower_last(high);
  } else if (end.v_px + low - first >= last - end.v_px - high) {
    lower_last(low);
  } else {
    raise_first(high);
  }
}

}  // namespace

FaceShape::Rows FaceShape::rows(int u, double margin_px) const {
  const FaceColumn& column = columns_[static_cast<std::size_t>(u)];
  if (!column.valid) return {0, -1};
  if (full_image_) return {0, camera_.size().height - 1};
  // A pixel is on the face when all of it is: its centre is inside by half a pixel and the margin.
  int first = std::max(0, static_cast<int>(std::ceil(column.upper_v + 0.5 + margin_px)));
  int last = std::min(camera_.size().height - 1,
                      static_cast<int>(std::floor(column.lower_v - 0.5 - margin_px)));
  if (ends_.first) stop_at(*ends_.first, -1, u, margin_px, first, last);
  if (ends_.last) stop_at(*ends_.last, 1, u, margin_px, first, last);
  return {first, last};
}

// v is taken from the nearest valid column: an end is steep.
std::optional<double> FaceShape::end_column(bool at_base) const {
  const std::optional<FaceEnd>& end = at_base == base_at_low_u_ ? ends_.first : ends_.last;
  if (!end) return std::nullopt;
  const auto [first, last] = valid_columns(columns_);
  double u = end->u_px;
  for (int step = 0; step < 3; ++step) {
    const FaceColumn& column =
        columns_[static_cast<std::size_t>(std::clamp(std::lround(u), first, last))];
    u = end->at(0.5 * (column.upper_v + column.lower_v));
  }
  // Far from trusted columns the length to an end is not known.
  constexpr double kNear_px = 2.0;
  if (u < static_cast<double>(first) - kNear_px || u > static_cast<double>(last) + kNear_px)
    return std::nullopt;
  return u;
}

void FaceShape::compute_lengths() {
  struct Sample {
    std::size_t u;
    double length_mm;
  };
  std::vector<Sample> samples;  // of the valid columns, from base to tip
  samples.reserve(columns_.size());
  const bool x_by_column = camera_.is_linear() && camera_.is_perspective();
  std::optional<Eigen::Vector2d> before;  // x and z, mm
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    const std::size_t u = base_at_low_u_ ? i : columns_.size() - 1 - i;
    const FaceColumn& column = columns_[u];
    if (!column.valid) continue;
    Eigen::Vector2d here;
    if (x_by_column) {
      here = {column.z_mm * x_of_column(static_cast<double>(u)), column.z_mm};
    } else {
      const auto ray =
          camera_.unproject({static_cast<double>(u), 0.5 * (column.upper_v + column.lower_v)});
      if (!ray) continue;
      const Eigen::Vector3d point_mm = ray->point_at(column.z_mm);
      here = {point_mm.x(), point_mm.z()};
    }
    const double step_mm = before ? (here - *before).norm() : 0.0;
    samples.push_back({u, samples.empty() ? 0.0 : samples.back().length_mm + step_mm});
    before = here;
  }
  length_mm_.assign(columns_.size(), 0.0);
  if (samples.size() < 2) return;
  // An end lies between columns. Lengths are extrapolated with the slope of the outermost two
  // columns.
  const double direction = base_at_low_u_ ? 1.0 : -1.0;
  const auto length_to = [&](double u) {
    const auto part = [&](const Sample& a, const Sample& b) {
      return a.length_mm + (b.length_mm - a.length_mm) * (u - static_cast<double>(a.u)) /
                               (static_cast<double>(b.u) - static_cast<double>(a.u));
    };
    std::size_t i = 1;
    while (i + 1 < samples.size() && direction * (u - static_cast<double>(samples[i].u)) > 0) ++i;
    return part(samples[i - 1], samples[i]);
  };
  const auto base = end_column(true), tip = end_column(false);
  const double zero_mm = base ? length_to(*base) : 0.0;
  const double first_mm = std::min(zero_mm, 0.0);
  const double last_mm = std::max(tip ? length_to(*tip) : 0.0, samples.back().length_mm);
  std::size_t next = 0;
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    const std::size_t u = base_at_low_u_ ? i : columns_.size() - 1 - i;
    if (next < samples.size() && samples[next].u == u) ++next;
    const double length_mm = next == 0 ? first_mm
                             : next == samples.size() && samples.back().u != u
                                 ? last_mm
                                 : samples[next - 1].length_mm;
    length_mm_[u] = length_mm - zero_mm;
  }
}

double FaceShape::end_sd_mm(bool at_base, double column) const {
  const bool is_first = at_base == base_at_low_u_;
  const double inwards = is_first ? 1.0 : -1.0;
  const double inner = std::clamp(column + 2 * inwards, 0.0, width_px() - 1.0);
  const double mm_per_px = std::abs(length_at(inner + inwards) - length_at(inner));
  const double sd_px = (is_first ? ends_.first : ends_.last)->sd_px;
  // The crossing of the mean level is slightly off a blurred end.
  constexpr double kEndBias_px = 0.07;
  return mm_per_px * std::hypot(sd_px, kEndBias_px);
}

std::optional<double> FaceShape::base_sd_mm() const {
  if (full_image_) return 0.0;
  const auto end = end_column(true);
  if (!end) return std::nullopt;
  return end_sd_mm(true, *end);
}

std::optional<FaceShape::TipEnd> FaceShape::tip_end() const {
  if (full_image_) return std::nullopt;
  const auto end = end_column(false);
  if (!end) return std::nullopt;
  // Constant from the end on.
  const double length_mm = length_at(base_at_low_u_ ? width_px() - 1.0 : 0.0);
  const FaceColumn& column = columns_[static_cast<std::size_t>(
      std::clamp(std::lround(*end), 0L, static_cast<long>(columns_.size()) - 1))];
  const double slope = (base_at_low_u_ ? ends_.last : ends_.first)->slope;
  const double lean_px = 0.5 * slope * (column.lower_v - column.upper_v);
  return TipEnd{length_mm, end_sd_mm(false, *end), lean_px};
}

double FaceShape::length_at(double u) const {
  const double clamped = std::clamp(u, 0.0, static_cast<double>(columns_.size() - 1));
  const auto left = static_cast<std::size_t>(clamped);
  const std::size_t right = std::min(left + 1, columns_.size() - 1);
  const double part = clamped - static_cast<double>(left);
  return length_mm_[left] + part * (length_mm_[right] - length_mm_[left]);
}

Eigen::Vector2d FaceShape::position_mm(double u, double v) const {
  const auto nearest = std::clamp<long>(std::lround(u), 0, width_px() - 1);
  const FaceColumn& column = columns_[static_cast<std::size_t>(nearest)];
  const double across = column.valid ? (v - 0.5 * (column.upper_v + column.lower_v)) *
                                           camera_.mm_per_px_at(column.z_mm)
                                     : 0.0;
  return {length_at(u), across};
}

std::optional<FaceShape::Middle> FaceShape::middle_at(double u) const {
  if (full_image_) return std::nullopt;
  const auto [first, last] = valid_columns(columns_);
  return middle_within(std::clamp(u, static_cast<double>(first), static_cast<double>(last)));
}

std::optional<FaceShape::Middle> FaceShape::middle_within(double u) const {
  const auto left = static_cast<std::size_t>(u);
  const std::size_t right = std::min(left + 1, columns_.size() - 1);
  const auto middle_v = [](const FaceColumn& c) { return 0.5 * (c.upper_v + c.lower_v); };
  const double v =
      middle_v(columns_[left]) +
      (u - static_cast<double>(left)) * (middle_v(columns_[right]) - middle_v(columns_[left]));
  const auto ray = camera_.unproject({u, v});
  if (!ray) return std::nullopt;
  const double inverse_z = inverse_z_of(*ray);
  const Eigen::Vector2d seen = seen_from(*ray, inverse_z);
  const auto here = across_from(seen.x(), seen.y(), inverse_depth_at(seen.x()));
  if (!here) return std::nullopt;
  const double across_y = std::hypot(here->normal.x(), here->normal.z());
  return Middle{u, length_position(*this, u), ray->point_at(here->z_mm),
                here->normal.z() / across_y, -here->normal.x() / across_y};
}

std::optional<FaceShape::Middle> FaceShape::foot_of(double x_mm, double z_mm) const {
  if (full_image_) return std::nullopt;
  // The offset to the point changes from ahead to behind along the face; the foot lies between.
  const auto ahead = [&](const Middle& m) {
    return (x_mm - m.point_mm.x()) * m.tangent_x + (z_mm - m.point_mm.z()) * m.tangent_z;
  };
  auto low = middle_at(0.0), high = middle_at(static_cast<double>(columns_.size() - 1));
  if (!low || !high) return std::nullopt;
  if (ahead(*low) <= 0.0) return low;
  if (ahead(*high) >= 0.0) return high;
  constexpr double kClosePx = 0.1;
  while (high->u - low->u > kClosePx) {
    const auto between = middle_within(0.5 * (low->u + high->u));
    if (!between) return std::nullopt;
    (ahead(*between) > 0.0 ? low : high) = between;
  }
  return low;
}

std::optional<Eigen::Vector2d> FaceShape::direction_of(const Eigen::Vector2d& pixel) const {
  const auto ray = camera_.unproject(pixel);
  if (!ray) return std::nullopt;
  return seen_from(*ray, inverse_z_of(*ray));
}

}  // namespace alltact
