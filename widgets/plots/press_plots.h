// The error of every press, worst first; one can be chosen, by mouse or keys.
#pragma once

#include "widgets/plots/plot.h"

#include <optional>
#include <string>
#include <vector>

namespace alltact {

/// One measure on two sets of data: the mean magnitude of mapping minus ball in one contact, mm.
struct PressError {
  std::string press;
  double residual_mm = 0;             ///< of the mapping that was fitted with it
  std::optional<double> held_out_mm;  ///< of a mapping fitted without it: the press's error
};

class PressErrorPlot : public Plot {
  Q_OBJECT
 public:
  using Plot::Plot;
  /// In any order. Presses beyond kShown are cut off at the good end, with a note. The choice stays
  /// while there is a press of this name.
  void set_data(std::vector<PressError> errors);
  /// A press can be chosen from now on: by a click on its row, and by the keys of a list.
  void enable_choice();
  /// Empty: none. Does not emit press_chosen.
  void choose(const std::string& press);
  [[nodiscard]] const std::string& chosen() const { return chosen_; }
  static constexpr int kShown = 24;
  /// Height in px at which all bars and names have room.
  [[nodiscard]] int comfortable_height() const;

 Q_SIGNALS:
  /// By the user; empty: none any more.
  void press_chosen(const std::string& press);
  /// By a double click or Enter: show this press.
  void press_opened(const std::string& press);

 protected:
  void keyPressEvent(QKeyEvent* event) override;
  bool draw() override;
  [[nodiscard]] QString title() const override;
  [[nodiscard]] QString empty_text() const override;

 private:
  [[nodiscard]] int shown() const;
  /// Index into errors_; nullopt: none.
  [[nodiscard]] std::optional<int> chosen_row() const;
  [[nodiscard]] std::optional<int> row_at(const QPointF& pixel) const;
  void press(const QPointF& pixel);
  void choose_by_hand(const std::string& press);
  void announce();
  void draw_chosen();
  std::vector<PressError> errors_;  // worst first
  std::string chosen_;
  bool can_choose_ = false;
};

// Brightness of every press relative to the reference, measured on the skin out of contact.

struct PressLight {
  std::string press;
  double percent = 0;  ///< 2: the face out of contact is 2 % brighter than in the reference
};

class PressLightPlot : public Plot {
  Q_OBJECT
 public:
  using Plot::Plot;
  /// In the order of the presses. `limit_percent`: lines on both sides of zero; 0: none.
  void set_data(std::vector<PressLight> presses, double limit_percent);

 protected:
  bool draw() override;
  [[nodiscard]] QString title() const override;
  [[nodiscard]] QString empty_text() const override;

 private:
  std::vector<PressLight> presses_;
  double limit_percent_ = 0;
};

}  // namespace alltact
