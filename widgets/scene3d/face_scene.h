// The 3D scene: the finger with its face in colours, the undeformed face, the camera, points and
// lines on the face, a ruler, the colour scale. The same for the window and for offscreen images.
#pragma once

#include "core/camera/camera.h"
#include "core/geometry/rigid_transform.h"
#include "core/geometry/surface_distance.h"
#include "widgets/scene3d/face_surface.h"
#include "widgets/scene3d/scene_options.h"

#include <memory>
#include <optional>
#include <vector>

#include <Eigen/Core>
#include <opencv2/core.hpp>

class vtkRenderWindow;

namespace alltact {

struct SceneColours {
  cv::Vec3b ground{255, 255, 255}, text{0, 0, 0};  ///< red, green, blue
  char decimal_mark = '.';
};

/// On the face, by image pixels.
struct SceneMarks {
  std::vector<std::optional<cv::Point2d>> points;  ///< A, B, ...; nullopt: the next letter's turn
  std::vector<std::vector<cv::Point2d>> lines;
};

/// Eye, target and up direction of the view; in the scene's frame, mm.
struct ViewPose {
  Eigen::Vector3d eye, at, up;
  bool operator==(const ViewPose&) const = default;
};

/// One of two fingers: its measured surface, and its camera's pose in the gripper.
struct SceneFinger {
  const FaceSurface& surface;
  const Camera& camera;
  RigidTransform gripper_from_camera;
};

/// The scene's frame is the camera's, or with two fingers the gripper's. Changes take effect when
/// the window renders. For one thread, that of the window.
///
/// A face's light is fixed to its finger, see FaceMesh::update(): where it is flat, it has the
/// scale's colours from every viewpoint. The bodies are lit by the first finger's key light and by
/// some light from the eye.
class FaceScene {
 public:
  /// The window outlives the scene.
  explicit FaceScene(vtkRenderWindow* window);
  ~FaceScene();
  FaceScene(const FaceScene&) = delete;
  FaceScene& operator=(const FaceScene&) = delete;

  /// The face by depth. The first time, and after forget(), the view is the one of the last
  /// set_viewpoint().
  void show(const FaceSurface& surface, const Camera& camera);
  /// The face by depth minus `other_mm` (CV_32FC1, of the surface's grid), by
  /// SceneOptions::difference_top_mm.
  void show_difference(const FaceSurface& surface, const cv::Mat& other_mm, const Camera& camera);
  /// Two fingers in the gripper's frame, by depth on one scale. The axes are x1 to z1, x2 to z2 of
  /// their cameras and X, Y, Z of the gripper. Marks are those of the first.
  void show_in_gripper(const SceneFinger& first, const SceneFinger& second);
  /// A line between two points of the scene, such as the faces' nearest ones; nullopt: no line.
  void set_gap(const std::optional<NearestPoints>& gap);
  /// Removes the face; the next one counts as a new one.
  void forget();

  void set_options(const SceneOptions& options);
  void set_colours(const SceneColours& colours);
  void set_marks(SceneMarks marks);
  /// Scales lines and points, as the window's dots per inch scale letters.
  void set_scale(double pixels_per_unit);

  void set_viewpoint(Viewpoint viewpoint);
  /// While the user turns it, a face of very many vertices is drawn with a subset of them, so that
  /// the image follows the hand; all are drawn as soon as it rests. Positions and pixels always
  /// refer to all of them. True: the drawing changed.
  bool set_moving(bool is_moving);
  /// Fits everything into the window, whose size may have changed; does nothing once the user
  /// turned or moved the view.
  void fit();
  [[nodiscard]] Viewpoint viewpoint() const;
  void turn(double right_deg, double up_deg);
  void shift(double right_part, double up_part);  ///< in fractions of the window's height
  void dolly(double factor);
  /// Takes over the view of another scene until set_viewpoint().
  void set_view_pose(const ViewPose& pose);
  [[nodiscard]] ViewPose view_pose() const;

  /// The image pixel of the (first) finger under a window pixel (device pixels, from the top left);
  /// nullopt where the second face covers it.
  [[nodiscard]] std::optional<cv::Point2d> pixel_at(double x, double y) const;
  /// The window pixel of an image pixel (device pixels, from the top left).
  [[nodiscard]] std::optional<cv::Point2d> window_pixel_of(cv::Point2d pixel) const;
  /// Number of triangle topologies built so far.
  [[nodiscard]] int topologies() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace alltact
