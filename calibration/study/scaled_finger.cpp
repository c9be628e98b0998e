#include "calibration/study/scaled_finger.h"

#include "calibration/study/painted_press.h"
#include "core/recording/video_file.h"
#include "core/sensing/reference/flat_reference.h"

#include <algorithm>
#include <cmath>

#include <opencv2/imgproc.hpp>

namespace alltact {
namespace {

double scaled_px(double px, double by) {
  return (px + 0.5) * by - 0.5;
}

FingerSnapshot at_scale(const FingerSnapshot& original, double by) {
  FingerSnapshot scaled = original;
  CameraParameters& camera = scaled.finger.camera;
  camera.orientation = Orientation::kNone;
  camera.width_px = static_cast<int>(std::lround(camera.width_px * by));
  camera.height_px = static_cast<int>(std::lround(camera.height_px * by));
  camera.fx_px *= by;
  camera.fy_px *= by;
  camera.cx_px = scaled_px(camera.cx_px, by);
  camera.cy_px = scaled_px(camera.cy_px, by);
  camera.mm_per_px /= by;
  if (auto& contact = scaled.finger.contact) {
    contact->threshold_px *= by;
    for (Eigen::Vector2d& marker : contact->rest_markers)
      marker = {scaled_px(marker.x(), by), scaled_px(marker.y(), by)};
  }
  if (auto& reference = scaled.finger.reference; reference && reference->positions)
    reference->positions->from_u_px = scaled_px(reference->positions->from_u_px, by);
  scaled.force.reset();
  return scaled;
}

MarkerTable at_scale(MarkerTable table, double by) {
  table.layouts = ((table.layouts.array() + 0.5) * by - 0.5).matrix();
  for (Dot& dot : table.typical) {
    dot.u = scaled_px(dot.u, by);
    dot.v = scaled_px(dot.v, by);
    dot.radius_px *= by;
    dot.half_u_px *= by;
    dot.half_v_px *= by;
  }
  return table;
}

}  // namespace

Result<RecordedImages> recorded_images(const FingerPtr& snapshot, int count, const Job& job) {
  const Finger& finger = snapshot->finger;
  StudyWorldOptions few;
  few.frames = 1;
  if (finger.face.kind == FaceKind::kFlat) {
    auto untouched = untouched_images(snapshot, few, job);
    if (!untouched) return untouched.error();
    return RecordedImages{{}, std::move(untouched->images)};
  }
  if (!snapshot->mapping || !finger.reference || finger.reference->video.empty())
    return Error{en::say("the finger has no reference recording, or is not calibrated yet"),
                 (snapshot->folder / Finger::kFileName).string(),
                 en::say("alltact reference, then alltact calibrate")};
  const auto table =
      MarkerTable::load(snapshot->folder / finger.reference->markers, finger.marker_count());
  if (!table) return table.error();
  const auto file = snapshot->folder / finger.reference->video;
  auto video = VideoFile::open(file, job);
  if (!video) return video.error();
  const std::size_t rows = table->frames.size();
  const std::size_t used = std::min(rows, static_cast<std::size_t>(count));
  RecordedImages recorded;
  recorded.table.typical = table->typical;
  recorded.table.layouts.resize(static_cast<Eigen::Index>(used), table->layouts.cols());
  for (std::size_t i = 0; i < used; ++i) {
    if (job.stop_requested()) return Error{en::say("stopped before the study was over"), "", ""};
    const std::size_t row = i * rows / used;
    const auto frame = video->frame(static_cast<std::size_t>(table->frames[row]));
    if (!frame) return frame.error();
    auto grey = oriented_for(
        finger.camera, (*frame)->grey, en::say("the recording's picture"), file.string(), "");
    if (!grey) return grey.error();
    recorded.table.frames.push_back(static_cast<int>(i));
    recorded.table.seen.push_back(table->seen[row]);
    recorded.table.layouts.row(static_cast<Eigen::Index>(i)) =
        table->layouts.row(static_cast<Eigen::Index>(row));
    recorded.images.push_back(grey->clone());
  }
  return recorded;
}

Result<ScaledFinger> scaled_finger(const FingerSnapshot& original,
                                   const RecordedImages& recorded,
                                   double by,
                                   std::uint64_t seed,
                                   const Job& job) {
  FingerSnapshot finger = at_scale(original, by);
  auto camera = Camera::create(finger.finger.camera);
  if (!camera) return camera.error();
  finger.camera = std::move(camera).value();
  std::vector<cv::Mat> images;
  for (const cv::Mat& image : recorded.images) {
    cv::Mat scaled;
    cv::resize(
        image, scaled, finger.camera.size(), 0, 0, by < 1 ? cv::INTER_AREA : cv::INTER_CUBIC);
    images.push_back(std::move(scaled));
  }
  const auto image_of = [&](std::size_t number) -> Result<cv::Mat> { return images[number]; };
  auto library = recorded.table.frames.empty()
                     ? ReferenceLibrary::single(images.front())
                     : ReferenceLibrary::from_frames(image_of,
                                                     images.size(),
                                                     original.folder,
                                                     at_scale(recorded.table, by),
                                                     finger.finger,
                                                     finger.camera,
                                                     job);
  if (!library) return library.error();
  ScaledFinger scaled{std::move(finger), std::move(library).value(), {}};
  Pipeline pipeline = scaled.pipeline();
  const PressPainter painter(scaled.finger, painted_radius_mm(scaled.finger));
  for (std::size_t i = 0; i < images.size(); ++i) {
    auto frame = std::make_shared<Frame>();
    frame->grey = images[i];
    frame->name = fmt::format("frame_{:05}", i);
    pipeline.forget();
    const auto seen = pipeline(frame);
    if (!seen) return seen.error();
    if (!seen->shape) continue;
    StudyDraws draws(seed, static_cast<std::uint32_t>(i));
    const auto painted =
        painter.ball(images[i], *seen->shape, draws, static_cast<FaceZone>(i % kFaceZones));
    if (painted) frame->grey = painted->image->grey;
    scaled.frames.push_back(std::move(frame));
  }
  if (scaled.frames.empty())
    return Error{en::say("no picture of the reference recording shows the face"),
                 original.folder.string(),
                 en::say("record the finger bending through all its poses")};
  return scaled;
}

}  // namespace alltact
