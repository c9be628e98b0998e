// The column of buttons at the window's left edge, one for each place.
#pragma once

#include "widgets/places/place.h"

#include <QButtonGroup>
#include <QFrame>

namespace alltact {

class Rail : public Translated<QFrame> {
  Q_OBJECT
 public:
  /// Begins with the first place, of which there is at least one.
  explicit Rail(const std::vector<Place*>& places, QWidget* parent = nullptr);

  /// Its button is down from now on.
  void mark(std::size_t place) { buttons_->button(static_cast<int>(place))->setChecked(true); }

 Q_SIGNALS:
  void chosen(const std::string& place);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  [[nodiscard]] QAbstractButton* make_button();
  void name_buttons();
  void set_icons();

  std::vector<Place*> places_;
  QButtonGroup* buttons_;  // by the places' order
};

}  // namespace alltact
