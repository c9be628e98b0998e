// One finger in the scene: its face in colours, its body, a ruler, the undeformed face, the camera
// and its axes, all at the pose of the finger's camera. Inside this folder only.
#pragma once

#include "core/geometry/rigid_transform.h"
#include "widgets/scene3d/face_mesh.h"
#include "widgets/scene3d/face_scene.h"
#include "widgets/scene3d/face_surface.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>
#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkTextActor.h>

class vtkMatrix4x4;
class vtkRenderer;

namespace alltact {

// A frame's three axes with their letters. Inside this folder only.

/// x orange, y green, z blue (after Okabe and Ito), each also named.
class Axes {
 public:
  /// The renderer outlives them.
  Axes(vtkRenderer* renderer, double length_mm);

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

// The finger's body in the scene: walls, base, edges, dots. Inside this folder only.

/// Clear silicone that never veils the face: its walls, far ones first, are blended with what lies
/// behind the finger, and the face is drawn over them. No edge of the back crosses the face; seen
/// from behind the base there is no base.
class BodyActors {
 public:
  /// The renderer outlives them.
  explicit BodyActors(vtkRenderer* renderer);

  void draw(const FingerBody& body, const std::vector<SurfaceMarker>& markers);
  void show(bool is_shown);
  void set_pose(vtkMatrix4x4* scene_from_camera);
  void apply_style(const SceneColours& colours, double pixels_per_unit);
  /// The side of the view: from outside the face, and from behind the base.
  void set_viewpoint(bool is_outside, bool is_behind_base);

 private:
  void show_parts();

  bool is_shown_ = false, is_outside_ = false, is_behind_base_ = false;
  [[nodiscard]] std::array<vtkActor*, 7> all() const;

  vtkNew<vtkPolyData> walls_data_, base_data_, edges_data_, back_data_, seen_data_, guessed_data_;
  vtkSmartPointer<vtkActor> far_walls_, near_walls_, base_, edges_, back_, seen_, guessed_;
};

// Scales for length and height along the face. Inside this folder only.

/// Millimetres along the face from its base, ticked along an edge. At its end a stick has the
/// length at which its labelled height is drawn, so that it shows the exaggeration of heights.
class Ruler {
 public:
  /// The renderer outlives it.
  explicit Ruler(vtkRenderer* renderer);

  /// `times`: factor on heights; 0: there are none.
  void draw(const FaceSurface& surface, double exaggeration,
            const RigidTransform& scene_from_camera);
  void hide();
  void apply_style(const SceneColours& colours, double pixels_per_unit);
  /// Points that must be visible, in the scene.
  [[nodiscard]] const std::vector<Eigen::Vector3d>& corners() const { return corners_; }

 private:
  void draw_stick(const FaceSurface& surface, double exaggeration,
                  const RigidTransform& scene_from_camera,
                  std::vector<std::vector<Eigen::Vector3d>>& lines);
  void write(const Eigen::Vector3d& at, const std::string& text);

  vtkNew<vtkPolyData> data_;
  vtkSmartPointer<vtkActor> lines_;
  std::array<vtkNew<vtkTextActor>, 14> texts_;
  char decimal_mark_ = '.';
  std::size_t written_ = 0;
  std::vector<Eigen::Vector3d> corners_;
};

/// The stick's height: of 1, 2, 5, 10 ... hundredths of a mm the one whose drawn length is nearest
/// to, but not longer than, `longest_mm`.
[[nodiscard]] double stick_height_mm(double exaggeration, double longest_mm);

class FingerActors {
 public:
  /// The renderer outlives it.
  explicit FingerActors(vtkRenderer* renderer);

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
  /// The direction that its key light comes from, in the scene.
  [[nodiscard]] Eigen::Vector3d light() const {
    return pose_.direction(key_light(surface_.untouched_mm));
  }
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

// Lines and points in a 3D scene. Inside this folder only.

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
