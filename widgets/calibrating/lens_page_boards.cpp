// The step Lens with a board in front of the live camera: detects it, captures useful views, and
// calibrates the lens with them.
#include "core/io/atomic_file.h"
#include "core/io/image_file.h"
#include "widgets/calibrating/board_overlays.h"
#include "widgets/calibrating/lens_page.h"
#include "widgets/language.h"

#include <QApplication>
#include <QDateTime>

namespace alltact {

bool LensPage::has_folder() const {
  const FingerStatus& finger = session_.status().finger;
  return finger.state == FingerState::kReady && !finger.folder.empty();
}

bool LensPage::can_take() const {
  return !has_folder() && session_.view() && session_.status().source.is_live;
}

void LensPage::press_pedal() {
  if (take_->isEnabled() && take_->isVisible()) request_board();
}

void LensPage::request_board() {
  is_board_requested_ = true;
  analyse_frame();
}

void LensPage::begin_boards() {
  collector_.reset();
  detection_.reset();
  cells_ = {};
  fitted_.reset();
  boards_folder_.clear();
  is_board_requested_ = false;
  fitting_.stop();
  views_->clear();
  forecast_->clear();
  show_boards();
}

/// Analyses one frame at a time, always the newest.
void LensPage::analyse_frame() {
  if (!isVisible() || !can_take() || analysing_.is_running() || work_.is_running()) return;
  const FramePtr frame = session_.view()->result.frame;
  if (!frame || (detection_ && detection_->frame == frame)) return;
  if (!collector_) collector_ = std::make_shared<BoardCollector>(form_->board());
  analysing_.start([this, frame, collector = collector_](const Job&) {
    auto detection = std::make_shared<BoardAnalysis>(collector->analyse(frame));
    return std::function<void()>(
        [this, detection, collector] { take_detection(collector, *detection); });
  });
}

void LensPage::take_detection(const std::shared_ptr<BoardCollector>& by,
                              const BoardAnalysis& detection) {
  if (by != collector_) return;  // another board was chosen meanwhile
  detection_ = detection;
  remove_pending_view();
  if (is_fit_stale_) fit_boards();
  const bool is_by_hand = std::exchange(is_board_requested_, false);
  if (detection.view && (is_by_hand || (automatic_->isChecked() && detection.is_useful())))
    add_board(detection);
  show_boards();
}

void LensPage::add_board(const BoardAnalysis& detection) {
  collector_->add(detection);
  cells_ = collector_->cells();
  if (boards_folder_.empty()) {
    boards_folder_ =
        work_folder_ /
        ("boards_" +
         QDateTime::currentDateTime().toString(QStringLiteral("yyyy-MM-dd_HHmmss")).toStdString());
    images_->setText(QString::fromStdString(boards_folder_.string()));
  }
  disk_->add([folder = boards_folder_, frame = collector_->frames().back()]() -> Status {
    if (const Status made = make_folder(folder); !made) return made;
    return write_image(folder / (frame->name + ".png"),
                       frame->grey,
                       frame->controls ? *frame->controls : std::string());
  });
  live_->freeze(false);
  live_->flash(tr("Board %1").arg(collector_->views().size()));
  QApplication::beep();
  is_fit_stale_ = true;
  fit_boards();
}

void LensPage::remove_chosen_view() {
  if (const QListWidgetItem* item = views_->currentItem())
    view_to_remove_ = item->data(Qt::UserRole).toString().toStdString();
  if (!analysing_.is_running()) remove_pending_view();
}

void LensPage::remove_pending_view() {
  const std::string name = std::exchange(view_to_remove_, {});
  if (name.empty() || !collector_) return;
  collector_->forget(name);
  cells_ = collector_->cells();
  disk_->add([file = boards_folder_ / (name + ".png")]() -> Status {
    std::error_code failed;
    std::filesystem::remove(file, failed);
    return {};
  });
  is_fit_stale_ = true;
  fit_boards();
}

/// Calibrates the lens with the views captured so far.
void LensPage::fit_boards() {
  // While a frame is analysed its thread owns the collector; finishing calls this again.
  if (!is_fit_stale_ || fitting_.is_running() || analysing_.is_running() || !collector_)
    return show_boards();
  is_fit_stale_ = false;
  const auto& views = collector_->views();
  std::vector<LensViewReport> bare;
  for (const BoardView& view : views) {
    bare.emplace_back();
    bare.back().name = view.name;
    bare.back().rejection = en::say("its error is told from the third view on");
  }
  if (static_cast<int>(views.size()) < kFewestViews) {
    fitted_.reset();
    show_views(bare);
    return show_boards();
  }
  fitting_.start([this,
                  views,
                  size = collector_->frames().front()->grey.size(),
                  settings = form_->settings(),
                  collector = collector_](const Job& job) {
    auto made =
        std::make_shared<Result<LensCalibration>>(calibrate_lens(views, size, settings, job));
    return std::function<void()>([this, made, collector] {
      if (collector != collector_) return;
      fitted_ = *made ? std::make_shared<const LensCalibration>(std::move(**made)) : nullptr;
      if (fitted_) show_views(fitted_->views);
      forecast_->setText(fitted_ ? window_sentence(fitted_->verdict.sentence)
                                 : window_sentence(made->error().what));
      show_boards();
    });
  });
  show_boards();
}

QString LensPage::board_words() const {
  if (!can_take()) return tr("Open the camera as source, and boards can be taken live.");
  if (!detection_) return tr("Looking for the board.");
  if (!detection_->view) return window_sentence(detection_->no_board_reason);
  if (!detection_->is_sharp) return tr("The board is blurred: hold it still, or further away.");
  if (!detection_->is_new) return tr("This place is taken: move the board, or tilt it.");
  if (!detection_->is_still) return tr("Hold it still.");
  return tr("Good: take it.");
}

void LensPage::show_boards() {
  const bool is_possible = can_take();
  live_group_->setVisible(!has_folder());
  take_->setEnabled(is_possible && detection_ && detection_->view);
  automatic_->setEnabled(is_possible);
  QString words = board_words();
  if (fitted_ && !fitted_->coverage.advice.empty())
    words += QLatin1Char('\n') +
             tr("Still missing: %1.").arg(in_window_language(fitted_->coverage.advice));
  guide_->setText(words);
  views_->setVisible(!has_folder() && views_->count() > 0);
  forecast_->setVisible(!has_folder() && !forecast_->text().isEmpty());
  forget_->setVisible(!has_folder() && !boards_folder_.empty());
  forget_->setEnabled(views_->currentItem() != nullptr);
}

std::vector<Overlay> LensPage::overlays(const LiveView& view) const {
  const FingerStatus& finger = session_.status().finger;
  if (has_folder() && finger.finger) {
    const auto camera = Camera::create(finger.finger->camera);
    const bool fits = camera && camera->size().width == view.result.grey.cols;
    return fits ? std::vector<Overlay>{lens_grid_overlay(*camera)} : std::vector<Overlay>();
  }
  std::vector<Overlay> overlays;
  if (!can_take()) return overlays;
  const QSize size(view.result.grey.cols, view.result.grey.rows);
  if (views_->count() > 0) overlays.push_back(unseen_cells_overlay(cells_, size));
  if (detection_ && detection_->view) overlays.push_back(corners_overlay(*detection_));
  return overlays;
}

}  // namespace alltact
