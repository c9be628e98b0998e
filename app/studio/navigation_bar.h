// The column of buttons at the window's left edge, one for each page.
#pragma once

#include "widgets/pages/page.h"

#include <QButtonGroup>
#include <QFrame>

namespace alltact {

class NavigationBar : public Translated<QFrame> {
  Q_OBJECT
 public:
  /// Marks the first page at first; there is at least one.
  explicit NavigationBar(const std::vector<Page*>& pages, QWidget* parent = nullptr);

  /// Its button is down from now on.
  void mark(std::size_t page) { buttons_->button(static_cast<int>(page))->setChecked(true); }

 Q_SIGNALS:
  void chosen(const std::string& page);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  [[nodiscard]] QAbstractButton* make_button();
  void name_buttons();
  void set_icons();

  std::vector<Page*> pages_;
  QButtonGroup* buttons_;  // by the pages' order
};

}  // namespace alltact
