// The two measuring points: their positions and readings.
#pragma once

#include "core/inspection/face_reading.h"
#include "core/sensing/surface_measurement.h"
#include "widgets/controls/number_field.h"
#include "widgets/inspect/inspected_frame.h"
#include "widgets/plots/plot.h"
#include "widgets/undo_step.h"
#include "widgets/widget_base.h"

#include <QComboBox>
#include <QGroupBox>
#include <QLabel>
#include <QPushButton>
#include <QString>
#include <QTableWidget>
#include <array>
#include <memory>
#include <optional>
#include <vector>

#include <opencv2/core.hpp>

namespace alltact {

class PointsBox : public Translated<QGroupBox> {
  Q_OBJECT
 public:
  explicit PointsBox(QWidget* parent = nullptr);

  void set_options(const InspectOptions& options);
  /// Null: nothing can be measured.
  void show_frame(const std::shared_ptr<const InspectedFrame>& frame);

 Q_SIGNALS:
  /// As in ViewBox.
  void changed(const alltact::InspectOptions& options, const alltact::StepWords& what,
               int merge_id);

 private:
  struct Point {
    std::optional<FacePosition> InspectOptions::*member;
    QLabel* label;
    std::array<NumberField*, 2> boxes;  // along, across
  };
  void connect_points();
  void change_coordinate(const Point& point, std::size_t part, int merge_id);
  void name_parts();
  void set_section_line(bool is_across);
  [[nodiscard]] std::optional<cv::Point2d> deepest() const;
  void show_points();
  void show_reading();

  InspectOptions options_;
  std::shared_ptr<const InspectedFrame> frame_;
  std::array<Point, 2> points_;
  QPushButton *deepest_, *across_, *along_, *clear_;
  QLabel* reading_;
};

// Readings at two points, as text.

/// Rich text: positions of A and B with depth and its standard deviation, and their distance.
[[nodiscard]] QString reading_text(const InspectedFrame& frame,
                                   const std::optional<FacePosition>& a,
                                   const std::optional<FacePosition>& b);

/// Reading at the centre of a pixel, with the numbers that `alltact reconstruct` writes; one line
/// of plain text each.
struct ProbeText {
  QString depth;     ///< "depth 0.53 ± 0.02 mm"
  QString position;  ///< "45.2 mm along, 3.1 mm across; x 3.10, y -0.20, z 48.03 mm"
};
/// nullopt outside the face. `pixel`: integers.
[[nodiscard]] std::optional<ProbeText> probe_text(const InspectedFrame& frame, cv::Point2d pixel);

/// "Deepest 0.82 mm at x 3.1, y -0.2, z 48.0 mm."; empty without contact.
[[nodiscard]] QString deepest_text(const InspectedFrame& frame);

// Readings of the face between the points A and B.

/// One line of the table.
struct SurfaceReading {
  Measurand what = Measurand::kDistance;
  FaceReading reading;
};

/// All measurands. Empty for a frame without depth.
[[nodiscard]] std::vector<SurfaceReading> surface_readings(const InspectedFrame& frame,
                                                           cv::Point2d a, cv::Point2d b,
                                                           const RoughnessFilter& filter);

/// "Ball's radius"
[[nodiscard]] QString name_of(Measurand what);
/// "mm²"
[[nodiscard]] QString unit_text(Measurand what);
[[nodiscard]] int decimals_of(Measurand what);
/// "4.02 ± 0.03 mm"; a dash where nothing was measured.
[[nodiscard]] QString value_text(Measurand what, const FaceReading& reading);

/// A line each: "Ball's radius: 4.020 ± 0.031 mm".
[[nodiscard]] QString text_of(const std::vector<SurfaceReading>& readings);

/// A header and a line each: name, value, standard deviation, unit, limits. Numbers in the C
/// locale.
[[nodiscard]] QString csv_of(const std::vector<SurfaceReading>& readings);

// Table of the readings between A and B, to read and to copy.

/// "without a form of degree 4, wavelengths up to 0.8 mm"; empty for the default.
[[nodiscard]] QString filter_text(const RoughnessFilter& filter);

class SurfaceBox : public Translated<QGroupBox> {
  Q_OBJECT
 public:
  explicit SurfaceBox(QWidget* parent = nullptr);

  void set_options(const InspectOptions& options);
  /// Null, or without both points: nothing.
  void show_readings(const std::shared_ptr<const InspectedFrame>& frame,
                     const std::optional<cv::Point2d>& a, const std::optional<cv::Point2d>& b);

 Q_SIGNALS:
  /// As in ViewBox.
  void changed(const alltact::InspectOptions& options, const alltact::StepWords& what,
               int merge_id);
  /// The selected reading is to be part of the recipe.
  void add_requested(alltact::Measurand what);

 private:
  void connect_parts();
  void name_parts();
  void fill();
  void follow_selection();

  InspectOptions options_;
  std::vector<SurfaceReading> readings_;
  QLabel* hint_;
  QLabel *form_label_, *lambda_label_;
  QComboBox* form_;
  NumberField* lambda_;
  QTableWidget* table_;
  QPushButton *add_, *copy_text_, *copy_;
};

// Plot of depth along a line over the face, for the screen and for a paper.

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
  [[nodiscard]] QString title() const override;
  [[nodiscard]] QString empty_text() const override;

 private:
  Profile profile_;
  QString other_name_;
  std::optional<Profile> other_;
};

}  // namespace alltact
