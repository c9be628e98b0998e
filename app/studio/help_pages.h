// The help's texts, which the help window, the first-time hints and the printed guide all read.
#pragma once

#include <QString>
#include <QStringList>

namespace alltact {

/// ":/alltact/help/NAME_LANGUAGE.md" for the window's language; the English one where there is
/// none.
[[nodiscard]] QString help_file(const QString& name);
/// Its text; empty where there is no such page.
[[nodiscard]] QString help_text(const QString& name);

/// The beginning of every page's help.
struct HelpLead {
  QString title;
  QString lead;       ///< the first paragraph, in one line
  QString image;      ///< a file next to the page; empty: none
  QStringList steps;  ///< the numbered list, each entry in one line
};
[[nodiscard]] HelpLead lead_of(const QString& markdown);

/// The text of a Markdown paragraph for a label, without its marks.
[[nodiscard]] QString without_marks(QString markdown);

}  // namespace alltact
