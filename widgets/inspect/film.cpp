#include "widgets/inspect/film.h"

#include "core/io/atomic_file.h"

#include <QImage>
#include <QString>
#include <cmath>

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

namespace alltact {
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

bool is_shown(const std::shared_ptr<const InspectedFrame>& frame) {
  return frame && (frame->surface || frame->bare);
}

bool is_side_by_side(const FilmView& view, const FilmMoment& moment) {
  return moment.second ? !moment.poses : view.options.shown_comparison() == Comparison::kSideBySide;
}

}  // namespace

bool FilmMoment::has_face() const {
  if (!poses) return is_shown(first) && (!second || is_shown(second));
  return first && second && first->surface && second->surface;
}

Result<FilmRenderer> FilmRenderer::create(const FilmView& view) {
  // Three panes are made where two fingers or measurements may be shown; a moment uses one or two.
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

cv::Mat FilmRenderer::operator()(const FilmMoment& moment) {
  if (moment.view_pose && !(view_pose_ && *view_pose_ == *moment.view_pose)) {
    view_pose_ = moment.view_pose;
    for (OffscreenScene& pane : panes_) pane.scene().set_view_pose(*view_pose_);
  }
  const auto draw = [&](OffscreenScene& pane,
                        const InspectedFrame& frame,
                        PaneContent content,
                        bool has_marks,
                        const std::optional<OtherInGripper>& other) {
    show_in(pane.scene(), frame, content, other);
    pane.scene().set_gap(other ? moment.gap : std::nullopt);
    pane.scene().set_marks(has_marks ? marks_of(frame, view_.options) : SceneMarks());
    return pane.image();
  };
  if (is_side_by_side(view_, moment) && panes_.size() > 1) {
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
              moment.second && moment.poses
                  ? std::optional(OtherInGripper{moment.second, *moment.poses})
                  : std::nullopt);
}

Status FilmWriter::add(const FilmMoment& moment, double frames_per_s) {
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

Status FilmWriter::finish() {
  if (!writer_) return Error{en::say("no frame shows a face"), file_.string(), ""};
  return writer_->finish();
}

Status save_paper_figure(const FilmMoment& moment,
                         FilmView view,
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
  QImage image(
      bgr.data, bgr.cols, bgr.rows, static_cast<qsizetype>(bgr.step), QImage::Format_BGR888);
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
