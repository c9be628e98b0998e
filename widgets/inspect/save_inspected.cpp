#include "widgets/inspect/save_inspected.h"

#include "core/base/atomic_file.h"
#include "core/image/image_file.h"
#include "core/mesh/surface_file.h"
#include "core/sensing/face/rectified_map.h"
#include "core/sources/file_source.h"
#include "widgets/inspect/inspection.h"

#include <QHBoxLayout>
#include <QImage>
#include <QStandardItemModel>
#include <QString>
#include <chrono>
#include <cmath>

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

namespace alltact {
namespace {

Error no_face(const std::filesystem::path& file) {
  return {en::say("there is no face to save"), file, en::say("another frame")};
}

bool is_map(const std::filesystem::path& file) { return file.extension() == ".tiff"; }

Status save_map(const InspectedFrame& frame, const std::filesystem::path& file) {
  const RectifiedMap map = rectified_map(frame.result.depth->depth_mm, *frame.result.shape);
  return write_file_atomically(file, depth_tiff(map.values, map.plane));
}

}  // namespace

Status save_surface(const InspectedFrame& frame, const std::filesystem::path& file) {
  if (!frame.result.depth) return no_face(file);
  if (is_map(file)) return save_map(frame, file);
  const FaceVertices vertices = contact_face_vertices(frame.result, frame.face);
  return write_surface(file, vertices.points_mm, vertices.depth_mm);
}

std::vector<std::filesystem::path> files_of_both(const std::filesystem::path& file) {
  std::vector<std::filesystem::path> files;
  for (const char* number : {"-1", "-2"})
    files.push_back(file.parent_path() /
                    (file.stem().string() + number + file.extension().string()));
  return files;
}

Status save_both(const FramePair& frames, const std::filesystem::path& file) {
  const auto files = files_of_both(file);
  for (std::size_t i = 0; i < files.size(); ++i) {
    const InspectedFrame& frame = i == 0 ? *frames.first : *frames.second;
    if (!frame.result.depth) return no_face(files[i]);
    if (is_map(file)) {  // each in its own plane
      if (const Status status = save_map(frame, files[i]); !status) return status;
      continue;
    }
    FaceVertices vertices = contact_face_vertices(frame.result, frame.face);
    vertices.points_mm.forEach<cv::Vec3f>([&](cv::Vec3f& p, const int*) {
      const Eigen::Vector3d at = (*frames.poses)[i].point({p[0], p[1], p[2]});
      p = cv::Vec3d(at.x(), at.y(), at.z());
    });
    const Status status = write_surface(files[i], vertices.points_mm, vertices.depth_mm);
    if (!status) return status;
  }
  return {};
}

namespace {

/// Packs a colour image as a frame, already encoded as JPEG.
Frame frame_of(const cv::Mat& bgr, const Frame& from, std::size_t number) {
  Frame frame;
  frame.name = from.name;
  frame.origin = from.origin;
  frame.sequence = number;
  frame.time_ns = from.time_ns;
  auto jpeg = std::make_shared<std::vector<std::uint8_t>>();
  constexpr int kQuality = 95;
  cv::imencode(".jpg", bgr, *jpeg, {cv::IMWRITE_JPEG_QUALITY, kQuality});
  cv::cvtColor(bgr, frame.grey, cv::COLOR_BGR2GRAY);
  frame.jpeg = std::move(jpeg);
  return frame;
}

bool is_side_by_side(const FilmView& view, const FramePair& moment) {
  return moment.second ? !moment.poses : view.options.shown_comparison() == Comparison::kSideBySide;
}

/// Renders faces without a window.
class FilmRenderer {
 public:
  /// Error: no OpenGL.
  static Result<FilmRenderer> create(const FilmView& view) {
    // Three panes are made where two fingers or measurements may be shown; a moment uses one or
    // two.
    const bool may_be_two =
        view.options.second || view.options.shown_comparison() == Comparison::kSideBySide;
    std::vector<OffscreenScene> panes;
    const cv::Size half(view.size_px.width / 2, view.size_px.height);
    for (const cv::Size& size :
         may_be_two ? std::vector{view.size_px, half, half} : std::vector{view.size_px}) {
      auto pane = OffscreenScene::create(size, view.pixels_per_unit);
      if (!pane) return pane.error();
      pane->scene().set_options(view.options.scene);
      pane->scene().set_colours(view.colours);
      pane->scene().set_viewpoint(view.options.viewpoint);
      if (view.options.view_pose) pane->scene().set_view_pose(*view.options.view_pose);
      panes.push_back(std::move(*pane));
    }
    return FilmRenderer(view, std::move(panes));
  }

  /// The moment has a face. Returns CV_8UC3, BGR.
  cv::Mat operator()(const FramePair& moment) {
    if (moment.view_pose && !(view_pose_ && *view_pose_ == *moment.view_pose)) {
      view_pose_ = moment.view_pose;
      for (OffscreenScene& pane : panes_) pane.scene().set_view_pose(*view_pose_);
    }
    const auto draw = [&](OffscreenScene& pane, const FramePair& shown, PaneContent content,
                          bool has_marks = true) {
      show_in(pane.scene(), shown, content);
      pane.scene().set_marks(has_marks ? marks_of(*shown.first, view_.options) : SceneMarks());
      return pane.image();
    };
    if (is_side_by_side(view_, moment) && panes_.size() > 1) {
      const cv::Mat left = draw(panes_[1], {moment.first}, PaneContent::kFirst);
      const cv::Mat right = moment.second
                                ? draw(panes_[2], {moment.second}, PaneContent::kFirst, false)
                                : draw(panes_[2], {moment.first}, PaneContent::kSecond);
      cv::Mat both;
      cv::hconcat(left, right, both);
      return both;
    }
    const bool is_difference = view_.options.shown_comparison() == Comparison::kDifference;
    return draw(panes_[0], moment, is_difference ? PaneContent::kDifference : PaneContent::kFirst);
  }

 private:
  FilmRenderer(FilmView view, std::vector<OffscreenScene> panes)
      : view_(std::move(view)), panes_(std::move(panes)) {}
  FilmView view_;
  std::vector<OffscreenScene> panes_;
  std::optional<ViewPose> view_pose_;
};

/// A video (Matroska, Motion JPEG) that is complete whenever it ends.
class FilmWriter {
 public:
  FilmWriter(std::filesystem::path file, const FilmView& view)
      : file_(std::move(file)), view_(view) {}

  /// Moments without a face are skipped. Errors: no OpenGL, those of writing.
  [[nodiscard]] Status add(const FramePair& moment, double frames_per_s) {
    if (!moment.has_face()) return {};
    if (!renderer_) {
      auto renderer = FilmRenderer::create(view_);
      if (!renderer) return renderer.error();
      renderer_ = std::move(*renderer);
    }
    const cv::Mat bgr = (*renderer_)(moment);
    const Frame frame = frame_of(bgr, *moment.first->result.frame, written_++);
    if (!writer_) {
      auto made = VideoWriter::create(file_, frame, VideoCodec::kMjpeg, frames_per_s);
      if (!made) return made.error();
      writer_ = std::move(*made);
    }
    return writer_->add(frame);
  }

  /// Error: nothing was written.
  [[nodiscard]] Status finish() {
    if (!writer_) return Error{en::say("no frame shows a face"), file_.string(), ""};
    return writer_->finish();
  }

 private:
  std::filesystem::path file_;
  FilmView view_;
  std::optional<FilmRenderer> renderer_;
  std::optional<VideoWriter> writer_;
  std::size_t written_ = 0;
};

/// Frames of the second finger, synchronised with the first.
class SecondFilm {
 public:
  explicit SecondFilm(const SecondFinger& second) {
    request_.finger = second.finger;
    request_.input = second.recording;
  }
  /// Null where that frame cannot be measured. Error: the recording or the finger cannot be opened.
  Result<std::shared_ptr<const InspectedFrame>> partner(std::size_t number,
                                                        const RecordingInfo& first,
                                                        const Job& job) {
    if (!recording_) {
      const InspectAnswer begin = inspector_(request_, job);
      if (!begin.recording) return *begin.problem;
      recording_ = begin.recording;
    }
    request_.number = matched_frame(number, first, *recording_).number;
    return inspector_(request_, job).frame;
  }

 private:
  Inspector inspector_;
  InspectRequest request_;
  std::optional<RecordingInfo> recording_;
};

}  // namespace

Status save_film(const std::filesystem::path& finger, const FilmView& view,
                 const std::optional<std::array<RigidTransform, 2>>& poses,
                 const std::filesystem::path& file, const Job& job) {
  const InspectOptions& options = view.options;
  FilmWriter writer(file, view);
  Inspector inspector;
  InspectRequest request;
  request.finger = finger;
  request.input = options.recording;
  request.other = options.comparand();
  std::optional<SecondFilm> second;
  if (options.second) second.emplace(*options.second);
  for (std::size_t count = 1; request.number < count && !job.stop_requested(); ++request.number) {
    const InspectAnswer answer = inspector(request, job);
    if (!answer.recording) return *answer.problem;
    if (answer.frame && answer.frame->other_problem) return *answer.frame->other_problem;
    count = answer.recording->count;
    job.report(static_cast<double>(request.number) / static_cast<double>(count),
               en::say("frame {} of {}", request.number + 1, count));
    FramePair moment{answer.frame, nullptr, poses};
    if (second) {
      auto partner = second->partner(request.number, *answer.recording, job);
      if (!partner) return partner.error();
      moment.second = std::move(*partner);
      if (!moment.second) continue;
    }
    const Status status = writer.add(moment, answer.recording->frames_per_s);
    if (!status) return status;
  }
  return writer.finish();
}

void FilmQueue::add(FramePair moment) {
  const std::lock_guard lock(mutex_);
  moments_.push_back(std::move(moment));
  if (moments_.size() > kMaxMoments) moments_.pop_front();
  added_.notify_one();
}

std::optional<FramePair> FilmQueue::next() {
  constexpr auto kWhile = std::chrono::milliseconds(100);
  std::unique_lock lock(mutex_);
  if (!added_.wait_for(lock, kWhile, [this] { return !moments_.empty(); })) return std::nullopt;
  FramePair moment = std::move(moments_.front());
  moments_.pop_front();
  return moment;
}

Status save_live_film(FilmQueue& queue, const FilmView& view, const std::filesystem::path& file,
                      const Job& job) {
  constexpr double kFramesPerS = 30;  // for frames without times
  FilmWriter writer(file, view);
  // Moments queued before the stop are still written.
  for (std::size_t left = FilmQueue::kMaxMoments; left > 0; left -= job.stop_requested() ? 1 : 0)
    if (const auto moment = queue.next())
      if (const Status status = writer.add(*moment, kFramesPerS); !status) return status;
  return writer.finish();
}

Status save_paper_figure(const FramePair& moment, FilmView view,
                         const std::filesystem::path& file) {
  if (!moment.has_face())
    return Error{en::say("there is no face to save"), file.string(), en::say("another frame")};
  view.colours = {};
  view.pixels_per_unit = kPaperWidth_px / std::max(1, view.size_px.width);
  view.size_px = cv::Size(
      static_cast<int>(kPaperWidth_px),
      static_cast<int>(std::lround(view.pixels_per_unit * std::max(1, view.size_px.height))));
  auto renderer = FilmRenderer::create(view);
  if (!renderer) return renderer.error();
  return write_paper_figure(file, (*renderer)(moment));
}

Status write_paper_figure(const std::filesystem::path& file, const cv::Mat& bgr) {
  QImage image(bgr.data, bgr.cols, bgr.rows, static_cast<qsizetype>(bgr.step),
               QImage::Format_BGR888);
  constexpr double kMetresPerInch = 0.0254;
  const int per_metre = static_cast<int>(std::lround(kPaperDotsPerInch / kMetresPerInch));
  image.setDotsPerMeterX(per_metre);
  image.setDotsPerMeterY(per_metre);
  return write_file_atomically(file, [&](const std::filesystem::path& temporary) -> Status {
    if (image.save(QString::fromStdString(temporary.string()), "PNG")) return {};
    return Error{en::say("the image cannot be written"), file.string(),
                 en::say("another folder, or freeing some space")};
  });
}

SaveBar::SaveBar(QWidget* parent)
    : Translated(parent),
      kind_(new QComboBox),
      save_(new QPushButton),
      stop_(new QPushButton),
      progress_(new QProgressBar) {
  auto* row = without_margins(new QHBoxLayout(this));
  for (const char* ending : kSaveFormats) kind_->addItem(QString(), QLatin1String(ending));
  progress_->setMaximumWidth(160);
  kind_->setMinimumWidth(52);  // px, for small windows
  for (QWidget* widget : std::initializer_list<QWidget*>{progress_, stop_, kind_, save_})
    row->addWidget(widget, widget == kind_ ? 1 : 0);
  connect(save_, &QPushButton::clicked, this,
          [this] { Q_EMIT save_requested(kind_->currentData().toString()); });
  connect(stop_, &QPushButton::clicked, this, &SaveBar::stop_requested);
  say([this] {
    const std::array<QString, kSaveFormats.size()> kinds{
        tr("Mesh, PLY"),          tr("Mesh, VTP (VTK)"),       tr("Mesh, STL"),
        tr("Mesh, glTF"),         tr("Depth map in mm, TIFF"), tr("Image, PNG (300 dpi)"),
        tr("Cross-section, PDF"), tr("Cross-section, SVG"),    tr("Cross-section, CSV"),
        tr("Video in 3D, MKV")};
    for (std::size_t i = 0; i < kinds.size(); ++i)
      kind_->setItemText(static_cast<int>(i), kinds[i]);
    kind_->setAccessibleName(tr("Content to save"));
    kind_->setToolTip(tr("What is saved, and in which format"));
    save_->setText(tr("&Save…"));
    save_->setToolTip(tr("Asks for the file to write"));
    stop_->setText(tr("Stop"));
    stop_->setToolTip(tr("Ends saving; a video has what was saved so far"));
    progress_->setAccessibleName(tr("Progress of saving"));
  });
  show_progress(std::nullopt);
  set_can_save({});
}

bool CanSave::saves(const std::string& ending) const {
  if (ending == "png") return image;
  if (ending == "pdf" || ending == "svg" || ending == "csv") return section;
  return ending == "mkv" ? film : surface;
}

void SaveBar::set_can_save(const CanSave& can) {
  auto* model = qobject_cast<QStandardItemModel*>(kind_->model());
  int first = -1;
  for (int i = 0; i < kind_->count(); ++i) {
    const bool is_on = can.saves(kSaveFormats[static_cast<std::size_t>(i)]);
    model->item(i)->setEnabled(is_on);
    if (is_on && first < 0) first = i;
  }
  kind_->setEnabled(first >= 0);
  save_->setEnabled(first >= 0);
  if (first >= 0 && !can.saves(kSaveFormats[static_cast<std::size_t>(kind_->currentIndex())]))
    kind_->setCurrentIndex(first);
}

void SaveBar::show_progress(std::optional<double> fraction) {
  for (QWidget* widget : std::initializer_list<QWidget*>{progress_, stop_})
    widget->setVisible(fraction.has_value());
  for (QWidget* widget : std::initializer_list<QWidget*>{kind_, save_})
    widget->setVisible(!fraction.has_value());
  if (!fraction) return;
  progress_->setRange(0, *fraction < 0 ? 0 : 100);
  progress_->setValue(static_cast<int>(std::lround(100 * *fraction)));
}

}  // namespace alltact
