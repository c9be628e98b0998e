// Opens files in the desktop's programs, and reports where that fails.
#pragma once

#include "core/base/result.h"

#include <QObject>
#include <QUrl>

namespace alltact {

/// While it lives, QDesktopServices opens files and folders through it. Qt itself reports success
/// as soon as it has started the desktop's opener, also where no program can show the file.
class DesktopFiles : public QObject {
  Q_OBJECT
 public:
  explicit DesktopFiles(QObject* parent = nullptr);
  ~DesktopFiles() override;

  Q_INVOKABLE void open(const QUrl& file);

 Q_SIGNALS:
  /// No program showed a file; the error names it.
  void failed(const alltact::Error& why);
};

}  // namespace alltact
