#include "widgets/scene3d/face_surface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <Eigen/Geometry>

namespace alltact {
namespace {

struct Columns {
  int first = 0, last = -1;
};

/// From the first to the last column that has rows.
Columns columns_of(const FaceShape& shape) {
  Columns columns;
  const auto has_rows = [&](int u) { return shape.rows(u, 0).first < shape.rows(u, 0).last; };
  while (columns.first < shape.width_px() && !has_rows(columns.first)) ++columns.first;
  columns.last = shape.width_px() - 1;
  while (columns.last > columns.first && !has_rows(columns.last)) --columns.last;
  return columns;
}

/// The nearest column to u that has rows; between the first and the last there is one.
int usable_column(const FaceShape& shape, int u) {
  for (int step = 0;; ++step)
    for (const int near : {u - step, u + step})
      if (near >= 0 && near < shape.width_px() &&
          shape.rows(near, 0).first < shape.rows(near, 0).last)
        return near;
}

/// Both edges of the face at a fractional column: interpolated between its neighbours, so that the
/// grid's border is as smooth as the face's.
struct EdgeRows {
  double first, last;
};
EdgeRows edge_rows(const FaceShape& shape, int u) {
  const auto rows = shape.rows(u, 0);
  const FaceColumn& column = shape.columns()[static_cast<std::size_t>(u)];
  // The outermost pixels lie half a pixel inside; where an end cuts a column short, the end gives
  // the edge.
  const auto exact = [](double edge, int pixel) {
    return std::abs(edge - pixel) < 1 ? edge : static_cast<double>(pixel);
  };
  return {exact(column.upper_v + 0.5, rows.first), exact(column.lower_v - 0.5, rows.last)};
}
EdgeRows edge_rows_between(const FaceShape& shape, double u) {
  const int left = static_cast<int>(std::floor(u));
  const int a = usable_column(shape, left);
  const int b = usable_column(shape, std::min(left + 1, shape.width_px() - 1));
  const EdgeRows one = edge_rows(shape, a), two = edge_rows(shape, b);
  const double part = b > a ? std::clamp((u - a) / (b - a), 0.0, 1.0) : 0.0;
  return {one.first + part * (two.first - one.first), one.last + part * (two.last - one.last)};
}

/// Bilinear over those of the four pixels that have a value, where they hold most of the weight.
float depth_between(const cv::Mat& depth_mm, double u, double v) {
  const int left = static_cast<int>(std::floor(u)), upper = static_cast<int>(std::floor(v));
  double sum = 0, share = 0;
  for (const auto& [x, y] : {std::pair{0, 0}, {1, 0}, {0, 1}, {1, 1}}) {
    const int i = left + x, j = upper + y;
    if (i < 0 || j < 0 || i >= depth_mm.cols || j >= depth_mm.rows) continue;
    const float depth = depth_mm.at<float>(j, i);
    if (!std::isfinite(depth)) continue;
    const double part = (x == 0 ? left + 1 - u : u - left) * (y == 0 ? upper + 1 - v : v - upper);
    sum += part * static_cast<double>(depth);
    share += part;
  }
  constexpr double kEnough = 0.5;
  return share >= kEnough ? static_cast<float>(sum / share)
                          : std::numeric_limits<float>::quiet_NaN();
}

/// The edges lie up to two pixels outside the last pixels with a depth.
float depth_within(const cv::Mat& depth_mm, double u, double v, const EdgeRows& edges) {
  constexpr int kMargin = 2;
  float depth = depth_between(depth_mm, u, v);
  const int inward = v < edges.first + kMargin ? 1 : v > edges.last - kMargin ? -1 : 0;
  for (int k = 1; k <= kMargin && inward != 0 && !std::isfinite(depth); ++k)
    depth = depth_between(depth_mm, u, v + k * inward);
  return depth;
}

/// The side face at row 0 or at the last row, straight behind the face: the edge, and below it the
/// same edge `deep_mm` further in.
cv::Mat side_wall(const cv::Mat& untouched_mm, int row, double deep_mm) {
  cv::Mat wall(2, untouched_mm.cols, CV_32FC3);
  for (int i = 0; i < wall.cols; ++i) {
    const auto& edge = untouched_mm.at<cv::Vec3f>(row, i);
    const Eigen::Vector3d in = deep_mm * inward_normal(untouched_mm, i, row);
    wall.at<cv::Vec3f>(0, i) = edge;
    wall.at<cv::Vec3f>(1, i) = edge + cv::Vec3f(cv::Vec3d(in.x(), in.y(), in.z()));
  }
  return wall;
}

/// Intersections of the markers' rays with the side faces.
std::vector<SurfaceMarker> markers_on(const FaceSurface& surface, const FaceShape& shape,
                                      const Markers& markers) {
  const double deep_mm = 2 * shape.face().width_mm;  // deeper than any finger's dots
  const std::size_t per_row = markers.size() / 2;
  std::vector<SurfaceMarker> found;
  for (const bool is_upper : {true, false}) {
    const cv::Mat wall =
        side_wall(surface.untouched_mm, is_upper ? 0 : surface.rows() - 1, deep_mm);
    for (std::size_t k = 0; k < per_row; ++k) {
      const Marker& marker = markers[is_upper ? k : per_row + k];
      const auto ray = shape.camera().unproject({marker.u, marker.v});
      if (!ray) continue;
      const auto hit = first_hit(wall, ray->origin_mm, ray->direction);
      if (!hit) continue;
      const cv::Vec3f at = point_between(wall, *hit);
      found.push_back({{at[0], at[1], at[2]}, hit->x, hit->y * deep_mm, marker.seen});
    }
  }
  return found;
}

/// `depth`: empty where none is known.
std::optional<FaceSurface> surface_of(const FrameResult& result, const cv::Mat& depth,
                                      const Face& face, int columns, int rows) {
  CV_Assert(columns >= 2 && rows >= 2);
  const FaceShape& shape = *result.shape;
  const Columns range = columns_of(shape);
  if (range.last <= range.first) return std::nullopt;
  FaceSurface surface;
  surface.untouched_mm.create(rows, columns, CV_32FC3);
  surface.depth_mm.create(rows, columns, CV_32FC1);
  surface.pixel.create(rows, columns, CV_32FC2);
  for (int i = 0; i < columns; ++i) {
    double u = range.first + static_cast<double>(i) * (range.last - range.first) / (columns - 1);
    // The nearest column with a face stands in for columns without one.
    if (shape.rows(static_cast<int>(std::lround(u)), 0).first >=
        shape.rows(static_cast<int>(std::lround(u)), 0).last)
      u = usable_column(shape, static_cast<int>(std::lround(u)));
    const EdgeRows inside = edge_rows_between(shape, u);
    surface.along_mm.push_back(shape.length_at(u));
    for (int j = 0; j < rows; ++j) {
      const double v = inside.first + j * (inside.last - inside.first) / (rows - 1);
      const auto local = shape.at(u, v);
      if (!local) return std::nullopt;
      const Eigen::Vector3f at =
          untouched_point_mm(*local, face.layer_mm, MappingAlong::kZ).cast<float>();
      surface.untouched_mm.at<cv::Vec3f>(j, i) = {at.x(), at.y(), at.z()};
      surface.depth_mm.at<float>(j, i) = depth.empty() ? std::numeric_limits<float>::quiet_NaN()
                                                       : depth_within(depth, u, v, inside);
      surface.pixel.at<cv::Vec2f>(j, i) = {static_cast<float>(u), static_cast<float>(v)};
    }
  }
  surface.has_body = face.kind == FaceKind::kFinRay;
  if (surface.has_body && result.markers)
    surface.markers = markers_on(surface, shape, *result.markers);
  return surface;
}

}  // namespace

Eigen::Vector3d inward_normal(const cv::Mat& grid, int column, int row) {
  const auto at = [&](int j, int i) {
    const auto& p =
        grid.at<cv::Vec3f>(std::clamp(j, 0, grid.rows - 1), std::clamp(i, 0, grid.cols - 1));
    return Eigen::Vector3d(p[0], p[1], p[2]);
  };
  const Eigen::Vector3d along = at(row, column + 1) - at(row, column - 1);
  // From edge to edge: neighbouring rows lie too near for a float's last digits.
  const Eigen::Vector3d down = at(grid.rows - 1, column) - at(0, column);
  return down.cross(along).normalized();
}

cv::Size grid_for(const FrameResult& result, int vertices) {
  if (!result.shape) return {2, 2};
  const Columns columns = columns_of(*result.shape);
  const int length = std::max(1, columns.last - columns.first);
  const int middle = usable_column(*result.shape, (columns.first + columns.last) / 2);
  const auto rows = result.shape->rows(middle, 0);
  const int width = std::max(1, rows.last - rows.first);
  double step = std::sqrt(static_cast<double>(length) * width / vertices);
  if (result.mesh_step_px > 1) step = std::max<double>(step, result.mesh_step_px);
  return {std::max(2, static_cast<int>(std::lround(length / step))),
          std::max(2, static_cast<int>(std::lround(width / step)))};
}

std::optional<FaceSurface> face_surface(const FrameResult& result, const Face& face, int columns,
                                        int rows) {
  if (!result.shape || !result.depth) return std::nullopt;
  return surface_of(result, result.depth->depth_mm, face, columns, rows);
}

std::optional<FaceSurface> uncalibrated_surface(const FrameResult& result, const Face& face,
                                                int columns, int rows) {
  if (!result.shape) return std::nullopt;
  return surface_of(result, {}, face, columns, rows);
}

namespace {

template <class Vector>
Vector between(const cv::Mat& grid, cv::Point2d position) {
  const int i = std::clamp(static_cast<int>(position.x), 0, grid.cols - 2);
  const int j = std::clamp(static_cast<int>(position.y), 0, grid.rows - 2);
  const auto x = static_cast<float>(position.x - i), y = static_cast<float>(position.y - j);
  return (1 - y) * ((1 - x) * grid.at<Vector>(j, i) + x * grid.at<Vector>(j, i + 1)) +
         y * ((1 - x) * grid.at<Vector>(j + 1, i) + x * grid.at<Vector>(j + 1, i + 1));
}

Eigen::Vector3d at(const cv::Mat& grid, int i, int j) {
  const auto& p = grid.at<cv::Vec3f>(j, i);
  return {p[0], p[1], p[2]};
}

/// Moeller and Trumbore: distance along the ray, and the weights of the second and third corner.
struct Hit {
  double distance, second, third;
};
std::optional<Hit> hit(const Eigen::Vector3d& from, const Eigen::Vector3d& direction,
                       const std::array<Eigen::Vector3d, 3>& corner) {
  const Eigen::Vector3d one = corner[1] - corner[0], two = corner[2] - corner[0];
  const Eigen::Vector3d p = direction.cross(two);
  const double determinant = one.dot(p);
  if (determinant == 0) return std::nullopt;
  const Eigen::Vector3d t = from - corner[0];
  const double second = t.dot(p) / determinant;
  if (!(second >= 0 && second <= 1)) return std::nullopt;
  const Eigen::Vector3d q = t.cross(one);
  const double third = direction.dot(q) / determinant;
  if (!(third >= 0 && second + third <= 1)) return std::nullopt;
  const double distance = two.dot(q) / determinant;
  if (!(distance > 0)) return std::nullopt;
  return Hit{distance, second, third};
}

/// Bounding sphere test: the ray's distance from the middle is at most half the diagonal.
bool may_meet(const Eigen::AlignedBox3d& box, const Eigen::Vector3d& from,
              const Eigen::Vector3d& direction) {
  const Eigen::Vector3d away = box.center() - from;
  const double along = away.dot(direction) / direction.squaredNorm();
  constexpr double kRounding = 1.0001;
  return (away - along * direction).squaredNorm() <=
         kRounding * 0.25 * box.diagonal().squaredNorm();
}

}  // namespace

cv::Vec2f pixel_between(const cv::Mat& grid, cv::Point2d position) {
  return between<cv::Vec2f>(grid, position);
}

cv::Vec3f point_between(const cv::Mat& grid, cv::Point2d position) {
  return between<cv::Vec3f>(grid, position);
}

std::optional<cv::Point2d> grid_position_of(const FaceSurface& surface, cv::Point2d pixel) {
  const cv::Mat& grid = surface.pixel;
  const auto u = [&](int i) { return static_cast<double>(grid.at<cv::Vec2f>(0, i)[0]); };
  if (grid.empty() || !(pixel.x >= u(0) && pixel.x <= u(grid.cols - 1))) return std::nullopt;
  int low = 0, high = grid.cols - 1;
  while (high - low > 1) (u((low + high) / 2) <= pixel.x ? low : high) = (low + high) / 2;
  const double width = u(high) - u(low);
  const double share = width > 0 ? (pixel.x - u(low)) / width : 0.0;
  const auto v = [&](int j) {
    return (1 - share) * grid.at<cv::Vec2f>(j, low)[1] + share * grid.at<cv::Vec2f>(j, high)[1];
  };
  const double first = v(0), last = v(grid.rows - 1);
  // Edges between columns of the grid differ a little from those of the image.
  constexpr double kSlack_px = 1.5;
  if (!(pixel.y >= first - kSlack_px && pixel.y <= last + kSlack_px) || first == last)
    return std::nullopt;
  const double part = std::clamp((pixel.y - first) / (last - first), 0.0, 1.0);
  return cv::Point2d(low + share, part * (grid.rows - 1));
}

GridBoxes::GridBoxes(const cv::Mat& drawn_mm) : drawn_mm_(drawn_mm) {
  constexpr int kCells = 16;
  for (int j = 0; j + 1 < drawn_mm.rows; j += kCells)
    for (int i = 0; i + 1 < drawn_mm.cols; i += kCells) {
      Box& box = boxes_.emplace_back();
      box.cells = {i, j, std::min(kCells, drawn_mm.cols - 1 - i),
                   std::min(kCells, drawn_mm.rows - 1 - j)};
      for (int row = j; row <= j + box.cells.height; ++row)
        for (int column = i; column <= i + box.cells.width; ++column)
          box.bounds.extend(at(drawn_mm, column, row));
    }
}

std::optional<cv::Point2d> GridBoxes::first_hit(const Eigen::Vector3d& from,
                                                const Eigen::Vector3d& direction) const {
  double nearest = std::numeric_limits<double>::infinity();
  std::optional<cv::Point2d> position;
  for (const Box& box : boxes_) {
    if (!may_meet(box.bounds, from, direction)) continue;
    for (int j = box.cells.y; j < box.cells.y + box.cells.height; ++j) {
      for (int i = box.cells.x; i < box.cells.x + box.cells.width; ++i) {
        const Eigen::Vector3d a = at(drawn_mm_, i, j), below = at(drawn_mm_, i, j + 1);
        const Eigen::Vector3d right = at(drawn_mm_, i + 1, j), over = at(drawn_mm_, i + 1, j + 1);
        if (const auto found = hit(from, direction, {a, below, right});
            found && found->distance < nearest) {
          nearest = found->distance;
          position = cv::Point2d(i + found->third, j + found->second);
        }
        if (const auto found = hit(from, direction, {over, right, below});
            found && found->distance < nearest) {
          nearest = found->distance;
          position = cv::Point2d(i + 1 - found->third, j + 1 - found->second);
        }
      }
    }
  }
  return position;
}

std::optional<cv::Point2d> first_hit(const cv::Mat& drawn_mm, const Eigen::Vector3d& from,
                                     const Eigen::Vector3d& direction) {
  return GridBoxes(drawn_mm).first_hit(from, direction);
}

namespace {

constexpr int kSections = 41;
constexpr double kMinBase = 0.3, kMaxBase = 4, kMinTip = 0.12;  // depth in face widths
constexpr double kAroundDot_mm = 1.5;  // extent of the side face beyond a dot's centre
constexpr double kBaseLength_mm = 10, kBaseWider_mm = 3;

Eigen::Vector3d vertex(const cv::Mat& grid, int row, int column) {
  const auto& p = grid.at<cv::Vec3f>(row, column);
  return {p[0], p[1], p[2]};
}

/// From base to tip, evenly over the grid's columns.
std::vector<int> columns_from_base(const FaceSurface& surface) {
  const int last = surface.columns() - 1;
  const int count = std::min(kSections, surface.columns());
  const bool base_is_first =
      surface.along_mm.empty() || surface.along_mm.front() <= surface.along_mm.back();
  std::vector<int> columns;
  for (int k = 0; k < count; ++k) {
    const int column = static_cast<int>(std::lround(static_cast<double>(k) * last / (count - 1)));
    columns.push_back(base_is_first ? column : last - column);
  }
  return columns;
}

/// From the face's outer side to the back, at the base and at the tip.
struct Depths {
  double base_mm, tip_mm;
  [[nodiscard]] double at(double part) const { return base_mm + part * (tip_mm - base_mm); }
};
Depths depths_of(const FaceSurface& surface, const std::vector<int>& columns) {
  const cv::Mat& face = surface.untouched_mm;
  const int begin = columns.front(), rows = face.rows;
  const double width_mm = (vertex(face, 0, begin) - vertex(face, rows - 1, begin)).norm();
  const Eigen::Vector3d middle = 0.5 * (vertex(face, 0, begin) + vertex(face, rows - 1, begin));
  // The camera is the origin.
  const double camera_mm = inward_normal(face, begin, rows / 2).dot(-middle);
  Depths depths{std::clamp(camera_mm, kMinBase * width_mm, kMaxBase * width_mm),
                kMinTip * width_mm};
  const double begins = begin, ends = columns.back();
  for (const SurfaceMarker& marker : surface.markers) {
    const double part = (marker.column - begins) / (ends - begins);
    const double needed_mm = marker.behind_mm + kAroundDot_mm;
    constexpr double kHalf = 0.5;
    if (part < kHalf)
      depths.base_mm = std::max(depths.base_mm, needed_mm);
    else
      depths.tip_mm = std::max(depths.tip_mm, (needed_mm - (1 - part) * depths.base_mm) / part);
  }
  return depths;
}

/// A section moved `along_mm` away from the base, and widened on all sides.
FingerBody::Section moved(const FingerBody::Section& section, const Eigen::Vector3d& along_mm,
                          double wider_mm) {
  const Eigen::Vector3d middle = 0.25 * (section[0] + section[1] + section[2] + section[3]);
  const Eigen::Vector3d across = (section[1] - section[0]).normalized();
  const Eigen::Vector3d behind = (section[3] - section[0]).normalized();
  FingerBody::Section other = section;
  for (Eigen::Vector3d& corner : other) {
    const Eigen::Vector3d from = corner - middle;
    corner += along_mm + wider_mm * (std::copysign(1.0, from.dot(across)) * across +
                                     std::copysign(1.0, from.dot(behind)) * behind);
  }
  return other;
}

}  // namespace

std::vector<Eigen::Vector3d> FingerBody::corners() const {
  std::vector<Eigen::Vector3d> all;
  for (const Section& section : sections) all.insert(all.end(), section.begin(), section.end());
  if (sections.empty()) return all;
  for (const Section& end : base) all.insert(all.end(), end.begin(), end.end());
  return all;
}

FingerBody body_of(const FaceSurface& surface) {
  FingerBody body;
  if (!surface.has_body || surface.columns() < 3) return body;
  const cv::Mat& face = surface.untouched_mm;
  const std::vector<int> columns = columns_from_base(surface);
  const Depths depths = depths_of(surface, columns);
  const int last_row = face.rows - 1;
  for (std::size_t k = 0; k < columns.size(); ++k) {
    const double part = static_cast<double>(k) / static_cast<double>(columns.size() - 1);
    const Eigen::Vector3d upper = vertex(face, 0, columns[k]);
    const Eigen::Vector3d lower = vertex(face, last_row, columns[k]);
    const Eigen::Vector3d in = depths.at(part) * inward_normal(face, columns[k], face.rows / 2);
    body.sections.push_back({upper, lower, lower + in, upper + in});
  }
  const Eigen::Vector3d along =
      (body.sections[0][0] - body.sections[1][0] + body.sections[0][1] - body.sections[1][1])
          .normalized();
  body.base = {moved(body.sections[0], kBaseLength_mm * along, kBaseWider_mm),
               moved(body.sections[0], Eigen::Vector3d::Zero(), kBaseWider_mm)};
  return body;
}

}  // namespace alltact
