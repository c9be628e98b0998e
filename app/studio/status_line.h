// The line below every page: delivered, lost and delayed frames of the open source.
#pragma once

#include "widgets/live/live_session.h"
#include "widgets/shell/age_label.h"
#include "widgets/translated.h"

#include <QLabel>
#include <QStatusBar>
#include <array>

namespace alltact {

class StatusLine : public Translated<QStatusBar> {
  Q_OBJECT
 public:
  explicit StatusLine(const LiveSession& session);

 private:
  [[nodiscard]] std::array<QLabel*, 4> labels() const;
  void follow();
  void show_source(const SourceStatus& source, double shown_per_s);

  const LiveSession& session_;
  QLabel *delivered_, *lost_, *time_;
  AgeLabel* age_;
};

}  // namespace alltact
