// Depth along a line over the face, to look at, and for a paper.
#pragma once

#include "core/sensing/measures.h"
#include "widgets/plots/plot.h"

#include <optional>

namespace alltact {

class SectionPlot : public Plot {
  Q_OBJECT
 public:
  using Plot::Plot;
  /// `other`: of what it is compared with, drawn dashed. Empty profiles: nothing is drawn.
  void set_profiles(Profile profile, std::optional<Profile> other);
  /// What `other` is, for the legend; from the next profiles on.
  void set_other_name(const QString& name) { other_name_ = name; }
  [[nodiscard]] bool is_empty() const { return profile_.along_mm.size() < 2; }
  /// A headline and a line for each place: mm along, depth, standard deviation, and the depth of
  /// `other`, empty where there is none; numbers as programs read them.
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
