#include "widgets/scene3d/vtk_view.h"

#include <QCoreApplication>
#include <QCursor>
#include <QEvent>
#include <QMouseEvent>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLExtraFunctions>
#include <QOpenGLFunctions>
#include <QScreen>
#include <QSurfaceFormat>
#include <QTimer>
#include <QWheelEvent>
#include <QWidget>
#include <cmath>
#include <cstdio>
#include <map>
#include <memory>

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <opencv2/imgproc.hpp>
#include <qopengl.h>
#include <vtkCallbackCommand.h>
#include <vtkCommand.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkImageData.h>
#include <vtkInteractorStyleTrackballCamera.h>
#include <vtkNew.h>
#include <vtkObject.h>
#include <vtkObjectFactory.h>
#include <vtkOpenGLFramebufferObject.h>
#include <vtkOpenGLState.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>
#include <vtkRendererCollection.h>
#include <vtkWindowToImageFilter.h>

namespace alltact {
namespace {

/// Qt owns the loop; timers are Qt's.
class Interactor : public vtkRenderWindowInteractor {
 public:
  static Interactor* New();
  vtkTypeMacro(Interactor, vtkRenderWindowInteractor)
  Interactor(const Interactor&) = delete;
  Interactor& operator=(const Interactor&) = delete;

  void Start() override {}
  void TerminateApp() override {}

  /// Passes a mouse, wheel, enter, leave or touch event of `widget` on to VTK; false: none of
  /// these.
  bool take(const QWidget& widget, QEvent& event);

 protected:
  Interactor() = default;
  ~Interactor() override = default;
  int InternalCreateTimer(int timer_id, int timer_type, unsigned long duration_ms) override;
  int InternalDestroyTimer(int platform_timer_id) override;

 private:
  bool take_mouse(double ratio, QEvent& event);
  bool take_wheel(double ratio, QEvent& event);

  std::map<int, std::unique_ptr<QTimer>> timers_;  // running ones, by their id
  int last_timer_ = 0;
  int wheel_ = 0;  // eighths of a degree not yet passed on
};

constexpr int kWheelStep = 120;  // one click of a mouse's wheel, as Qt counts

unsigned long vtk_event_of(QEvent::Type type, Qt::MouseButton button) {
  const bool is_release = type == QEvent::MouseButtonRelease;
  switch (button) {
    case Qt::LeftButton:
      return is_release ? vtkCommand::LeftButtonReleaseEvent : vtkCommand::LeftButtonPressEvent;
    case Qt::MiddleButton:
      return is_release ? vtkCommand::MiddleButtonReleaseEvent : vtkCommand::MiddleButtonPressEvent;
    case Qt::RightButton:
      return is_release ? vtkCommand::RightButtonReleaseEvent : vtkCommand::RightButtonPressEvent;
    default:
      return vtkCommand::NoEvent;
  }
}

vtkStandardNewMacro(Interactor);

int Interactor::InternalCreateTimer(int timer_id, int timer_type, unsigned long duration_ms) {
  const int id = ++last_timer_;
  auto timer = std::make_unique<QTimer>();
  timer->setSingleShot(timer_type == OneShotTimer);
  QObject::connect(timer.get(), &QTimer::timeout, timer.get(), [this, timer_id, timer_type]() {
    int fired_id = timer_id;
    if (GetEnabled()) InvokeEvent(vtkCommand::TimerEvent, &fired_id);
    if (timer_type == OneShotTimer) DestroyTimer(timer_id);
  });
  timer->start(static_cast<int>(duration_ms));
  timers_[id] = std::move(timer);
  return id;
}

int Interactor::InternalDestroyTimer(int platform_timer_id) {
  const auto found = timers_.find(platform_timer_id);
  if (found == timers_.end()) return 0;
  // It may be the timer whose event is being handled.
  found->second->stop();
  found->second.release()->deleteLater();
  timers_.erase(found);
  return 1;
}

bool Interactor::take(const QWidget& widget, QEvent& event) {
  if (!GetEnabled()) return false;
  const double ratio = widget.devicePixelRatioF();
  switch (event.type()) {
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonRelease:
    case QEvent::MouseButtonDblClick:
    case QEvent::MouseMove:
      return take_mouse(ratio, event);
    case QEvent::Wheel:
      return take_wheel(ratio, event);
    case QEvent::Enter:
      InvokeEvent(vtkCommand::EnterEvent);
      return true;
    case QEvent::Leave:
      InvokeEvent(vtkCommand::LeaveEvent);
      return true;
    // Accepted, or their updates never come; Qt makes mouse events of them.
    case QEvent::TouchBegin:
    case QEvent::TouchUpdate:
    case QEvent::TouchEnd:
      return true;
    default:
      return false;
  }
}

bool Interactor::take_mouse(double ratio, QEvent& event) {
  const auto& mouse = static_cast<const QMouseEvent&>(event);
  const Qt::KeyboardModifiers keys = mouse.modifiers();
  SetEventInformationFlipY(static_cast<int>(std::lround(mouse.position().x() * ratio)),
                           static_cast<int>(std::lround(mouse.position().y() * ratio)),
                           keys.testFlag(Qt::ControlModifier) ? 1 : 0,
                           keys.testFlag(Qt::ShiftModifier) ? 1 : 0, 0,
                           event.type() == QEvent::MouseButtonDblClick ? 1 : 0);
  SetAltKey(keys.testFlag(Qt::AltModifier) ? 1 : 0);
  if (event.type() == QEvent::MouseMove) {
    InvokeEvent(vtkCommand::MouseMoveEvent);
    return true;
  }
  const unsigned long vtk_event = vtk_event_of(event.type(), mouse.button());
  if (vtk_event == vtkCommand::NoEvent) return false;
  InvokeEvent(vtk_event);
  return true;
}

bool Interactor::take_wheel(double ratio, QEvent& event) {
  const auto& wheel = static_cast<const QWheelEvent&>(event);
  SetEventInformationFlipY(static_cast<int>(std::lround(wheel.position().x() * ratio)),
                           static_cast<int>(std::lround(wheel.position().y() * ratio)));
  wheel_ += wheel.angleDelta().y();
  for (; wheel_ >= kWheelStep; wheel_ -= kWheelStep)
    InvokeEvent(vtkCommand::MouseWheelForwardEvent);
  for (; wheel_ <= -kWheelStep; wheel_ += kWheelStep)
    InvokeEvent(vtkCommand::MouseWheelBackwardEvent);
  return true;
}

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

/// There is a current context of OpenGL 3.2 or later.
bool is_usable() {
  const auto* version = reinterpret_cast<const char*>(glGetString(GL_VERSION));
  int major = 0, minor = 0;
  if (version == nullptr || std::sscanf(version, "%d.%d", &major, &minor) != 2) return false;
  return major > 3 || (major == 3 && minor >= 2);
}

vtkStandardNewMacro(RenderWindow);

void RenderWindow::OpenGLInitContext() {
  const int were_warnings_on = vtkObject::GetGlobalWarningDisplay();
  vtkObject::GlobalWarningDisplayOff();
  vtkGenericOpenGLRenderWindow::OpenGLInitContext();
  vtkObject::SetGlobalWarningDisplay(were_warnings_on);
  if (!Initialized && is_usable()) {
    GlewInitValid = true;
    Initialized = true;
  }
}

}  // namespace

// After VTK's own adapter for Qt 5, with findings about Qt 6 and VTK 9.1; each step that looks
// superfluous has a platform that needs it.

namespace {

Qt::CursorShape shape_of(int vtk_cursor) {
  switch (vtk_cursor) {
    case VTK_CURSOR_CROSSHAIR:
      return Qt::CrossCursor;
    case VTK_CURSOR_SIZEALL:
      return Qt::SizeAllCursor;
    case VTK_CURSOR_SIZENS:
      return Qt::SizeVerCursor;
    case VTK_CURSOR_SIZEWE:
      return Qt::SizeHorCursor;
    case VTK_CURSOR_HAND:
      return Qt::PointingHandCursor;
    default:
      return Qt::ArrowCursor;
  }
}

bool is_software(QOpenGLContext& context) {
  const auto* name = reinterpret_cast<const char*>(context.functions()->glGetString(GL_RENDERER));
  const QByteArray renderer(name);
  return renderer.contains("llvmpipe") || renderer.contains("softpipe") ||
         renderer.contains("swrast");
}

}  // namespace

struct VtkView::State {
  vtkNew<RenderWindow> window;
  vtkNew<Interactor> interactor;
  std::vector<unsigned long> observers;
  QSurface* surface = nullptr;  // the context's own, not Qt's framebuffer
  bool is_dirty = true;
  bool is_painting = false;
  int renders = 0, contexts_made = 0, contexts_lost = 0;
};

void VtkView::prepare_application() {
  QCoreApplication::setAttribute(Qt::AA_ShareOpenGLContexts);
  QSurfaceFormat format;
  format.setRenderableType(QSurfaceFormat::OpenGL);
  format.setVersion(3, 2);
  format.setProfile(QSurfaceFormat::CoreProfile);
  format.setSwapBehavior(QSurfaceFormat::DoubleBuffer);
  for (const auto set : {&QSurfaceFormat::setRedBufferSize, &QSurfaceFormat::setGreenBufferSize,
                         &QSurfaceFormat::setBlueBufferSize, &QSurfaceFormat::setAlphaBufferSize,
                         &QSurfaceFormat::setDepthBufferSize})
    (format.*set)(8);
  format.setStencilBufferSize(0);
  format.setSamples(0);  // VTK smooths its own edges
  QSurfaceFormat::setDefaultFormat(format);
}

bool VtkView::is_supported() {
  // The test costs a context; the platform does not change.
  static const bool is = [] {
    QOpenGLContext context;
    if (!context.create()) return false;
    QOffscreenSurface surface;
    surface.setFormat(context.format());
    surface.create();
    if (!surface.isValid() || !context.makeCurrent(&surface)) return false;
    const QSurfaceFormat format = context.format();
    context.doneCurrent();
    return format.renderableType() != QSurfaceFormat::OpenGLES &&
           format.version() >= std::pair(3, 2);
  }();
  return is;
}

VtkView::VtkView(QWidget* parent) : QOpenGLWidget(parent), state_(std::make_unique<State>()) {
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  setAttribute(Qt::WA_Hover);
  setAttribute(Qt::WA_AcceptTouchEvents);
  setUpdateBehavior(QOpenGLWidget::NoPartialUpdate);
  setProperty("_kde_no_window_grab", true);
  RenderWindow* window = state_->window;
  window->SetReadyForRendering(false);
  window->SetFrameBlitModeToNoBlit();
  state_->interactor->SetRenderWindow(window);
  state_->interactor->Initialize();
  const vtkNew<vtkInteractorStyleTrackballCamera> style;
  state_->interactor->SetInteractorStyle(style);
  observe();
  // Comes after resizing and also when the screen or its scale changes.
  connect(this, &QOpenGLWidget::resized, this, &VtkView::fit_size);
}

VtkView::~VtkView() {
  if (context() != nullptr) {
    disconnect(context(), nullptr, this, nullptr);  // it goes after this object's own part has gone
    clean_up();
    doneCurrent();
  }
  for (const unsigned long observer : state_->observers) state_->window->RemoveObserver(observer);
  state_->interactor->SetRenderWindow(nullptr);
}

void VtkView::observe() {
  const auto on = [this](unsigned long event, void (*act)(VtkView&, void*)) {
    const vtkNew<vtkCallbackCommand> command;
    struct Call {
      VtkView* view;
      void (*act)(VtkView&, void*);
    };
    command->SetClientData(new Call{this, act});
    command->SetClientDataDeleteCallback([](void* call) { delete static_cast<Call*>(call); });
    command->SetCallback([](vtkObject*, unsigned long, void* call, void* data) {
      static_cast<Call*>(call)->act(*static_cast<Call*>(call)->view, data);
    });
    state_->observers.push_back(state_->window->AddObserver(event, command));
  };
  on(vtkCommand::WindowMakeCurrentEvent, [](VtkView& view, void*) {
    // Not QOpenGLWidget::makeCurrent(): that binds Qt's framebuffer behind VTK's back.
    if (view.context() != nullptr && view.state_->surface != nullptr)
      view.context()->makeCurrent(view.state_->surface);
  });
  on(vtkCommand::WindowIsCurrentEvent, [](VtkView& view, void* answer) {
    *static_cast<bool*>(answer) = view.context() != nullptr &&
                                  QOpenGLContext::currentContext() == view.context() &&
                                  view.context()->surface() == view.state_->surface;
  });
  on(vtkCommand::StartEvent, [](VtkView& view, void*) {
    // Opaque in every image, or the content behind the window shines through.
    vtkRendererCollection* renderers = view.state_->window->GetRenderers();
    renderers->InitTraversal();
    while (vtkRenderer* renderer = renderers->GetNextItem()) renderer->SetBackgroundAlpha(1);
  });
  on(vtkCommand::WindowFrameEvent, [](VtkView& view, void*) {
    RenderWindow* window = view.state_->window;
    // Picking renders without swapping, and makes no new image.
    if (window->GetDoubleBuffer() != 0 && window->GetSwapBuffers() == 0) return;
    ++view.state_->renders;
    view.state_->is_dirty = false;
    if (!view.state_->is_painting) view.update();
  });
  on(vtkCommand::CursorChangedEvent, [](VtkView& view, void* shape) {
    if (shape != nullptr) view.setCursor(shape_of(*static_cast<int*>(shape)));
  });
}

bool VtkView::can_draw() const { return isValid() && state_->window->GetReadyForRendering(); }

int VtkView::renders() const { return state_->renders; }

int VtkView::contexts_made() const { return state_->contexts_made; }

int VtkView::contexts_lost() const { return state_->contexts_lost; }

vtkGenericOpenGLRenderWindow* VtkView::render_window() const { return state_->window; }

vtkRenderWindow* VtkView::scene_window() const { return state_->window; }

vtkRenderWindowInteractor* VtkView::interactor() const { return state_->interactor; }

void VtkView::draw_later() {
  state_->is_dirty = true;
  update();
}

void VtkView::initializeGL() {
  RenderWindow* window = state_->window;
  state_->surface = context()->surface();
  window->SetForceMaximumHardwareLineWidth(1);
  window->SetReadyForRendering(true);
  window->SetOwnContext(0);
  window->OpenGLInitContext();
  // Smooth edges cost a graphics card nothing, and software as many times more.
  window->SetMultiSamples(is_software(*context()) ? 0 : 4);
  window->GetState()->Reset();
  // Qt leaves the test off and the function at GL_LESS; VTK assumes the opposite.
  window->GetState()->vtkglDepthFunc(GL_LEQUAL);
  window->GetState()->vtkglEnable(GL_DEPTH_TEST);
  ++state_->contexts_made;
  state_->is_dirty = true;
  connect(context(), &QOpenGLContext::aboutToBeDestroyed, this, &VtkView::clean_up,
          static_cast<Qt::ConnectionType>(Qt::DirectConnection | Qt::UniqueConnection));
  fit_size();
}

void VtkView::clean_up() {
  RenderWindow* window = state_->window;
  if (!window->GetReadyForRendering()) return;
  makeCurrent();
  window->Finalize();
  window->SetReadyForRendering(false);
  state_->surface = nullptr;
  ++state_->contexts_lost;
}

void VtkView::fit_size() {
  const double ratio = devicePixelRatioF();
  const QSize pixels = (QSizeF(size()) * ratio).toSize();
  constexpr int kDotsPerInch = 72;
  RenderWindow* window = state_->window;
  const QSize screen_px =
      screen() != nullptr ? (QSizeF(screen()->size()) * ratio).toSize() : pixels;
  window->SetScreenSize(screen_px.width(), screen_px.height());
  window->SetDPI(static_cast<int>(std::lround(kDotsPerInch * ratio)));
  window->SetSize(pixels.width(), pixels.height());
  state_->interactor->UpdateSize(pixels.width(), pixels.height());
  state_->interactor->InvokeEvent(vtkCommand::ConfigureEvent);
  state_->is_dirty = true;
}

void VtkView::render() {
  vtkOpenGLState* gl = state_->window->GetState();
  gl->Reset();
  gl->Push();
  gl->vtkglDepthFunc(GL_LEQUAL);
  gl->vtkglEnable(GL_DEPTH_TEST);
  if (state_->is_dirty) state_->window->Render();
  makeCurrent();  // rendering may have run something that took the context
  show_image();
  gl->Pop();
}

void VtkView::show_image() {
  RenderWindow* window = state_->window;
  vtkOpenGLState* gl = window->GetState();
  QOpenGLExtraFunctions* functions = context()->extraFunctions();
  functions->glBindFramebuffer(GL_DRAW_FRAMEBUFFER, defaultFramebufferObject());
  const GLenum buffer = GL_COLOR_ATTACHMENT0;
  functions->glDrawBuffers(1, &buffer);
  gl->vtkglDisable(GL_SCISSOR_TEST);
  functions->glDisable(GL_SCISSOR_TEST);
  const QSize pixels = (QSizeF(size()) * devicePixelRatioF()).toSize();
  const int* source = window->GetRenderFramebuffer()->GetLastSize();
  const bool is_same_size = source[0] == pixels.width() && source[1] == pixels.height();
  window->BlitDisplayFramebuffer(0, 0, 0, source[0], source[1], 0, 0, pixels.width(),
                                 pixels.height(), GL_COLOR_BUFFER_BIT,
                                 is_same_size ? GL_NEAREST : GL_LINEAR);
}

void VtkView::paintGL() {
  if (state_->is_painting || !state_->window->GetReadyForRendering()) return;
  state_->is_painting = true;
  render();
  state_->is_painting = false;
}

bool VtkView::event(QEvent* event) {
  if (state_ && state_->interactor->take(*this, *event)) {
    if (event->type() != QEvent::Enter && event->type() != QEvent::Leave) event->accept();
    QOpenGLWidget::event(event);
    event->accept();
    return true;
  }
  return QOpenGLWidget::event(event);
}

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
    constexpr EGLint kConfig[] = {EGL_SURFACE_TYPE, 0, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT,
                                  EGL_NONE};
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

void observe(RenderWindow* window, unsigned long event, SurfacelessContext& context,
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
    return Error{en::say("this computer cannot draw in 3D: there is no EGL with OpenGL 3.2"), "",
                 en::say("installing libegl1 and libgl1-mesa-dri, which render in software")};
  }
  RenderWindow* window = state->window;
  observe(window, vtkCommand::WindowMakeCurrentEvent, state->context,
          [](vtkObject*, unsigned long, void* context, void*) {
            static_cast<void>(static_cast<SurfacelessContext*>(context)->make_current());
          });
  observe(window, vtkCommand::WindowIsCurrentEvent, state->context,
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
  // VTK assumes GL_LEQUAL, without which nothing flat is drawn over anything flat.
  window->GetState()->Reset();
  window->GetState()->vtkglDepthFunc(GL_LEQUAL);
  state->scene = std::make_unique<FaceScene>(window);
  state->scene->set_scale(pixels_per_unit);
  return OffscreenScene(std::move(state));
}

OffscreenScene::OffscreenScene(std::unique_ptr<State> state) : state_(std::move(state)) {}
OffscreenScene::OffscreenScene(OffscreenScene&&) noexcept = default;
OffscreenScene& OffscreenScene::operator=(OffscreenScene&&) noexcept = default;
OffscreenScene::~OffscreenScene() = default;

FaceScene& OffscreenScene::scene() { return *state_->scene; }

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
