// One finger in the scene: its face in colours, its body, a ruler, the undeformed face, the camera
// and its axes, all at the pose of the finger's camera. Inside this folder only.
#pragma once

#include "widgets/scene3d/axes.h"
#include "widgets/scene3d/body_actors.h"
#include "widgets/scene3d/face_grid.h"
#include "widgets/scene3d/face_mesh.h"
#include "widgets/scene3d/face_scene.h"
#include "widgets/scene3d/finger_body.h"
#include "widgets/scene3d/ruler.h"

#include <optional>
#include <vector>

namespace alltact {

/// Fraction of ambient light; see FaceScene for the rest.
inline constexpr double kFaceAmbient = 0.3;

class FingerActors {
 public:
  /// The renderer outlives it.
  explicit FingerActors(vtkRenderer* renderer);
  ~FingerActors();
  FingerActors(const FingerActors&) = delete;
  FingerActors& operator=(const FingerActors&) = delete;

  /// other_mm: empty, or the depth that is subtracted before colouring.
  void show(const FaceSurface& surface, const cv::Mat& other_mm);
  void hide();
  [[nodiscard]] bool is_shown() const { return !surface_.untouched_mm.empty(); }
  /// False for a finger without calibration.
  [[nodiscard]] bool has_depth() const { return has_depth_; }
  [[nodiscard]] bool is_difference() const { return !other_mm_.empty(); }
  /// Of the current content.
  [[nodiscard]] ColourScale colours() const;
  void set_options(const SceneOptions& options);
  /// Overrides the options.
  void show_camera(bool is_shown);
  /// The pose of its camera in the scene.
  void set_pose(const RigidTransform& scene_from_camera);
  void draw_camera(const Camera& camera);
  void apply_style(const SceneColours& colours, double pixels_per_unit);
  [[nodiscard]] Axes& axes() { return axes_; }

  /// While the user turns it, at most about `max_vertices`.
  /// True: the drawing changed.
  bool set_moving(bool is_moving, int max_vertices);
  /// Prepares for a view from here.
  void set_eye(const Eigen::Vector3d& eye);

  /// Points that must be visible: its vertices and, with the body, its body and its camera.
  [[nodiscard]] std::vector<Eigen::Vector3d> outline(bool with_body) const;
  /// Across the face, towards the camera, in the camera's frame.
  [[nodiscard]] Eigen::Vector3d inward() const;
  [[nodiscard]] const RigidTransform& scene_from_camera() const { return pose_; }

  struct Hit {
    cv::Point2d pixel;
    double along = 0;  ///< in lengths of the ray's direction
  };
  [[nodiscard]] std::optional<Hit> hit(const Eigen::Vector3d& from,
                                       const Eigen::Vector3d& direction) const;
  /// The position of an image pixel in the scene.
  [[nodiscard]] std::optional<Eigen::Vector3d> point_of(cv::Point2d pixel) const;
  [[nodiscard]] int topologies() const { return mesh_.topologies(); }

 private:
  void draw_face();
  void draw_body();
  void draw_ghost();

  FaceSurface surface_;
  FingerBody body_;
  cv::Mat other_mm_;
  SceneOptions options_;
  RigidTransform pose_;
  FaceMesh mesh_;
  mutable std::optional<GridBoxes> boxes_;  // of the mesh, made at first use
  vtkNew<vtkActor> face_;
  vtkNew<vtkPolyData> ghost_lines_, camera_lines_;
  vtkSmartPointer<vtkActor> ghost_, camera_;
  BodyActors body_actors_;
  Ruler ruler_;
  Axes axes_;
  bool is_camera_shown_ = true, has_depth_ = false;
};

}  // namespace alltact
