#include "app/studio/header_bar.h"

#include "calibration/checks/check_history.h"
#include "core/base/utc_time.h"
#include "widgets/shell/finger_card.h"
#include "widgets/theme.h"

#include <QHBoxLayout>

namespace alltact {
namespace {

namespace fs = std::filesystem;

constexpr int kSummarySymbol = 18;
constexpr int kNameWidth_px = 150;  // of the buttons: a name that changes moves nothing
constexpr int kBetweenLooks_ms = 3000;

std::string written_in(const fs::path& folder, const std::vector<fs::path>& reference) {
  std::string times;
  std::vector<fs::path> files{folder / "finger.yaml", folder / kCheckFile};
  files.insert(files.end(), reference.begin(), reference.end());
  for (const fs::path& file : files) {
    std::error_code failed;
    const auto time = fs::last_write_time(file, failed);
    times += failed ? "-" : std::to_string(time.time_since_epoch().count());
    times += ' ';
  }
  return times;
}

}  // namespace

FingerSummary::FingerSummary(const LiveSession& session, const Workspace& work, QWidget* parent)
    : Translated(parent),
      session_(session),
      work_(work),
      symbol_(new QLabel),
      text_(new ElidedLabel),
      due_(new QPushButton) {
  auto* row = without_margins(new QHBoxLayout(this));
  row->addWidget(symbol_);
  row->addWidget(text_, 1);
  row->addWidget(due_);
  due_->setObjectName(QStringLiteral("due"));
  connect(&work_, &Workspace::finger_changed, this, &FingerSummary::follow);
  connect(&work_, &Workspace::finger_rewritten, this, &FingerSummary::read);
  connect(&poll_timer_, &QTimer::timeout, this, &FingerSummary::read);
  poll_timer_.start(kBetweenLooks_ms);
  connect(due_, &QPushButton::clicked, this, [this] { Q_EMIT due_requested(due_page()); });
  say([this] {
    text_->setAccessibleName(tr("Summary of this finger"));
    show_summary();
  });
}

void FingerSummary::follow() {
  if (work_.state().finger != read_) {
    card_.reset();
    written_.clear();
    show_summary();
  }
  read();
}

void FingerSummary::read() {
  const auto folder = work_.state().finger;
  if (folder.empty()) return;
  const auto known = card_ ? card_->files : std::vector<fs::path>();
  reading_.start([this, folder, known, before = written_](const Job&) {
    // With other files than before, the next call differs, and reads once more.
    const std::string written = written_in(folder, known);
    if (written == before) return std::function<void()>([] {});
    auto card = read_finger_card(folder, utc_now());
    return std::function<void()>([this, folder, written, card = std::move(card)] {
      if (folder != work_.state().finger) return read();
      read_ = folder;
      written_ = written;
      card_ = card;
      show_summary();
    });
  });
}

std::string FingerSummary::due_page() const {
  const bool records = card_ && card_->is_recorded &&
                       (card_->due == FingerDue::kRecording || card_->due == FingerDue::kRepair);
  return records ? "record" : "calibrate";
}

void FingerSummary::set_led(bool is_guided, const std::string& page, const std::string& leads_to) {
  if (is_guided == is_guided_ && page == page_ && leads_to == leads_to_) return;
  is_guided_ = is_guided;
  page_ = page;
  leads_to_ = leads_to;
  show_summary();
}

void FingerSummary::show_summary() {
  setVisible(card_.has_value() && !is_guided_);
  due_->setToolTip(tr("Opens the page of what is due for this finger"));
  if (!card_) return;
  const Meaning meaning = headline_of(*card_).meaning;
  symbol_->setPixmap(symbol(meaning_symbol(meaning), meaning_colour(meaning, palette()),
                            kSummarySymbol, devicePixelRatioF()));
  text_->set_text(summary_of(*card_, utc_now()));
  due_->setVisible(card_->due != FingerDue::kNothing && page_ != due_page() &&
                   leads_to_ != due_page());
  switch (card_->due) {
    case FingerDue::kRecording:
    case FingerDue::kRepair:
      return due_->setText(card_->is_recorded ? tr("Go to Record") : tr("Go to Calibrate"));
    case FingerDue::kFirstCheck:
    case FingerDue::kCheck:
    case FingerDue::kInspect:
    case FingerDue::kMorePresses:
      return due_->setText(tr("Go to the check"));
    default:
      return due_->setText(tr("Go to Calibrate"));
  }
}

void FingerSummary::changeEvent(QEvent* event) {
  Translated::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) show_summary();
}

HeaderBar::HeaderBar(const LiveSession& session, const Workspace& work, QMenu& finger_menu,
                     QMenu& source_menu)
    : session_(session),
      work_(work),
      finger_label_(new QLabel),
      source_label_(new QLabel),
      finger_(new QToolButton),
      source_(new QToolButton),
      summary_(new FingerSummary(session, work)) {
  auto* row = without_margins(new QHBoxLayout(this));
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
  button->setFixedWidth(kNameWidth_px);
  label->setBuddy(button);
  auto* row = static_cast<QHBoxLayout*>(layout());
  row->addWidget(label);
  row->addWidget(button);
  row->addSpacing(kSpacing);
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
  finger_->setText(cut_to_button(finger));
  finger_->setAccessibleName(tr("Finger: %1").arg(finger));
  const auto& folder = session_.status().finger.folder;
  finger_->setToolTip(folder.empty() ? finger : QString::fromStdString(folder.string()));
  source_->setText(cut_to_button(source));
  source_->setAccessibleName(tr("Source: %1").arg(source));
  const auto& inputs = work_.state().source;
  source_->setToolTip(inputs.empty() ? tr("Opens a camera, a recording or the simulated finger")
                                     : QString::fromStdString(inputs.front().string()));
}

QString HeaderBar::cut_to_button(const QString& name) const {
  constexpr int kIconAndFrame_px = 52;  // icon, arrow and frame
  return fontMetrics().elidedText(name, Qt::ElideMiddle, kNameWidth_px - kIconAndFrame_px);
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
