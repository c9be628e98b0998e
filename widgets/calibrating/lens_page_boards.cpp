// The step Lens with a board that is held before the camera: found in the live picture, taken where
// it is worth it, and what the lens is worth so far.
#include "core/io/atomic_file.h"
#include "core/io/picture.h"
#include "widgets/calibrating/board_overlays.h"
#include "widgets/calibrating/lens_page.h"
#include "widgets/language.h"

#include <QApplication>
#include <QDateTime>

namespace alltact {

bool LensPage::is_own() const {
  const FingerStatus& finger = session_.status().finger;
  return finger.state == FingerState::kReady && !finger.folder.empty();
}

bool LensPage::can_take() const {
  return !is_own() && session_.view() && session_.status().source.is_live;
}

void LensPage::press_pedal() {
  if (take_->isEnabled() && take_->isVisible()) want_board();
}

void LensPage::want_board() {
  is_board_wanted_ = true;
  look_at_frame();
}

void LensPage::begin_boards() {
  collector_.reset();
  look_.reset();
  cells_ = {};
  fitted_.reset();
  boards_folder_.clear();
  is_board_wanted_ = false;
  fitting_.stop();
  views_->clear();
  forecast_->clear();
  show_boards();
}

/// One frame after the other, each the newest when the one before is done.
void LensPage::look_at_frame() {
  if (!isVisible() || !can_take() || looking_.is_running() || work_.is_running()) return;
  const FramePtr frame = session_.view()->result.frame;
  if (!frame || (look_ && look_->frame == frame)) return;
  if (!collector_) collector_ = std::make_shared<BoardCollector>(form_->board());
  looking_.start([this, frame, collector = collector_](const Job&) {
    auto look = std::make_shared<BoardLook>(collector->look(frame));
    return std::function<void()>([this, look, collector] { take_look(collector, *look); });
  });
}

void LensPage::take_look(const std::shared_ptr<BoardCollector>& by, const BoardLook& look) {
  if (by != collector_) return;  // another board was chosen meanwhile
  look_ = look;
  forget_wanted_board();
  if (is_fit_stale_) fit_boards();
  const bool is_by_hand = std::exchange(is_board_wanted_, false);
  if (look.view && (is_by_hand || (by_itself_->isChecked() && look.is_worth_keeping())))
    keep_board(look);
  show_boards();
}

void LensPage::keep_board(const BoardLook& look) {
  collector_->keep(look);
  cells_ = collector_->cells();
  if (boards_folder_.empty()) {
    boards_folder_ =
        work_folder_ /
        ("boards_" +
         QDateTime::currentDateTime().toString(QStringLiteral("yyyy-MM-dd_HHmmss")).toStdString());
    pictures_->setText(QString::fromStdString(boards_folder_.string()));
  }
  disk_->add([folder = boards_folder_, frame = collector_->frames().back()]() -> Status {
    if (const Status made = make_folder(folder); !made) return made;
    return write_picture(folder / (frame->name + ".png"),
                         frame->grey,
                         frame->controls ? *frame->controls : std::string());
  });
  live_->freeze(false);
  live_->flash(tr("Board %1").arg(collector_->views().size()));
  QApplication::beep();
  is_fit_stale_ = true;
  fit_boards();
}

void LensPage::forget_board() {
  if (const QListWidgetItem* item = views_->currentItem())
    unwanted_ = item->data(Qt::UserRole).toString().toStdString();
  if (!looking_.is_running()) forget_wanted_board();
}

void LensPage::forget_wanted_board() {
  const std::string name = std::exchange(unwanted_, {});
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

/// With the boards that were taken so far.
void LensPage::fit_boards() {
  // While a frame is looked at the collector is that thread's; it comes back here.
  if (!is_fit_stale_ || fitting_.is_running() || looking_.is_running() || !collector_)
    return show_boards();
  is_fit_stale_ = false;
  const auto& views = collector_->views();
  std::vector<LensViewReport> bare;
  for (const BoardView& view : views) {
    bare.emplace_back();
    bare.back().name = view.name;
    bare.back().put_aside = en::say("its error is told from the third view on");
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
  if (!look_) return tr("Looking for the board.");
  if (!look_->view) return window_sentence(look_->why_none);
  if (!look_->is_sharp) return tr("The board is blurred: hold it still, or further away.");
  if (!look_->is_new) return tr("This place is taken: move the board, or tilt it.");
  if (!look_->is_still) return tr("Hold it still.");
  return tr("Good: take it.");
}

void LensPage::show_boards() {
  const bool is_possible = can_take();
  live_group_->setVisible(!is_own());
  take_->setEnabled(is_possible && look_ && look_->view);
  by_itself_->setEnabled(is_possible);
  QString words = board_words();
  if (fitted_ && !fitted_->coverage.advice.empty())
    words += QLatin1Char('\n') +
             tr("Still missing: %1.").arg(in_window_language(fitted_->coverage.advice));
  guide_->setText(words);
  views_->setVisible(!is_own() && views_->count() > 0);
  forecast_->setVisible(!is_own() && !forecast_->text().isEmpty());
  forget_->setVisible(!is_own() && !boards_folder_.empty());
  forget_->setEnabled(views_->currentItem() != nullptr);
}

std::vector<Overlay> LensPage::overlays(const LiveView& view) const {
  const FingerStatus& finger = session_.status().finger;
  if (is_own() && finger.finger) {
    const auto camera = Camera::create(finger.finger->camera);
    const bool fits = camera && camera->size().width == view.result.grey.cols;
    return fits ? std::vector<Overlay>{lens_grid_overlay(*camera)} : std::vector<Overlay>();
  }
  std::vector<Overlay> overlays;
  if (!can_take()) return overlays;
  const QSize size(view.result.grey.cols, view.result.grey.rows);
  if (views_->count() > 0) overlays.push_back(unseen_cells_overlay(cells_, size));
  if (look_ && look_->view) overlays.push_back(corners_overlay(*look_));
  return overlays;
}

}  // namespace alltact
