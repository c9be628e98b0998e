// Intersections of rays with a surface swept by a straight line: the view face and the side faces
// of a finger that twists, or that lies behind a window.
#pragma once

#include "core/camera/camera.h"
#include "core/simulation/face_curve.h"

#include <optional>
#include <vector>

#include <Eigen/Core>

namespace alltact {

/// point(s, r) = p(s) + r g(s), s the arc length of the face's middle line.
class RuledSurface {
 public:
  static constexpr double kLastStep_mm = 1e-4;  ///< of Newton's method
  static constexpr double kMinSlant = 0.02;     ///< of a ray to the surface at their intersection

  /// The line across the view face: r is the position across it.
  [[nodiscard]] static RuledSurface view_face(const FaceCurve& curve);
  /// A side face; `side` is -1 (small v) or 1. r is the depth behind the face's edge, towards the
  /// camera.
  [[nodiscard]] static RuledSurface side_face(const FaceCurve& curve, int side, double width_mm);

  struct Intersection {
    double s_mm, r_mm, z_mm;
    Eigen::Vector3d point_s, point_r;  ///< derivatives of the point by s and by r
    Eigen::Vector3d normal;  ///< unit, point_s x point_r: of the view face away from the camera

    /// Change of s and r from this ray to a neighbouring one.
    [[nodiscard]] double s_by(const Ray& ray, const Ray& neighbour) const {
      const Eigen::Vector3d turn = point_r.cross(ray.direction);
      return (neighbour.point_at(z_mm) - ray.point_at(z_mm)).dot(turn) / point_s.dot(turn);
    }
    [[nodiscard]] double r_by(const Ray& ray, const Ray& neighbour) const {
      const Eigen::Vector3d turn = point_s.cross(ray.direction);
      return (neighbour.point_at(z_mm) - ray.point_at(z_mm)).dot(turn) / point_r.dot(turn);
    }
  };
  /// Intersects the ray by Newton's method on the volume ((p - o) x g) . d that the ray and the
  /// line span, starting at `near_s_mm`. nullopt: no intersection before the camera, or a grazing
  /// one.
  [[nodiscard]] std::optional<Intersection> intersect(const Ray& ray, double near_s_mm) const;
  /// The same without a start: uses the first part of the curve in which the volume changes its
  /// sign.
  [[nodiscard]] std::optional<Intersection> intersect(const Ray& ray) const;

  /// Intersections of neighbouring rays, as the pixels of a row: equal within 1e-7 mm, many at a
  /// time.
  class IntersectionRow {
   public:
    explicit IntersectionRow(std::size_t n);
    [[nodiscard]] bool is_hit(std::size_t i) const { return hit_[i] != 0; }
    /// Of a ray with an intersection.
    [[nodiscard]] Intersection at(std::size_t i) const;

   private:
    friend class RuledSurface;
    enum Number {
      kS,
      kR,
      kZ,
      kPointS,
      kPointR = kPointS + 3,
      kNormal = kPointR + 3,
      kNumbers = kNormal + 3
    };
    void set(std::size_t i, const Intersection& intersection);
    [[nodiscard]] double* row(int number) {
      return numbers_.data() + static_cast<std::size_t>(number) * hit_.size();
    }

    std::vector<double> numbers_;  // by number, then by ray
    std::vector<char> hit_;
  };
  /// requested: by ray; the others count as misses
  /// near_s_mm: by ray; null: searched from the previous ray's result, and everywhere if that fails
  [[nodiscard]] IntersectionRow intersect_row(const std::vector<Ray>& rays,
                                              const std::vector<char>& requested,
                                              const float* near_s_mm = nullptr) const;

 private:
  enum class Line { kAcross = 1, kBack };
  RuledSurface(const FaceCurve& curve, Line line, double offset_mm)
      : curve_(&curve), line_(line), offset_mm_(offset_mm) {}

  struct Ruling {
    Eigen::Vector3d p, p_s, g, g_s;
  };
  [[nodiscard]] Ruling ruling_at(double s_mm) const;
  class RowSearch;

  const FaceCurve* curve_;
  Line line_;
  double offset_mm_;  // of p from the middle line, across
};

}  // namespace alltact
