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
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->addWidget(symbol_);
  row->addWidget(text_, 1);
  row->addWidget(due_);
  connect(&work_, &Workspace::finger_changed, this, &FingerSummary::follow);
  connect(&work_, &Workspace::finger_rewritten, this, &FingerSummary::read);
  connect(&poll_timer_, &QTimer::timeout, this, &FingerSummary::read);
  poll_timer_.start(kBetweenLooks_ms);
  connect(due_, &QPushButton::clicked, this, [this] {
    const bool records = card_ && (card_->due == FingerDue::kRecording ||
                                   (card_->due == FingerDue::kRepair && card_->is_recorded));
    Q_EMIT due_requested(records ? "record" : "calibrate");
  });
  say([this] {
    text_->setAccessibleName(tr("What is known of this finger"));
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

void FingerSummary::show_summary() {
  setVisible(card_.has_value());
  if (!card_) return;
  const Meaning meaning = headline_of(*card_).meaning;
  symbol_->setPixmap(symbol(meaning_symbol(meaning),
                            meaning_colour(meaning, palette()),
                            kSummarySymbol,
                            devicePixelRatioF()));
  text_->set_text(summary_of(*card_, utc_now()));
  due_->setVisible(card_->due != FingerDue::kNothing);
  switch (card_->due) {
    case FingerDue::kRecording:
      return due_->setText(tr("Go to Record"));
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

}  // namespace alltact
