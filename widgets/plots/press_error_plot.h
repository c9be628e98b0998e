// The error of every press, worst first.
#pragma once

#include "widgets/plots/plot.h"

#include <optional>
#include <string>
#include <vector>

namespace alltact {

/// Mean absolute errors in mm of press depth inside one contact.
struct PressError {
  std::string press;
  double residual_mm = 0;             ///< with the mapping that it helped to make
  std::optional<double> held_out_mm;  ///< with a mapping made without it
};

class PressErrorPlot : public Plot {
  Q_OBJECT
 public:
  using Plot::Plot;
  /// In any order. More than kShown are cut off at the good end, and it says so.
  void set_data(std::vector<PressError> errors);
  static constexpr int kShown = 24;
  /// Height in px at which all bars and names have room.
  [[nodiscard]] int comfortable_height() const;

 protected:
  bool draw() override;
  [[nodiscard]] QString empty_text() const override;

 private:
  std::vector<PressError> errors_;  // worst first
};

}  // namespace alltact
