// What the place Inspect opens from files and saves into them.
#include "core/io/picture.h"
#include "widgets/inspect/save_inspected.h"
#include "widgets/language.h"
#include "widgets/places/inspect_place.h"

#include <QFileDialog>

namespace alltact {
void InspectPlace::choose_video() {
  auto* dialog =
      new QFileDialog(this, tr("Open a video"), QString(), tr("Videos (*.mkv *.avi *.mp4)"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setFileMode(QFileDialog::ExistingFile);
  connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& file) {
    open(file.toStdString());
  });
  dialog->show();
}

void InspectPlace::choose_folder() {
  auto* dialog = new QFileDialog(this, tr("Open a folder of pictures"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setFileMode(QFileDialog::Directory);
  connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& folder) {
    open(folder.toStdString());
  });
  dialog->show();
}

void InspectPlace::choose_file(const QString& ending) {
  auto* dialog = new QFileDialog(this, tr("Save what is shown"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setAcceptMode(QFileDialog::AcceptSave);
  dialog->setDefaultSuffix(ending);
  dialog->setNameFilter(QStringLiteral("*.") + ending);
  if (const auto& frame = inspection_.frame())
    dialog->selectFile(QString::fromStdString(frame->result.frame->name) + QLatin1Char('.') +
                       ending);
  connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& file) {
    save(file.toStdString());
  });
  dialog->show();
}

void InspectPlace::save(const std::filesystem::path& file) {
  if (!inspection_.frame() || saving_.is_running()) return;
  saved_->clear();
  saving_.start(saving_work(file));
  show_saving();
}

BackgroundWork::Work InspectPlace::saving_work(const std::filesystem::path& file) {
  const auto ended = [this](const Status& status, const std::vector<std::filesystem::path>& files) {
    return [this, status, files] { end_saving(status, files); };
  };
  if (file.extension() == ".png") {
    const QImage picture = first_->picture().convertToFormat(QImage::Format_BGR888);
    return [=](const Job&) {
      const cv::Mat pixels(picture.height(),
                           picture.width(),
                           CV_8UC3,
                           const_cast<uchar*>(picture.constBits()),
                           static_cast<std::size_t>(picture.bytesPerLine()));
      return ended(write_picture(file, pixels), {file});
    };
  }
  if (file.extension() == ".mkv") {
    FilmOptions film;
    film.finger = session_.status().finger.folder;
    film.input = options_.recording;
    film.view = options_;
    film.colours = scene_colours(palette());
    if (first_->face_pane() != nullptr) film.look = first_->face_pane()->scene().look();
    return [=](const Job& job) { return ended(save_film(film, file, job), {file}); };
  }
  if (const auto frames = pair_.frames(); frames && pair_.is_placed()) {
    const std::array<PlacedFrame, 2> both{
        PlacedFrame{frames->first, *pair_.place(false)->gripper_from_camera},
        PlacedFrame{frames->second, *pair_.place(true)->gripper_from_camera}};
    return [=](const Job&) { return ended(save_both(both, file), files_of_both(file)); };
  }
  const auto frame = inspection_.frame();
  return [=](const Job&) { return ended(save_surface(*frame, file), {file}); };
}

void InspectPlace::show_saving() {
  save_bar_->show_progress(saving_.is_running() ? std::optional(saving_.fraction()) : std::nullopt);
}

void InspectPlace::end_saving(const Status& status,
                              const std::vector<std::filesystem::path>& files) {
  QStringList names;
  for (const auto& file : files) names << text_of(file);
  saved_->setText(status ? tr("Saved: %1").arg(names.join(QStringLiteral(", ")))
                         : window_sentence(status.error().message()));
  saved_->setToolTip(saved_->text());
}

}  // namespace alltact
