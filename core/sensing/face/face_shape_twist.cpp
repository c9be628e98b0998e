// Face shapes with turned cross-sections (twist).
#include "core/numerics/chebyshev.h"
#include "core/numerics/least_squares.h"
#include "core/sensing/face/face_shape.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace alltact {
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
  const auto valid = [](const FaceColumn& c) { return c.valid; };
  const auto first = std::find_if(columns_.begin(), columns_.end(), valid) - columns_.begin();
  const auto last = columns_.rend() - std::find_if(columns_.rbegin(), columns_.rend(), valid) - 1;
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
  const auto valid = std::count_if(
      shape.columns_.begin(), shape.columns_.end(), [](const FaceColumn& c) { return c.valid; });
  if (valid < 5) return std::nullopt;
  shape.finish();
  return shape;
}

}  // namespace alltact
