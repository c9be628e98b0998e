// Opening and saving files in the page Inspect.
#include "core/io/atomic_file.h"
#include "widgets/joined_words.h"
#include "widgets/language.h"
#include "widgets/pages/inspect_page.h"
#include "widgets/theme.h"

#include <QFileDialog>

namespace alltact {

void InspectPage::choose_video() {
  auto* dialog =
      new QFileDialog(this, tr("Open a video"), QString(), tr("Videos (*.mkv *.avi *.mp4)"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setFileMode(QFileDialog::ExistingFile);
  connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& file) {
    open(file.toStdString());
  });
  dialog->show();
}

void InspectPage::choose_folder() {
  auto* dialog = new QFileDialog(this, tr("Open a folder of pictures"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setFileMode(QFileDialog::Directory);
  connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& folder) {
    open(folder.toStdString());
  });
  dialog->show();
}

void InspectPage::choose_file(const QString& ending) {
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

void InspectPage::save(const std::filesystem::path& file) {
  if (!inspection_.frame() || saving_.is_running()) return;
  saved_->clear();
  const std::string ending = file.extension().string();
  if (ending == ".pdf" || ending == ".svg" || ending == ".csv")
    return end_saving(save_section(file), {file});
  saving_.start(saving_work(file));
  show_saving();
}

CanSave InspectPage::can_save() const {
  const auto& frame = inspection_.frame();
  CanSave can;
  can.surface = frame && frame->surface;
  can.image = frame && (frame->surface || frame->bare);
  can.section = !side_->section().is_empty();
  can.film = can.image && (options_.recording.empty() || inspection_.recording());
  return can;
}

/// The cross-section as shown, for a paper: on white, whatever the theme.
Status InspectPage::save_section(const std::filesystem::path& file) {
  SectionPlot& section = side_->section();
  if (section.is_empty())
    return Error{
        en::say("there is no cross-section"), file.string(), en::say("two points, A and B")};
  if (file.extension() == ".csv") return write_file_atomically(file, section.csv().toStdString());
  const QPalette before = section.palette();
  section.setPalette(theme_palette(Theme::kLight));
  const QSize size(560, 320);
  const Status status =
      write_file_atomically(file, [&](const std::filesystem::path& temporary) -> Status {
        const QString name = text_of(temporary);
        if (file.extension() == ".pdf" ? section.save_pdf(name, size)
                                       : section.save_svg(name, size))
          return {};
        return Error{en::say("the figure cannot be written"),
                     file.string(),
                     en::say("another folder, or freeing some space")};
      });
  section.setPalette(before);
  return status;
}

FilmView InspectPage::film_view() const {
  FilmView view;
  view.options = options_;
  view.colours = scene_colours(palette());
  if (first_->face_pane() != nullptr)
    view.options.view_pose = first_->face_pane()->scene().view_pose();
  return view;
}

FilmMoment InspectPage::film_moment() const {
  FilmMoment moment{inspection_.frame(), nullptr};
  if (options_.second) moment.second = pair_.second().frame();
  if (pair_.frames() && pair_.has_both_poses()) {
    moment.poses = {*pair_.mount(false)->gripper_from_camera,
                    *pair_.mount(true)->gripper_from_camera};
    moment.gap = pair_.gap();
  }
  if (first_->face_pane() != nullptr) moment.view_pose = first_->face_pane()->scene().view_pose();
  return moment;
}

BackgroundWork::Work InspectPage::image_work(const std::filesystem::path& file) {
  const auto ended = [this, file](const Status& status) {
    return [this, file, status] { end_saving(status, {file}); };
  };
  const QSize pane = first_->image_size();
  if (first_->is_3d()) {
    FilmView view = film_view();
    const int panes = second_->isVisible() ? 2 : 1;
    view.size_px = cv::Size(panes * pane.width(), pane.height());
    return [=, moment = film_moment()](const Job&) {
      return ended(save_paper_figure(moment, view, file));
    };
  }
  const QImage image = first_->map_image(kPaperWidth_px / std::max(1, pane.width()));
  return [=](const Job&) {
    const cv::Mat pixels(image.height(),
                         image.width(),
                         CV_8UC3,
                         const_cast<uchar*>(image.constBits()),
                         static_cast<std::size_t>(image.bytesPerLine()));
    return ended(write_paper_figure(file, pixels));
  };
}

BackgroundWork::Work InspectPage::film_work(const std::filesystem::path& file) {
  if (options_.recording.empty()) {
    live_film_ = std::make_shared<FilmQueue>();
    live_film_->add(film_moment());
    return [this, file, queue = live_film_, view = film_view()](const Job& job) {
      const Status status = save_live_film(*queue, view, file, job);
      return std::function<void()>([this, file, status] {
        live_film_.reset();
        end_saving(status, {file});
      });
    };
  }
  FilmOptions film;
  film.finger = session_.status().finger.folder;
  film.input = options_.recording;
  film.view = film_view();
  film.poses = film_moment().poses;
  return [this, film, file](const Job& job) {
    const Status status = save_film(film, file, job);
    return std::function<void()>([this, file, status] { end_saving(status, {file}); });
  };
}

BackgroundWork::Work InspectPage::saving_work(const std::filesystem::path& file) {
  if (file.extension() == ".png") return image_work(file);
  if (file.extension() == ".mkv") return film_work(file);
  const auto ended = [this](const Status& status, const std::vector<std::filesystem::path>& files) {
    return [this, status, files] { end_saving(status, files); };
  };
  if (const auto frames = pair_.frames(); frames && pair_.has_both_poses()) {
    const std::array<PosedFrame, 2> both{
        PosedFrame{frames->first, *pair_.mount(false)->gripper_from_camera},
        PosedFrame{frames->second, *pair_.mount(true)->gripper_from_camera}};
    return [=](const Job&) { return ended(save_both(both, file), files_of_both(file)); };
  }
  const auto frame = inspection_.frame();
  return [=](const Job&) { return ended(save_surface(*frame, file), {file}); };
}

void InspectPage::show_saving() {
  const double fraction = live_film_ ? -1.0 : saving_.fraction();  // its length is unknown
  save_bar_->show_progress(saving_.is_running() ? std::optional(fraction) : std::nullopt);
}

void InspectPage::end_saving(const Status& status,
                             const std::vector<std::filesystem::path>& files) {
  QStringList names;
  for (const auto& file : files) names << text_of(file);
  saved_->setText(status ? tr("Saved: %1").arg(listed(names))
                         : window_sentence(status.error().message()));
  saved_->setToolTip(saved_->text());
}

}  // namespace alltact
