// Scales for length and height along the face. Inside this folder only.
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

/// Millimetres along the face from its base, ticked along an edge. At its end a stick has the
/// length at which its labelled height is drawn, so that it shows the exaggeration of heights.
class Ruler {
 public:
  /// The renderer outlives it.
  explicit Ruler(vtkRenderer* renderer);
  ~Ruler();
  Ruler(const Ruler&) = delete;
  Ruler& operator=(const Ruler&) = delete;

  /// `times`: factor on heights; 0: there are none.
  void draw(const FaceSurface& surface,
            double exaggeration,
            const RigidTransform& scene_from_camera);
  void hide();
  void apply_style(const SceneColours& colours, double pixels_per_unit);
  /// Points that must be visible, in the scene.
  [[nodiscard]] const std::vector<Eigen::Vector3d>& corners() const { return corners_; }

 private:
  void draw_stick(const FaceSurface& surface,
                  double exaggeration,
                  const RigidTransform& scene_from_camera,
                  std::vector<std::vector<Eigen::Vector3d>>& lines);
  void write(const Eigen::Vector3d& at, const std::string& text);

  vtkNew<vtkPolyData> data_;
  vtkSmartPointer<vtkActor> lines_;
  std::array<vtkNew<vtkTextActor>, 14> texts_;
  std::size_t written_ = 0;
  std::vector<Eigen::Vector3d> corners_;
};

/// The stick's height: of 1, 2, 5, 10 ... hundredths of a mm the one whose drawn length is nearest
/// to, but not longer than, `longest_mm`.
[[nodiscard]] double stick_height_mm(double exaggeration, double longest_mm);

}  // namespace alltact
