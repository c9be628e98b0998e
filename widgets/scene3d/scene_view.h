// The view of a scene: eye, target, up direction. Inside this folder only.
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

  /// The content that a viewpoint shows.
  struct Subject {
    std::vector<Eigen::Vector3d> points;  ///< that must be visible
    Eigen::Vector3d inward{0, 0, -1};     ///< across the face, towards its camera, camera frame
    RigidTransform scene_from_camera;
  };
  /// Fits everything into a window of this size, less the fraction at the right that `used_width`
  /// leaves over.
  void look_at(const Subject& subject,
               Viewpoint viewpoint,
               const int* window_px,
               double used_width);
  /// As look_at() left it: nobody turned or moved it since.
  [[nodiscard]] bool is_unchanged() const;

  void turn(double right_deg, double up_deg);
  void shift(double right_part, double up_part);
  void dolly(double factor);
  void set_view_pose(const ViewPose& pose);
  [[nodiscard]] ViewPose pose() const;
  /// Call it after anything was drawn at another position than before.
  void reset_clipping();

 private:
  vtkRenderer* renderer_;
  std::optional<Eigen::Vector3d> eye_set_;  // the eye that look_at() set
};

}  // namespace alltact
