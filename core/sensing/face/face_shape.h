// The untouched face in 3D, from its two edges (Fin Ray) or as the known plane (flat sensor).
#pragma once

#include "core/base/result.h"
#include "core/camera/camera.h"
#include "core/finger/finger.h"
#include "core/sensing/face/face_edges.h"

#include <optional>
#include <vector>

#include <Eigen/Core>

namespace alltact {

// Twist: rotation of a face's cross-sections about the finger's length, from base to tip.

/// Tangent of the twist over the face's length, t from -1 to 1: c0 + c1 t + c2 (2 t^2 - 1).
/// Positive: the side at large v is turned away from the camera.
struct FaceTwist {
  static constexpr int kTerms = 3;

  Eigen::Vector3d coefficients = Eigen::Vector3d::Zero();
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  /// Yaw of the cross-sections per slope dy/ds of a swaying middle line: 1 as in a beam, 0 where
  /// they slide past each other.
  double yaw_per_slope = 0;

  [[nodiscard]] static Eigen::RowVector3d terms_at(double t) { return {1.0, t, 2.0 * t * t - 1.0}; }
  [[nodiscard]] double at(double t) const { return terms_at(t) * coefficients; }
  [[nodiscard]] double variance_at(double t) const {
    return terms_at(t) * covariance * terms_at(t).transpose();
  }
};

struct RobustPolynomial;

/// One pixel column of the face. With lens distortion the values hold on the middle of the face;
/// FaceShape::at is exact for every pixel.
struct FaceColumn {
  double upper_v = 0, lower_v = 0;  ///< fitted edges, px
  double z_mm = 0;                  ///< view face
  double z_sd_mm = 0;               ///< standard deviation of z_mm
  bool valid = false;               ///< false: off the face, or z_sd_mm above the limit
};

/// Scaled column, the argument of the Chebyshev series along the face: t from -1 to 1 over the
/// image.
struct ScaledColumn {
  double middle_px = 0, half_px = 1;
  [[nodiscard]] double at(double u) const { return (u - middle_px) / half_px; }
};

/// The view face as a ruled surface: straight across the finger, smooth along it. Across is along y
/// unless the finger twists (`twisted`).
class FaceShape {
 public:
  /// Fits both edges robustly (Tukey) as Chebyshev polynomials of the column. Then 1/z = (width of
  /// the face in the image) / (f W), which is linear and unbiased in the width; z is never
  /// averaged. A column is valid between the face's ends (between trusted edges where an end was
  /// not found) with z_sd_mm below `z_sd_limit_mm`. Errors: an outline that jumps, since the finger
  /// hides a part of itself (face_edges.h); too few trusted columns; a fit whose z is not
  /// positive and finite.
  static Result<FaceShape> fit(const FaceEdges& edges, const Camera& camera, const Face& face,
                               int degree, double z_sd_limit_mm = 0.5);

  /// Fits a face with turned cross-sections of width W to the same edges. Both ends of each
  /// cross-section lie on the edges; its direction is
  ///   e = (y - yaw t + twist n) / |.|,
  /// t along the middle line, n normal to it (both without y). nullopt: no such face (z not
  /// positive and finite), or a flat sensor.
  [[nodiscard]] std::optional<FaceShape> twisted(const FaceTwist& twist) const;
  /// The argument of `twisted`.
  [[nodiscard]] const std::optional<FaceTwist>& twist() const { return twist_; }

  /// The plane z = face.plane_z_mm; every pixel is on it.
  static FaceShape plane(const Camera& camera, const Face& face);

  [[nodiscard]] const Camera& camera() const { return camera_; }
  [[nodiscard]] const Face& face() const { return face_; }
  [[nodiscard]] const std::vector<FaceColumn>& columns() const { return columns_; }
  [[nodiscard]] int width_px() const { return static_cast<int>(columns_.size()); }
  /// True when the finger's base (near the camera, wide) is at small u.
  [[nodiscard]] bool base_at_low_u() const { return base_at_low_u_; }

  /// First and last row of the face in column u, at least `margin_px` inside its edges and ends.
  /// Empty (first > last) where the column is not valid.
  struct Rows {
    int first, last;
  };
  [[nodiscard]] Rows rows(int u, double margin_px) const;

  /// Point of a pixel on the view face, outward unit normal (away from the camera), and cosine of
  /// the angle between that normal and z. nullopt off the valid columns or rays.
  struct Local {
    Eigen::Vector3d view_point_mm;
    Eigen::Vector3d normal;
    double cos_incline;
  };
  [[nodiscard]] std::optional<Local> at(double u, double v) const;

  /// Area that one pixel covers; nullopt as above. A separate call, because through a lens it costs
  /// three times as much as the point.
  struct PixelArea {
    double on_face_mm2;
    double projected_mm2;  ///< projected along z
  };
  [[nodiscard]] std::optional<PixelArea> pixel_area(double u, double v) const;

  /// 1 / cos(incline) on the middle of the face, by column: ratio of a length along z to the one
  /// along the normal. 1 where the column is not valid.
  [[nodiscard]] const std::vector<float>& along_z_per_normal() const { return along_z_per_normal_; }

  /// Position of a pixel on the face: mm along it from its base (length_at) and across it from its
  /// middle line. For pixels on the face or near it; across is 0 off the valid columns.
  [[nodiscard]] Eigen::Vector2d position_mm(double u, double v) const;

  /// Arc length from the face's base end to column u, mm, on the middle of the face; increases from
  /// base to tip. Begins at the first valid column where no base end was found. Constant beyond
  /// both ends.
  [[nodiscard]] double length_at(double u) const;
  /// Standard deviation of the origin of length_at, mm; 0 on a flat sensor. nullopt: the face's
  /// base end is outside the image or was not found, so that the length before it is unknown.
  [[nodiscard]] std::optional<double> base_sd_mm() const;
  /// The face's tip end. nullopt as above, and on a flat sensor.
  struct TipEnd {
    double length_mm;  ///< length_at
    double sd_mm;      ///< by the end's column alone; the shape's own error is FaceColumn::z_sd_mm
    double lean_px;    ///< column of the end at the lower edge minus that in the middle
  };
  [[nodiscard]] std::optional<TipEnd> tip_end() const;

  /// A point on the middle line between the edges.
  struct Middle {
    double u;                     ///< column
    double t;                     ///< -1 at the base end, 1 at the tip end
    Eigen::Vector3d point_mm;     ///< on the view face
    double tangent_x, tangent_z;  ///< unit vector along the face, towards large u
  };
  /// At a column, or at the nearest valid one. nullopt on a flat sensor.
  [[nodiscard]] std::optional<Middle> middle_at(double u) const;
  /// Foot of the normal through (x, any y, z) on the middle of the face, limited to its ends.
  [[nodiscard]] std::optional<Middle> foot_of(double x_mm, double z_mm) const;
  /// Direction (x, y) at z = 1 of a pixel's point on the face, as a camera without distortion or
  /// window images it.
  [[nodiscard]] std::optional<Eigen::Vector2d> direction_of(const Eigen::Vector2d& pixel) const;

 private:
  FaceShape(const Camera& camera, const Face& face) : camera_(camera), face_(face) {}
  bool set_edges(const RobustPolynomial& upper, const RobustPolynomial& lower);  // linear cameras
  bool fit_inverse_depth(double first, double last, int degree);
  bool fit_to_rays(const std::vector<Ray>& uppers, const std::vector<Ray>& lowers, Eigen::Index n);
  double inverse_z_of(const Ray& ray) const;
  /// Direction (x, y) of a ray's point at depth z, as a camera without a window images it.
  static Eigen::Vector2d seen_from(const Ray& ray, double inverse_z) {
    return ray.direction.head<2>() + inverse_z * ray.origin_mm.head<2>();
  }
  std::optional<Middle> middle_within(double u) const;  // u between valid columns
  void compute_across();
  std::optional<double> end_column(bool at_base) const;  // on the middle of the face
  double end_sd_mm(bool at_base, double column) const;   // along the face
  void compute_lengths();
  double z_of_column(int u) const;  // on the middle of the face; 0 where there is none
  void finish();
  // Conversion between a ray's x and its column in a lens without distortion.
  double x_of_column(double u) const;
  double column_of(double x) const;
  /// 1/z = a + b y + d y^2, the ray's direction being (x, y): b and d are 0 without twist.
  struct InverseDepth {
    double a = 0, b = 0, d = 0;                    // at x
    double a_slope = 0, b_slope = 0, d_slope = 0;  // d/dx
    [[nodiscard]] double at(double y) const { return a + y * (b + y * d); }
  };
  InverseDepth inverse_depth_at(double x) const;
  double inverse_z_at(const Eigen::Vector2d& direction) const;
  /// The surface at a ray, independent of its pixel.
  struct Across {
    double z_mm = 0, along = 0, length = 0;
    Eigen::Vector3d normal{0.0, 0.0, 0.0};
  };
  static std::optional<Across> across_from(double x, double y, const InverseDepth& inverse);
  std::optional<Across> across_of(const Ray& ray, std::optional<std::size_t> column) const;
  /// A pixel's ray and its intersection with the face.
  struct RayHit {
    Ray ray;
    Across across;
  };
  std::optional<RayHit> ray_hit_at(double u, double v) const;
  double ray_area(const Ray& ray, double u, double v, double inverse_z) const;
  struct Rulings;
  bool fit_to_rulings(const Rulings& rulings);
  Rulings rulings_of(const FaceTwist& twist) const;
  void compute_columns(const FaceTwist& twist);

  Camera camera_;
  Face face_;
  FaceEnds ends_;
  bool base_at_low_u_ = true;
  bool full_image_ = false;
  std::vector<FaceColumn> columns_;
  std::vector<double> length_mm_;
  // Chebyshev series over the scaled column: y of the edges, 1/z (InverseDepth) and its slopes.
  Eigen::VectorXd upper_y_, lower_y_;
  Eigen::VectorXd inverse_z_, inverse_z_by_y_, inverse_z_by_y2_;
  Eigen::VectorXd inverse_z_slope_, inverse_z_by_y_slope_, inverse_z_by_y2_slope_;
  ScaledColumn scale_;
  std::vector<float> along_z_per_normal_;
  std::optional<FaceTwist> twist_;
  /// By column, where a column's rays share their x (no lens distortion).
  std::vector<Across> across_;           // without twist
  std::vector<InverseDepth> by_column_;  // with twist
};

/// Point of the untouched contact face (outer side of the layer) over a point of the view face.
///   kNormal: p + layer * n, exact for a layer of even thickness at any slope.
///   kZ: p + (0, 0, layer / cos(incline)), the paper's; incline clamped to 75 degrees.
[[nodiscard]] Eigen::Vector3d untouched_point_mm(const FaceShape::Local& local, double layer_mm,
                                                 MappingAlong along);

// Default degree of the face's edges along the finger.

/// Degree of the Chebyshev polynomials of FaceShape::fit; default of --profile-degree. A static
/// assertion in pipeline_settings.cpp holds both equal.
inline constexpr int kDefaultProfileDegree = 7;

// Inverse projection of the face: from a position on it to its pixel.

/// The pixel whose FaceShape::position_mm is `position_mm`, in valid columns. nullopt: no valid
/// column shows that length.
[[nodiscard]] std::optional<Eigen::Vector2d> pixel_of_position(const FaceShape& shape,
                                                               const Eigen::Vector2d& position_mm);

}  // namespace alltact
