// Report pages: the mapping, and its errors by press, by position and by size.
#include "widgets/plots/histogram_plot.h"
#include "widgets/report/report_pages.h"

#include <algorithm>

namespace alltact {

void ReportPages::add_mapping() {
  document_.new_page();
  document_.heading(text("From brightness to depth"));
  if (!calibration_.calibration.mapping.variation.is_none())
    document_.paragraph(
        text("The mapping varies over the face; shown is the middle of the face, the "
             "points as they would be there."));
  MappingPlot plot;
  apply_style(plot);
  plot.set_data(mapping_figure(calibration_.calibration, calibration_.residuals));
  add_plot(
      plot,
      340,
      text("Each point is a block of pixels under a ball: how much darker it became, and how deep "
           "the ball is there. The line is the mapping, the band two standard deviations of it. "
           "Good: one narrow cloud around the line, reaching to the deepest presses you will "
           "measure. Two clouds side by side: presses that do not agree. Crosses far off the line "
           "belong to the rim, where skin leaves the ball, and are not used."));
}

void ReportPages::add_errors() {
  constexpr std::size_t kFewPresses = 8;  // their bars fit below the mapping
  if (calibration_.calibration.balls.size() > kFewPresses) document_.new_page();
  document_.heading(text("Errors"));
  PressErrorPlot bars;
  apply_style(bars);
  bars.set_data(press_errors(calibration_.calibration));
  add_plot(
      bars,
      bars.comfortable_height(),
      text("Good: all bars alike. One bar much longer than the others: look at that press' picture "
           "above, and leave it out if it shows anything but one clean ball. Much longer without "
           "the "
           "press than with it: this press shows something that no other does; press more like "
           "it."));
}

void ReportPages::add_map(FaceQuantity quantity, const QString& caption) {
  FaceMapPlot plot;
  apply_style(plot);
  plot.set_data(face_figure(
      quantity, calibration_.calibration, calibration_.residuals, calibration_.finger.face.kind));
  const FaceMapData data = face_figure(
      quantity, calibration_.calibration, calibration_.residuals, calibration_.finger.face.kind);
  // The face in its proportions, within limits.
  const double ratio = data.length_mm > 0 ? data.width_mm / data.length_mm : 0.4;
  add_plot(plot, 62 + static_cast<int>(470 * std::clamp(ratio, 0.2, 0.45)), caption);
}

void ReportPages::add_maps() {
  document_.new_page();
  document_.heading(text("Where on the face"));
  add_map(FaceQuantity::kResidual,
          text("Mapping minus ball, mean of each square millimetre. Good: no pattern. Errors that "
               "grow towards one "
               "end or one side point to light or shape there."));
  if (calibration_.calibration.held_out_mm > 0)
    add_map(FaceQuantity::kHeldOut,
            text("Error of each press when the mapping was made without it. Hatched: nothing was "
                 "pressed there, nothing is known."));
  add_map(
      FaceQuantity::kCoverage,
      text("How deep the presses went, and where. Press next where it is hatched, and as deep as "
           "you will measure."));
}

void ReportPages::add_spread() {
  document_.new_page();
  document_.heading(text("How errors are spread"));
  HistogramPlot histogram;
  apply_style(histogram);
  histogram.set_data(all_errors(calibration_.residuals), text("Mapping minus ball (mm)"));
  add_plot(
      histogram,
      260,
      text("Errors of all blocks in the inner part of the contacts. Good: one hill around zero. A "
           "second hill or a hill beside zero: something differs between presses."));
}

}  // namespace alltact
