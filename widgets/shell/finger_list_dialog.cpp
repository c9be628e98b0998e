#include "widgets/shell/finger_list_dialog.h"

#include "core/utc_time.h"
#include "widgets/shell/finger_card_words.h"
#include "widgets/shell/icons.h"
#include "widgets/shell/primary_button.h"

#include <QFileDialog>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QVBoxLayout>
#include <algorithm>

namespace alltact {
namespace {

namespace fs = std::filesystem;

constexpr int kListSymbol = 16;
constexpr std::size_t kMaxFingers = 500;  // of a folder that holds something else

enum ListColumn {
  kListName,
  kListWorth,
  kListError,
  kListCalibrated,
  kListChecked,
  kListDue,
  kListFolder,
  kListColumns
};

/// Sorts the most urgent action to the top.
int urgency(const FingerCard& card) {
  switch (card.due) {
    case FingerDue::kRepair:
    case FingerDue::kCalibrateAgain:
    case FingerDue::kRepeat:
      return 0;
    case FingerDue::kInspect:
      return 1;
    case FingerDue::kEvidence:
    case FingerDue::kCheck:
    case FingerDue::kMorePresses:
      return 2;
    case FingerDue::kFirstCheck:
      return 3;
    case FingerDue::kCalibration:
      return 4;
    case FingerDue::kRecording:
      return 5;
    case FingerDue::kNothing:
      break;
  }
  return 6;
}

/// Without the error, which has a column of its own.
QString worth_text(const FingerCard& card, const Headline& headline) {
  return card.error_mm > 0 && card.grade ? grade_text(*card.grade) : headline.text;
}

}  // namespace

std::vector<FingerCard> read_all_fingers(const std::set<fs::path>& folders,
                                         const std::vector<fs::path>& known,
                                         const std::string& now,
                                         const Job& job) {
  std::set<fs::path> all(known.begin(), known.end());
  for (const fs::path& folder : folders) {
    std::error_code failed;
    for (fs::directory_iterator entry(folder, failed), end; !failed && entry != end;
         entry.increment(failed)) {
      std::error_code ignored;
      if (all.size() < kMaxFingers && fs::exists(entry->path() / "finger.yaml", ignored))
        all.insert(entry->path());
    }
  }
  std::vector<FingerCard> cards;
  for (const fs::path& folder : all) {
    if (job.stop_requested()) break;
    if (auto card = read_finger_card(folder, now)) cards.push_back(std::move(*card));
  }
  std::stable_sort(cards.begin(), cards.end(), [](const FingerCard& a, const FingerCard& b) {
    return urgency(a) < urgency(b);
  });
  return cards;
}

FingerListDialog::FingerListDialog(std::vector<fs::path> known, QWidget* parent)
    : FittedDialog(parent),
      known_(std::move(known)),
      list_(new QTreeWidget),
      count_(new QLabel),
      open_(new QPushButton),
      folder_(new QPushButton),
      buttons_(new QDialogButtonBox(QDialogButtonBox::Close)) {
  for (const fs::path& folder : known_) folders_.insert(folder.parent_path());
  auto* column = new QVBoxLayout(this);
  list_->setRootIsDecorated(false);
  list_->setAllColumnsShowFocus(true);
  list_->setUniformRowHeights(true);
  list_->setTextElideMode(Qt::ElideRight);
  column->addWidget(count_);
  column->addWidget(list_, 1);
  auto* row = new QHBoxLayout;
  row->addWidget(open_);
  row->addWidget(folder_);
  row->addStretch();
  row->addWidget(buttons_);
  column->addLayout(row);
  set_primary(*open_);
  connect(&reading_, &BackgroundWork::finished, this, &FingerListDialog::fill);
  connect(list_, &QTreeWidget::itemActivated, this, &FingerListDialog::open_chosen);
  connect(list_, &QTreeWidget::currentItemChanged, this, &FingerListDialog::follow_choice);
  connect(open_, &QPushButton::clicked, this, &FingerListDialog::open_chosen);
  connect(folder_, &QPushButton::clicked, this, &FingerListDialog::choose_folder);
  connect(buttons_, &QDialogButtonBox::rejected, this, &QDialog::reject);
  resize(920, 460);
  say([this] {
    setWindowTitle(tr("All fingers"));
    list_->setAccessibleName(tr("Fingers"));
    list_->setHeaderLabels({tr("Finger"),
                            tr("Worth"),
                            tr("Error, mm"),
                            tr("Calibrated"),
                            tr("Checked"),
                            tr("Due"),
                            tr("Folder")});
    open_->setText(tr("&Open"));
    folder_->setText(tr("&Look into another folder…"));
    buttons_->button(QDialogButtonBox::Close)->setText(tr("&Close"));
    fill();
  });
  read();
}

void FingerListDialog::read() {
  reading_.restart([this, folders = folders_, known = known_](const Job& job) {
    auto cards = read_all_fingers(folders, known, utc_now(), job);
    return std::function<void()>([this, cards = std::move(cards)] { cards_ = cards; });
  });
  fill();
}

void FingerListDialog::fill() {
  list_->clear();
  const std::string now = utc_now();
  for (const FingerCard& card : cards_) {
    auto* row = new QTreeWidgetItem(list_);
    const Headline headline = headline_of(card);
    const Meaning meaning = headline.meaning;
    row->setIcon(kListName,
                 QIcon(symbol(meaning_symbol(meaning),
                              meaning_colour(meaning, palette()),
                              kListSymbol,
                              devicePixelRatioF())));
    row->setText(kListName, QString::fromStdString(card.name));
    row->setText(kListWorth, worth_text(card, headline));
    row->setText(kListError, card.error_mm > 0 ? local_mm(card.error_mm, 3) : QString());
    row->setText(kListCalibrated, age_in_days(card.calibrated_on, now));
    row->setText(kListChecked, age_in_days(card.checked_on, now));
    row->setText(kListDue, due_text(card));
    row->setText(kListFolder, QString::fromStdString(card.folder.string()));
    const QString findings = findings_text(card);
    for (int i = 0; i < kListColumns; ++i)
      row->setToolTip(
          i, findings.isEmpty() ? row->text(i) : row->text(i) + QLatin1Char('\n') + findings);
    row->setTextAlignment(kListError, Qt::AlignRight | Qt::AlignVCenter);
  }
  for (int i = 0; i < kListFolder; ++i) list_->resizeColumnToContents(i);
  const auto due = std::count_if(cards_.begin(), cards_.end(), [](const FingerCard& card) {
    return card.due != FingerDue::kNothing;
  });
  count_->setText(reading_.is_running()
                      ? tr("Looking at the fingers' folders…")
                      : tr("%n finger(s), ", nullptr, static_cast<int>(cards_.size())) +
                            tr("something is due with %n", nullptr, static_cast<int>(due)));
  if (!cards_.empty()) list_->setCurrentItem(list_->topLevelItem(0));
  follow_choice();
}

void FingerListDialog::follow_choice() {
  open_->setEnabled(list_->currentItem() != nullptr);
}

void FingerListDialog::choose_folder() {
  auto* dialog = new QFileDialog(this, tr("Folder with fingers in it"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setFileMode(QFileDialog::Directory);
  connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& folder) {
    folders_.insert(folder.toStdString());
    read();
  });
  dialog->show();
}

void FingerListDialog::open_chosen() {
  const QTreeWidgetItem* chosen = list_->currentItem();
  if (chosen == nullptr) return;
  Q_EMIT finger_chosen(chosen->text(kListFolder));
  accept();
}

}  // namespace alltact
