#include "widgets/inspect/recordings_dialog.h"

#include "calibration/reference/make_reference.h"
#include "core/open/open_source.h"
#include "core/sources/file_source.h"
#include "widgets/image/image_view.h"
#include "widgets/language.h"
#include "widgets/theme.h"

#include <QDesktopServices>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QMessageBox>
#include <QPainter>
#include <QStandardPaths>
#include <QUrl>
#include <QVBoxLayout>
#include <algorithm>

namespace alltact {
namespace {

const QSize kThumbnail(128, 72);

QString text_of(const std::filesystem::path& path) { return QString::fromStdString(path.string()); }

}  // namespace

QString minutes_text(double seconds) {
  const int total_s = static_cast<int>(seconds);
  return QStringLiteral("%1:%2").arg(total_s / 60).arg(total_s % 60, 2, 10, QLatin1Char('0'));
}

bool move_recording_to_trash(const std::filesystem::path& video) {
  // The trash is in this folder; without it, Qt 6.4 creates one in the current folder.
  QDir().mkpath(QStandardPaths::writableLocation(QStandardPaths::GenericDataLocation));
  if (!QFile::moveToTrash(text_of(video))) return false;
  QFile::moveToTrash(text_of(std::filesystem::path(video).replace_extension(".frames.csv")));
  return true;
}

RecordingsDialog::RecordingsDialog(std::filesystem::path finger, QWidget* parent)
    : FittedDialog(parent),
      finger_(std::move(finger)),
      note_(wrapped_label()),
      list_(new QListWidget),
      open_(new QAction(this)),
      folder_(new QAction(this)),
      trash_(new QAction(this)),
      open_button_(new QPushButton),
      buttons_(new QDialogButtonBox(QDialogButtonBox::Close)) {
  auto* column = new QVBoxLayout(this);
  list_->setIconSize(kThumbnail);
  list_->setUniformItemSizes(true);
  list_->setContextMenuPolicy(Qt::ActionsContextMenu);
  trash_->setShortcut(Qt::Key_Delete);
  for (QAction* action : {open_, folder_, trash_}) {
    action->setShortcutContext(Qt::WidgetShortcut);
    list_->addAction(action);
  }
  add_widgets(*column, {note_, list_});
  auto* row = new QHBoxLayout;
  row->addWidget(open_button_);
  row->addStretch();
  row->addWidget(buttons_);
  column->addLayout(row);
  set_primary(*open_button_);
  connect(&reading_, &BackgroundWork::finished, this, &RecordingsDialog::read_next);
  connect(list_, &QListWidget::itemActivated, this, &RecordingsDialog::open_chosen);
  connect(list_, &QListWidget::currentRowChanged, this, &RecordingsDialog::follow_choice);
  connect(open_, &QAction::triggered, this, &RecordingsDialog::open_chosen);
  connect(open_button_, &QPushButton::clicked, this, &RecordingsDialog::open_chosen);
  connect(trash_, &QAction::triggered, this, &RecordingsDialog::ask_for_trash);
  connect(folder_, &QAction::triggered, this,
          [this] { QDesktopServices::openUrl(QUrl::fromLocalFile(text_of(finger_))); });
  connect(buttons_, &QDialogButtonBox::rejected, this, &QDialog::reject);
  resize(480, 480);
  say([this] {
    setWindowTitle(tr("Recordings of %1").arg(text_of(finger_.filename())));
    list_->setAccessibleName(tr("Recordings, newest first"));
    list_->setToolTip(tr("Double click or Return opens a recording; Delete moves it to the trash"));
    open_->setText(tr("&Open"));
    folder_->setText(tr("&Show in folder"));
    trash_->setText(tr("&Move to the trash…"));
    open_button_->setText(tr("&Open"));
    open_button_->setToolTip(tr("Opens the selected recording on this page (Return)"));
    buttons_->button(QDialogButtonBox::Close)->setText(tr("&Close"));
    buttons_->button(QDialogButtonBox::Close)->setToolTip(tr("Closes this window (Esc)"));
    fill();
  });
  list_files();
}

void RecordingsDialog::list_files() {
  reading_.start([this, finger = finger_](const Job& job) {
    std::vector<Recording> found;
    std::error_code failed;
    for (std::filesystem::directory_iterator entry(finger, failed), end; !failed && entry != end;
         entry.increment(failed)) {
      if (job.stop_requested()) break;
      const QFileInfo info(text_of(entry->path()));
      if (!info.isFile() || !is_video(entry->path())) continue;
      found.push_back({entry->path(),
                       info.lastModified(),
                       entry->path().filename() == kReferenceVideo,
                       false,
                       {},
                       {}});
    }
    std::sort(found.begin(), found.end(), [](const Recording& a, const Recording& b) {
      return a.written != b.written ? a.written > b.written : a.file < b.file;
    });
    return std::function<void()>([this, found = std::move(found)] {
      recordings_ = found;
      is_listed_ = true;
      fill();
    });
  });
}

/// One after the other, so that each is shown as soon as it is read.
void RecordingsDialog::read_next() {
  const auto next = std::find_if(recordings_.begin(), recordings_.end(),
                                 [](const Recording& recording) { return !recording.is_read; });
  if (next == recordings_.end()) return;
  reading_.start([this, file = next->file](const Job& job) {
    QImage image;
    std::optional<double> length_s;
    if (auto frames = RecordedFrames::open(file, job)) {
      length_s = static_cast<double>(frames->count()) / std::max(frames->frames_per_s(), 1e-3);
      if (const auto frame = frames->frame(frames->count() / 2))
        image = image_with_overlays((*frame)->grey, {})
                    .scaled(2 * kThumbnail, Qt::KeepAspectRatio, Qt::SmoothTransformation);
    }
    return std::function<void()>([this, file, image, length_s] {
      for (std::size_t i = 0; i < recordings_.size(); ++i) {
        if (recordings_[i].file != file) continue;
        recordings_[i].is_read = true;
        recordings_[i].image = image;
        recordings_[i].length_s = length_s;
        show_row(static_cast<int>(i));
      }
    });
  });
}

void RecordingsDialog::fill() {
  const int before = std::max(list_->currentRow(), 0);
  list_->clear();
  for (int i = 0; i < static_cast<int>(recordings_.size()); ++i) {
    new QListWidgetItem(list_);
    show_row(i);
  }
  list_->setCurrentRow(std::min(before, list_->count() - 1));
  note_->setText(!is_listed_           ? tr("The folder is being read.")
                 : recordings_.empty() ? tr("The finger's folder has no video yet.")
                                       : text_of(finger_));
  follow_choice();
}

void RecordingsDialog::show_row(int row) {
  const Recording& recording = recordings_[static_cast<std::size_t>(row)];
  QListWidgetItem* item = list_->item(row);
  QStringList facts{moment_text(recording.written)};
  if (recording.length_s)
    facts << tr("%1 min").arg(minutes_text(*recording.length_s));
  else if (recording.is_read)
    facts << tr("cannot be read");
  QStringList lines{text_of(recording.file.filename()), joined(facts)};
  if (recording.is_reference) lines << tr("The finger's reference");
  item->setText(lines.join(QLatin1Char('\n')));
  item->setToolTip(text_of(recording.file));
  // The same size with and without a frame, so that no row moves.
  QPixmap thumbnail(kThumbnail * devicePixelRatioF());
  thumbnail.setDevicePixelRatio(devicePixelRatioF());
  thumbnail.fill(palette().color(QPalette::Dark));
  if (!recording.image.isNull()) {
    QPainter painter(&thumbnail);
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    QRect box(QPoint(), recording.image.size().scaled(kThumbnail, Qt::KeepAspectRatio));
    box.moveCenter(QRect(QPoint(), kThumbnail).center());
    painter.drawImage(box, recording.image);
  }
  QIcon frame(thumbnail);
  frame.addPixmap(thumbnail, QIcon::Selected);  // not tinted
  item->setIcon(frame);
}

const RecordingsDialog::Recording* RecordingsDialog::selected() const {
  const int row = list_->currentRow();
  return row < 0 ? nullptr : &recordings_[static_cast<std::size_t>(row)];
}

void RecordingsDialog::follow_choice() {
  const Recording* recording = selected();
  open_button_->setEnabled(recording != nullptr);
  open_->setEnabled(recording != nullptr);
  trash_->setEnabled(recording != nullptr && !recording->is_reference);
}

void RecordingsDialog::open_chosen() {
  const Recording* recording = selected();
  if (recording == nullptr || !isVisible()) return;  // Return also clicks the button
  Q_EMIT chosen(recording->file);
  accept();
}

void RecordingsDialog::ask_for_trash() {
  const Recording* recording = selected();
  if (recording == nullptr || recording->is_reference) return;
  auto* box = new QMessageBox(QMessageBox::Question, tr("Move to the trash"),
                              tr("Move %1 to the trash?").arg(text_of(recording->file.filename())),
                              QMessageBox::NoButton, this);
  auto* move = box->addButton(tr("&Move to the trash"), QMessageBox::DestructiveRole);
  auto* cancel = box->addButton(tr("&Cancel"), QMessageBox::RejectRole);
  box->setDefaultButton(move);
  box->setEscapeButton(cancel);
  connect(move, &QPushButton::clicked, this, [this, file = recording->file] { remove(file); });
  show_dialog(*box);
}

void RecordingsDialog::remove(const std::filesystem::path& file) {
  if (!move_recording_to_trash(file))
    return note_->setText(
        tr("%1 cannot be moved to the trash. Delete it in its folder.").arg(text_of(file)));
  std::erase_if(recordings_, [&](const Recording& recording) { return recording.file == file; });
  fill();
}

}  // namespace alltact
