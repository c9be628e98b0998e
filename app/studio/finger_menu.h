// The menu of recently opened fingers, and the dialogs that open, make and export one. No dialog
// stops running work.
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

  /// The same entries in the menu File, with keys.
  void add_to(TranslatedMenu& file);
  void choose();
  /// Makes a new one, with these known values.
  void make(const NewFinger& known = {});
  /// All fingers of the lab in one list.
  void list_all();
  /// The recent ones that can be opened: only they are offered.
  void offer(const std::vector<std::filesystem::path>& found);

 private:
  void fill();
  void export_finger();

  [[nodiscard]] std::vector<std::filesystem::path> offered() const;

  Workspace& work_;
  QMenu* recent_;
  std::optional<std::vector<std::filesystem::path>> found_;  // nullopt: they are not read yet
};

}  // namespace alltact
