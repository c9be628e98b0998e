// Rays that meet a surface swept by a straight line: the view face and the side faces of a finger
// that twists, or that is seen through a window.
#pragma once

#include "core/camera/ray.h"
#include "core/simulation/face_curve.h"

#include <optional>
#include <vector>

#include <Eigen/Core>

namespace alltact {

/// point(s, r) = p(s) + r g(s), s the arc length of the face's middle line.
class RuledSurface {
 public:
  static constexpr double kLastStep_mm = 1e-4;  ///< of Newton's method
  static constexpr double kLeastSlant = 0.02;   ///< of a ray to the surface that it meets

  /// The line across the view face: r is the place across it.
  [[nodiscard]] static RuledSurface view_face(const FaceCurve& curve);
  /// A side face; `side` is -1 (small v) or 1. r is how far behind the face's edge it is, towards
  /// the camera.
  [[nodiscard]] static RuledSurface side_face(const FaceCurve& curve, int side, double width_mm);

  struct Meeting {
    double s_mm, r_mm, z_mm;
    Eigen::Vector3d s_way, r_way;  ///< derivatives of the point by s and by r
    Eigen::Vector3d normal;        ///< unit, s_way x r_way: of the view face away from the camera

    /// How s and r change from the ray that meets it here to one beside it.
    [[nodiscard]] double s_by(const Ray& ray, const Ray& beside) const {
      const Eigen::Vector3d turn = r_way.cross(ray.direction);
      return (beside.point_at(z_mm) - ray.point_at(z_mm)).dot(turn) / s_way.dot(turn);
    }
    [[nodiscard]] double r_by(const Ray& ray, const Ray& beside) const {
      const Eigen::Vector3d turn = s_way.cross(ray.direction);
      return (beside.point_at(z_mm) - ray.point_at(z_mm)).dot(turn) / r_way.dot(turn);
    }
  };
  /// Where the ray meets it, by Newton's method on the volume ((p - o) x g) . d that the ray and
  /// the line span, from `near_s_mm` on. nullopt: nowhere before the camera, or where it grazes it.
  [[nodiscard]] std::optional<Meeting> meet(const Ray& ray, double near_s_mm) const;
  /// The same without knowing where: the first of the curve's parts in which the volume changes its
  /// sign is taken.
  [[nodiscard]] std::optional<Meeting> meet(const Ray& ray) const;

  /// Of rays side by side, as the pixels of a row: the same meetings within 1e-7 mm, many at a
  /// time.
  class MeetingRow {
   public:
    explicit MeetingRow(std::size_t n);
    [[nodiscard]] bool met(std::size_t i) const { return met_[i] != 0; }
    /// Of a ray that met it.
    [[nodiscard]] Meeting at(std::size_t i) const;

   private:
    friend class RuledSurface;
    enum Number {
      kS,
      kR,
      kZ,
      kSWay,
      kRWay = kSWay + 3,
      kNormal = kRWay + 3,
      kNumbers = kNormal + 3
    };
    void set(std::size_t i, const Meeting& meeting);
    [[nodiscard]] double* row(int number) { return numbers_.data() + number * met_.size(); }

    std::vector<double> numbers_;  // by number, then by ray
    std::vector<char> met_;
  };
  /// wanted: by ray; the others count as not met
  /// near_s_mm: by ray; none: looked for from the ray before, and where that fails all over
  [[nodiscard]] MeetingRow meet_row(const std::vector<Ray>& rays,
                                    const std::vector<char>& wanted,
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
