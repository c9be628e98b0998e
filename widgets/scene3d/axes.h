// A frame's three axes with their letters. Inside this folder only.
#pragma once

#include "core/geometry/rigid_transform.h"

#include <array>
#include <string>
#include <vector>

#include <vtkNew.h>
#include <vtkSmartPointer.h>

class vtkActor;
class vtkPolyData;
class vtkRenderer;
class vtkTextActor;

namespace alltact {

/// x orange, y green, z blue (after Okabe and Ito), each also named.
class Axes {
 public:
  /// The renderer outlives them.
  Axes(vtkRenderer* renderer, double length_mm);
  ~Axes();
  Axes(const Axes&) = delete;
  Axes& operator=(const Axes&) = delete;

  void set_names(const std::array<std::string, 3>& names);
  void set_pose(const RigidTransform& scene_from_frame);
  void show(bool is_shown);
  /// Widths of lines and letters for a screen with that many pixels a unit.
  void apply_style(double pixels_per_unit);
  /// The origin and the three ends, in the scene.
  [[nodiscard]] std::vector<Eigen::Vector3d> corners() const;

 private:
  double length_mm_;
  RigidTransform pose_;
  std::array<vtkNew<vtkPolyData>, 3> lines_;
  std::array<vtkSmartPointer<vtkActor>, 3> actors_;
  std::array<vtkNew<vtkTextActor>, 3> names_;  // flat, in front of everything, to be readable
};

}  // namespace alltact
