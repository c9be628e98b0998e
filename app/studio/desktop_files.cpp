#include "app/studio/desktop_files.h"

#include <QDesktopServices>
#include <QProcess>
#include <QStandardPaths>

namespace alltact {
namespace {

Error nothing_opens(const QUrl& file) {
  return {en::say("no program on this computer opens this file"), file.toLocalFile().toStdString(),
          en::say("install one, such as a web browser for reports, or open the file on another "
                  "computer")};
}

}  // namespace

DesktopFiles::DesktopFiles(QObject* parent) : QObject(parent) {
  QDesktopServices::setUrlHandler(QStringLiteral("file"), this, "open");
}

DesktopFiles::~DesktopFiles() { QDesktopServices::unsetUrlHandler(QStringLiteral("file")); }

void DesktopFiles::open(const QUrl& file) {
  const QString opener = QStandardPaths::findExecutable(QStringLiteral("xdg-open"));
  if (opener.isEmpty()) {
    if (!QDesktopServices::openUrl(file)) Q_EMIT failed(nothing_opens(file));
    return;
  }
  auto* process = new QProcess;  // without a parent: the opened program outlives the window
  connect(process, &QProcess::finished, process, &QObject::deleteLater);
  connect(process, &QProcess::errorOccurred, this,
          [this, process, file](QProcess::ProcessError error) {
            if (error != QProcess::FailedToStart) return;  // which never finishes
            process->deleteLater();
            Q_EMIT failed(nothing_opens(file));
          });
  connect(process, &QProcess::finished, this, [this, file](int code, QProcess::ExitStatus status) {
    if (code != 0 || status != QProcess::NormalExit) Q_EMIT failed(nothing_opens(file));
  });
  process->setStandardOutputFile(QProcess::nullDevice());
  process->setStandardErrorFile(QProcess::nullDevice());
  process->start(opener, {file.toLocalFile()});
}

}  // namespace alltact
