// Qt without a screen, for programs that draw now and then.
#pragma once

#include "core/result.h"

#include <memory>

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

}  // namespace alltact
