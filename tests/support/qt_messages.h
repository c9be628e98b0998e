// What Qt says while tests run.
#pragma once

#include <QString>
#include <QtGlobal>
#include <cstdio>

namespace alltact::test {

/// Shows Qt's messages, without the one by which its offscreen platform answers every window: a
/// thousand of those hide what a failing test says.
inline void show_qt_messages() {
  qInstallMessageHandler([](QtMsgType, const QMessageLogContext&, const QString& message) {
    if (message != QLatin1String("This plugin does not support propagateSizeHints()"))
      std::fprintf(stderr, "%s\n", message.toUtf8().constData());
  });
}

}  // namespace alltact::test
