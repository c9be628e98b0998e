#include "widgets/shell/settings_dialog.h"

#include <QFormLayout>
#include <QHBoxLayout>
#include <QVBoxLayout>
#include <array>

namespace alltact {
namespace {

constexpr std::array kThemes{Theme::kSystem, Theme::kLight, Theme::kDark, Theme::kHighContrast};
constexpr std::array kLanguages{"", "en", "de", "zh_CN"};

}  // namespace

SettingsDialog::SettingsDialog(const Appearance& now, Pedal* pedal, QWidget* parent)
    : FittedDialog(parent),
      pedal_(pedal),
      theme_label_(new QLabel),
      language_label_(new QLabel),
      pedal_label_(new QLabel),
      pedal_text_(wrapped_label()),
      theme_(new QComboBox),
      language_(new QComboBox),
      learn_(new QPushButton),
      forget_(new QPushButton),
      buttons_(new QDialogButtonBox(QDialogButtonBox::Close)) {
  auto* layout = new QVBoxLayout(this);
  auto* form = new QFormLayout;
  form->addRow(theme_label_, theme_);
  form->addRow(language_label_, language_);
  theme_label_->setBuddy(theme_);
  language_label_->setBuddy(language_);
  form->addRow(pedal_label_, make_pedal());
  layout->addLayout(form);
  layout->addStretch();
  layout->addWidget(buttons_);
  for (std::size_t i = 0; i < kThemes.size(); ++i) theme_->addItem({});
  // Each language in its own words, so that its speakers find it.
  for (const char* name : {"", "English", "Deutsch", "简体中文"})
    language_->addItem(QString::fromUtf8(name));
  theme_->setCurrentIndex(
      static_cast<int>(std::find(kThemes.begin(), kThemes.end(), now.theme) - kThemes.begin()));
  for (std::size_t i = 0; i < kLanguages.size(); ++i)
    if (now.language == QLatin1String(kLanguages[i]))
      language_->setCurrentIndex(static_cast<int>(i));
  connect(theme_, &QComboBox::currentIndexChanged, this, &SettingsDialog::emit_choice);
  connect(language_, &QComboBox::currentIndexChanged, this, &SettingsDialog::emit_choice);
  connect(buttons_, &QDialogButtonBox::rejected, this, &QDialog::reject);
  say([this] {
    setWindowTitle(tr("Settings"));
    theme_label_->setText(tr("&Appearance"));
    language_label_->setText(tr("&Language"));
    theme_->setAccessibleName(tr("Appearance"));
    theme_->setToolTip(tr("Colours of all windows"));
    language_->setAccessibleName(tr("Language"));
    language_->setToolTip(tr("Language of all texts, and the form of numbers and dates"));
    theme_->setItemText(0, tr("Follow system"));
    theme_->setItemText(1, tr("Light"));
    theme_->setItemText(2, tr("Dark"));
    theme_->setItemText(3, tr("High contrast"));
    language_->setItemText(0, tr("Follow system"));
    pedal_label_->setText(tr("&Foot pedal"));
    forget_->setText(tr("&None"));
    forget_->setToolTip(tr("Stops using the pedal."));
    learn_->setToolTip(tr("Press the pedal or button after this click"));
    show_pedal();
    buttons_->button(QDialogButtonBox::Close)->setText(tr("&Close"));
    buttons_->button(QDialogButtonBox::Close)->setToolTip(tr("Closes this window (Esc)"));
  });
}

QWidget* SettingsDialog::make_pedal() {
  auto* container = new QWidget;
  auto* column = without_margins(new QVBoxLayout(container));
  auto* row = new QHBoxLayout;
  row->addWidget(learn_);
  row->addWidget(forget_);
  row->addStretch();
  column->addWidget(pedal_text_);
  column->addLayout(row);
  pedal_text_->setMinimumWidth(240);
  pedal_label_->setBuddy(learn_);
  connect(learn_, &QPushButton::clicked, this, [this] {
    if (pedal_->is_learning())
      pedal_->stop_learning();
    else
      pedal_->learn();
  });
  connect(forget_, &QPushButton::clicked, this, [this] { pedal_->listen(std::nullopt); });
  if (pedal_ != nullptr) connect(pedal_, &Pedal::changed, this, &SettingsDialog::show_pedal);
  return container;
}

void SettingsDialog::show_pedal() {
  const bool is_learning = pedal_ != nullptr && pedal_->is_learning();
  const bool is_chosen = pedal_ != nullptr && pedal_->button();
  learn_->setEnabled(pedal_ != nullptr);
  learn_->setText(is_learning ? tr("&Stop") : tr("&Learn by pressing it…"));
  learn_->setAccessibleName(is_learning ? tr("Stop learning the foot pedal")
                                        : tr("Learn the foot pedal by pressing it"));
  forget_->setEnabled(is_chosen && !is_learning);
  QString text = tr("None. A pedal takes presses on Calibrate; on Record it starts and stops.");
  if (is_chosen) text = QString::fromStdString(pedal_->button()->device);
  if (is_chosen && pedal_->problem()) text = tr("%1: no signal").arg(text);
  if (pedal_ != nullptr && !pedal_->learning_text().isEmpty() && (is_learning || !is_chosen))
    text = pedal_->learning_text();
  pedal_text_->setText(text);
}

void SettingsDialog::emit_choice() {
  Q_EMIT appearance_chosen(
      {kThemes[static_cast<std::size_t>(theme_->currentIndex())],
       QString::fromLatin1(kLanguages[static_cast<std::size_t>(language_->currentIndex())])});
}

}  // namespace alltact
