#include "calibration/reference/recording_pass.h"

#include "core/io/image_file.h"
#include "core/recording/video_file.h"
#include "core/recording/video_writer.h"
#include "core/sensing/face/face_edges.h"
#include "core/sensing/face/face_shape.h"
#include "core/sensing/face/profile_degree.h"

#include <system_error>

namespace alltact {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMaxCachedBytes = std::size_t{512} << 20;

// The reference video, created at its first frame.
class ReferenceVideo {
 public:
  ReferenceVideo(fs::path file, double frames_per_s)
      : file_(std::move(file)), frames_per_s_(frames_per_s) {}

  Status add(const Frame& frame) {
    if (!writer_) {
      auto made = VideoWriter::create(file_, frame, VideoCodec::kMagicYuv, frames_per_s_);
      if (!made) return made.error();
      writer_ = std::move(*made);
    }
    return writer_->add(frame);
  }
  Status finish() { return writer_ ? writer_->finish() : Status(); }

 private:
  fs::path file_;
  double frames_per_s_;
  std::optional<VideoWriter> writer_;
};

FrameDots analyse(const cv::Mat& grey, const Camera& camera, const Finger& finger) {
  FrameDots found;
  const auto edges = FaceEdgeFinder({.view = FaceView{camera, finger.face.width_mm}})(grey);
  if (!edges) {
    found.problem = edges.error().what;
    return found;
  }
  const auto shape = FaceShape::fit(*edges, camera, finger.face, kDefaultProfileDegree);
  if (!shape) {
    found.problem = shape.error().what;
    return found;
  }
  found.curves = edge_curves(*shape);
  if (finger.markers.per_row == 0) return found;
  for (const Polarity polarity : {Polarity::kBright, Polarity::kDark}) {
    if (finger.markers.polarity != Polarity::kAuto && finger.markers.polarity != polarity) continue;
    auto& dots = polarity == Polarity::kBright ? found.bright : found.dark;
    dots = MarkerDetector({finger.markers.per_row, polarity})(grey, *shape).dots;
  }
  return found;
}

}  // namespace

Result<RecordingPass> read_recording(Source& source,
                                     const Camera& camera,
                                     const Finger& finger,
                                     const Job& job,
                                     const fs::path& video) {
  RecordingPass pass;
  ReferenceVideo writer(video, source.frames_per_s());
  const auto total = source.count();
  std::size_t cached_bytes = 0;
  for (;;) {
    if (job.stop_requested())
      return Error{
          en::say("stopped before the recording was read"), video.parent_path().string(), ""};
    const auto frame = source.next();
    if (frame && !*frame) break;
    const std::size_t number = pass.frames.size();
    if (total && *total > 0)
      job.report(static_cast<double>(number) / static_cast<double>(*total),
                 en::say("reading frame {} of {}", number + 1, *total));
    if (!frame) {
      pass.frames.push_back({{}, {}, {}, frame.error().what});
      pass.in_video.push_back(-1);
      // A source that fails permanently must not block.
      if (total && pass.frames.size() > *total) return frame.error();
      if (!total && pass.written == 0 && pass.frames.size() > 100) return frame.error();
      continue;
    }
    const auto grey = oriented_for(finger.camera,
                                   (*frame)->grey,
                                   en::say("the picture"),
                                   (*frame)->origin.empty() ? (*frame)->name : (*frame)->origin,
                                   en::say("a recording made with this finger's camera, or the "
                                           "right camera.size and orientation"));
    if (!grey) return grey.error();
    pass.settings.add(**frame);
    pass.frames.push_back(analyse(*grey, camera, finger));
    const Status written = writer.add(**frame);
    if (!written) return written.error();
    pass.in_video.push_back(pass.written++);
    const std::size_t bytes = grey->total();
    const bool has_room = cached_bytes + bytes <= kMaxCachedBytes;
    pass.greys.push_back(has_room ? *grey : cv::Mat());
    if (has_room) cached_bytes += bytes;
  }
  if (const Status finished = writer.finish(); !finished) return finished.error();
  return pass;
}

Status retain_frames(const fs::path& video, const std::vector<char>& keep, const Job& job) {
  fs::path full = video;
  full.replace_filename(video.stem().string() + ".whole" + video.extension().string());
  std::error_code problem;
  fs::rename(video, full, problem);
  if (problem)
    return Error{
        en::say("the recording cannot be renamed: {}", problem.message()), video.string(), ""};
  struct Remove {
    const fs::path& file;
    ~Remove() {
      std::error_code ignored;
      fs::remove(file, ignored);
    }
  } remove{full};
  auto reader = VideoFile::open(full, job);
  if (!reader) return reader.error();
  ReferenceVideo writer(video, reader->frames_per_s());
  for (std::size_t i = 0; i < keep.size(); ++i) {
    if (job.stop_requested())
      return Error{en::say("stopped before the recording was written"), video.string(), ""};
    if (!keep[i]) continue;
    job.report(static_cast<double>(i) / static_cast<double>(keep.size()),
               en::say("writing the frames that are kept"));
    const auto frame = reader->frame(i);
    if (!frame) return frame.error();
    if (const Status written = writer.add(**frame); !written) return written;
  }
  return writer.finish();
}

}  // namespace alltact
