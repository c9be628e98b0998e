// VTK's interactor on Qt's event loop. Inside this folder only.
#pragma once

#include <memory>

#include <vtkRenderWindowInteractor.h>

class QEvent;
class QWidget;

namespace alltact {

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
  Interactor();
  ~Interactor() override;
  int InternalCreateTimer(int timer_id, int timer_type, unsigned long duration_ms) override;
  int InternalDestroyTimer(int platform_timer_id) override;

 private:
  struct Timers;
  bool take_mouse(double ratio, QEvent& event);
  bool take_wheel(double ratio, QEvent& event);

  std::unique_ptr<Timers> timers_;
  int wheel_ = 0;  // eighths of a degree not yet passed on
};

}  // namespace alltact
