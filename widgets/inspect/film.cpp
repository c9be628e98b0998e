#include "widgets/inspect/film.h"

#include "core/io/atomic_file.h"

#include <QImage>
#include <QString>
#include <cmath>

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

namespace alltact {
namespace {

/// A picture in colour as a frame that is written as it is.
Frame frame_of(const cv::Mat& picture, const Frame& from, std::size_t number) {
  Frame frame;
  frame.name = from.name;
  frame.origin = from.origin;
  frame.sequence = number;
  frame.time_ns = from.time_ns;
  auto jpeg = std::make_shared<std::vector<std::uint8_t>>();
  constexpr int kQuality = 95;
  cv::imencode(".jpg", picture, *jpeg, {cv::IMWRITE_JPEG_QUALITY, kQuality});
  cv::cvtColor(picture, frame.grey, cv::COLOR_BGR2GRAY);
  frame.jpeg = std::move(jpeg);
  return frame;
}

bool is_shown(const std::shared_ptr<const InspectedFrame>& frame) {
  return frame && (frame->surface || frame->bare);
}

bool is_beside(const FilmView& view, const FilmMoment& moment) {
  return moment.second ? !moment.places
                       : view.options.shown_comparison() == Comparison::kSideBySide;
}

}  // namespace

bool FilmMoment::has_face() const {
  if (!places) return is_shown(first) && (!second || is_shown(second));
  return first && second && first->surface && second->surface;
}

Result<FilmPictures> FilmPictures::create(const FilmView& view) {
  // Two panes are made where two may be shown; a moment uses as many as it needs.
  const bool may_be_two =
      view.options.second || view.options.shown_comparison() == Comparison::kSideBySide;
  std::vector<ScenePictures> panes;
  const cv::Size half(view.size_px.width / 2, view.size_px.height);
  for (const cv::Size& size :
       may_be_two ? std::vector{view.size_px, half, half} : std::vector{view.size_px}) {
    auto pane = ScenePictures::create(size, view.pixels_per_unit);
    if (!pane) return pane.error();
    pane->scene().set_options(view.options.scene);
    pane->scene().set_colours(view.colours);
    pane->scene().look_from(view.options.standpoint);
    if (view.options.look) pane->scene().look_as(*view.options.look);
    panes.push_back(std::move(*pane));
  }
  return FilmPictures(view, std::move(panes));
}

cv::Mat FilmPictures::operator()(const FilmMoment& moment) {
  if (moment.look && !(look_ && *look_ == *moment.look)) {
    look_ = moment.look;
    for (ScenePictures& pane : panes_) pane.scene().look_as(*look_);
  }
  const auto draw = [&](ScenePictures& pane,
                        const InspectedFrame& frame,
                        PaneContent content,
                        bool has_marks,
                        const std::optional<OtherInGripper>& other) {
    show_in(pane.scene(), frame, content, other);
    pane.scene().set_gap(other ? moment.gap : std::nullopt);
    pane.scene().set_marks(has_marks ? marks_of(frame, view_.options) : SceneMarks());
    return pane.picture();
  };
  if (is_beside(view_, moment) && panes_.size() > 1) {
    const cv::Mat left = draw(panes_[1], *moment.first, PaneContent::kFirst, true, {});
    const cv::Mat right = moment.second
                              ? draw(panes_[2], *moment.second, PaneContent::kFirst, false, {})
                              : draw(panes_[2], *moment.first, PaneContent::kSecond, true, {});
    cv::Mat both;
    cv::hconcat(left, right, both);
    return both;
  }
  const bool is_difference = view_.options.shown_comparison() == Comparison::kDifference;
  return draw(panes_[0],
              *moment.first,
              is_difference ? PaneContent::kDifference : PaneContent::kFirst,
              true,
              moment.second && moment.places
                  ? std::optional(OtherInGripper{moment.second, *moment.places})
                  : std::nullopt);
}

Status FilmWriter::add(const FilmMoment& moment, double frames_per_s) {
  if (!moment.has_face()) return {};
  if (!pictures_) {
    auto pictures = FilmPictures::create(view_);
    if (!pictures) return pictures.error();
    pictures_ = std::move(*pictures);
  }
  const cv::Mat picture = (*pictures_)(moment);
  const Frame frame = frame_of(picture, *moment.first->result.frame, written_++);
  if (!writer_) {
    auto made = VideoWriter::create(file_, frame, VideoCodec::kMjpeg, frames_per_s);
    if (!made) return made.error();
    writer_ = std::move(*made);
  }
  return writer_->add(frame);
}

Status FilmWriter::finish() {
  if (!writer_) return Error{en::say("no frame shows a face"), file_.string(), ""};
  return writer_->finish();
}

Status save_paper_picture(const FilmMoment& moment,
                          FilmView view,
                          const std::filesystem::path& file) {
  if (!moment.has_face())
    return Error{en::say("there is no face to save"), file.string(), en::say("another frame")};
  view.colours = {};
  view.pixels_per_unit = kPaperWidth_px / std::max(1, view.size_px.width);
  view.size_px = cv::Size(
      static_cast<int>(kPaperWidth_px),
      static_cast<int>(std::lround(view.pixels_per_unit * std::max(1, view.size_px.height))));
  auto pictures = FilmPictures::create(view);
  if (!pictures) return pictures.error();
  return write_paper_picture(file, (*pictures)(moment));
}

Status write_paper_picture(const std::filesystem::path& file, const cv::Mat& picture) {
  QImage image(picture.data,
               picture.cols,
               picture.rows,
               static_cast<qsizetype>(picture.step),
               QImage::Format_BGR888);
  constexpr double kMetresPerInch = 0.0254;
  const int per_metre = static_cast<int>(std::lround(kPaperDotsPerInch / kMetresPerInch));
  image.setDotsPerMeterX(per_metre);
  image.setDotsPerMeterY(per_metre);
  return write_file_atomically(file, [&](const std::filesystem::path& temporary) -> Status {
    if (image.save(QString::fromStdString(temporary.string()), "PNG")) return {};
    return Error{en::say("the picture cannot be written"),
                 file.string(),
                 en::say("another folder, or freeing some space")};
  });
}

}  // namespace alltact
