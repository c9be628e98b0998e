// Images of the 3D view without a window and without a display.
#pragma once

#include "core/result.h"
#include "widgets/scene3d/face_scene.h"

#include <memory>

#include <opencv2/core.hpp>

namespace alltact {

/// Renders a scene in memory, over EGL without a surface (in software without a graphics card). For
/// one thread.
class OffscreenScene {
 public:
  /// pixels_per_unit: larger for paper, so that lines and letters grow with the image.
  /// Error: this computer has no OpenGL 3.2, not even in software.
  [[nodiscard]] static Result<OffscreenScene> create(cv::Size size_px, double pixels_per_unit = 1);
  OffscreenScene(OffscreenScene&&) noexcept;
  OffscreenScene& operator=(OffscreenScene&&) noexcept;
  ~OffscreenScene();

  [[nodiscard]] FaceScene& scene();
  /// The scene in its current state, CV_8UC3, blue, green, red.
  [[nodiscard]] cv::Mat image();

 private:
  struct State;
  explicit OffscreenScene(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace alltact
