// The finger's body in the scene: walls, base, edges, dots. Inside this folder only.
#pragma once

#include "widgets/scene3d/face_scene.h"
#include "widgets/scene3d/finger_body.h"

#include <array>
#include <vector>

#include <vtkNew.h>
#include <vtkSmartPointer.h>

class vtkActor;
class vtkMatrix4x4;
class vtkPolyData;
class vtkRenderer;

namespace alltact {

/// Opaque, but it never hides the face. From the camera's side only the inner sides of the walls
/// behind the face are drawn, from outside only the outer ones. No edge of the back crosses the
/// face; seen from behind the base there is no base.
class BodyActors {
 public:
  /// The renderer outlives them.
  explicit BodyActors(vtkRenderer* renderer);
  ~BodyActors();
  BodyActors(const BodyActors&) = delete;
  BodyActors& operator=(const BodyActors&) = delete;

  void draw(const FingerBody& body, const std::vector<SurfaceMarker>& markers);
  void show(bool is_shown);
  void set_pose(vtkMatrix4x4* scene_from_camera);
  void apply_style(const SceneColours& colours, double pixels_per_unit);
  /// The side of the view: from outside the face, and from behind the base.
  void set_viewpoint(bool is_outside, bool is_behind_base);

 private:
  void show_parts();

  bool is_shown_ = false, is_outside_ = false, is_behind_base_ = false;
  [[nodiscard]] std::array<vtkActor*, 6> all() const;

  vtkNew<vtkPolyData> walls_data_, base_data_, edges_data_, back_data_, seen_data_, guessed_data_;
  vtkSmartPointer<vtkActor> walls_, base_, edges_, back_, seen_, guessed_;
};

}  // namespace alltact
