// Settings of the view: standpoint, colours and comparison.
#pragma once

#include "widgets/controls/number_field.h"
#include "widgets/inspect/inspect_options.h"
#include "widgets/translated.h"
#include "widgets/undo_step.h"

#include <QCheckBox>
#include <QComboBox>
#include <QGroupBox>
#include <QLabel>
#include <vector>

namespace alltact {

class ViewBox : public Translated<QGroupBox> {
  Q_OBJECT
 public:
  explicit ViewBox(QWidget* parent = nullptr);

  void set_options(const InspectOptions& options);
  /// Frames of the open recording; 0: none is open, and no other frame can be compared.
  void set_frame_count(std::size_t count);

 Q_SIGNALS:
  /// merge_id: consecutive changes with the same id become one undo step; -1: none.
  void changed(const alltact::InspectOptions& options,
               const alltact::StepWords& what,
               int merge_id);

 private:
  struct Row {
    QLabel* label;
    QWidget* widget;
    QString (*text)();
  };
  void add_row(QWidget* widget, QString (*text)());
  void connect_view();
  void connect_comparison();
  void fill_settings();
  void show_rows();
  [[nodiscard]] QLabel* label_of(const QWidget* widget) const;

  InspectOptions options_;
  std::size_t frame_count_ = 0;
  QComboBox *shown_as_, *standpoint_, *comparison_, *with_, *setting_;
  IntegerField* frame_;
  NumberField *top_, *difference_top_, *times_;
  std::vector<Row> rows_;
  struct Part {
    QCheckBox* box;
    bool SceneOptions::*member;
    QString (*text)();
  };
  std::vector<Part> parts_;
};

/// What a frame is compared with, as a title over its image.
[[nodiscard]] QString comparand_text(const ComparisonSpec& other);

}  // namespace alltact
