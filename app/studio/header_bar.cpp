#include "app/studio/header_bar.h"

#include "widgets/shell/icons.h"

#include <QHBoxLayout>

namespace alltact {

HeaderBar::HeaderBar(const LiveSession& session,
                     const Workspace& work,
                     QMenu& finger_menu,
                     QMenu& source_menu)
    : session_(session),
      work_(work),
      finger_label_(new QLabel),
      source_label_(new QLabel),
      finger_(new QToolButton),
      source_(new QToolButton),
      summary_(new FingerSummary(session, work)) {
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  add_button(finger_label_, finger_, finger_menu);
  add_button(source_label_, source_, source_menu);
  row->addWidget(summary_, 1);
  row->addStretch();
  connect(&session_, &LiveSession::status_ready, this, &HeaderBar::follow);
  say([this] {
    finger_label_->setText(tr("Finger:"));
    source_label_->setText(tr("Source:"));
    follow();
  });
  set_icons();
}

void HeaderBar::add_button(QLabel* label, QToolButton* button, QMenu& menu) {
  button->setMenu(&menu);
  button->setPopupMode(QToolButton::InstantPopup);
  button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  button->setFocusPolicy(Qt::TabFocus);
  label->setBuddy(button);
  auto* row = static_cast<QHBoxLayout*>(layout());
  row->addWidget(label);
  row->addWidget(button);
  row->addSpacing(18);
}

void HeaderBar::set_icons() {
  finger_->setIcon(icon(QStringLiteral("finger"), palette()));
  source_->setIcon(icon(QStringLiteral("source"), palette()));
}

void HeaderBar::changeEvent(QEvent* event) {
  Translated::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) set_icons();
}

void HeaderBar::follow() {
  const QString finger = finger_name(), source = work_.source_name();
  finger_->setText(finger);
  finger_->setAccessibleName(tr("Finger: %1").arg(finger));
  finger_->setToolTip(QString::fromStdString(session_.status().finger.folder.string()));
  source_->setText(source);
  source_->setAccessibleName(tr("Source: %1").arg(source));
  const auto& inputs = work_.state().source;
  source_->setToolTip(inputs.empty() ? QString() : QString::fromStdString(inputs.front().string()));
}

QString HeaderBar::finger_name() const {
  const FingerStatus& finger = session_.status().finger;
  if (finger.state == FingerState::kNone) return tr("none", "finger");
  const bool is_named = finger.finger && !finger.finger->name.empty();
  const QString name =
      QString::fromStdString(is_named ? finger.finger->name : finger.folder.filename().string());
  if (finger.state == FingerState::kLoading) return tr("%1 (loading)").arg(name);
  const bool is_simulated = finger.state == FingerState::kReady && finger.folder.empty();
  return is_simulated ? tr("%1 (simulated)").arg(name) : name;
}

}  // namespace alltact
