#include "calibration/reference_recording.h"

#include "calibration/recording_layouts.h"
#include "calibration/settings_record.h"
#include "core/io/atomic_file.h"
#include "core/io/picture.h"
#include "core/recording/video_file.h"
#include "core/recording/video_writer.h"
#include "core/sensing/face_edges.h"
#include "core/sensing/face_shape.h"
#include "core/sensing/layout_search.h"
#include "core/sensing/reference_library.h"

#include <system_error>

#include <fmt/format.h>

namespace alltact {
namespace {

namespace fs = std::filesystem;

constexpr const char* kVideo = "reference.mkv";
constexpr const char* kTable = "reference.csv";
constexpr int kProfileDegree = 7;
constexpr double kTouchSigmas = 5.0;
constexpr double kTouchFloorPx = 0.2;  // of every marker at once: a camera that moves or warms up

// The reference video, made with its first frame.
class ReferenceVideo {
 public:
  ReferenceVideo(fs::path file, double frames_per_s)
      : file_(std::move(file)), frames_per_s_(frames_per_s) {}

  Status add(const Frame& frame) {
    if (!writer_) {
      auto made = VideoWriter::create(file_, frame, VideoCodec::kFfv1, frames_per_s_);
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

// All that the first pass over a recording leaves.
struct Pass {
  std::vector<FrameDots> frames;
  std::vector<int> in_video;  // number in the video just written, -1: never got there
  int written = 0;
  SettingsSeen settings;
};

FrameDots look_at(const cv::Mat& grey, const Camera& camera, const Finger& finger) {
  FrameDots found;
  const auto edges = FaceEdgeFinder()(grey);
  if (!edges) {
    found.problem = edges.error().what;
    return found;
  }
  const auto shape = FaceShape::fit(*edges, camera, finger.face, kProfileDegree);
  if (!shape) {
    found.problem = shape.error().what;
    return found;
  }
  found.base_at_low_u = shape->base_at_low_u();
  for (const Polarity polarity : {Polarity::kBright, Polarity::kDark}) {
    if (finger.markers.polarity != Polarity::kAuto && finger.markers.polarity != polarity) continue;
    auto& dots = polarity == Polarity::kBright ? found.bright : found.dark;
    dots = MarkerDetector({finger.markers.per_row, polarity})(grey, *shape).dots;
  }
  return found;
}

Result<Pass> first_pass(Source& source,
                        const Camera& camera,
                        const Finger& finger,
                        const Job& job,
                        const fs::path& video) {
  Pass pass;
  ReferenceVideo writer(video, source.frames_per_s());
  const auto total = source.count();
  for (;;) {
    if (job.stop_requested())
      return Error{"stopped before the recording was read", video.parent_path().string(), ""};
    const auto frame = source.next();
    if (frame && !*frame) break;
    const std::size_t number = pass.frames.size();
    if (total && *total > 0)
      job.report(0.8 * static_cast<double>(number) / static_cast<double>(*total),
                 fmt::format("reading frame {} of {}", number + 1, *total));
    if (!frame) {
      pass.frames.push_back({{}, {}, true, frame.error().what});
      pass.in_video.push_back(-1);
      // A source that fails for ever must not keep us here.
      if (total && pass.frames.size() > *total) return frame.error();
      if (!total && pass.written == 0 && pass.frames.size() > 100) return frame.error();
      continue;
    }
    const auto grey = oriented_for(
        finger.camera,
        (*frame)->grey,
        "the picture",
        (*frame)->origin.empty() ? (*frame)->name : (*frame)->origin,
        "a recording made with this finger's camera, or the right camera.size and orientation");
    if (!grey) return grey.error();
    pass.settings.add(**frame);
    pass.frames.push_back(look_at(*grey, camera, finger));
    const Status written = writer.add(**frame);
    if (!written) return written.error();
    pass.in_video.push_back(pass.written++);
  }
  if (const Status finished = writer.finish(); !finished) return finished.error();
  return pass;
}

// Rewrites the video with only some of its frames, in order.
Status keep_frames(const fs::path& video, const std::vector<char>& keep, const Job& job) {
  fs::path whole = video;
  whole.replace_filename(video.stem().string() + ".whole" + video.extension().string());
  std::error_code problem;
  fs::rename(video, whole, problem);
  if (problem)
    return Error{"the recording cannot be renamed: " + problem.message(), video.string(), ""};
  struct Remove {
    const fs::path& file;
    ~Remove() {
      std::error_code ignored;
      fs::remove(file, ignored);
    }
  } remove{whole};
  auto reader = VideoFile::open(whole, job);
  if (!reader) return reader.error();
  ReferenceVideo writer(video, reader->frames_per_s());
  for (std::size_t i = 0; i < keep.size(); ++i) {
    if (job.stop_requested())
      return Error{"stopped before the recording was written", video.string(), ""};
    if (!keep[i]) continue;
    const auto frame = reader->frame(i);
    if (!frame) return frame.error();
    if (const Status written = writer.add(**frame); !written) return written;
  }
  return writer.finish();
}

MarkerTable table_of(const NumberedRecording& numbered, const std::vector<std::size_t>& kept) {
  MarkerTable table;
  const auto count = numbered.typical.size();
  table.typical = numbered.typical;
  table.layouts.resize(static_cast<Eigen::Index>(kept.size()),
                       static_cast<Eigen::Index>(2 * count));
  for (std::size_t i = 0; i < kept.size(); ++i) {
    const Markers& markers = *numbered.markers[kept[i]];
    table.frames.push_back(static_cast<int>(i));
    table.seen.emplace_back(count, 0);
    for (std::size_t m = 0; m < count; ++m) {
      table.layouts.row(static_cast<Eigen::Index>(i)).segment<2>(static_cast<Eigen::Index>(2 * m))
          << markers[m].u,
          markers[m].v;
      table.seen.back()[m] = static_cast<char>(markers[m].seen);
    }
  }
  return table;
}

// Noise of a sum of offsets is that of one times the root of their number, twice over because the
// rest layout was measured too; never below a shift of all markers that is no touch.
double touch_threshold_px(double marker_noise_px, std::size_t markers) {
  const auto count = static_cast<double>(markers);
  return std::max(kTouchSigmas * marker_noise_px * std::sqrt(2 * count), kTouchFloorPx * count);
}

// Fills `temporary` with the video and `table` and `report` with what goes with it.
Status make_reference(Source& source,
                      const Camera& camera,
                      const Finger& finger,
                      const Job& job,
                      const fs::path& temporary,
                      MarkerTable& table,
                      NumberedRecording& numbered,
                      SettingsSeen& settings,
                      ReferenceReport& report) {
  const auto pass = first_pass(source, camera, finger, job, temporary);
  if (!pass) return pass.error();
  settings = pass->settings;
  report.frames_read = static_cast<int>(pass->frames.size());
  if (pass->frames.size() < 2)
    return Error{fmt::format("the recording holds {} frame{}; at least 2 are needed",
                             pass->frames.size(),
                             pass->frames.size() == 1 ? "" : "s"),
                 "recording",
                 "record the finger while it bends slowly in every direction, untouched"};
  job.report(0.8, "numbering the markers");
  auto result = number_recording(pass->frames, finger.markers);
  if (!result) return result.error();
  numbered = std::move(*result);
  std::vector<std::size_t> kept;
  std::vector<char> keep(static_cast<std::size_t>(pass->written), 0);
  for (std::size_t i = 0; i < pass->frames.size(); ++i) {
    if (!numbered.markers[i]) {
      report.rejected.push_back(fmt::format("frame {}: {}", i, numbered.problems[i]));
      continue;
    }
    kept.push_back(i);
    keep[static_cast<std::size_t>(pass->in_video[i])] = 1;
  }
  if (kept.size() < 2)
    return Error{fmt::format("only {} of {} frames can be used ({})",
                             kept.size(),
                             report.frames_read,
                             report.rejected.front()),
                 "recording",
                 "record again with every marker in view"};
  if (static_cast<int>(kept.size()) < pass->written) {
    job.report(0.9, "writing the frames that are kept");
    const Status rewritten = keep_frames(temporary, keep, job);
    if (!rewritten) return rewritten;
  }
  table = table_of(numbered, kept);
  report.frames_kept = static_cast<int>(kept.size());
  report.median_step_px = LayoutSearch(table.layouts).median_step_px();
  return {};
}

void remark(const MarkerTable& table, ReferenceReport& report) {
  std::size_t estimated = 0;
  for (const auto& row : table.seen)
    estimated += static_cast<std::size_t>(std::count(row.begin(), row.end(), 0));
  if (estimated > 0)
    report.remarks.push_back(
        fmt::format("{} marker positions in {} frames are estimates, because the markers were "
                    "covered or not found",
                    estimated,
                    report.frames_kept));
  if (report.frames_kept < 100)
    report.remarks.push_back(
        fmt::format("{} frames are few: a recording of a minute (about 1500 frames) over all "
                    "directions of bending gives closer references",
                    report.frames_kept));
}

}  // namespace

Result<ReferenceReport> install_reference(Source& source,
                                          const fs::path& folder,
                                          Finger& finger,
                                          const Job& job) {
  if (finger.face.kind != FaceKind::kFinRay || finger.markers.per_row < 2)
    return Error{"this finger has no markers to record a reference with",
                 folder.string(),
                 "a flat sensor takes one untouched picture; for a Fin Ray set markers.per_row"};
  const auto camera = Camera::create(finger.camera);
  if (!camera) return camera.error();
  ReferenceReport report;
  MarkerTable table;
  NumberedRecording numbered;
  SettingsSeen settings;
  const Status written =
      write_file_atomically(folder / kVideo, [&](const fs::path& temporary) -> Status {
        try {
          const Status made = make_reference(
              source, *camera, finger, job, temporary, table, numbered, settings, report);
          // The table first: should the disk fill up here, the old video still stands beside the
          // old table.
          return made ? table.save(folder / kTable) : made;
        } catch (const std::exception& problem) {
          return Error{fmt::format("the recording could not be processed ({})", problem.what()),
                       folder.string(),
                       ""};
        }
      });
  if (!written) return written.error();
  finger.reference = ReferenceFiles{kVideo, kTable, ""};
  finger.markers.polarity = numbered.polarity;
  ContactSettings contact;
  for (Eigen::Index k = 0; k < table.layouts.cols(); k += 2)
    contact.rest_markers.emplace_back(table.layouts(0, k), table.layouts(0, k + 1));
  contact.threshold_px = touch_threshold_px(numbered.marker_noise_px, contact.rest_markers.size());
  finger.contact = std::move(contact);
  report.warnings = record_settings(settings, RecordingKind::kReference, finger);
  remark(table, report);
  job.report(1.0, "reference installed");
  return report;
}

Result<std::vector<std::string>> install_flat_reference(const fs::path& picture,
                                                        const fs::path& folder,
                                                        Finger& finger) {
  if (finger.face.kind != FaceKind::kFlat)
    return Error{"only a flat sensor takes one untouched picture as its reference",
                 picture.string(),
                 "a recording of the bending, untouched finger"};
  Frame frame;
  std::string note;
  const auto grey = read_grey_picture(picture, &note);
  if (!grey) return grey.error();
  if (!note.empty()) frame.controls = std::make_shared<const std::string>(note);
  const auto camera = Camera::create(finger.camera);
  if (!camera) return camera.error();
  const auto fitting = oriented_for(finger.camera,
                                    *grey,
                                    "the picture",
                                    picture.string(),
                                    "an untouched picture taken with this sensor's camera");
  if (!fitting) return fitting.error();
  constexpr const char* kPicture = "reference.png";
  const Status written = write_picture(folder / kPicture, *grey, note);
  if (!written) return written.error();
  finger.reference = ReferenceFiles{"", "", kPicture};
  SettingsSeen settings;
  settings.add(frame);
  return record_settings(settings, RecordingKind::kReference, finger);
}

}  // namespace alltact
