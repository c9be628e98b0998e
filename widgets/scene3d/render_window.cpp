#include "widgets/scene3d/render_window.h"

#include <cstdio>

#include <qopengl.h>
#include <vtkObject.h>
#include <vtkObjectFactory.h>

namespace alltact {
namespace {

/// Suppresses VTK's warnings while it lives.
class NoWarnings {
 public:
  NoWarnings() : were_on_(vtkObject::GetGlobalWarningDisplay()) {
    vtkObject::GlobalWarningDisplayOff();
  }
  ~NoWarnings() { vtkObject::SetGlobalWarningDisplay(were_on_); }
  NoWarnings(const NoWarnings&) = delete;
  NoWarnings& operator=(const NoWarnings&) = delete;

 private:
  int were_on_;
};

/// There is a current context of OpenGL 3.2 or later.
bool is_usable() {
  const auto* version = reinterpret_cast<const char*>(glGetString(GL_VERSION));
  int major = 0, minor = 0;
  if (version == nullptr || std::sscanf(version, "%d.%d", &major, &minor) != 2) return false;
  return major > 3 || (major == 3 && minor >= 2);
}

}  // namespace

vtkStandardNewMacro(RenderWindow);

void RenderWindow::OpenGLInitContext() {
  {
    const NoWarnings quiet;
    vtkGenericOpenGLRenderWindow::OpenGLInitContext();
  }
  if (!Initialized && is_usable()) {
    GlewInitValid = true;
    Initialized = true;
  }
}

}  // namespace alltact
