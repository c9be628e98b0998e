// The purpose of a page, shown at the first visit; once dismissed it stays away. Its text is the
// beginning of the page's help.
#pragma once

#include "app/studio/tutorial.h"

#include <QFrame>
#include <QLabel>
#include <QPushButton>

namespace alltact {

class PageHint : public Translated<QFrame> {
  Q_OBJECT
 public:
  /// Hidden while `guide` is on.
  explicit PageHint(const Tutorial& guide, QWidget* parent = nullptr);
  /// By its name.
  void show_for(const std::string& page);
  /// The settings key of a page whose hint was dismissed.
  [[nodiscard]] static QString key(const std::string& page);

 Q_SIGNALS:
  void help_requested();

 private:
  void follow();

  const Tutorial& guide_;
  std::string page_;
  QLabel* text_;
  QPushButton *more_, *seen_;
};

}  // namespace alltact
