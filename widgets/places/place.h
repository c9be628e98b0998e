// A place of the window: what fills it while its button in the rail is down.
#pragma once

#include "core/finger/new_finger.h"
#include "widgets/shell/problem_list.h"
#include "widgets/translated.h"

#include <QWidget>
#include <string>
#include <utility>
#include <vector>

namespace alltact {

/// The window keeps a table of its places and asks them only what stands here; whatever else a
/// place needs is given to its constructor. Its icon is resources/icons/NAME.svg, its help page
/// resources/help/NAME.md with one more for each language.
class Place : public Translated<QWidget> {
  Q_OBJECT
 public:
  /// `name` stands in session files and in names of files: it is never translated, and never
  /// another one.
  explicit Place(std::string name, QWidget* parent = nullptr)
      : Translated(parent), name_(std::move(name)) {}

  [[nodiscard]] const std::string& name() const { return name_; }
  /// In the rail.
  [[nodiscard]] virtual QString title() const = 0;
  /// In the menu View, with the letter that chooses it.
  [[nodiscard]] virtual QString menu_text() const = 0;

  /// The foot pedal was pressed while this place is shown.
  virtual void press_pedal() {}
  /// What is to be done here next with the open finger, for the top of the window; whichever place
  /// is shown.
  virtual void add_problems(std::vector<Problem>& /*problems*/) {}
  /// Somebody was led here to do what comes next: shows it.
  virtual void begin_with_next() {}
  /// What stands in the open finger's folder has changed.
  virtual void reload() {}

 Q_SIGNALS:
  /// What a session keeps of this place.
  void changed();
  void place_wanted(const std::string& name);
  /// Another place, to do there what comes next.
  void lead_wanted(const std::string& name);
  void open_finger_wanted();
  void new_finger_wanted(const alltact::NewFinger& known);

 private:
  std::string name_;
};

}  // namespace alltact
