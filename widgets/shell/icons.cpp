#include "widgets/shell/icons.h"

#include <QFile>
#include <QPainter>
#include <QPixmapCache>
#include <QSvgRenderer>
#include <cmath>

namespace alltact {

QPixmap symbol(const QString& name, const QColor& colour, int size, double ratio) {
  // Cached: every image panel has the same buttons, and a new theme draws all of them again.
  const QString key =
      QStringLiteral("alltact %1 %2 %3 %4").arg(name, colour.name()).arg(size).arg(ratio);
  QPixmap pixmap;
  if (QPixmapCache::find(key, &pixmap)) return pixmap;
  QFile file(QStringLiteral(":/alltact/icons/%1.svg").arg(name));
  pixmap = QPixmap(QSize(size, size) * ratio);
  pixmap.setDevicePixelRatio(ratio);
  pixmap.fill(Qt::transparent);
  if (!file.open(QIODevice::ReadOnly)) return pixmap;
  QSvgRenderer renderer(file.readAll().replace("currentColor", colour.name().toLatin1()));
  QPainter painter(&pixmap);
  renderer.render(&painter, QRectF(0, 0, size, size));
  painter.end();
  QPixmapCache::insert(key, pixmap);
  return pixmap;
}

QIcon icon(const QString& name, const QPalette& palette) {
  QIcon icon;
  for (const int size : {16, 24, 32})
    for (const double ratio : {1.0, 2.0}) {
      const auto add = [&](QPalette::ColorGroup group, QIcon::Mode mode) {
        icon.addPixmap(symbol(name, palette.color(group, QPalette::ButtonText), size, ratio), mode);
      };
      add(QPalette::Active, QIcon::Normal);
      add(QPalette::Disabled, QIcon::Disabled);
    }
  return icon;
}

QString meaning_symbol(Meaning meaning) {
  switch (meaning) {
    case Meaning::kGood:
      return QStringLiteral("good");
    case Meaning::kDoubtful:
      return QStringLiteral("doubtful");
    case Meaning::kBad:
      break;
  }
  return QStringLiteral("bad");
}

}  // namespace alltact
