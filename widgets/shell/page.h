// Base class of the window's pages, each with a button in the navigation bar.
#pragma once

#include "core/finger/finger_store.h"
#include "widgets/shell/dropped_files.h"
#include "widgets/shell/problem_list.h"
#include "widgets/widget_base.h"

#include <QScrollArea>
#include <QSplitter>
#include <QVBoxLayout>
#include <QWidget>
#include <string>
#include <utility>
#include <vector>

namespace alltact {

/// The window has a table of its pages and uses this interface only; other dependencies go to the
/// constructors. The icon is resources/icons/NAME.svg; the help page is resources/help/NAME.md,
/// plus one for each language.
class Page : public Translated<QWidget> {
  Q_OBJECT
 public:
  /// `name` is stored in session files and file names: it is never translated and never changes.
  explicit Page(std::string name, QWidget* parent = nullptr)
      : Translated(parent), name_(std::move(name)) {}

  [[nodiscard]] const std::string& name() const { return name_; }
  /// Label in the navigation bar.
  [[nodiscard]] virtual QString title() const = 0;
  /// Entry of the menu View, with its mnemonic.
  [[nodiscard]] virtual QString menu_text() const = 0;

  /// The foot pedal was pressed while this page is visible.
  virtual void press_pedal() {}
  /// Adds problems of the open finger that the user should solve next, and those of this page while
  /// it is visible. Called whichever page is visible.
  virtual void add_problems(std::vector<Problem>& /*problems*/) {}
  /// The user was sent here to do the next step: opens it.
  virtual void begin_next_step() {}
  /// The open finger's folder has changed.
  virtual void reload() {}
  /// Opens files that were dropped on this page. False: it has no use for them.
  [[nodiscard]] virtual bool take_files(const DroppedFiles& /*dropped*/) { return false; }
  /// The page, by its name, that a button of this page leads to now; empty for none.
  [[nodiscard]] virtual std::string leads_to() const { return {}; }
  /// Gives the focus to what comes next: the primary action, or to the page while none is possible.
  void focus_next();

 Q_SIGNALS:
  /// State that a session stores has changed.
  void changed();
  /// add_problems() may give others.
  void problems_changed();
  void page_requested(const std::string& name);
  /// Opens another page to do the next step there.
  void lead_requested(const std::string& name);
  void open_finger_requested();
  /// A video or a folder of images is to be shown on the page Inspect.
  void inspect_requested(const std::filesystem::path& recording);
  void new_finger_requested(const alltact::NewFinger& known);

 protected:
  /// Hands the focus on if it waits at the page. Call it when an action has become possible.
  void follow_focus();

 private:
  std::string name_;
};

// The column of groups next to a page's image.

/// `column` takes the groups, and scrolls in a low window; `foot` takes what stays below them. As
/// wide as `min_width_px`, or as its content needs in the window's language.
struct SidePanel {
  explicit SidePanel(int min_width_px);
  /// Both in a splitter. The user's width of the panel is stored under `key`; a double click on the
  /// handle removes it.
  [[nodiscard]] QSplitter* next_to(QWidget* image, const QString& key) const;
  QWidget* root;
  QVBoxLayout *column, *foot;
};

}  // namespace alltact
