// Brightness of every press relative to the reference, measured on the skin out of contact.
#pragma once

#include "widgets/plots/plot.h"

#include <string>
#include <vector>

namespace alltact {

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
  [[nodiscard]] QString empty_text() const override;

 private:
  std::vector<PressLight> presses_;
  double limit_percent_ = 0;
};

}  // namespace alltact
