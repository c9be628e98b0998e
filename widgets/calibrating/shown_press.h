// How a press is shown: the best known ball, its thumbnail, and a short reason for its refusal.
#pragma once

#include "widgets/calibrating/calibration_run.h"
#include "widgets/image/outline_editor.h"
#include "widgets/theme.h"

#include <QPixmap>
#include <map>

namespace alltact {

/// The ball set by hand, else as a current calibration has it, else as found. nullopt: unknown, or
/// the press has none.
[[nodiscard]] std::optional<ShownBall> known_ball(const CollectedPress& press,
                                                  const PressCollection& collection,
                                                  const CalibrationRun& run);

/// One or two words for a list; the complete sentence is shown with the press' image.
[[nodiscard]] QString refusal_word(const Error& problem);

/// Thumbnail of a press, `size` logical pixels with `ratio` pixels each: a crop around the ball
/// with its outline, without a ball the full finger. `meaning`: drawn as a coloured bar at the left
/// edge with its symbol.
[[nodiscard]] QImage press_thumbnail(const cv::Mat& grey,
                                     const std::optional<ShownBall>& ball,
                                     const QSize& size,
                                     double ratio,
                                     std::optional<Meaning> meaning = std::nullopt);

/// Cache of the thumbnails of all presses in a list; an entry is drawn again when its press
/// changed.
class PressThumbnails {
 public:
  [[nodiscard]] QPixmap of(const CollectedPress& press,
                           const std::optional<ShownBall>& ball,
                           std::optional<Meaning> meaning);
  [[nodiscard]] static QSize size() { return {112, 63}; }

 private:
  struct Drawn {
    cv::Mat grey;  // holds the buffer, so that its address is not reused
    Eigen::Vector4d ball = Eigen::Vector4d::Zero();
    bool is_by_hand = false;
    std::optional<Meaning> meaning;
    QPixmap pixmap;
  };
  std::map<std::string, Drawn> drawn_;
};

}  // namespace alltact
