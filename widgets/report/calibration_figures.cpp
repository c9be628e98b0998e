#include "widgets/report/calibration_figures.h"

#include "core/finger/mapping.h"
#include "widgets/verdict_text.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>

namespace alltact {
namespace {

constexpr double kCellMm = 1.0;
constexpr int kCurvePoints = 120;

QString title_of(FaceQuantity quantity) {
  switch (quantity) {
    case FaceQuantity::kResidual:
      return QCoreApplication::translate("Figures", "Mapping minus ball (mm)");
    case FaceQuantity::kHeldOut:
      return QCoreApplication::translate("Figures", "Press error (mm)");
    case FaceQuantity::kDepthSd:
      return QCoreApplication::translate("Figures", "Depth SD (mm)");
    case FaceQuantity::kCoverage:
      break;
  }
  return QCoreApplication::translate("Figures", "Pressed depth (mm)");
}

const BallFit* ball_of(const Calibration& calibration, const std::string& press) {
  const auto ball = std::find_if(calibration.balls.begin(), calibration.balls.end(),
                                 [&](const BallFit& one) { return one.press == press; });
  return ball == calibration.balls.end() ? nullptr : &*ball;
}

}  // namespace

MappingPlotData mapping_figure(const Calibration& calibration,
                               const std::vector<PressResiduals>& residuals,
                               const std::string& chosen_press) {
  MappingPlotData data;
  data.chosen = QString::fromStdString(chosen_press);
  const auto mapping = Mapping::create(calibration.mapping);
  if (!mapping) return data;
  data.x_max = mapping->x_max();
  if (calibration.mapping.along != MappingAlong::kZ)
    data.depth_axis = QCoreApplication::translate("Figures", "Press depth, %1 (mm)")
                          .arg(calibration.mapping.along == MappingAlong::kNormal
                                   ? QCoreApplication::translate("Figures", "along the normal")
                                   : QCoreApplication::translate("Figures", "projected"));
  for (int i = 0; i <= kCurvePoints; ++i) {
    const double x = data.x_max * i / kCurvePoints;
    data.curve.push_back({x, mapping->depth_mm(x), mapping->depth_sd_mm(x)});
  }
  for (const PressResiduals& press : residuals)
    for (const ResidualSample& sample : press.samples)
      data.points.push_back({sample.x, sample.ball_depth_mm / sample.factor,
                             sample.rim <= kInnerRim,
                             !chosen_press.empty() && press.press == chosen_press});
  return data;
}

std::vector<PressError> press_errors(const Calibration& calibration) {
  std::vector<PressError> errors;
  for (const BallFit& ball : calibration.balls) {
    PressError& error = errors.emplace_back();
    error.press = ball.press;
    error.residual_mm = ball.residual_mm;
    error.held_out_mm = press_error_mm(ball);
  }
  return errors;
}

FaceMapData face_figure(FaceQuantity quantity, const Calibration& calibration,
                        const std::vector<PressResiduals>& residuals, FaceKind kind,
                        const std::string& chosen_press) {
  double length = 0, width = 0;
  for (const PressResiduals& press : residuals) {
    length = std::max(length, press.face_length_mm);
    width = std::max(width, press.face_width_mm);
  }
  FaceMapData data;
  const auto mapping = Mapping::create(calibration.mapping);
  if (length > 0 && width > 0 && mapping) {
    FaceCells cells(length, width, kCellMm);
    for (const PressResiduals& press : residuals) {
      const BallFit* ball = ball_of(calibration, press.press);
      for (const ResidualSample& sample : press.samples) {
        double value = sample.ball_depth_mm;
        if (quantity == FaceQuantity::kResidual) {
          if (sample.rim > kInnerRim) continue;
          value = std::abs(sample.residual_mm);
        }
        if (quantity == FaceQuantity::kDepthSd)
          value = mapping->depth_sd_mm(sample.x, {sample.along_mm, sample.across_mm});
        if (quantity == FaceQuantity::kHeldOut) {
          const auto error = ball == nullptr ? std::nullopt : press_error_mm(*ball);
          if (!error) continue;
          value = *error;
        }
        cells.add(sample.along_mm, sample.across_mm, value);
      }
    }
    data = cells.map();
  }
  data.quantity = title_of(quantity);
  data.has_base = kind == FaceKind::kFinRay;
  for (const PressResiduals& press : residuals)
    data.contacts.push_back({press.along_mm, press.across_mm, press.contact_radius_mm, "", false,
                             !chosen_press.empty() && press.press == chosen_press});
  return data;
}

std::vector<double> all_errors(const std::vector<PressResiduals>& residuals) {
  std::vector<double> errors;
  for (const PressResiduals& press : residuals)
    for (const ResidualSample& sample : press.samples)
      if (sample.rim <= kInnerRim) errors.push_back(sample.residual_mm);
  return errors;
}

}  // namespace alltact
