#include "widgets/inspect/save_inspected.h"

#include "core/io/surface_file.h"
#include "core/recording/video_writer.h"
#include "widgets/inspect/inspector.h"
#include "widgets/scene3d/scene_pictures.h"

#include <fmt/format.h>
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

void show(const InspectedFrame& frame, const InspectOptions& view, FaceScene& scene) {
  if (view.comparison == Comparison::kDifference && frame.other_surface)
    scene.show_difference(*frame.surface, frame.other_depth_mm, *frame.camera);
  else
    scene.show(*frame.surface, *frame.camera);
}

Error no_face(const std::filesystem::path& file) {
  return {en::say("there is no face to save"), file, en::say("another frame")};
}

}  // namespace

Status save_surface(const InspectedFrame& frame, const std::filesystem::path& file) {
  if (!frame.result.depth) return no_face(file);
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

Status save_both(const std::array<PlacedFrame, 2>& frames, const std::filesystem::path& file) {
  const auto files = files_of_both(file);
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const InspectedFrame& frame = *frames[i].frame;
    if (!frame.result.depth) return no_face(files[i]);
    FaceVertices vertices = contact_face_vertices(frame.result, frame.face);
    vertices.points_mm.forEach<cv::Vec3f>([&](cv::Vec3f& p, const int*) {
      const Eigen::Vector3d at = frames[i].gripper_from_camera.point({p[0], p[1], p[2]});
      p = cv::Vec3d(at.x(), at.y(), at.z());
    });
    const Status status = write_surface(files[i], vertices.points_mm, vertices.depth_mm);
    if (!status) return status;
  }
  return {};
}

Status save_film(const FilmOptions& options, const std::filesystem::path& file, const Job& job) {
  auto pictures = ScenePictures::create(options.size_px);
  if (!pictures) return pictures.error();
  FaceScene& scene = pictures->scene();
  scene.set_options(options.view.scene);
  scene.set_colours(options.colours);
  scene.look_from(options.view.standpoint);
  if (options.look) scene.look_as(*options.look);
  Inspector inspector;
  InspectWish wish;
  wish.finger = options.finger;
  wish.input = options.input;
  if (options.view.comparison == Comparison::kDifference) wish.other = OtherMethod::kPaper;
  std::optional<VideoWriter> writer;
  std::size_t written = 0;
  for (std::size_t count = 1; wish.number < count && !job.stop_requested(); ++wish.number) {
    const InspectAnswer answer = inspector(wish, job);
    if (!answer.recording) return *answer.problem;
    if (answer.frame && answer.frame->other_problem) return *answer.frame->other_problem;
    count = answer.recording->count;
    job.report(static_cast<double>(wish.number) / static_cast<double>(count),
               en::say("frame {} of {}", wish.number + 1, count));
    if (!answer.frame || !answer.frame->surface) continue;
    show(*answer.frame, options.view, scene);
    const Frame frame = frame_of(pictures->picture(), *answer.frame->result.frame, written++);
    if (!writer) {
      auto made =
          VideoWriter::create(file, frame, VideoCodec::kMjpeg, answer.recording->frames_per_s);
      if (!made) return made.error();
      writer = std::move(*made);
    }
    if (const Status status = writer->add(frame); !status) return status;
  }
  if (!writer)
    return Error{en::say("no frame of the recording shows a face"), options.input.string(), ""};
  return writer->finish();
}

}  // namespace alltact
