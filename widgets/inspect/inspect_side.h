// The right-hand side of the page Inspect: view, points, cross-section, and readings between the
// points.
#pragma once

#include "widgets/controls/number_field.h"
#include "widgets/inspect/inspected_frame.h"
#include "widgets/inspect/point_readings.h"
#include "widgets/inspect/recipe_box.h"
#include "widgets/undo_step.h"
#include "widgets/widget_base.h"

#include <QCheckBox>
#include <QComboBox>
#include <QGroupBox>
#include <QLabel>
#include <QPushButton>
#include <filesystem>
#include <functional>
#include <memory>
#include <vector>

namespace alltact {

// Settings of the view: standpoint, colours and comparison.

class ViewBox : public Translated<QGroupBox> {
  Q_OBJECT
 public:
  explicit ViewBox(QWidget* parent = nullptr);

  void set_options(const InspectOptions& options);
  /// Frames of the open recording; 0: none is open, and no other frame can be compared.
  void set_frame_count(std::size_t count);

 Q_SIGNALS:
  /// merge_id: consecutive changes with the same id become one undo step; -1: none.
  void changed(const alltact::InspectOptions& options, const alltact::StepWords& what,
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
  /// Asks for the file of a comparison, or for another finger and its recording.
  void ask_for_comparand(const ComparisonSpec& with,
                         const std::function<void(const ComparisonSpec&)>& use);
  void show_rows();
  [[nodiscard]] QLabel* label_of(const QWidget* widget) const;

  InspectOptions options_;
  std::size_t frame_count_ = 0;
  QComboBox *shown_as_, *standpoint_, *comparison_, *with_, *setting_;
  QPushButton* file_;
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

class InspectSide : public Translated<QWidget> {
  Q_OBJECT
 public:
  explicit InspectSide(QWidget* parent = nullptr);

  void set_options(const InspectOptions& options);
  /// Null: nothing can be measured.
  void show_frame(const std::shared_ptr<const InspectedFrame>& frame);
  void set_frame_count(std::size_t count) { view_->set_frame_count(count); }
  void open_recipe(const std::filesystem::path& file) { recipe_->open(file); }
  [[nodiscard]] SectionPlot& section() const { return *section_; }
  /// Wide enough for hidden boxes too: nothing moves aside when they come.
  [[nodiscard]] QSize minimumSizeHint() const override;

 Q_SIGNALS:
  /// As in ViewBox.
  void changed(const alltact::InspectOptions& options, const alltact::StepWords& what,
               int merge_id);
  /// As in RecipeBox.
  void run_requested();
  void run_in_folder_requested();

 private:
  void measure();

  InspectOptions options_;
  std::shared_ptr<const InspectedFrame> frame_;
  ViewBox* view_;
  PointsBox* points_;
  QGroupBox* section_group_;
  SectionPlot* section_;
  SurfaceBox* surface_;
  RecipeBox* recipe_;
};

}  // namespace alltact
