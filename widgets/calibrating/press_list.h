// List model of the presses, sorted by error once there is a calibration, largest first.
#pragma once

#include "widgets/calibrating/calibration_run.h"
#include "widgets/image/outline_editor.h"
#include "widgets/theme.h"
#include "widgets/verdict_text.h"

#include <QAbstractListModel>
#include <QFocusEvent>
#include <QListView>
#include <QPixmap>
#include <map>

namespace alltact {

// How a press is shown: the best known ball, its thumbnail, and a short reason for its refusal.

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
[[nodiscard]] QImage press_thumbnail(const cv::Mat& grey, const std::optional<ShownBall>& ball,
                                     const QSize& size, double ratio,
                                     std::optional<Meaning> meaning = std::nullopt);

/// Cache of the thumbnails of all presses in a list; an entry is drawn again when its press
/// changed.
class PressThumbnails {
 public:
  [[nodiscard]] QPixmap of(const CollectedPress& press, const std::optional<ShownBall>& ball,
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

/// State and error of one press, in one line.
[[nodiscard]] QString press_state_text(const CollectedPress& press,
                                       const PressCollection& collection,
                                       const CalibrationRun& run);
/// nullptr where the press is not part of a calibration with figures.
[[nodiscard]] const BallFit* fitted_ball(const CalibrationRun& run, const std::string& press);
[[nodiscard]] const StepFit* fitted_step(const CalibrationRun& run, const std::string& press);
/// nullptr also where the calibration used another body than that of `file`.
[[nodiscard]] const BodyFit* fitted_body(const CalibrationRun& run, const std::string& press,
                                         const std::string& file);

/// Rating of a press by its error, or as refused; nullopt where it is unknown.
[[nodiscard]] std::optional<Meaning> press_meaning(const CollectedPress& press,
                                                   const PressCollection& collection,
                                                   const CalibrationRun& run);

class PressModel : public QAbstractListModel {
  Q_OBJECT
 public:
  enum Role { kName = Qt::UserRole };

  PressModel(const PressCollection& collection, const CalibrationRun& run,
             QObject* parent = nullptr);
  /// -1: no such press.
  [[nodiscard]] int row_of(const std::string& name) const;
  [[nodiscard]] std::string name_at(int row) const;

  [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;

 private:
  void follow();

  const PressCollection& collection_;
  const CalibrationRun& run_;
  std::vector<std::string> names_;
  mutable PressThumbnails thumbnails_;
};

// A list of presses that highlights the current press with or without focus. Focus alone selects no
// press.

class PressListView : public QListView {
  Q_OBJECT
 public:
  explicit PressListView(QWidget* parent = nullptr);
  /// Shown in the middle while there is no press.
  void set_empty_text(const QString& text);
  /// As low as two presses: its column makes it higher where there is room.
  [[nodiscard]] QSize sizeHint() const override {
    return {QListView::sizeHint().width(), kMinHeight_px};
  }
  static constexpr int kMinHeight_px = 150;

 protected:
  void paintEvent(QPaintEvent* event) override;
  void focusInEvent(QFocusEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  void mark_always();

  QString empty_text_;
};

}  // namespace alltact
