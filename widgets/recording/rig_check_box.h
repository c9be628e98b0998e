// Checklist before the first recording: each item with its figure and, where that is not good, with
// advice.
#pragma once

#include "calibration/checks/rig_check.h"
#include "core/sources/v4l2/camera_controls.h"
#include "widgets/theme.h"
#include "widgets/translated.h"

#include <QLabel>
#include <QToolButton>
#include <QVBoxLayout>
#include <QWidget>
#include <vector>

namespace alltact {

/// Automatic camera modes are one more line, which names the controls to lock.
class RigCheckBox : public Translated<QWidget> {
  Q_OBJECT
 public:
  explicit RigCheckBox(QWidget* parent = nullptr);

  /// `controls`: of the camera; empty where the source is none.
  void show_findings(const std::vector<RigFinding>& findings,
                     const std::vector<CameraControl>& controls);
  /// Unfolds the list when needed, else folds it; the user may change that.
  void set_needed(bool is_needed);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  struct Line {
    Meaning meaning = Meaning::kGood;
    bool is_known = true;
    QString text;
    bool operator==(const Line&) const = default;
  };
  struct Row {
    QLabel *symbol, *text;
  };
  [[nodiscard]] static Line line_of(const RigFinding& finding);
  void show_lines(bool anew);
  void show_fold();

  QToolButton* fold_;
  QWidget* rows_;
  QVBoxLayout* column_;
  std::vector<Row> shown_;
  std::vector<Line> lines_;
  std::vector<RigFinding> findings_;
  std::vector<CameraControl> controls_;
  bool is_needed_ = false;
};

}  // namespace alltact
