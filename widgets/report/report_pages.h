// The pages of a calibration's report while they are written.
#pragma once

#include "calibration/finger/calibration_report.h"
#include "widgets/plots/plot.h"
#include "widgets/report/calibration_figures.h"
#include "widgets/report/document.h"
#include "widgets/report/fault_pages.h"
#include "widgets/report/report_words.h"
#include "widgets/theme.h"

#include <array>
#include <filesystem>
#include <memory>
#include <vector>

namespace alltact {

/// Writes one report from top to bottom.
class ReportPages {
 public:
  ReportPages(std::shared_ptr<const FingerCalibration> done,
              std::filesystem::path folder,
              std::vector<SimulatedCalibration> faults)
      : shared_(std::move(done)),
        folder_(std::move(folder)),
        faults_(std::move(faults)),
        light_(theme_palette(Theme::kLight)),
        document_(text("Calibration of finger %1").arg(as_text(shared_->finger.name))) {}

  /// Writes the next part, in a fraction of a second. False: there is none left.
  bool write_next() {
    constexpr std::array kParts{&ReportPages::add_verdict,
                                &ReportPages::add_facts,
                                &ReportPages::add_presses,
                                &ReportPages::add_mapping,
                                &ReportPages::add_errors,
                                &ReportPages::add_maps,
                                &ReportPages::add_spread,
                                &ReportPages::add_methods,
                                &ReportPages::add_light,
                                &ReportPages::add_remarks,
                                &ReportPages::add_history,
                                &ReportPages::add_repetition,
                                &ReportPages::add_faults};
    if (next_ == kParts.size()) return false;
    (this->*kParts[next_++])();
    return true;
  }
  [[nodiscard]] const Document& document() const { return document_; }

 private:
  static constexpr int kFigureWidth = 600;   // px at 96 to the inch: the width of a printed page
  static constexpr double kSharpness = 2.0;  // pixels to each of these, for paper and dense screens

  void add_verdict();
  void add_causes();
  void add_zones();
  void add_facts();
  [[nodiscard]] QString press_words(const BallFit& ball) const;
  static QString punch_words(const StepFit& step);
  void add_presses();
  void add_left_out();
  void add_mapping();
  void add_errors();
  void add_maps();
  void add_map(FaceQuantity quantity, const QString& caption);
  void add_spread();
  static QString method_words(CalibrationMethod method);
  void add_methods();
  void add_light();
  void add_remarks();
  void add_history();
  void add_repetition();
  void add_faults() { add_typical_faults(document_, faults_, light_, plot_font()); }

  void add_plot(Plot& plot, int height, const QString& caption) {
    document_.figure(plot.image({kFigureWidth, height}, kSharpness), kFigureWidth, caption);
  }
  static QFont plot_font() {
    QFont font("DejaVu Sans");
    font.setPixelSize(12);
    return font;
  }
  void apply_style(Plot& plot) const {
    plot.setFont(plot_font());
    plot.setPalette(light_);
  }
  [[nodiscard]] std::vector<Eigen::Vector2d> contact_pixels_of(const BallFit& ball) const {
    std::vector<Eigen::Vector2d> pixels;
    for (const PressResiduals& press : calibration_.residuals)
      if (press.press == ball.press)
        for (const ResidualSample& sample : press.samples) pixels.push_back(sample.pixel);
    return pixels;
  }
  [[nodiscard]] QString provenance_text(const char* key) const {
    const auto found = calibration_.finger.provenance.find(key);
    return found == calibration_.finger.provenance.end() ? QString() : as_text(found->second);
  }

  const std::shared_ptr<const FingerCalibration> shared_;
  const FingerCalibration& calibration_ = *shared_;
  const std::filesystem::path folder_;
  const std::vector<SimulatedCalibration> faults_;
  std::size_t next_ = 0;
  const QPalette light_;
  Document document_;
};

}  // namespace alltact
