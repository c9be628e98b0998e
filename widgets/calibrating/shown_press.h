// What can be seen of a press: its ball as it is known best, its picture in a list, and why it is
// refused, in a word.
#pragma once

#include "widgets/calibrating/calibration_run.h"
#include "widgets/picture/outline_editor.h"
#include "widgets/theme.h"

#include <QPixmap>
#include <map>

namespace alltact {

/// Put by hand, else as a current calibration has it, else as it was found; nullopt where none of
/// these is known, or there is none.
[[nodiscard]] std::optional<ShownBall> known_ball(const DeskPress& press,
                                                  const PressDesk& desk,
                                                  const CalibrationRun& run);

/// A word or two for a list; the whole sentence stands beside the press' picture.
[[nodiscard]] QString refusal_word(const Error& problem);

/// A press' picture for a list, in `size` (px at `ratio` to the logical one): cut around the ball
/// with its outline, the whole finger where there is no ball. `meaning`: a bar in its colour at the
/// left edge with its symbol; none where there is none.
[[nodiscard]] QImage press_thumbnail(const cv::Mat& grey,
                                     const std::optional<ShownBall>& ball,
                                     const QSize& size,
                                     double ratio,
                                     std::optional<Meaning> meaning = std::nullopt);

/// The same of all presses of a list, drawn when something about them has changed.
class PressThumbnails {
 public:
  [[nodiscard]] QPixmap of(const DeskPress& press,
                           const std::optional<ShownBall>& ball,
                           std::optional<Meaning> meaning);
  [[nodiscard]] static QSize size() { return {112, 63}; }

 private:
  struct Drawn {
    cv::Mat grey;  // held, so that its address stays its own
    Eigen::Vector4d ball = Eigen::Vector4d::Zero();
    bool is_by_hand = false;
    std::optional<Meaning> meaning;
    QPixmap picture;
  };
  std::map<std::string, Drawn> drawn_;
};

}  // namespace alltact
