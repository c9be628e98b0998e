// Accessibility of widgets that paint themselves.
#pragma once

#include <QAccessible>
#include <QWidget>

namespace alltact {

/// Assistive programs see `widget` in this role from now on; its name and description are the
/// widget's accessibleName() and accessibleDescription().
void set_accessible_role(QWidget& widget, QAccessible::Role role);

/// Sets the value that a widget with such a role shows now, as text; announces a change.
void set_accessible_value(QWidget& widget, const QString& text);

/// Sets the description; announces a change.
void set_accessible_description(QWidget& widget, const QString& text);

}  // namespace alltact
