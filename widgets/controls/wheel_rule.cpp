#include "widgets/controls/wheel_rule.h"

#include <QAbstractSpinBox>
#include <QComboBox>
#include <QEvent>
#include <QFocusEvent>

namespace alltact {
namespace {

/// Somebody went to the field, rather than the page as it opened.
bool is_by_somebody(Qt::FocusReason reason) {
  return reason == Qt::MouseFocusReason || reason == Qt::TabFocusReason ||
         reason == Qt::BacktabFocusReason || reason == Qt::ShortcutFocusReason;
}

class WheelRule : public QObject {
 public:
  explicit WheelRule(QCoreApplication& application) : QObject(&application) {
    setObjectName(kName);
    application.installEventFilter(this);
  }
  bool eventFilter(QObject* object, QEvent* event) override {
    const QEvent::Type type = event->type();
    if (type != QEvent::Wheel && type != QEvent::Polish && type != QEvent::FocusIn) return false;
    auto* field = qobject_cast<QWidget*>(object);
    if (qobject_cast<QAbstractSpinBox*>(object) == nullptr &&
        qobject_cast<QComboBox*>(object) == nullptr)
      return false;
    // Else the wheel itself would give it the focus.
    if (type == QEvent::Polish && field->focusPolicy() == Qt::WheelFocus)
      field->setFocusPolicy(Qt::StrongFocus);
    if (type == QEvent::FocusIn)
      field->setProperty(kEntered, is_by_somebody(static_cast<QFocusEvent*>(event)->reason()));
    if (type != QEvent::Wheel || (field->hasFocus() && field->property(kEntered).toBool()))
      return false;
    event->ignore();  // for what lies around it
    return true;
  }
  static constexpr const char *kName = "alltact_wheel_rule", *kEntered = "alltact_is_entered";
};

}  // namespace

void let_wheel_scroll(QCoreApplication& application) {
  if (application.findChild<QObject*>(WheelRule::kName, Qt::FindDirectChildrenOnly) == nullptr)
    new WheelRule(application);
}

}  // namespace alltact
