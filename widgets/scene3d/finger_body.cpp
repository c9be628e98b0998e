#include "widgets/scene3d/finger_body.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

namespace alltact {
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
FingerBody::Section moved(const FingerBody::Section& section,
                          const Eigen::Vector3d& along_mm,
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
