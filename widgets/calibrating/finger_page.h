// Step 2, the finger: its geometry, and its contact-free reference.
#pragma once

#include "calibration/reference/reference_recording.h"
#include "core/base/slow_disk.h"
#include "widgets/background_work.h"
#include "widgets/calibrating/step_page.h"
#include "widgets/controls/number_field.h"
#include "widgets/live/live_session.h"
#include "widgets/panels/image_panel.h"
#include "widgets/shell/new_finger_dialog.h"

#include <QGroupBox>
#include <QPushButton>
#include <QUndoStack>

namespace alltact {

class FingerPage : public StepPage {
  Q_OBJECT
 public:
  FingerPage(LiveSession& session, QUndoStack& undo, QWidget* parent = nullptr);

  [[nodiscard]] QString title() const override { return tr("Finger"); }
  [[nodiscard]] StepState state() const override;
  [[nodiscard]] QString missing() const override;
  [[nodiscard]] QVBoxLayout* foot() const override { return foot_; }
  [[nodiscard]] QWidget* main_control() const override { return make_; }
  [[nodiscard]] const QPushButton* action_button() const override;
  /// Its button leads to the page Record.
  [[nodiscard]] bool leads_to_record() const { return record_->isVisible(); }
  void show_status();
  /// Camera file of a new finger; may be empty.
  void set_camera_file(const std::filesystem::path& file) { camera_file_ = file; }

 Q_SIGNALS:
  /// A new finger is to be created; `known` holds what is known of it.
  void new_finger_requested(const alltact::NewFinger& known);
  void open_finger_requested();
  void record_requested();

 private:
  [[nodiscard]] bool has_folder() const;
  /// A complete finger is loaded again after a change; the page stays as it is.
  [[nodiscard]] bool is_reloading() const;
  [[nodiscard]] QWidget* make_side();
  void connect_parts();
  void name_parts();
  void make_finger();
  void take_reference_image();
  void choose_reference_image();
  void install_reference_image(std::function<Result<UntouchedImage>()> image);
  [[nodiscard]] static QString reference_text(bool is_flat, bool has_reference);
  void show_sizes();
  void change_sizes();
  /// Width of the face and thickness of the layer, mm.
  using Sizes = std::pair<double, double>;
  void write_sizes(const std::filesystem::path& folder, const Sizes& sizes);

  QVBoxLayout* foot_ = nullptr;
  LiveSession& session_;
  QUndoStack& undo_;
  ImagePanel* live_;
  std::filesystem::path camera_file_;
  QGroupBox *geometry_group_, *reference_group_;
  QLabel* geometry_;
  ReservedText* reference_;
  QPushButton *make_, *open_, *record_, *reference_image_, *reference_file_;
  QLabel *width_label_, *layer_label_;
  NumberField *width_, *layer_;
  QWidget* sizes_;
  QPushButton* change_;
  std::filesystem::path shown_folder_;
  Sizes shown_sizes_;
  bool was_complete_ = false;  // state before the finger was loaded again
  BackgroundWork work_;
  DiskQueue disk_;
};

}  // namespace alltact
