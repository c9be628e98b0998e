#include "widgets/shell/finger_cards.h"

#include "core/utc_time.h"
#include "widgets/shell/icons.h"
#include "widgets/theme.h"

#include <QDateTime>
#include <QEvent>
#include <QLocale>
#include <QPainter>

namespace alltact {
namespace {

constexpr int kColumns = 2;
constexpr QSize kCardPicture(128, 72);
constexpr int kCardWidth = 400, kCardSymbol = 22;

QString grade_word(const FingerCard& card) {
  if (!card.grade && (card.due == FingerDue::kRecording || card.due == FingerDue::kCalibration))
    return FingerCards::tr("Not calibrated yet");
  if (!card.grade) return FingerCards::tr("Calibrated; how well is not kept");
  switch (*card.grade) {
    case Grade::kGood:
      return FingerCards::tr("Good");
    case Grade::kUsable:
      return FingerCards::tr("Usable for contact and its place");
    case Grade::kUnproven:
      return FingerCards::tr("Unproven");
    case Grade::kUnfit:
      break;
  }
  return FingerCards::tr("Not fit to measure with");
}

Meaning meaning_of(const FingerCard& card) {
  if (!card.grade) return Meaning::kDoubtful;
  if (*card.grade == Grade::kUnfit || card.due == FingerDue::kAgain) return Meaning::kBad;
  const bool is_well = card.due == FingerDue::kNothing && *card.grade == Grade::kGood;
  return is_well ? Meaning::kGood : Meaning::kDoubtful;
}

/// Where it is, as people there write it; empty for no date.
QString local_day(const std::string& utc) {
  const QDateTime time = QDateTime::fromString(QString::fromStdString(utc), Qt::ISODate);
  return time.isValid() ? QLocale().toString(time.toLocalTime().date(), QLocale::ShortFormat)
                        : QString();
}

QString dates_of(const FingerCard& card) {
  const QString made = local_day(card.calibrated_on), checked = local_day(card.checked_on);
  if (made.isEmpty()) return {};
  return checked.isEmpty() ? FingerCards::tr("Calibrated %1").arg(made)
                           : FingerCards::tr("Calibrated %1, checked %2").arg(made, checked);
}

QString due_text(FingerDue due) {
  switch (due) {
    case FingerDue::kRecording:
      return FingerCards::tr("Due: record it bending");
    case FingerDue::kCalibration:
      return FingerCards::tr("Due: calibrate it");
    case FingerDue::kFirstCheck:
    case FingerDue::kCheck:
      return FingerCards::tr("Due: a check");
    case FingerDue::kLook:
      return FingerCards::tr("Drifting: look at the last check");
    case FingerDue::kAgain:
      return FingerCards::tr("Due: calibrate it again");
    case FingerDue::kNothing:
      break;
  }
  return FingerCards::tr("Nothing is due");
}

/// The picture with the verdict's symbol in its corner.
QIcon picture_of(const FingerCard& card, const QPalette& palette, double ratio) {
  QPixmap picture(kCardPicture * ratio);
  picture.setDevicePixelRatio(ratio);
  picture.fill(palette.color(QPalette::Dark));
  QPainter painter(&picture);
  painter.setRenderHint(QPainter::SmoothPixmapTransform);
  const QRect whole(QPoint(0, 0), kCardPicture);
  if (card.picture.isNull()) {
    icon(QStringLiteral("finger"), palette).paint(&painter, whole.adjusted(40, 14, -40, -14));
  } else {
    QRect placed(QPoint(0, 0),
                 card.picture.size().scaled(kCardPicture, Qt::KeepAspectRatioByExpanding));
    placed.moveCenter(whole.center());
    painter.setClipRect(whole);
    painter.drawImage(placed, card.picture);
  }
  const Meaning meaning = meaning_of(card);
  const QString name = meaning == Meaning::kGood       ? QStringLiteral("good")
                       : meaning == Meaning::kDoubtful ? QStringLiteral("doubtful")
                                                       : QStringLiteral("bad");
  const QRect corner(whole.right() - kCardSymbol - 3, 4, kCardSymbol, kCardSymbol);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(Qt::NoPen);
  painter.setBrush(palette.color(QPalette::Base));
  painter.drawEllipse(corner.adjusted(-2, -2, 2, 2));
  painter.drawPixmap(corner, symbol(name, meaning_colour(meaning, palette), kCardSymbol, ratio));
  return QIcon(picture);
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
  if (reading_.is_running()) {
    connect(&reading_,
            &BackgroundWork::finished,
            this,
            &FingerCards::read,
            static_cast<Qt::ConnectionType>(Qt::SingleShotConnection | Qt::UniqueConnection));
    return;
  }
  reading_.start([this, folders = folders_](const Job& job) {
    std::vector<FingerCard> cards;
    for (const auto& folder : folders) {
      if (job.stop_requested() || cards.size() == kMost) break;
      if (auto card = read_finger_card(folder, utc_now())) cards.push_back(std::move(*card));
    }
    return std::function<void()>([this, cards] {
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
    grid_->addWidget(
        make_button(cards_[i]), static_cast<int>(i) / kColumns, static_cast<int>(i) % kColumns);
  setVisible(!cards_.empty());
}

QToolButton* FingerCards::make_button(const FingerCard& card) {
  auto* button = new QToolButton;
  button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  button->setIconSize(kCardPicture);
  button->setIcon(picture_of(card, palette(), devicePixelRatioF()));
  button->setFixedWidth(kCardWidth);
  const int room = kCardWidth - kCardPicture.width() - 30;
  QStringList lines;
  for (const QString& line :
       {QString::fromStdString(card.name), grade_word(card), dates_of(card), due_text(card.due)})
    if (!line.isEmpty()) lines << fontMetrics().elidedText(line, Qt::ElideRight, room);
  button->setText(lines.join(QLatin1Char('\n')).replace(QLatin1Char('&'), QLatin1String("&&")));
  button->setAccessibleName(tr("Open the finger %1").arg(QString::fromStdString(card.name)));
  button->setAccessibleDescription(
      QStringList{grade_word(card), dates_of(card), due_text(card.due)}.join(QLatin1String(". ")));
  button->setToolTip(QString::fromStdString(card.folder.string()));
  connect(button, &QToolButton::clicked, this, [this, folder = card.folder] {
    Q_EMIT finger_chosen(QString::fromStdString(folder.string()));
  });
  return button;
}

void FingerCards::changeEvent(QEvent* event) {
  Translated::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) rebuild();
}

/// What was done since is told.
void FingerCards::showEvent(QShowEvent* event) {
  Translated::showEvent(event);
  read();
}

}  // namespace alltact
