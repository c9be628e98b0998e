// VTK inside a Qt window.
#pragma once

#include "core/base/result.h"
#include "widgets/scene3d/face_scene.h"

#include <QOpenGLWidget>
#include <memory>

#include <opencv2/core.hpp>

class vtkGenericOpenGLRenderWindow;
class vtkRenderWindow;
class vtkRenderWindowInteractor;

namespace alltact {

/// A widget that shows what VTK renders. Its user adds renderers to render_window(), changes the
/// scene on the window's thread only, and calls draw_later(), which merges many calls into one
/// drawing. A repaint by Qt alone does not render again. On a platform without OpenGL (see
/// can_draw()) nothing is drawn and nothing breaks.
class VtkView : public QOpenGLWidget {
  Q_OBJECT
 public:
  /// This platform has OpenGL 3.2. Call it first; needs a QApplication.
  [[nodiscard]] static bool is_supported();

  explicit VtkView(QWidget* parent = nullptr);
  ~VtkView() override;

  /// Call it before the QApplication is made: contexts are shared, so that a view may move between
  /// windows, and have the format that VTK needs.
  static void prepare_application();

  /// True once there is a context: shown at least once.
  [[nodiscard]] bool can_draw() const;
  /// Renders before the next repaint.
  void draw_later();
  /// Number of times VTK has rendered the scene for the screen.
  [[nodiscard]] int renders() const;
  /// Numbers of contexts that were set up and released.
  [[nodiscard]] int contexts_made() const;
  [[nodiscard]] int contexts_lost() const;

  [[nodiscard]] vtkGenericOpenGLRenderWindow* render_window() const;
  /// The same as its base class, for callers that need no more.
  [[nodiscard]] vtkRenderWindow* scene_window() const;
  [[nodiscard]] vtkRenderWindowInteractor* interactor() const;

  [[nodiscard]] QSize sizeHint() const override { return {800, 450}; }
  [[nodiscard]] QSize minimumSizeHint() const override { return {240, 135}; }

 protected:
  void initializeGL() override;
  void paintGL() override;
  bool event(QEvent* event) override;

 private:
  struct State;
  void observe();
  void fit_size();
  void render();
  void show_image();
  void clean_up();
  std::unique_ptr<State> state_;
};

// Images of the 3D view without a window and without a display.

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
