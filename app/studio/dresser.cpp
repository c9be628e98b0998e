#include "app/studio/dresser.h"

#include <QApplication>
#include <QLibraryInfo>
#include <QLocale>
#include <QWidget>

namespace alltact {

void Dresser::wear(const Appearance& appearance) {
  appearance_ = appearance;
  QApplication::setPalette(theme_palette(appearance.theme));
  speak(appearance.language.isEmpty() ? QLocale::system().name() : appearance.language);
}

void Dresser::speak(const QString& language) {
  if (language == spoken_) return;
  spoken_ = language;
  QCoreApplication::removeTranslator(&ours_);
  QCoreApplication::removeTranslator(&qt_);
  const QLocale locale(language);
  QLocale::setDefault(locale);
  // What stands already took the one before: its fields would go on writing numbers its way.
  for (QWidget* window : QApplication::topLevelWidgets()) window->setLocale(locale);
  if (qt_.load(locale,
               QStringLiteral("qtbase"),
               QStringLiteral("_"),
               QLibraryInfo::path(QLibraryInfo::TranslationsPath)))
    QCoreApplication::installTranslator(&qt_);
  // What is counted has its forms in a translation, in English too: "1 frame", "2 frames".
  if (ours_.load(
          locale, QStringLiteral("alltact"), QStringLiteral("_"), QStringLiteral(":/i18n")) ||
      ours_.load(QStringLiteral(":/i18n/alltact_en")))
    QCoreApplication::installTranslator(&ours_);
}

}  // namespace alltact
