#include "widgets/shell/finger_card.h"

#include "calibration/checks/finger_check.h"
#include "calibration/finger/calibration_inputs.h"
#include "core/base/utc_time.h"
#include "core/finger/finger_store.h"
#include "widgets/language.h"
#include "widgets/theme.h"
#include "widgets/verdict_text.h"

#include <QAction>
#include <QDateTime>
#include <QDesktopServices>
#include <QEvent>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLocale>
#include <QPainter>
#include <QUrl>
#include <QVBoxLayout>
#include <algorithm>

namespace alltact {
namespace {

namespace fs = std::filesystem;

constexpr int kImageHeight = 288;  // twice the shown height of most, for dense screens

/// The first press, or the reference image of a flat sensor.
fs::path image_file_of(const fs::path& folder, const Finger& finger) {
  if (const auto presses = stored_presses(folder); presses && !presses->empty())
    return presses->front();
  if (finger.reference && !finger.reference->image.empty()) return folder / finger.reference->image;
  return {};
}

}  // namespace

std::optional<FingerCard> read_finger_card(const fs::path& folder, const std::string& now) {
  const auto opened = open_finger(folder);
  if (!opened) return std::nullopt;
  const Finger& finger = (*opened)->finger;
  FingerCard card;
  card.folder = folder;
  card.name = finger.name.empty() ? folder.filename().string() : finger.name;
  const FingerWorth state = worth_of(**opened, now);
  if (finger.mapping)
    if (const auto date = finger.provenance.find("calibration_date");
        date != finger.provenance.end())
      card.calibrated_on = date->second;
  if (state.check) {
    card.checked_on = state.check->time;
    card.checked_mm = state.check->error_mm;
  }
  if (state.verdict) {
    card.grade = state.verdict->grade;
    const Verdict worth = window_verdict(*state.evidence);
    card.error_mm = expected_error_mm(worth).value_or(0.0);
    card.findings = findings_of(worth, state.evidence->contradictions);
    if (!worth.missing_names.empty()) card.lacks = worth.missing_names.front();
    card.rests_on = worth.rests_on;
  }
  card.reference = state.reference;
  card.is_recorded = finger.face.kind == FaceKind::kFinRay;
  card.must_repeat = state.must_repeat;
  if (const Message broken = sentence(state.reference);
      state.due == FingerDue::kRepair && card.findings.empty())
    card.findings = {broken};
  if (finger.reference)
    for (const std::string& name :
         {finger.reference->image, finger.reference->video, finger.reference->markers})
      if (!name.empty()) card.files.push_back(folder / name);
  card.due = state.due;
  if (const fs::path file = image_file_of(folder, finger); !file.empty())
    if (const QImage full_image(QString::fromStdString(file.string())); !full_image.isNull())
      card.image = full_image.scaledToHeight(kImageHeight, Qt::SmoothTransformation)
                       .convertToFormat(QImage::Format_RGB32);
  return card;
}

namespace {

QDateTime local_time(const std::string& utc) {
  return QDateTime::fromString(QString::fromStdString(utc), Qt::ISODate).toLocalTime();
}

/// The action that brings the missing evidence of a calibration.
QString evidence_due_text(const FingerCard& card) {
  const auto lacks = [&card](std::initializer_list<std::string_view> names) {
    return std::find(names.begin(), names.end(), card.lacks) != names.end();
  };
  if (!card.grade || lacks({"basis_stored", "complete"}))
    return FingerCards::tr("Due: calibrate it again");
  if (lacks({"fresh"})) return FingerCards::tr("Due: a check");
  if (lacks({"held_out", "presses", "positions", "thirds", "depths", "scale_known"}))
    return FingerCards::tr("Due: more presses");
  return FingerCards::tr("Due: read its verdict");
}

QString in_mm(double value) { return FingerCards::tr("%1 mm").arg(local_mm(value, 3)); }

}  // namespace

Headline headline_of(const FingerCard& card) {
  if (card.grade) {
    Headline headline = headline_of(*card.grade, card.error_mm, card.must_repeat, card.reference);
    if (card.due == FingerDue::kCalibrateAgain) headline.meaning = Meaning::kBad;
    if (card.due != FingerDue::kNothing && headline.meaning == Meaning::kGood)
      headline.meaning = Meaning::kDoubtful;
    return headline;
  }
  if (card.due == FingerDue::kRepair)
    return headline_of(Grade::kUnfit, 0, card.must_repeat, card.reference);
  const bool is_new = card.due == FingerDue::kRecording || card.due == FingerDue::kCalibration;
  return {is_new ? FingerCards::tr("Not calibrated yet")
                 : FingerCards::tr("Calibrated; quality not stored"),
          Meaning::kDoubtful};
}

QString local_day(const std::string& utc) {
  const QDateTime time = local_time(utc);
  return time.isValid() ? day_text(time.date()) : QString();
}

QString age_in_days(const std::string& utc, const std::string& now) {
  const QDateTime then = local_time(utc), today = local_time(now);
  if (!then.isValid() || !today.isValid()) return {};
  const auto days = static_cast<int>(then.date().daysTo(today.date()));
  if (days <= 0) return FingerCards::tr("today");
  if (days == 1) return FingerCards::tr("yesterday");
  return FingerCards::tr("%n days ago", nullptr, days);
}

QString dates_of(const FingerCard& card) {
  const QString made = local_day(card.calibrated_on), checked = local_day(card.checked_on);
  if (made.isEmpty()) return {};
  return checked.isEmpty() ? FingerCards::tr("Calibrated %1").arg(made)
                           : FingerCards::tr("Calibrated %1, checked %2").arg(made, checked);
}

QString due_text(const FingerCard& card) {
  switch (card.due) {
    case FingerDue::kRecording:
      return card.is_recorded ? FingerCards::tr("Due: record it bending")
                              : FingerCards::tr("Due: its untouched image");
    case FingerDue::kCalibration:
      return FingerCards::tr("Due: calibrate it");
    case FingerDue::kRepair:
      return card.reference == ReferenceState::kMissing
                 ? FingerCards::tr("Due: restore its reference")
                 : FingerCards::tr("Due: record its reference again");
    case FingerDue::kEvidence:
      return evidence_due_text(card);
    case FingerDue::kFirstCheck:
    case FingerDue::kCheck:
    case FingerDue::kMorePresses:
      return FingerCards::tr("Due: a check");
    case FingerDue::kInspect:
      return FingerCards::tr("Drifting: see the last check");
    case FingerDue::kCalibrateAgain:
    case FingerDue::kRepeat:
      return FingerCards::tr("Due: calibrate it again");
    case FingerDue::kNothing:
      break;
  }
  return FingerCards::tr("Nothing is due");
}

QString findings_text(const FingerCard& card) {
  QStringList lines;
  for (const Message& finding : card.findings) lines << window_sentence(finding);
  return lines.join(QLatin1Char('\n'));
}

QString summary_of(const FingerCard& card, const std::string& now) {
  QStringList parts{headline_of(card).text};
  const QString made = age_in_days(card.calibrated_on, now);
  if (!made.isEmpty()) parts << FingerCards::tr("calibrated %1").arg(made);
  const QString checked = age_in_days(card.checked_on, now);
  if (!checked.isEmpty())
    parts << FingerCards::tr("checked %1, error %2").arg(checked, in_mm(card.checked_mm));
  parts << due_text(card);
  return parts.join(QString::fromUtf8(" \u00b7 "));
}

namespace {

constexpr int kCardColumns = 3;
constexpr int kCardWidth = 190, kMaxImageWidth = 320, kCardSymbol = 22;
constexpr int kCardMargin = 14;  // px, both sides of image and text together

/// The image with the verdict's symbol in its corner.
QIcon icon_of(const FingerCard& card, const QSize& size, const QPalette& palette, double ratio) {
  QPixmap image(size * ratio);
  image.setDevicePixelRatio(ratio);
  image.fill(palette.color(QPalette::Dark));
  QPainter painter(&image);
  painter.setRenderHint(QPainter::SmoothPixmapTransform);
  const QRect card_box(QPoint(0, 0), size);
  if (card.image.isNull()) {
    const int side = size.height() / 2;
    QRect box(0, 0, side, side);
    box.moveCenter(card_box.center());
    painter.drawPixmap(
        box, symbol(QStringLiteral("finger"), palette.color(QPalette::WindowText), side, ratio));
  } else {
    QRect image_box(QPoint(0, 0), card.image.size().scaled(size, Qt::KeepAspectRatioByExpanding));
    image_box.moveCenter(card_box.center());
    painter.setClipRect(card_box);
    painter.drawImage(image_box, card.image);
  }
  const Meaning meaning = headline_of(card).meaning;
  const QRect corner(card_box.right() - kCardSymbol - 3, 4, kCardSymbol, kCardSymbol);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(Qt::NoPen);
  painter.setBrush(palette.color(QPalette::Base));
  painter.drawEllipse(corner.adjusted(-2, -2, 2, 2));
  painter.drawPixmap(corner, symbol(meaning_symbol(meaning), meaning_colour(meaning, palette),
                                    kCardSymbol, ratio));
  return QIcon(image);
}

/// The name, what it is worth, and what is due.
QStringList lines_of(const FingerCard& card) {
  QStringList lines;
  for (const QString& line :
       {QString::fromStdString(card.name), headline_of(card).text, due_text(card)})
    if (!line.isEmpty()) lines << line;
  return lines;
}

bool is_only_one_of_its_name(const FingerCard& card, const std::vector<FingerCard>& cards) {
  return std::count_if(cards.begin(), cards.end(),
                       [&](const FingerCard& other) { return other.name == card.name; }) == 1;
}

}  // namespace

FingerCards::FingerCards(QWidget* parent) : Translated(parent), grid_(new QGridLayout(this)) {
  grid_->setContentsMargins(0, 0, 0, 0);
  hide();
  say([this] { rebuild(); });
}

void FingerCards::set_fingers(const std::vector<std::filesystem::path>& folders) {
  folders_ = folders;
  read();
}

void FingerCards::read() {
  reading_.restart([this, folders = folders_](const Job& job) {
    std::vector<FingerCard> cards;
    std::vector<std::filesystem::path> there;
    for (const auto& folder : folders) {
      if (job.stop_requested()) break;
      auto card = read_finger_card(folder, utc_now());
      if (!card) continue;
      there.push_back(folder);
      if (cards.size() < kMaxCards) cards.push_back(std::move(*card));
    }
    return std::function<void()>([this, cards, there] {
      Q_EMIT found(there);
      if (cards == cards_) return;
      cards_ = cards;
      rebuild();
    });
  });
}

void FingerCards::rebuild() {
  while (QLayoutItem* item = grid_->takeAt(0)) {
    item->widget()->hide();
    item->widget()->deleteLater();
    delete item;
  }
  for (std::size_t i = 0; i < cards_.size(); ++i)
    grid_->addWidget(make_button(cards_[i]), static_cast<int>(i) / kCardColumns,
                     static_cast<int>(i) % kCardColumns);
  fit();
  setVisible(!cards_.empty());
  Q_EMIT filled();
}

QToolButton* FingerCards::make_button(const FingerCard& card) {
  auto* button = new QToolButton;
  button->setToolButtonStyle(Qt::ToolButtonTextUnderIcon);
  button->setMinimumWidth(kCardWidth);
  button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  button->setAccessibleName(tr("Open the finger %1").arg(QString::fromStdString(card.name)));
  QStringList lines = lines_of(card);
  if (const QString dates = dates_of(card); !dates.isEmpty()) lines << dates;
  if (const QString findings = findings_text(card); !findings.isEmpty()) lines << findings;
  button->setAccessibleDescription(lines.mid(1).join(QLatin1String(". ")));
  lines << QString::fromStdString(card.folder.string());
  button->setToolTip(lines.join(QLatin1Char('\n')));
  connect(button, &QToolButton::clicked, this, [this, folder = card.folder] {
    Q_EMIT finger_chosen(QString::fromStdString(folder.string()));
  });
  const auto add_action = [&](const QString& text, const std::function<void()>& act) {
    auto* action = new QAction(text, button);
    connect(action, &QAction::triggered, this, act);
    button->addAction(action);
  };
  button->setContextMenuPolicy(Qt::ActionsContextMenu);
  add_action(tr("&Open"), [button] { button->click(); });
  add_action(tr("&Show in folder"), [folder = card.folder] {
    QDesktopServices::openUrl(QUrl::fromLocalFile(QString::fromStdString(folder.string())));
  });
  add_action(tr("&Remove from this list"),
             [this, folder = card.folder] { Q_EMIT removal_requested(folder); });
  return button;
}

/// The tool tip holds text that does not fit into its card.
void FingerCards::fit() {
  const int columns = std::clamp(static_cast<int>(cards_.size()), 1, kCardColumns);
  const int room =
      std::max(kCardWidth, (width() - (columns - 1) * grid_->spacing()) / columns) - kCardMargin;
  const int image_width = std::min(room, kMaxImageWidth);
  const QSize image(image_width, image_width * 9 / 16);
  for (std::size_t i = 0; i < cards_.size(); ++i) {
    auto* button = static_cast<QToolButton*>(grid_->itemAt(static_cast<int>(i))->widget());
    const FingerCard& card = cards_[i];
    if (button->iconSize() != image || button->icon().isNull()) {
      button->setIconSize(image);
      button->setIcon(icon_of(card, image, palette(), devicePixelRatioF()));
    }
    QStringList lines;
    for (const QString& line : lines_of(card))
      lines << fontMetrics().elidedText(line, Qt::ElideRight, room);
    if (!is_only_one_of_its_name(card, cards_))
      lines.insert(1,
                   elided_path(QString::fromStdString(card.folder.string()), fontMetrics(), room));
    button->setText(lines.join(QLatin1Char('\n')).replace(QLatin1Char('&'), QLatin1String("&&")));
  }
}

void FingerCards::resizeEvent(QResizeEvent* event) {
  Translated::resizeEvent(event);
  fit();
}

void FingerCards::changeEvent(QEvent* event) {
  Translated::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) rebuild();
}

/// Reads again, so that the cards show what happened in between.
void FingerCards::showEvent(QShowEvent* event) {
  Translated::showEvent(event);
  read();
}

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
                                         const std::vector<fs::path>& known, const std::string& now,
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
      list_(new RowList),
      count_(new QLabel),
      open_(new QPushButton),
      folder_(new QPushButton),
      gage_(new QPushButton),
      buttons_(new QDialogButtonBox(QDialogButtonBox::Close)) {
  for (const fs::path& folder : known_) folders_.insert(folder.parent_path());
  auto* column = new QVBoxLayout(this);
  list_->header()->setStretchLastSection(true);  // the folder
  list_->setTextElideMode(Qt::ElideRight);
  list_->setSelectionMode(QAbstractItemView::ExtendedSelection);
  column->addWidget(count_);
  column->addWidget(list_, 1);
  auto* row = new QHBoxLayout;
  row->addWidget(open_);
  row->addWidget(folder_);
  row->addWidget(gage_);
  row->addStretch();
  row->addWidget(buttons_);
  column->addLayout(row);
  set_primary(*open_);
  connect(&reading_, &BackgroundWork::finished, this, &FingerListDialog::fill);
  connect(list_, &QTreeWidget::itemActivated, this, &FingerListDialog::open_chosen);
  connect(list_, &QTreeWidget::currentItemChanged, this, &FingerListDialog::follow_choice);
  connect(list_, &QTreeWidget::itemSelectionChanged, this, &FingerListDialog::follow_choice);
  connect(gage_, &QPushButton::clicked, this, [this] { Q_EMIT gage_requested(selected()); });
  connect(open_, &QPushButton::clicked, this, &FingerListDialog::open_chosen);
  connect(folder_, &QPushButton::clicked, this, [this] {
    ask_for_folder(this, FilesOf::kFingers, tr("Folder with fingers"),
                   [this](const QString& folder) {
                     folders_.insert(folder.toStdString());
                     read();
                   });
  });
  connect(buttons_, &QDialogButtonBox::rejected, this, &QDialog::reject);
  resize(920, 460);
  say([this] {
    setWindowTitle(tr("All fingers"));
    list_->setAccessibleName(tr("Fingers"));
    list_->setHeaderLabels({tr("Finger"), tr("Quality"), tr("Error, mm"), tr("Calibrated"),
                            tr("Checked"), tr("Due"), tr("Folder")});
    open_->setText(tr("&Open"));
    open_->setToolTip(tr("Opens the selected finger (Enter)"));
    folder_->setText(tr("&Look in another folder…"));
    folder_->setToolTip(tr("Adds the fingers of another folder to the list"));
    gage_->setText(tr("&Gage R&&R…"));
    gage_->setToolTip(tr("Compares the checks of the selected fingers by their operators"));
    buttons_->button(QDialogButtonBox::Close)->setText(tr("&Close"));
    buttons_->button(QDialogButtonBox::Close)->setToolTip(tr("Closes this window (Esc)"));
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
                 QIcon(symbol(meaning_symbol(meaning), meaning_colour(meaning, palette()),
                              kListSymbol, devicePixelRatioF())));
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
                      ? tr("Reading the fingers' folders…")
                      : tr("%n finger(s), ", nullptr, static_cast<int>(cards_.size())) +
                            tr("%n with something due", nullptr, static_cast<int>(due)));
  if (!cards_.empty()) list_->setCurrentItem(list_->topLevelItem(0));
  follow_choice();
}

void FingerListDialog::follow_choice() {
  open_->setEnabled(list_->currentItem() != nullptr);
  gage_->setEnabled(!selected().empty());
}

std::vector<fs::path> FingerListDialog::selected() const {
  std::vector<fs::path> folders;
  for (int i = 0; i < list_->topLevelItemCount(); ++i)
    if (const auto* row = list_->topLevelItem(i); row->isSelected())
      folders.emplace_back(row->text(kListFolder).toStdString());
  return folders;
}

void FingerListDialog::open_chosen() {
  const QTreeWidgetItem* chosen = list_->currentItem();
  if (chosen == nullptr) return;
  Q_EMIT finger_chosen(chosen->text(kListFolder));
  accept();
}

}  // namespace alltact
