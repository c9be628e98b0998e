#include "widgets/calibrating/undo_bar.h"

#include "widgets/shell/icons.h"
#include "widgets/undo_step.h"

#include <QHBoxLayout>

namespace alltact {
namespace {

constexpr int kMaxTextWidth_px = 200;  // px

}  // namespace

UndoBar::UndoBar(QUndoStack& undo, const LiveSession& session, QWidget* parent)
    : Translated(parent),
      stack_(undo),
      session_(session),
      undo_(new QToolButton),
      redo_(new QToolButton) {
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  for (QToolButton* button : {undo_, redo_}) row->addWidget(button);
  row->addStretch();
  undo_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  connect(undo_, &QToolButton::clicked, &stack_, &QUndoStack::undo);
  connect(redo_, &QToolButton::clicked, &stack_, &QUndoStack::redo);
  connect(&stack_, &QUndoStack::indexChanged, this, &UndoBar::follow);
  connect(&session_, &LiveSession::status_ready, this, &UndoBar::follow);
  set_icons();
  say([this] { follow(); });
}

void UndoBar::follow() {
  const bool is_recording = session_.status().recording.state == RecordingState::kRunning;
  undo_->setEnabled(stack_.canUndo() && !is_recording);
  redo_->setEnabled(stack_.canRedo() && !is_recording);
  const QString undo = stack_.canUndo() ? tr("Undo: %1").arg(undo_words(stack_)) : tr("Undo");
  const QString redo = stack_.canRedo() ? tr("Redo: %1").arg(redo_words(stack_)) : tr("Redo");
  undo_->setText(undo_->fontMetrics().elidedText(undo, Qt::ElideRight, kMaxTextWidth_px));
  undo_->setToolTip(tr("%1 (Ctrl+Z)").arg(undo));
  redo_->setToolTip(tr("%1 (Ctrl+Shift+Z)").arg(redo));
  undo_->setAccessibleName(undo);
  redo_->setAccessibleName(redo);
}

void UndoBar::set_icons() {
  undo_->setIcon(icon(QStringLiteral("undo"), palette()));
  redo_->setIcon(icon(QStringLiteral("redo"), palette()));
}

void UndoBar::changeEvent(QEvent* event) {
  Translated::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) set_icons();
}

}  // namespace alltact
