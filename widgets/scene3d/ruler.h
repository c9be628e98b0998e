// How long and how high things are, drawn beside the face. Inside this folder only.
#pragma once

#include "widgets/scene3d/face_scene.h"

#include <array>
#include <vector>

#include <vtkNew.h>
#include <vtkSmartPointer.h>

class vtkActor;
class vtkPolyData;
class vtkRenderer;
class vtkTextActor;

namespace alltact {

/// Millimetres along the face from its base, ticked along an edge; and at its end a stick as long
/// as a height is drawn that stands beside it, which tells how much larger than they are heights
/// are drawn.
class Ruler {
 public:
  /// The renderer outlives it.
  explicit Ruler(vtkRenderer* renderer);
  ~Ruler();
  Ruler(const Ruler&) = delete;
  Ruler& operator=(const Ruler&) = delete;

  /// `times`: that heights are drawn larger; 0: there are none.
  void draw(const FaceSurface& surface, double times, const RigidTransform& scene_from_camera);
  void hide();
  void dress(const SceneColours& colours, double pixels_per_unit);
  /// What must be in sight, in the scene.
  [[nodiscard]] const std::vector<Eigen::Vector3d>& corners() const { return corners_; }

 private:
  void draw_stick(const FaceSurface& surface,
                  double times,
                  const RigidTransform& scene_from_camera,
                  std::vector<std::vector<Eigen::Vector3d>>& lines);
  void write(const Eigen::Vector3d& at, const std::string& text);

  vtkNew<vtkPolyData> data_;
  vtkSmartPointer<vtkActor> lines_;
  std::array<vtkNew<vtkTextActor>, 14> texts_;
  std::size_t written_ = 0;
  std::vector<Eigen::Vector3d> corners_;
};

/// The height that the stick stands for: of 1, 2, 5, 10 ... hundredths of a mm the one that is
/// drawn nearest to, but not longer than, `longest_mm`.
[[nodiscard]] double stick_height_mm(double times, double longest_mm);

}  // namespace alltact
