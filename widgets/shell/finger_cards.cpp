#include "widgets/shell/finger_cards.h"

#include "core/utc_time.h"
#include "widgets/shell/finger_card_words.h"
#include "widgets/shell/icons.h"

#include <QEvent>
#include <QPainter>

namespace alltact {
namespace {

constexpr int kCardColumns = 2;
constexpr QSize kCardImage(128, 72);
constexpr int kCardWidth = 290, kCardSymbol = 22;
constexpr int kCardTextMargin = kCardImage.width() + 30;  // px of a card

/// The image with the verdict's symbol in its corner.
QIcon icon_of(const FingerCard& card, const QPalette& palette, double ratio) {
  QPixmap image(kCardImage * ratio);
  image.setDevicePixelRatio(ratio);
  image.fill(palette.color(QPalette::Dark));
  QPainter painter(&image);
  painter.setRenderHint(QPainter::SmoothPixmapTransform);
  const QRect card_box(QPoint(0, 0), kCardImage);
  if (card.image.isNull()) {
    icon(QStringLiteral("finger"), palette).paint(&painter, card_box.adjusted(40, 14, -40, -14));
  } else {
    QRect image_box(QPoint(0, 0),
                    card.image.size().scaled(kCardImage, Qt::KeepAspectRatioByExpanding));
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
  painter.drawPixmap(
      corner,
      symbol(meaning_symbol(meaning), meaning_colour(meaning, palette), kCardSymbol, ratio));
  return QIcon(image);
}

QStringList lines_of(const FingerCard& card) {
  QStringList lines;
  for (const QString& line :
       {QString::fromStdString(card.name), headline_of(card).text, dates_of(card), due_text(card)})
    if (!line.isEmpty()) lines << line;
  return lines;
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
    grid_->addWidget(make_button(cards_[i]),
                     static_cast<int>(i) / kCardColumns,
                     static_cast<int>(i) % kCardColumns);
  fit();
  setVisible(!cards_.empty());
  Q_EMIT filled();
}

QToolButton* FingerCards::make_button(const FingerCard& card) {
  auto* button = new QToolButton;
  button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  button->setIconSize(kCardImage);
  button->setIcon(icon_of(card, palette(), devicePixelRatioF()));
  button->setMinimumWidth(kCardWidth);
  button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  button->setAccessibleName(tr("Open the finger %1").arg(QString::fromStdString(card.name)));
  QStringList lines = lines_of(card);
  if (const QString findings = findings_text(card); !findings.isEmpty()) lines << findings;
  button->setAccessibleDescription(lines.mid(1).join(QLatin1String(". ")));
  lines << QString::fromStdString(card.folder.string());
  button->setToolTip(lines.join(QLatin1Char('\n')));
  connect(button, &QToolButton::clicked, this, [this, folder = card.folder] {
    Q_EMIT finger_chosen(QString::fromStdString(folder.string()));
  });
  return button;
}

/// The tool tip holds text that does not fit into its card.
void FingerCards::fit() {
  for (std::size_t i = 0; i < cards_.size(); ++i) {
    auto* button = static_cast<QToolButton*>(grid_->itemAt(static_cast<int>(i))->widget());
    const int room =
        std::max(kCardWidth, (width() - grid_->spacing()) / kCardColumns) - kCardTextMargin;
    QStringList lines;
    for (const QString& line : lines_of(cards_[i]))
      lines << fontMetrics().elidedText(line, Qt::ElideRight, room);
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

}  // namespace alltact
