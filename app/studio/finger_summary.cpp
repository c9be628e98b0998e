#include "app/studio/finger_summary.h"

#include "calibration/checks/check_history.h"
#include "core/utc_time.h"
#include "widgets/shell/finger_card_words.h"
#include "widgets/shell/icons.h"

#include <QHBoxLayout>

namespace alltact {
namespace {

namespace fs = std::filesystem;

constexpr int kSummarySymbol = 18;
constexpr int kBetweenLooks_ms = 3000;

std::string written_in(const fs::path& folder) {
  std::string times;
  for (const char* file : {"finger.yaml", kCheckFile}) {
    std::error_code failed;
    const auto time = fs::last_write_time(folder / file, failed);
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
      text_(new OneLine),
      due_(new QPushButton) {
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->addWidget(symbol_);
  row->addWidget(text_, 1);
  row->addWidget(due_);
  connect(&work_, &Workspace::finger_changed, this, &FingerSummary::follow);
  connect(&work_, &Workspace::finger_rewritten, this, &FingerSummary::read);
  connect(&look_, &QTimer::timeout, this, &FingerSummary::read);
  look_.start(kBetweenLooks_ms);
  connect(due_, &QPushButton::clicked, this, [this] {
    const bool is_recording = card_ && card_->due == FingerDue::kRecording;
    Q_EMIT due_wanted(is_recording ? "record" : "calibrate");
  });
  say([this] {
    text_->setAccessibleName(tr("What is known of this finger"));
    tell();
  });
}

void FingerSummary::follow() {
  if (work_.state().finger != read_) {
    card_.reset();
    written_.clear();
    tell();
  }
  read();
}

void FingerSummary::read() {
  const auto folder = work_.state().finger;
  if (folder.empty()) return;
  reading_.start([this, folder, before = written_](const Job&) {
    const std::string written = written_in(folder);
    if (written == before) return std::function<void()>([] {});
    auto card = read_finger_card(folder, utc_now());
    return std::function<void()>([this, folder, written, card = std::move(card)] {
      if (folder != work_.state().finger) return read();
      read_ = folder;
      written_ = written;
      card_ = card;
      tell();
    });
  });
}

void FingerSummary::tell() {
  setVisible(card_.has_value());
  if (!card_) return;
  const Meaning meaning = meaning_of(*card_);
  symbol_->setPixmap(symbol(meaning_symbol(meaning),
                            meaning_colour(meaning, palette()),
                            kSummarySymbol,
                            devicePixelRatioF()));
  text_->set_text(summary_of(*card_, utc_now()));
  due_->setVisible(card_->due != FingerDue::kNothing);
  switch (card_->due) {
    case FingerDue::kRecording:
      return due_->setText(tr("Go to Record"));
    case FingerDue::kFirstCheck:
    case FingerDue::kCheck:
    case FingerDue::kLook:
      return due_->setText(tr("Go to the check"));
    default:
      return due_->setText(tr("Go to Calibrate"));
  }
}

void FingerSummary::changeEvent(QEvent* event) {
  Translated::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) tell();
}

}  // namespace alltact
