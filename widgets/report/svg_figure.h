// SVG figures as PNG and PDF, for programs that show no SVG.
#pragma once

#include "core/result.h"

#include <string>

namespace alltact {

/// The same figure as a PNG (at twice its own resolution) and as one PDF page of its size.
struct SvgFigureFiles {
  std::string png, pdf;
};

/// The same figure and date give the same bytes. Needs a QApplication, on any platform. Error: it
/// is no SVG.
///   date: for the PDF, as utc_now() writes it
[[nodiscard]] Result<SvgFigureFiles> svg_figure_files(const std::string& svg,
                                                      const std::string& title,
                                                      const std::string& date);

}  // namespace alltact
