#include "calibration/reference/bend_ghost.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

namespace alltact {
namespace {

constexpr int kSections = 24;
constexpr double kBeyond = 1.1;  // times what is needed

/// A section of the face: the points of both edges, and the fraction of the length.
struct Section {
  Eigen::Vector3d upper, lower, normal;
  double part = 0;  ///< 0 at the base, 1 at the tip
};

std::vector<Section> sections_of(const FaceShape& shape) {
  std::vector<Section> sections;
  std::vector<int> valid;
  for (int u = 0; u < shape.width_px(); ++u)
    if (shape.columns()[static_cast<std::size_t>(u)].valid) valid.push_back(u);
  if (valid.size() < 2 * kSections) return sections;
  if (!shape.base_at_low_u()) std::reverse(valid.begin(), valid.end());
  const double length = shape.length_at(valid.back());
  for (int i = 0; i <= kSections; ++i) {
    const int u = valid[i * (valid.size() - 1) / kSections];
    const auto rows = shape.rows(u, 0);
    const auto upper = shape.at(u, rows.first), lower = shape.at(u, rows.last);
    if (rows.first >= rows.last || !upper || !lower || !(length > 0)) continue;
    sections.push_back({upper->view_point_mm,
                        lower->view_point_mm,
                        (upper->normal + lower->normal).normalized(),
                        shape.length_at(u) / length});
  }
  return sections;
}

}  // namespace

std::optional<BentOutline> bent_outline(const FaceShape& shape, const TipMotion& motion) {
  const auto sections = sections_of(shape);
  if (sections.size() < 2) return std::nullopt;
  const Eigen::Vector3d by =
      motion.bend_mm * sections.back().normal + motion.sway_mm * Eigen::Vector3d::UnitY();
  BentOutline outline;
  for (const Section& section : sections) {
    const double weight = section.part * section.part;
    const Eigen::Vector3d middle = 0.5 * (section.upper + section.lower);
    const Eigen::AngleAxisd turn(weight * motion.twist_deg * M_PI / 180, Eigen::Vector3d::UnitZ());
    const auto seen = [&](const Eigen::Vector3d& point) {
      return shape.camera().project(middle + turn * (point - middle) + weight * by);
    };
    const auto upper = seen(section.upper), lower = seen(section.lower);
    if (!upper || !lower) continue;
    outline.upper.push_back(*upper);
    outline.lower.push_back(*lower);
  }
  return outline.upper.size() < 2 ? std::nullopt : std::optional(outline);
}

TipMotion motion_left(const BendState& image, BendDirection direction) {
  TipMotion left;
  if (!image.now) return left;
  const auto to = [](double now, double need, bool is_up) {
    return (is_up ? 1 : -1) * kBeyond * need - now;
  };
  switch (direction) {
    case BendDirection::kAway:
    case BendDirection::kTowards:
      left.bend_mm = to(image.now->bend_mm, image.need.bend_mm, direction == BendDirection::kAway);
      break;
    case BendDirection::kDown:
    case BendDirection::kUp:
      left.sway_mm = to(image.now->sway_mm, image.need.sway_mm, direction == BendDirection::kDown);
      break;
    case BendDirection::kTwistRight:
    case BendDirection::kTwistLeft:
      left.twist_deg =
          to(image.now->twist_deg, image.need.twist_deg, direction == BendDirection::kTwistRight);
      break;
  }
  return left;
}

}  // namespace alltact
