#include "widgets/scene3d/interactor.h"

#include <QMouseEvent>
#include <QTimer>
#include <QWheelEvent>
#include <QWidget>
#include <cmath>
#include <map>

#include <vtkCommand.h>
#include <vtkObjectFactory.h>

namespace alltact {
namespace {

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

}  // namespace

struct Interactor::Timers {
  std::map<int, std::unique_ptr<QTimer>> running;
  int last_id = 0;
};

vtkStandardNewMacro(Interactor);

Interactor::Interactor() : timers_(std::make_unique<Timers>()) {}

Interactor::~Interactor() = default;

int Interactor::InternalCreateTimer(int timer_id, int timer_type, unsigned long duration_ms) {
  const int id = ++timers_->last_id;
  auto timer = std::make_unique<QTimer>();
  timer->setSingleShot(timer_type == OneShotTimer);
  QObject::connect(timer.get(), &QTimer::timeout, timer.get(), [this, timer_id, timer_type]() {
    int fired_id = timer_id;
    if (GetEnabled()) InvokeEvent(vtkCommand::TimerEvent, &fired_id);
    if (timer_type == OneShotTimer) DestroyTimer(timer_id);
  });
  timer->start(static_cast<int>(duration_ms));
  timers_->running[id] = std::move(timer);
  return id;
}

int Interactor::InternalDestroyTimer(int platform_timer_id) {
  const auto found = timers_->running.find(platform_timer_id);
  if (found == timers_->running.end()) return 0;
  // It may be the timer whose event is being handled.
  found->second->stop();
  found->second.release()->deleteLater();
  timers_->running.erase(found);
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
                           keys.testFlag(Qt::ShiftModifier) ? 1 : 0,
                           0,
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

}  // namespace alltact
