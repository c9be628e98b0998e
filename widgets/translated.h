// Widgets that set their texts again when the language changes.
#pragma once

#include <QEvent>
#include <QWidget>
#include <functional>
#include <vector>

namespace alltact {

/// A widget class Base whose texts are set by say(): once at the call, and again for each new
/// language.
template <class Base>
class Translated : public Base {
 public:
  using Base::Base;

 protected:
  void say(std::function<void()> texts) {
    texts();
    texts_.push_back(std::move(texts));
  }
  void changeEvent(QEvent* event) override {
    if (event->type() == QEvent::LanguageChange)
      for (const auto& texts : texts_) texts();
    Base::changeEvent(event);
  }

 private:
  std::vector<std::function<void()>> texts_;
};

}  // namespace alltact
