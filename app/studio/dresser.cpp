#include "app/studio/dresser.h"

#include <QApplication>
#include <QLibraryInfo>
#include <QLocale>

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
  if (qt_.load(locale,
               QStringLiteral("qtbase"),
               QStringLiteral("_"),
               QLibraryInfo::path(QLibraryInfo::TranslationsPath)))
    QCoreApplication::installTranslator(&qt_);
  if (ours_.load(locale, QStringLiteral("alltact"), QStringLiteral("_"), QStringLiteral(":/i18n")))
    QCoreApplication::installTranslator(&ours_);
}

}  // namespace alltact
