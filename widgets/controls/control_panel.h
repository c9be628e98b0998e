// A camera's controls, built from the list that the camera reports.
#pragma once

#include "core/sources/v4l2/camera_controls.h"
#include "widgets/translated.h"

#include <QCheckBox>
#include <QGridLayout>
#include <QLabel>
#include <QWidget>
#include <map>
#include <vector>

namespace alltact {

/// The controls that decide over brightness and sharpness come first. A locked panel shows all and
/// changes none.
class ControlPanel : public Translated<QWidget> {
  Q_OBJECT
 public:
  explicit ControlPanel(QWidget* parent = nullptr);

  /// May be called at every poll of the camera; a control in use is not changed.
  void set_controls(const std::vector<CameraControl>& controls, bool is_locked);

 Q_SIGNALS:
  /// By the user. `before`: its value until now.
  void control_changed(quint32 id, qint64 before, qint64 value);
  void lock_changed(bool is_locked);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  class Row;
  void rebuild();
  void refresh();

  std::vector<CameraControl> controls_;
  bool is_locked_ = true;
  QCheckBox* lock_;
  QLabel* reason_;
  QLabel* empty_;
  QWidget* list_;
  std::map<std::uint32_t, Row*> rows_;
};

}  // namespace alltact
