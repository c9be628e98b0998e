// Plot of depth along a line over the face, for the screen and for a paper.
#pragma once

#include "core/sensing/measures.h"
#include "widgets/plots/plot.h"

#include <optional>

namespace alltact {

class SectionPlot : public Plot {
  Q_OBJECT
 public:
  using Plot::Plot;
  /// `other`: the compared profile, drawn dashed. Empty profiles: nothing is drawn.
  void set_profiles(Profile profile, std::optional<Profile> other);
  /// Legend text of `other`; used from the next set_profiles() on.
  void set_other_name(const QString& name) { other_name_ = name; }
  [[nodiscard]] bool is_empty() const { return profile_.along_mm.size() < 2; }
  /// A header and a line for each position: mm along, depth, standard deviation, and the depth of
  /// `other`, empty where there is none. Numbers in the C locale.
  [[nodiscard]] QString csv() const;

 protected:
  bool draw() override;
  [[nodiscard]] QString empty_text() const override;

 private:
  Profile profile_;
  QString other_name_;
  std::optional<Profile> other_;
};

}  // namespace alltact
