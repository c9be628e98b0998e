// VTK's window over an OpenGL context that somebody else makes current. Inside this folder only.
#pragma once

#include <vtkGenericOpenGLRenderWindow.h>

namespace alltact {

/// Debian's VTK 9.1 initialises GLEW for GLX and takes its own context for unusable without one
/// (Wayland, EGL), although all functions are loaded by then. This class asks the context.
class RenderWindow : public vtkGenericOpenGLRenderWindow {
 public:
  static RenderWindow* New();
  vtkTypeMacro(RenderWindow, vtkGenericOpenGLRenderWindow)
  RenderWindow(const RenderWindow&) = delete;
  RenderWindow& operator=(const RenderWindow&) = delete;

  void OpenGLInitContext() override;

 protected:
  RenderWindow() = default;
  ~RenderWindow() override = default;
};

}  // namespace alltact
