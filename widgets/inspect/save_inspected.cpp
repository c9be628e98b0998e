#include "widgets/inspect/save_inspected.h"

#include "core/io/surface_file.h"
#include "core/recording/time_match.h"
#include "widgets/inspect/inspector.h"

#include <chrono>

namespace alltact {
namespace {

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

Status save_both(const std::array<PosedFrame, 2>& frames, const std::filesystem::path& file) {
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

namespace {

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
    static const FrameTimes kNone;
    request_.number = match_frame(number,
                                  first.times_ns ? *first.times_ns : kNone,
                                  recording_->times_ns ? *recording_->times_ns : kNone,
                                  recording_->count)
                          .number;
    return inspector_(request_, job).frame;
  }

 private:
  Inspector inspector_;
  InspectRequest request_;
  std::optional<RecordingInfo> recording_;
};

}  // namespace

Status save_film(const FilmOptions& options, const std::filesystem::path& file, const Job& job) {
  const InspectOptions& view = options.view.options;
  FilmWriter writer(file, options.view);
  Inspector inspector;
  InspectRequest request;
  request.finger = options.finger;
  request.input = options.input;
  request.other = view.comparand();
  std::optional<SecondFilm> second;
  if (view.second) second.emplace(*view.second);
  for (std::size_t count = 1; request.number < count && !job.stop_requested(); ++request.number) {
    const InspectAnswer answer = inspector(request, job);
    if (!answer.recording) return *answer.problem;
    if (answer.frame && answer.frame->other_problem) return *answer.frame->other_problem;
    count = answer.recording->count;
    job.report(static_cast<double>(request.number) / static_cast<double>(count),
               en::say("frame {} of {}", request.number + 1, count));
    FilmMoment moment{answer.frame, nullptr, options.poses};
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

void FilmQueue::add(FilmMoment moment) {
  const std::lock_guard lock(mutex_);
  moments_.push_back(std::move(moment));
  if (moments_.size() > kMaxMoments) {
    moments_.pop_front();
    ++left_out_;
  }
  added_.notify_one();
}

std::optional<FilmMoment> FilmQueue::next() {
  constexpr auto kWhile = std::chrono::milliseconds(100);
  std::unique_lock lock(mutex_);
  if (!added_.wait_for(lock, kWhile, [this] { return !moments_.empty(); })) return std::nullopt;
  FilmMoment moment = std::move(moments_.front());
  moments_.pop_front();
  return moment;
}

std::size_t FilmQueue::left_out() const {
  const std::lock_guard lock(mutex_);
  return left_out_;
}

Status save_live_film(FilmQueue& queue,
                      const FilmView& view,
                      const std::filesystem::path& file,
                      const Job& job) {
  constexpr double kFramesPerS = 30;  // for frames without times
  FilmWriter writer(file, view);
  // Moments queued before the stop are still written.
  for (std::size_t left = FilmQueue::kMaxMoments; left > 0; left -= job.stop_requested() ? 1 : 0)
    if (const auto moment = queue.next())
      if (const Status status = writer.add(*moment, kFramesPerS); !status) return status;
  return writer.finish();
}

}  // namespace alltact
