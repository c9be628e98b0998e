// Depth along a line over the face.
#pragma once

#include "core/sensing/measures.h"
#include "widgets/plots/plot.h"

#include <optional>

namespace alltact {

class SectionPlot : public Plot {
  Q_OBJECT
 public:
  using Plot::Plot;
  /// `other`: of another method, drawn dashed. Empty profiles: nothing is drawn.
  void set_profiles(Profile profile, std::optional<Profile> other);

 protected:
  bool draw() override;
  [[nodiscard]] QString empty_text() const override;

 private:
  Profile profile_;
  std::optional<Profile> other_;
};

}  // namespace alltact
