#include "widgets/accessible.h"

#include <QAccessibleWidget>

namespace alltact {
namespace {

constexpr const char* kRole = "alltact_accessible_role";
constexpr const char* kValue = "alltact_accessible_value";

/// Also reports a value as text.
class AccessibleWidget : public QAccessibleWidget {
 public:
  using QAccessibleWidget::QAccessibleWidget;
  [[nodiscard]] QString text(QAccessible::Text kind) const override {
    if (kind == QAccessible::Value) return object()->property(kValue).toString();
    return QAccessibleWidget::text(kind);
  }
};

QAccessibleInterface* make_interface(const QString& /*class_name*/, QObject* object) {
  auto* widget = qobject_cast<QWidget*>(object);
  if (widget == nullptr) return nullptr;
  const QVariant role = widget->property(kRole);
  if (!role.isValid()) return nullptr;
  return new AccessibleWidget(widget, static_cast<QAccessible::Role>(role.toInt()));
}

}  // namespace

void set_accessible_role(QWidget& widget, QAccessible::Role role) {
  static const bool is_installed = (QAccessible::installFactory(make_interface), true);
  static_cast<void>(is_installed);
  widget.setProperty(kRole, static_cast<int>(role));
}

void set_accessible_value(QWidget& widget, const QString& text) {
  if (widget.property(kValue).toString() == text) return;
  widget.setProperty(kValue, text);
  QAccessibleValueChangeEvent event(&widget, text);
  QAccessible::updateAccessibility(&event);
}

void set_accessible_description(QWidget& widget, const QString& text) {
  if (widget.accessibleDescription() == text) return;
  widget.setAccessibleDescription(text);
  QAccessibleEvent event(&widget, QAccessible::DescriptionChanged);
  QAccessible::updateAccessibility(&event);
}

}  // namespace alltact
