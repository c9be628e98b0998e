// What a screen reader is told of widgets that paint themselves.
#pragma once

#include <QAccessible>
#include <QWidget>

namespace alltact {

/// From now on assistive programs see `widget` in this role; its name and description are the
/// widget's accessibleName() and accessibleDescription().
void set_accessible_role(QWidget& widget, QAccessible::Role role);

/// What a widget with such a role shows now, in words; tells of the change, where it is one.
void set_accessible_value(QWidget& widget, const QString& text);

/// Sets the description and tells of the change, where it is one.
void set_accessible_description(QWidget& widget, const QString& text);

}  // namespace alltact
