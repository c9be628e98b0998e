// After VTK's own adapter for Qt 5, with findings about Qt 6 and VTK 9.1; each step that looks
// superfluous has a platform that needs it.
#include "widgets/scene3d/vtk_view.h"

#include "widgets/scene3d/interactor.h"
#include "widgets/scene3d/render_window.h"

#include <QCoreApplication>
#include <QCursor>
#include <QEvent>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLExtraFunctions>
#include <QOpenGLFunctions>
#include <QScreen>
#include <QSurfaceFormat>

#include <vtkCallbackCommand.h>
#include <vtkCommand.h>
#include <vtkInteractorStyleTrackballCamera.h>
#include <vtkNew.h>
#include <vtkOpenGLFramebufferObject.h>
#include <vtkOpenGLState.h>
#include <vtkRenderer.h>
#include <vtkRendererCollection.h>

namespace alltact {
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
  for (const auto set : {&QSurfaceFormat::setRedBufferSize,
                         &QSurfaceFormat::setGreenBufferSize,
                         &QSurfaceFormat::setBlueBufferSize,
                         &QSurfaceFormat::setAlphaBufferSize,
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

bool VtkView::can_draw() const {
  return isValid() && state_->window->GetReadyForRendering();
}

int VtkView::renders() const {
  return state_->renders;
}

int VtkView::contexts_made() const {
  return state_->contexts_made;
}

int VtkView::contexts_lost() const {
  return state_->contexts_lost;
}

vtkGenericOpenGLRenderWindow* VtkView::render_window() const {
  return state_->window;
}

vtkRenderWindow* VtkView::scene_window() const {
  return state_->window;
}

vtkRenderWindowInteractor* VtkView::interactor() const {
  return state_->interactor;
}

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
  connect(context(),
          &QOpenGLContext::aboutToBeDestroyed,
          this,
          &VtkView::clean_up,
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
  window->BlitDisplayFramebuffer(0,
                                 0,
                                 0,
                                 source[0],
                                 source[1],
                                 0,
                                 0,
                                 pixels.width(),
                                 pixels.height(),
                                 GL_COLOR_BUFFER_BIT,
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

}  // namespace alltact
