// From where one looks at a scene. Inside this folder only.
#pragma once

#include "widgets/scene3d/face_scene.h"

#include <optional>
#include <vector>

class vtkRenderer;

namespace alltact {

/// The camera of a renderer.
class SceneView {
 public:
  /// The renderer outlives it.
  explicit SceneView(vtkRenderer* renderer) : renderer_(renderer) {}

  /// What is looked at from a standpoint.
  struct Subject {
    std::vector<Eigen::Vector3d> points;  ///< that must be in sight
    Eigen::Vector3d inward{0, 0, -1};     ///< across the face, towards its camera, camera frame
    RigidTransform scene_from_camera;
  };
  /// So that all is in sight of a window of this size, but for what `used_width` leaves free at the
  /// right.
  void look_at(const Subject& subject,
               Standpoint standpoint,
               const int* window_px,
               double used_width);
  /// As look_at() left it: nobody turned or moved it since.
  [[nodiscard]] bool is_as_set() const;

  void turn(double right_deg, double up_deg);
  void shift(double right_part, double up_part);
  void come_closer(double factor);
  void look_as(const Look& look);
  [[nodiscard]] Look look() const;
  /// After anything was drawn elsewhere than before.
  void keep_in_sight();

 private:
  vtkRenderer* renderer_;
  std::optional<Eigen::Vector3d> eye_set_;  // where look_at() put it
};

}  // namespace alltact
