#include "widgets/scene3d/offscreen_scene.h"

#include "widgets/scene3d/render_window.h"

#include <cmath>

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <opencv2/imgproc.hpp>
#include <vtkCallbackCommand.h>
#include <vtkCommand.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkWindowToImageFilter.h>

namespace alltact {
namespace {

/// An OpenGL context without a surface; none where there is no EGL for it.
class SurfacelessContext {
 public:
  SurfacelessContext() {
    const auto get_display = reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(
        eglGetProcAddress("eglGetPlatformDisplayEXT"));
    if (get_display == nullptr) return;
    display_ = get_display(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    if (display_ == EGL_NO_DISPLAY || eglInitialize(display_, nullptr, nullptr) == EGL_FALSE)
      return;
    if (eglBindAPI(EGL_OPENGL_API) == EGL_FALSE) return;
    constexpr EGLint kConfig[] = {
        EGL_SURFACE_TYPE, 0, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    if (eglChooseConfig(display_, kConfig, &config, 1, &count) == EGL_FALSE || count == 0) return;
    constexpr EGLint kVersion[] = {EGL_CONTEXT_MAJOR_VERSION,
                                   3,
                                   EGL_CONTEXT_MINOR_VERSION,
                                   2,
                                   EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                   EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                   EGL_NONE};
    context_ = eglCreateContext(display_, config, EGL_NO_CONTEXT, kVersion);
  }
  ~SurfacelessContext() {
    if (context_ == EGL_NO_CONTEXT) return;
    if (is_current()) eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    eglDestroyContext(display_, context_);
    // The display is the process's; others may be using it.
  }
  SurfacelessContext(const SurfacelessContext&) = delete;
  SurfacelessContext& operator=(const SurfacelessContext&) = delete;

  [[nodiscard]] bool make_current() const {
    return context_ != EGL_NO_CONTEXT && eglBindAPI(EGL_OPENGL_API) == EGL_TRUE &&
           eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_) == EGL_TRUE;
  }
  [[nodiscard]] bool is_current() const {
    return context_ != EGL_NO_CONTEXT && eglGetCurrentContext() == context_;
  }

 private:
  EGLDisplay display_ = EGL_NO_DISPLAY;
  EGLContext context_ = EGL_NO_CONTEXT;
};

void observe(RenderWindow* window,
             unsigned long event,
             SurfacelessContext& context,
             void (*act)(vtkObject*, unsigned long, void*, void*)) {
  const vtkNew<vtkCallbackCommand> command;
  command->SetClientData(&context);
  command->SetCallback(act);
  window->AddObserver(event, command);
}

}  // namespace

struct OffscreenScene::State {
  SurfacelessContext context;  // outlives the window
  vtkNew<RenderWindow> window;
  std::unique_ptr<FaceScene> scene;

  ~State() {
    scene.reset();
    if (context.make_current()) window->Finalize();
  }
};

Result<OffscreenScene> OffscreenScene::create(cv::Size size_px, double pixels_per_unit) {
  auto state = std::make_unique<State>();
  if (!state->context.make_current()) {
    return Error{en::say("this computer cannot draw in 3D: there is no EGL with OpenGL 3.2"),
                 "",
                 en::say("installing libegl1 and libgl1-mesa-dri, which draw in software")};
  }
  RenderWindow* window = state->window;
  observe(window,
          vtkCommand::WindowMakeCurrentEvent,
          state->context,
          [](vtkObject*, unsigned long, void* context, void*) {
            static_cast<void>(static_cast<SurfacelessContext*>(context)->make_current());
          });
  observe(window,
          vtkCommand::WindowIsCurrentEvent,
          state->context,
          [](vtkObject*, unsigned long, void* context, void* answer) {
            *static_cast<bool*>(answer) = static_cast<SurfacelessContext*>(context)->is_current();
          });
  window->SetFrameBlitModeToNoBlit();
  window->SetForceMaximumHardwareLineWidth(1);
  window->SetOwnContext(0);
  window->SetMultiSamples(4);
  constexpr double kDotsPerInch = 72;  // as on a screen, see VtkView
  window->SetDPI(static_cast<int>(std::lround(kDotsPerInch * pixels_per_unit)));
  window->SetSize(size_px.width, size_px.height);
  window->OpenGLInitContext();
  state->scene = std::make_unique<FaceScene>(window);
  state->scene->set_scale(pixels_per_unit);
  return OffscreenScene(std::move(state));
}

OffscreenScene::OffscreenScene(std::unique_ptr<State> state) : state_(std::move(state)) {}
OffscreenScene::OffscreenScene(OffscreenScene&&) noexcept = default;
OffscreenScene& OffscreenScene::operator=(OffscreenScene&&) noexcept = default;
OffscreenScene::~OffscreenScene() = default;

FaceScene& OffscreenScene::scene() {
  return *state_->scene;
}

cv::Mat OffscreenScene::image() {
  state_->window->Render();
  const vtkNew<vtkWindowToImageFilter> reader;
  reader->SetInput(state_->window);
  reader->ReadFrontBufferOff();
  reader->ShouldRerenderOff();
  reader->SetInputBufferTypeToRGB();
  reader->Update();
  vtkImageData* pixels = reader->GetOutput();
  int size[3];
  pixels->GetDimensions(size);
  const cv::Mat rows(size[1], size[0], CV_8UC3, pixels->GetScalarPointer());
  cv::Mat flipped;
  cv::flip(rows, flipped, 0);
  cv::cvtColor(flipped, flipped, cv::COLOR_RGB2BGR);
  return flipped;
}

}  // namespace alltact
