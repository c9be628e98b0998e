// The untouched face in 3D: from its two edges (Fin Ray), or the known plane (flat sensor).
#pragma once

#include "core/camera/camera.h"
#include "core/finger/finger.h"
#include "core/result.h"
#include "core/sensing/face_edges.h"

#include <optional>
#include <vector>

#include <Eigen/Core>

namespace alltact {

/// One pixel column of the face. For a camera with lens distortion these are the values on the
/// middle of the face; FaceShape::view_point is exact for every pixel.
struct FaceColumn {
  double upper_v = 0, lower_v = 0;  ///< fitted edges, px
  double z_mm = 0;                  ///< view face
  double z_sd_mm = 0;               ///< standard deviation of z_mm
  bool valid = false;               ///< false: off the face, or z_sd_mm above the limit
};

/// The view face as a ruled surface: straight across the finger, smooth along it.
class FaceShape {
 public:
  /// Fits both edges as Chebyshev polynomials to their pixel residuals, robustly (Tukey), and takes
  /// 1/z = (width of the face in the picture) / (f W) from them: linear, unbiased in the width,
  /// never an average of z. A column is valid
  /// when it lies between trusted edges and its z_sd_mm is below `z_sd_limit_mm`.
  /// Errors: too few trusted columns; a fit whose z is not positive and finite.
  static Result<FaceShape> fit(const FaceEdges& edges,
                               const Camera& camera,
                               const Face& face,
                               int degree,
                               double z_sd_limit_mm = 0.5);

  /// The plane z = face.plane_z_mm, every pixel on it.
  static FaceShape plane(const Camera& camera, const Face& face);

  [[nodiscard]] const Camera& camera() const { return camera_; }
  [[nodiscard]] const Face& face() const { return face_; }
  [[nodiscard]] const std::vector<FaceColumn>& columns() const { return columns_; }
  [[nodiscard]] int width_px() const { return static_cast<int>(columns_.size()); }
  /// True when the finger's base (near the camera, wide) lies at small u.
  [[nodiscard]] bool base_at_low_u() const { return base_at_low_u_; }

  /// First and last row of the face in column u, at least `margin_px` inside its edges; an empty
  /// range (first > last) where the column is not valid.
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
    double area_mm2;       ///< of one pixel on the face
    double flat_area_mm2;  ///< of one pixel, projected along z
  };
  [[nodiscard]] std::optional<Local> at(double u, double v) const;

  /// 1 / cos(incline) on the middle of the face, by column: how much longer a way is along z than
  /// along the normal. 1 where the column is not valid.
  [[nodiscard]] std::vector<float> along_z_per_normal() const;

  /// Where a pixel lies on the face: mm along it from its base (length_at) and across it from its
  /// middle line. For pixels on the face or near it; across is 0 off the valid columns.
  [[nodiscard]] Eigen::Vector2d place_mm(double u, double v) const;

  /// Arc length along the face from the first valid column on the base's side to column u, mm,
  /// measured on the middle of the face; grows from base to tip.
  [[nodiscard]] double length_at(double u) const;

 private:
  FaceShape(const Camera& camera, const Face& face) : camera_(camera), face_(face) {}
  bool fit_inverse_depth(double first, double last, int degree);
  bool fit_to_rays(const std::vector<Ray>& uppers, const std::vector<Ray>& lowers, Eigen::Index n);
  double inverse_z_of(const Ray& ray) const;
  void know_across();
  double z_of_column(int u) const;  // on the middle of the face; 0 where there is none
  void finish();
  double inverse_z_at(double x) const;
  double inverse_z_slope_at(double x) const;
  /// What `at` tells of a ray but for y, which only scales it.
  struct Across {
    double z_mm, along, length, normal_x, normal_z;
  };
  static std::optional<Across> across_from(double x, double inverse_z, double inverse_z_slope);
  std::optional<Across> across_of(const Ray& ray) const;
  double ray_area(const Ray& ray, double u, double v, double inverse_z) const;

  Camera camera_;
  Face face_;
  bool base_at_low_u_ = true;
  bool whole_picture_ = false;
  std::vector<FaceColumn> columns_;
  std::vector<double> length_mm_;
  // 1/z over t = (x - x_mid_) / x_half_, x the normalised image coordinate; and its d/dx
  Eigen::VectorXd inverse_z_, inverse_z_slope_;
  double x_mid_ = 0, x_half_ = 1;
  /// Of every column, where a column's rays share their x (no lens distortion).
  std::vector<Across> across_;
};

/// The untouched outer side of the layer over a view-face point.
///   kNormal: p + layer * n, exact for a layer of even thickness at any slope.
///   kZ: p + (0, 0, layer / cos(incline)), the paper's; incline clamped to 75 degrees.
[[nodiscard]] Eigen::Vector3d untouched_point_mm(const FaceShape::Local& local,
                                                 double layer_mm,
                                                 MappingAlong along);

}  // namespace alltact
