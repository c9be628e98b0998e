// Pictures of the 3D view without a window and without a display.
#pragma once

#include "core/result.h"
#include "widgets/scene3d/face_scene.h"

#include <memory>

#include <opencv2/core.hpp>

namespace alltact {

/// Renders a scene in memory, over EGL without a surface (software where there is no graphics
/// card). Of one thread.
class ScenePictures {
 public:
  /// pixels_per_unit: larger ones for paper, so that lines and letters grow with the picture.
  /// Error: this computer has no OpenGL 3.2, not even in software.
  [[nodiscard]] static Result<ScenePictures> create(cv::Size size_px, double pixels_per_unit = 1);
  ScenePictures(ScenePictures&&) noexcept;
  ScenePictures& operator=(ScenePictures&&) noexcept;
  ~ScenePictures();

  [[nodiscard]] FaceScene& scene();
  /// The scene as it is now, CV_8UC3, blue, green, red.
  [[nodiscard]] cv::Mat picture();

 private:
  struct State;
  explicit ScenePictures(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace alltact
