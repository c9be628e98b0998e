// One finger in the scene: its face in colours, its body, a ruler beside it, the face as if nothing
// pressed, the camera and its axes, all where the finger's camera stands. Inside this folder only.
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

/// Part of the light that comes from everywhere; see FaceScene for the rest.
inline constexpr double kFaceAmbient = 0.3;

class PlacedFace {
 public:
  /// The renderer outlives it.
  explicit PlacedFace(vtkRenderer* renderer);
  ~PlacedFace();
  PlacedFace(const PlacedFace&) = delete;
  PlacedFace& operator=(const PlacedFace&) = delete;

  /// other_mm: empty, or what is taken off the depth before it is shown in colours.
  void show(const FaceSurface& surface, const cv::Mat& other_mm);
  void hide();
  [[nodiscard]] bool is_shown() const { return !surface_.untouched_mm.empty(); }
  /// Of a finger without calibration nothing is.
  [[nodiscard]] bool has_depth() const { return has_depth_; }
  [[nodiscard]] bool is_difference() const { return !other_mm_.empty(); }
  /// Of what is shown.
  [[nodiscard]] ColourScale colours() const;
  void set_options(const SceneOptions& options);
  /// Other than the options say.
  void show_camera(bool is_shown);
  /// Where its camera stands in the scene.
  void place(const RigidTransform& scene_from_camera);
  void draw_camera(const Camera& camera);
  void dress(const SceneColours& colours, double pixels_per_unit);
  [[nodiscard]] Axes& axes() { return axes_; }

  /// While one turns it, no finer than about `most_vertices`.
  /// True: it is drawn otherwise now.
  bool set_moving(bool is_moving, int most_vertices);
  /// One is about to look at it from here.
  void seen_from(const Eigen::Vector3d& eye);

  /// What must be in sight of it: its vertices, and of the whole finger its body and its camera.
  [[nodiscard]] std::vector<Eigen::Vector3d> outline(bool is_whole) const;
  /// Across the face, towards the camera, in the camera's frame.
  [[nodiscard]] Eigen::Vector3d inward() const;
  [[nodiscard]] const RigidTransform& scene_from_camera() const { return place_; }

  struct Hit {
    cv::Point2d pixel;
    double along = 0;  ///< in lengths of the ray's direction
  };
  [[nodiscard]] std::optional<Hit> hit(const Eigen::Vector3d& from,
                                       const Eigen::Vector3d& direction) const;
  /// Where a pixel of the picture is drawn, in the scene.
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
  RigidTransform place_;
  FaceMesh mesh_;
  mutable std::optional<GridBoxes> boxes_;  // of the mesh, once somebody asked
  vtkNew<vtkActor> face_;
  vtkNew<vtkPolyData> ghost_lines_, camera_lines_;
  vtkSmartPointer<vtkActor> ghost_, camera_;
  BodyActors body_actors_;
  Ruler ruler_;
  Axes axes_;
  bool is_camera_shown_ = true, has_depth_ = false;
};

}  // namespace alltact
