#include "widgets/shell/settings_dialog.h"

#include <QFormLayout>
#include <QPushButton>
#include <QVBoxLayout>
#include <array>

namespace alltact {
namespace {

constexpr std::array kThemes{Theme::kSystem, Theme::kLight, Theme::kDark, Theme::kHighContrast};
constexpr std::array kLanguages{"", "en", "de", "zh_CN"};

}  // namespace

SettingsDialog::SettingsDialog(const Appearance& now, QWidget* parent)
    : Translated(parent),
      theme_label_(new QLabel),
      language_label_(new QLabel),
      theme_(new QComboBox),
      language_(new QComboBox),
      buttons_(new QDialogButtonBox(QDialogButtonBox::Close)) {
  auto* layout = new QVBoxLayout(this);
  auto* form = new QFormLayout;
  form->addRow(theme_label_, theme_);
  form->addRow(language_label_, language_);
  theme_label_->setBuddy(theme_);
  language_label_->setBuddy(language_);
  layout->addLayout(form);
  layout->addStretch();
  layout->addWidget(buttons_);
  for (std::size_t i = 0; i < kThemes.size(); ++i) theme_->addItem({});
  // Each language in its own words, so that everyone finds theirs.
  for (const char* name : {"", "English", "Deutsch", "简体中文"})
    language_->addItem(QString::fromUtf8(name));
  theme_->setCurrentIndex(
      static_cast<int>(std::find(kThemes.begin(), kThemes.end(), now.theme) - kThemes.begin()));
  for (std::size_t i = 0; i < kLanguages.size(); ++i)
    if (now.language == QLatin1String(kLanguages[i]))
      language_->setCurrentIndex(static_cast<int>(i));
  connect(theme_, &QComboBox::currentIndexChanged, this, &SettingsDialog::tell);
  connect(language_, &QComboBox::currentIndexChanged, this, &SettingsDialog::tell);
  connect(buttons_, &QDialogButtonBox::rejected, this, &QDialog::reject);
  say([this] {
    setWindowTitle(tr("Settings"));
    theme_label_->setText(tr("&Appearance"));
    language_label_->setText(tr("&Language"));
    theme_->setAccessibleName(tr("Appearance"));
    language_->setAccessibleName(tr("Language"));
    theme_->setItemText(0, tr("As the system"));
    theme_->setItemText(1, tr("Light"));
    theme_->setItemText(2, tr("Dark"));
    theme_->setItemText(3, tr("High contrast"));
    language_->setItemText(0, tr("As the system"));
    buttons_->button(QDialogButtonBox::Close)->setText(tr("&Close"));
  });
}

void SettingsDialog::tell() {
  Q_EMIT appearance_chosen(
      {kThemes[static_cast<std::size_t>(theme_->currentIndex())],
       QString::fromLatin1(kLanguages[static_cast<std::size_t>(language_->currentIndex())])});
}

}  // namespace alltact
