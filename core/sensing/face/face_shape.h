// The untouched face in 3D: from its two edges (Fin Ray), or the known plane (flat sensor).
#pragma once

#include "core/camera/camera.h"
#include "core/finger/finger.h"
#include "core/result.h"
#include "core/sensing/face/face_edges.h"
#include "core/sensing/face/face_twist.h"

#include <optional>
#include <vector>

#include <Eigen/Core>

namespace alltact {

struct RobustPolynomial;

/// One pixel column of the face. For a camera with lens distortion these are the values on the
/// middle of the face; FaceShape::view_point is exact for every pixel.
struct FaceColumn {
  double upper_v = 0, lower_v = 0;  ///< fitted edges, px
  double z_mm = 0;                  ///< view face
  double z_sd_mm = 0;               ///< standard deviation of z_mm
  bool valid = false;               ///< false: off the face, or z_sd_mm above the limit
};

/// A column as curves along the face are polynomials of it: t from -1 to 1 over the picture.
struct ScaledColumn {
  double middle_px = 0, half_px = 1;
  [[nodiscard]] double at(double u) const { return (u - middle_px) / half_px; }
};

/// The view face as a ruled surface: straight across the finger, smooth along it. Straight across
/// is along y unless the finger twists (`twisted`).
class FaceShape {
 public:
  /// Fits both edges as Chebyshev polynomials of the column to their pixel residuals, robustly
  /// (Tukey), and takes 1/z = (width of the face in the picture) / (f W) from them:
  /// linear, unbiased in the width, never an average of z. A column is valid when it lies between
  /// the face's ends, or between trusted edges where an end was not seen, and its z_sd_mm is below
  /// `z_sd_limit_mm`. Errors: an outline that jumps, since the finger hides a part of itself
  /// (outline_jump.h); too few trusted columns; a fit whose z is not positive and finite.
  static Result<FaceShape> fit(const FaceEdges& edges,
                               const Camera& camera,
                               const Face& face,
                               int degree,
                               double z_sd_limit_mm = 0.5);

  /// The same edges as those of a face whose cross-sections are turned: of width W along
  ///   e = (y - yaw t + twist n) / |.|,
  /// t along the middle line, n normal to it (both without y), so that both ends of each lie on the
  /// edges. nullopt: no such face (not positive and finite in z, or a flat sensor).
  [[nodiscard]] std::optional<FaceShape> twisted(const FaceTwist& twist) const;
  /// That `twisted` was given.
  [[nodiscard]] const std::optional<FaceTwist>& twist() const { return twist_; }

  /// The plane z = face.plane_z_mm, every pixel on it.
  static FaceShape plane(const Camera& camera, const Face& face);

  [[nodiscard]] const Camera& camera() const { return camera_; }
  [[nodiscard]] const Face& face() const { return face_; }
  [[nodiscard]] const std::vector<FaceColumn>& columns() const { return columns_; }
  [[nodiscard]] int width_px() const { return static_cast<int>(columns_.size()); }
  /// True when the finger's base (near the camera, wide) lies at small u.
  [[nodiscard]] bool base_at_low_u() const { return base_at_low_u_; }

  /// First and last row of the face in column u, at least `margin_px` inside its edges and ends; an
  /// empty range (first > last) where the column is not valid.
  struct Rows {
    int first, last;
  };
  [[nodiscard]] Rows rows(int u, double margin_px) const;

  /// A pixel's point on the view face, the outward unit normal there (away from the camera), and
  /// the incline (angle of that normal to z). nullopt off the valid columns or rays.
  struct Local {
    Eigen::Vector3d view_point_mm;
    Eigen::Vector3d normal;
    double cos_incline;
  };
  [[nodiscard]] std::optional<Local> at(double u, double v) const;

  /// What one pixel covers; nullopt as above. Apart, because through a lens it costs three times as
  /// much as the point.
  struct PixelArea {
    double on_face_mm2;
    double flat_mm2;  ///< projected along z
  };
  [[nodiscard]] std::optional<PixelArea> pixel_area(double u, double v) const;

  /// 1 / cos(incline) on the middle of the face, by column: how much longer a way is along z than
  /// along the normal. 1 where the column is not valid.
  [[nodiscard]] const std::vector<float>& along_z_per_normal() const { return along_z_per_normal_; }

  /// Where a pixel lies on the face: mm along it from its base (length_at) and across it from its
  /// middle line. For pixels on the face or near it; across is 0 off the valid columns.
  [[nodiscard]] Eigen::Vector2d place_mm(double u, double v) const;

  /// Arc length along the face from its end at the base to column u, mm, measured on the middle of
  /// the face; grows from base to tip. Where no end was seen there it begins at the first valid
  /// column; beyond both ends it stays what it is at them.
  [[nodiscard]] double length_at(double u) const;
  /// Of where length_at begins, mm; 0 on a flat sensor. nullopt: the face's end at the base is out
  /// of the picture or was not seen, so that nobody knows how much of the face lies before it.
  [[nodiscard]] std::optional<double> base_sd_mm() const;

  /// A place half-way between the edges.
  struct Middle {
    double u;                     ///< column
    double t;                     ///< -1 at the base's end, 1 at the tip's
    Eigen::Vector3d point_mm;     ///< on the view face
    double tangent_x, tangent_z;  ///< unit vector along the face, towards large u
  };
  /// Of a column; of the nearest valid one where that is not. nullopt on a flat sensor.
  [[nodiscard]] std::optional<Middle> middle_at(double u) const;
  /// Where the normal through (x, any y, z) meets the middle of the face; its end beyond that.
  [[nodiscard]] std::optional<Middle> foot_of(double x_mm, double z_mm) const;
  /// The direction (x, y) of a pixel's ray at z = 1, as a camera without a lens's distortion or a
  /// window would see the face there.
  [[nodiscard]] std::optional<Eigen::Vector2d> direction_of(const Eigen::Vector2d& pixel) const;

 private:
  FaceShape(const Camera& camera, const Face& face) : camera_(camera), face_(face) {}
  bool take_over(const RobustPolynomial& upper, const RobustPolynomial& lower);  // linear cameras
  bool fit_inverse_depth(double first, double last, int degree);
  bool fit_to_rays(const std::vector<Ray>& uppers, const std::vector<Ray>& lowers, Eigen::Index n);
  double inverse_z_of(const Ray& ray) const;
  /// Where a ray lies at depth z, over z: as a camera without a window would see the point.
  static Eigen::Vector2d seen_from(const Ray& ray, double inverse_z) {
    return ray.direction.head<2>() + inverse_z * ray.origin_mm.head<2>();
  }
  std::optional<Middle> middle_within(double u) const;  // u between valid columns
  void know_across();
  std::optional<double> end_column(bool at_base) const;  // on the middle of the face
  void know_lengths();
  double z_of_column(int u) const;  // on the middle of the face; 0 where there is none
  void finish();
  // A ray's x and the column that a lens without distortion would show it in.
  double x_of_column(double u) const;
  double column_of(double x) const;
  /// 1/z = a + b y + d y^2 where the ray's direction is (x, y): b and d are 0 without twist.
  struct InverseDepth {
    double a = 0, b = 0, d = 0;                    // at x
    double a_slope = 0, b_slope = 0, d_slope = 0;  // d/dx
    [[nodiscard]] double at(double y) const { return a + y * (b + y * d); }
  };
  InverseDepth inverse_depth_at(double x) const;
  double inverse_z_at(const Eigen::Vector2d& direction) const;
  /// What `at` tells of a ray but for its place in the picture.
  struct Across {
    double z_mm = 0, along = 0, length = 0;
    Eigen::Vector3d normal{0.0, 0.0, 0.0};
  };
  static std::optional<Across> across_from(double x, double y, const InverseDepth& inverse);
  std::optional<Across> across_of(const Ray& ray, std::optional<std::size_t> column) const;
  /// A pixel's ray and where it meets the face.
  struct Seen {
    Ray ray;
    Across across;
  };
  std::optional<Seen> seen_at(double u, double v) const;
  double ray_area(const Ray& ray, double u, double v, double inverse_z) const;
  struct Rulings;
  bool fit_to_rulings(const Rulings& rulings);
  Rulings rulings_of(const FaceTwist& twist) const;
  void know_columns(const FaceTwist& twist);

  Camera camera_;
  Face face_;
  FaceEnds ends_;
  bool base_at_low_u_ = true;
  bool whole_picture_ = false;
  std::vector<FaceColumn> columns_;
  std::vector<double> length_mm_;
  // Chebyshev series over the scaled column: the edges' y, 1/z (InverseDepth) and its slopes.
  Eigen::VectorXd upper_y_, lower_y_;
  Eigen::VectorXd inverse_z_, inverse_z_by_y_, inverse_z_by_y2_;
  Eigen::VectorXd inverse_z_slope_, inverse_z_by_y_slope_, inverse_z_by_y2_slope_;
  ScaledColumn scale_;
  std::vector<float> along_z_per_normal_;
  std::optional<FaceTwist> twist_;
  /// Of every column, where a column's rays share their x (no lens distortion).
  std::vector<Across> across_;           // without twist
  std::vector<InverseDepth> by_column_;  // with twist
};

/// The untouched outer side of the layer over a view-face point.
///   kNormal: p + layer * n, exact for a layer of even thickness at any slope.
///   kZ: p + (0, 0, layer / cos(incline)), the paper's; incline clamped to 75 degrees.
[[nodiscard]] Eigen::Vector3d untouched_point_mm(const FaceShape::Local& local,
                                                 double layer_mm,
                                                 MappingAlong along);

}  // namespace alltact
