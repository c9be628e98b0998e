// What the mouse's wheel does over fields for numbers and choices.
#pragma once

#include <QCoreApplication>

namespace alltact {

/// Over a field that nobody clicked on or went to by keys the wheel scrolls the page, instead of
/// changing a number or a choice that nobody looks at. A call for each window is harmless.
void let_wheel_scroll(QCoreApplication& application);

}  // namespace alltact
