// What is wrong with how a window is laid out, told from the geometry of its widgets alone: texts
// that do not fit, widgets over each other, pictures that are too small, rooms that stand empty.
#pragma once

#include <QRect>
#include <QWidget>
#include <string>
#include <vector>

namespace alltact::test {

/// A sentence for each visible text below `root` that is wider or higher than its widget, or than
/// what its widget stands in where nothing scrolls there. One that is cut with an ellipsis and told
/// by a tool tip is none.
[[nodiscard]] std::vector<std::string> cut_texts(const QWidget& root);

/// A sentence for each two visible children of one parent that cover a pixel both.
[[nodiscard]] std::vector<std::string> overlaps(const QWidget& root);

/// A sentence for each visible image and plot below `root` that is of one colour but for a 200th.
/// Views of OpenGL are left out: nothing draws them off the screen.
[[nodiscard]] std::vector<std::string> blank_pictures(const QWidget& root);

/// Part of the page, 0 to 1, that pictures, plots and views in 3D take.
[[nodiscard]] double pictured_part(const QWidget& page);

/// The largest rectangle in which nothing stands, in the page's pixels (8 px steps). A picture
/// without content, the room below a list's last row and below a text are empty, too.
[[nodiscard]] QRect largest_empty(const QWidget& page);

/// Its part of the page, 0 to 1.
[[nodiscard]] double empty_part(const QWidget& page);

}  // namespace alltact::test
