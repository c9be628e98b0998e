// Qt without a screen, for programs that draw now and then.
#pragma once

#include "core/base/result.h"

#include <memory>
#include <string>

class QApplication;

namespace alltact {

/// Makes a QApplication on the offscreen platform where there is none yet, whatever the user's
/// display, and holds it while it lives. Make it in the main thread.
class OffscreenDrawing {
 public:
  OffscreenDrawing();
  ~OffscreenDrawing();
  /// Error: there is not enough memory to draw. Nothing may be drawn then: Qt would end the
  /// program, or wait for threads that never begin.
  [[nodiscard]] Status ready() const;
  OffscreenDrawing(const OffscreenDrawing&) = delete;
  OffscreenDrawing& operator=(const OffscreenDrawing&) = delete;

 private:
  bool has_room_;
  std::unique_ptr<QApplication> application_;
};

// SVG figures as PNG and PDF, for programs that show no SVG.

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
