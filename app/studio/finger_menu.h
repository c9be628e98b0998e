// Ways to a finger: the menu of those that were open last, and the dialogs that open, make and
// export one. No dialog stops what runs.
#pragma once

#include "app/studio/translated_menu.h"
#include "app/studio/workspace.h"
#include "core/finger/new_finger.h"

namespace alltact {

class FingerMenu : public TranslatedMenu {
  Q_OBJECT
 public:
  /// `window` has the dialogs.
  FingerMenu(Workspace& work, QWidget* window);

  /// The same as a part of the menu File, with keys.
  void add_to(TranslatedMenu& file);
  void choose();
  /// A new one, of which this much is known.
  void make(const NewFinger& known = {});
  /// All of the lab in one list.
  void list_all();
  /// Of the recent ones, those that can be opened: only they are offered.
  void offer(const std::vector<std::filesystem::path>& found);

 private:
  void fill();
  void export_finger();

  [[nodiscard]] std::vector<std::filesystem::path> offered() const;

  Workspace& work_;
  QMenu* recent_;
  std::optional<std::vector<std::filesystem::path>> found_;  // none: nobody has looked yet
};

}  // namespace alltact
