// The error of every press, worst first; one of them can be chosen, by mouse or keys.
#pragma once

#include "widgets/plots/plot.h"

#include <optional>
#include <string>
#include <vector>

namespace alltact {

/// One measure on two sets of data: the mean magnitude of mapping minus ball in one contact, mm.
struct PressError {
  std::string press;
  double residual_mm = 0;             ///< of the mapping that it helped to make
  std::optional<double> held_out_mm;  ///< of one made without it: the press's error
};

class PressErrorPlot : public Plot {
  Q_OBJECT
 public:
  using Plot::Plot;
  /// In any order. More than kShown are cut off at the good end, and it says so. What is chosen
  /// stays so while there is a press of this name.
  void set_data(std::vector<PressError> errors);
  /// From now on a press can be chosen: by a click on its row, and by the keys of a list.
  void let_choose();
  /// Empty: none. Says nothing to press_chosen's listeners.
  void choose(const std::string& press);
  [[nodiscard]] const std::string& chosen() const { return chosen_; }
  static constexpr int kShown = 24;
  /// Height in px at which all bars and names have room.
  [[nodiscard]] int comfortable_height() const;

 Q_SIGNALS:
  /// By hand; empty: none any more.
  void press_chosen(const std::string& press);
  /// By a double click or Enter: it is to be shown.
  void press_opened(const std::string& press);

 protected:
  void keyPressEvent(QKeyEvent* event) override;
  bool draw() override;
  [[nodiscard]] QString empty_text() const override;

 private:
  [[nodiscard]] int shown() const;
  /// Of errors_; nullopt: none.
  [[nodiscard]] std::optional<int> chosen_row() const;
  [[nodiscard]] std::optional<int> row_at(const QPointF& place) const;
  void press(const QPointF& place);
  void choose_by_hand(const std::string& press);
  void tell();
  void draw_chosen();
  std::vector<PressError> errors_;  // worst first
  std::string chosen_;
  bool can_choose_ = false;
};

}  // namespace alltact
