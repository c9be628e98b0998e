#include "widgets/panels/snapshot.h"

#include "widgets/grey_image.h"

#include <QCoreApplication>
#include <QDateTime>
#include <QDir>
#include <QFileDialog>
#include <QMessageBox>
#include <QPainter>
#include <QStandardPaths>

namespace alltact {
namespace {

struct SnapshotWords {
  Q_DECLARE_TR_FUNCTIONS(alltact::SnapshotWords)
 public:
  static QString title() { return tr("Save the picture"); }
  static QString drawn() { return tr("As it is shown (*.png)"); }
  static QString bare() { return tr("The camera's picture alone (*.png)"); }
  static QString failed(const QString& file) {
    return tr("%1 could not be written. Choose another folder, or make room on the disk.")
        .arg(QDir::toNativeSeparators(file));
  }
};

QString proposed_file() {
  const QDir images_dir(QStandardPaths::writableLocation(QStandardPaths::PicturesLocation));
  const QDir where = images_dir.exists() ? images_dir : QDir::home();
  return where.filePath(
      QStringLiteral("finger_%1.png")
          .arg(QDateTime::currentDateTime().toString(QStringLiteral("yyyy-MM-dd_HHmmss"))));
}

}  // namespace

QImage image_with_overlays(const cv::Mat& grey, const std::vector<Overlay>& overlays) {
  QImage image = grey_image(grey).convertToFormat(QImage::Format_RGB32);
  QPainter painter(&image);
  painter.setRenderHint(QPainter::Antialiasing);
  for (const Overlay& overlay : overlays) {
    painter.save();
    overlay(painter, ImageTransform());
    painter.restore();
  }
  return image;
}

void choose_snapshot(const cv::Mat& grey, const std::vector<Overlay>& overlays, QWidget& parent) {
  auto* dialog = new QFileDialog(&parent, SnapshotWords::title(), proposed_file());
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setAcceptMode(QFileDialog::AcceptSave);
  dialog->setDefaultSuffix(QStringLiteral("png"));
  dialog->setNameFilters({SnapshotWords::drawn(), SnapshotWords::bare()});
  const QImage drawn = image_with_overlays(grey, overlays), bare = grey_image(grey).copy();
  QObject::connect(dialog,
                   &QFileDialog::fileSelected,
                   &parent,
                   [drawn, bare, dialog, &parent](const QString& file) {
                     const bool is_bare = dialog->selectedNameFilter() == SnapshotWords::bare();
                     if ((is_bare ? bare : drawn).save(file, "PNG")) return;
                     auto* box = new QMessageBox(QMessageBox::Warning,
                                                 SnapshotWords::title(),
                                                 SnapshotWords::failed(file),
                                                 QMessageBox::Ok,
                                                 &parent);
                     box->setAttribute(Qt::WA_DeleteOnClose);
                     box->show();
                   });
  dialog->show();
}

}  // namespace alltact
