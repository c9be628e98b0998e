// The live frame measured with two settings: both depth maps and their difference.
#pragma once

#include "calibration/study/accuracy_study.h"
#include "widgets/background_work.h"
#include "widgets/image/image_view.h"
#include "widgets/live/live_session.h"
#include "widgets/widget_base.h"

#include <QLabel>
#include <array>
#include <memory>
#include <optional>
#include <string>

namespace alltact {

class SettingsComparison : public Translated<QWidget> {
  Q_OBJECT
 public:
  explicit SettingsComparison(LiveSession& session, QWidget* parent = nullptr);

  /// The compared settings, each with its name; null: no finger.
  struct Settings {
    PipelineSettings settings;
    QString words;
  };
  void compare(const FingerPtr& finger, const Settings& now, const Settings& other);

  /// The newest frame measured with both; null before the first.
  [[nodiscard]] const std::shared_ptr<const ComparedFrame>& compared() const { return compared_; }
  /// Shows a frame that was measured with both; null: none.
  void take(const std::shared_ptr<const ComparedFrame>& compared);
  /// End of the scale of the difference.
  [[nodiscard]] double difference_top_mm() const { return difference_top_mm_; }

 Q_SIGNALS:
  void shown();

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  enum View { kNow = 0, kOther, kDifference, kViews };
  struct Held;  // what the measuring thread holds from frame to frame
  void take_frame();
  void show_views();
  void show_view(View view, const FrameResult& result);
  void show_message(const QString& message);
  void name_parts();
  [[nodiscard]] QString figures() const;
  [[nodiscard]] bool is_same() const;

  LiveSession& session_;
  FingerPtr finger_;
  Settings now_, other_;
  std::array<QLabel*, kViews> captions_{};
  std::array<ImageView*, kViews> views_{};
  QLabel* figures_;
  std::shared_ptr<Held> held_;
  std::shared_ptr<const ComparedFrame> compared_;
  static constexpr double kMinDifferenceTop_mm = 0.01;
  double difference_top_mm_ = kMinDifferenceTop_mm;  // of the scale; it only grows
  std::optional<Error> problem_;
  FramePtr last_;  // that was measured
  BackgroundWork work_;
};

}  // namespace alltact
