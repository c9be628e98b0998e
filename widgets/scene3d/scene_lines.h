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

/// Replaces what the data held.
void set_lines(vtkPolyData* data, const std::vector<Polyline>& lines);
void set_points(vtkPolyData* data, const std::vector<Eigen::Vector3d>& points);

/// Unlit; `nearer`: how much nearer to the eye it is drawn than it lies, in 65000ths of what lies
/// between the nearest and the furthest thing in sight.
[[nodiscard]] vtkSmartPointer<vtkActor> line_actor(vtkPolyData* data, double nearer);

/// The camera as a pyramid towards what it sees.
///   half: half the size of its foot, mm at the distance `far_mm`
[[nodiscard]] std::vector<Polyline> camera_lines(double half_x_mm, double half_y_mm, double far_mm);

}  // namespace alltact
