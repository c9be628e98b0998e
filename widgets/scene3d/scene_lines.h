// Lines and points in a 3D scene. Inside this folder only.
#pragma once

#include <vector>

#include <Eigen/Core>
#include <vtkSmartPointer.h>

class vtkActor;
class vtkPolyData;

namespace alltact {

constexpr int kLetterPoints = 13;  ///< size of letters; the window knows its dots per inch

using Polyline = std::vector<Eigen::Vector3d>;

/// Replaces the content of the data.
void set_lines(vtkPolyData* data, const std::vector<Polyline>& lines);
void set_points(vtkPolyData* data, const std::vector<Eigen::Vector3d>& points);

/// Unlit. `nearer`: depth offset towards the eye, in 1/65000 of the distance between the nearest
/// and the furthest visible point.
[[nodiscard]] vtkSmartPointer<vtkActor> line_actor(vtkPolyData* data, double nearer);

/// The camera as a pyramid in its viewing direction.
///   half: half the size of its foot, mm at the distance `far_mm`
[[nodiscard]] std::vector<Polyline> camera_lines(double half_x_mm, double half_y_mm, double far_mm);

}  // namespace alltact
