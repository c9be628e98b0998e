#include "app/studio/program_appearance.h"

#include <QApplication>
#include <QLibraryInfo>
#include <QLocale>
#include <QWidget>

namespace alltact {

void ProgramAppearance::apply(const Appearance& appearance) {
  appearance_ = appearance;
  QApplication::setPalette(theme_palette(appearance.theme));
  set_language(appearance.language.isEmpty() ? QLocale::system().name() : appearance.language);
}

void ProgramAppearance::set_language(const QString& language) {
  if (language == language_) return;
  language_ = language;
  QCoreApplication::removeTranslator(&app_translator_);
  QCoreApplication::removeTranslator(&qt_translator_);
  const QLocale locale(language);
  QLocale::setDefault(locale);
  // Open windows took the locale from before: their fields would go on writing its numbers.
  for (QWidget* window : QApplication::topLevelWidgets()) window->setLocale(locale);
  if (qt_translator_.load(locale,
                          QStringLiteral("qtbase"),
                          QStringLiteral("_"),
                          QLibraryInfo::path(QLibraryInfo::TranslationsPath)))
    QCoreApplication::installTranslator(&qt_translator_);
  // Plural forms need a translation, in English too: "1 frame", "2 frames".
  if (app_translator_.load(
          locale, QStringLiteral("alltact"), QStringLiteral("_"), QStringLiteral(":/i18n")) ||
      app_translator_.load(QStringLiteral(":/i18n/alltact_en")))
    QCoreApplication::installTranslator(&app_translator_);
}

}  // namespace alltact
