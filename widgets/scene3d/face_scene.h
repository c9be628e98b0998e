// What the 3D view shows: the finger with its face in colours, the face as if nothing pressed, the
// camera, points and lines on the face, a ruler, the scale of the colours. The same for the window
// and for pictures made without one.
#pragma once

#include "core/camera/camera.h"
#include "core/geometry/rigid_transform.h"
#include "core/geometry/triangle_distance.h"
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
};

/// On the face, by pixels of the picture.
struct SceneMarks {
  std::vector<std::optional<cv::Point2d>> points;  ///< A, B, ...; absent: the next letter's turn
  std::vector<std::vector<cv::Point2d>> lines;
};

/// Where one looks from, what at, and which way is up; in the scene's frame, mm.
struct Look {
  Eigen::Vector3d eye, at, up;
  bool operator==(const Look&) const = default;
};

/// A finger among others: what it measured, and where its camera sits in the gripper.
struct SceneFinger {
  const FaceSurface& surface;
  const Camera& camera;
  RigidTransform gripper_from_camera;
};

/// The scene's frame is the camera's, or with two fingers the gripper's. Changes take effect when
/// the window renders. Of one thread, that of the window.
///
/// Light comes from over one's left shoulder, slanting, and from where one looks; what faces one is
/// as bright as the scale of the colours, whatever its depth.
class FaceScene {
 public:
  /// The window outlives the scene.
  explicit FaceScene(vtkRenderWindow* window);
  ~FaceScene();
  FaceScene(const FaceScene&) = delete;
  FaceScene& operator=(const FaceScene&) = delete;

  /// The face by depth. The first time, and after forget(), one looks at it as look_from() said
  /// last.
  void show(const FaceSurface& surface, const Camera& camera);
  /// The face by depth less `other_mm` (CV_32FC1, of the surface's grid), by
  /// SceneOptions::difference_top_mm.
  void show_difference(const FaceSurface& surface, const cv::Mat& other_mm, const Camera& camera);
  /// Two fingers in the gripper's frame, by depth on one scale, with the axes x1 to z1, x2 to z2 of
  /// their cameras and X, Y, Z of the gripper. Marks are those of the first.
  void show_in_gripper(const SceneFinger& first, const SceneFinger& second);
  /// A line between two points of the scene, as the faces' nearest ones; none: no line.
  void set_gap(const std::optional<NearestPoints>& gap);
  /// No face, and the next one is another one.
  void forget();

  void set_options(const SceneOptions& options);
  void set_colours(const SceneColours& colours);
  void set_marks(SceneMarks marks);
  /// Lines and points grow with it, as letters do with the window's dots per inch.
  void set_scale(double pixels_per_unit);

  void look_from(Standpoint standpoint);
  /// While somebody turns it, a face of very many vertices is drawn with a part of them, so that
  /// the picture follows the hand; all of them as soon as it rests. Places and pixels are told of
  /// all of them in any case. True: it is drawn otherwise now.
  bool set_moving(bool is_moving);
  /// Looks so that all is in the window, which may have another size now; nothing once somebody
  /// turned or moved it.
  void fit();
  [[nodiscard]] Standpoint standpoint() const;
  void turn(double right_deg, double up_deg);
  void shift(double right_part, double up_part);  ///< in parts of the window's height
  void come_closer(double factor);
  /// As another scene does; kept until look_from().
  void look_as(const Look& look);
  [[nodiscard]] Look look() const;

  /// The pixel of the (first) finger's picture under a place of the window (device pixels, from
  /// the top left); nullopt where the second face lies before it.
  [[nodiscard]] std::optional<cv::Point2d> pixel_at(double x, double y) const;
  /// Where a pixel of the picture is drawn in the window (device pixels, from the top left).
  [[nodiscard]] std::optional<cv::Point2d> place_of(cv::Point2d pixel) const;
  /// How often the triangles were put together.
  [[nodiscard]] int topologies() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace alltact
