#include "calibration/reference/reference_recording.h"

#include "calibration/reference/recording_layouts.h"
#include "calibration/reference/recording_pass.h"
#include "calibration/reference/recording_problem.h"
#include "calibration/reference/recording_study.h"
#include "calibration/reference/rest_pose.h"
#include "calibration/reference/settings_record.h"
#include "core/io/atomic_file.h"
#include "core/io/picture.h"
#include "core/recording/video_file.h"
#include "core/sensing/markers/layout_search.h"
#include "core/sensing/reference/reference_library.h"

#include <limits>

#include <fmt/format.h>

namespace alltact {
namespace {

namespace fs = std::filesystem;

constexpr const char* kVideo = "reference.mkv";
constexpr const char* kTable = "reference.csv";
constexpr double kTouchSigmas = 5.0;
constexpr double kRepeatSigmas = 2.0;    // of marker noise: poses nearer than that are the same
constexpr std::size_t kFewFrames = 100;  // so few that even repetitions help against noise
constexpr double kTouchFloorPx = 0.2;    // of every marker at once: a camera that moves or warms up

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

// What installing goes through and leaves.
struct Installed {
  MarkerTable table;
  NumberedRecording numbered;
  SettingsSeen settings;
  ReferenceReport report;
  std::size_t rest = 0;  // frame of the recording
  cv::Mat problem;       // a picture of what was found; empty: there is no problem
};

// What the recording is installed as, while it is studied.
Finger with_markers(const Finger& finger, const NumberedRecording& numbered) {
  Finger described = finger;
  described.markers.missing = numbered.missing;
  if (!numbered.places) described.markers.polarity = numbered.polarity;
  described.reference = ReferenceFiles{kVideo, kTable, "", numbered.places};
  return described;
}

// The frames of the video just written that may be kept, by their number in the recording.
std::vector<std::size_t> numbered_frames(const RecordingPass& pass, Installed& installed) {
  std::vector<std::size_t> kept;
  for (std::size_t i = 0; i < pass.frames.size(); ++i) {
    if (installed.numbered.markers[i])
      kept.push_back(i);
    else
      installed.report.rejected.push_back(
          fmt::format("frame {}: {}", i, installed.numbered.problems[i]));
  }
  return kept;
}

Error too_few(const ReferenceReport& report, std::size_t kept) {
  return {fmt::format("only {} of {} frames can be used ({})",
                      kept,
                      report.frames_read,
                      report.rejected.front()),
          "recording",
          "record again with every marker in view and nothing on the contact face"};
}

// Depth that a difference in brightness is taken for.
double mm_per_part(const Finger& finger) {
  if (finger.mapping)
    if (const auto mapping = Mapping::create(*finger.mapping)) return mapping->slope_mm(0.0);
  // Kubelka and Munk's layer over black, with the scattering of ordinary white silicone, 0.6 / mm.
  return finger.face.layer_mm * (1.0 + 0.6 * finger.face.layer_mm);
}

// Told by the pair of dots nearest to the tip between which the face is seen in nearly all frames,
// against the frame that counts as rest.
void add_motion(const std::vector<const StudiedFrame*>& frames,
                const StudiedFrame* rest,
                MotionCoverage& coverage) {
  constexpr double kNearlyAll = 0.8;
  const std::size_t pairs = frames.empty() ? 0 : frames.front()->pairs.size();
  for (std::size_t pair = pairs; pair-- > 0;) {
    std::vector<TipPlace> places;
    for (const StudiedFrame* frame : frames)
      if (pair < frame->pairs.size() && frame->pairs[pair]) places.push_back(*frame->pairs[pair]);
    if (places.size() < kNearlyAll * static_cast<double>(frames.size()) || places.empty()) continue;
    const TipPlace& from = rest && pair < rest->pairs.size() && rest->pairs[pair]
                               ? *rest->pairs[pair]
                               : places.front();
    for (const TipPlace& place : places) coverage.add(motion_between(from, place));
    return;
  }
}

// Index of the frame that shows the pose, as nearly as any; nullopt where none shows its dots.
std::optional<std::size_t> frame_nearest_to(const RestPose& pose,
                                            const std::vector<const StudiedFrame*>& frames,
                                            const MotionNeed& need) {
  std::optional<std::size_t> nearest;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const auto& pairs = frames[i]->pairs;
    if (pose.pair >= pairs.size() || !pairs[pose.pair]) continue;
    const TipMotion off = motion_between(pose.place, *pairs[pose.pair]);
    const double apart = std::hypot(
        off.bend_mm / need.bend_mm, off.sway_mm / need.sway_mm, off.twist_deg / need.twist_deg);
    if (apart < least) least = apart, nearest = i;
  }
  return nearest;
}

// The frame asked for, the one nearest to the pose asked for, or the middle one of those kept.
Status choose_rest(const ReferenceChoices& choices,
                   const std::vector<std::size_t>& kept,
                   const std::vector<const StudiedFrame*>& frames,
                   Installed& installed) {
  std::optional<std::size_t> nearest;
  if (choices.rest_pose) nearest = frame_nearest_to(*choices.rest_pose, frames, choices.need);
  if (!nearest)
    nearest = static_cast<std::size_t>(middle_pose(table_of(installed.numbered, kept).layouts));
  installed.rest = kept[*nearest];
  if (const auto& wanted = choices.rest_frame) {
    const auto number = static_cast<std::size_t>(*wanted);
    const auto& markers = installed.numbered.markers;
    if (*wanted < 0 || number >= markers.size() || !markers[number])
      return Error{fmt::format("frame {} cannot be the finger's rest: {}",
                               *wanted,
                               *wanted < 0 || number >= markers.size()
                                   ? "the recording has no such frame"
                                   : installed.numbered.problems[number]),
                   "recording",
                   "another frame in which the finger rests"};
    installed.rest = number;
  }
  installed.report.rest_frame = static_cast<int>(installed.rest);
  return {};
}

// Compares the frames with each other; takes out those that are touched and says what the rest is
// worth.
Status study(const fs::path& video,
             const RecordingPass& pass,
             const Camera& camera,
             const Finger& finger,
             const Job& job,
             const ReferenceChoices& choices,
             std::vector<std::size_t>& kept,
             Installed& installed) {
  MarkerTable table = table_of(installed.numbered, kept);
  for (std::size_t i = 0; i < kept.size(); ++i) table.frames[i] = pass.in_video[kept[i]];
  auto reader = VideoFile::open(video, job);
  if (!reader) return reader.error();
  const FrameOfRecording frame = [&](std::size_t number) -> Result<cv::Mat> {
    if (!pass.greys[number].empty()) return pass.greys[number];
    const auto read = reader->frame(number);
    if (!read) return read.error();
    return oriented_for(finger.camera, (*read)->grey, "the recording's picture", "", "");
  };
  const auto library = ReferenceLibrary::from_frames(
      frame, pass.greys.size(), video, table, finger, camera, Job(job, 0.0, 0.4));
  if (!library) return library.error();
  std::vector<std::size_t> of_library;  // by the library's index, the number in the recording
  std::vector<Markers> markers;
  for (std::size_t i = 0, row = 0; row < library->frame_count(); ++i) {
    if (table.frames[i] != library->frame_numbers()[row]) continue;
    of_library.push_back(kept[i]);
    markers.push_back(*installed.numbered.markers[kept[i]]);
    ++row;
  }
  const auto studied = study_recording(
      *library, markers, frame, reader->frames_per_s(), finger, camera, Job(job, 0.4, 1.0));
  if (!studied) return studied.error();
  ReferenceReport& report = installed.report;
  kept.clear();
  std::vector<const StudiedFrame*> untouched;
  for (std::size_t row = 0; row < of_library.size(); ++row) {
    if (const auto& touch = studied->touched[row]) {
      report.rejected.push_back(
          fmt::format("frame {}: something pressed on the contact face, {:.0f} mm from its base "
                      "({:.0f} % darker than untouched)",
                      of_library[row],
                      touch->along_mm,
                      100.0 * touch->darker));
      continue;
    }
    kept.push_back(of_library[row]);
    untouched.push_back(&studied->frames[row]);
  }
  if (kept.size() < 2) return {};
  const Status rested = choose_rest(choices, kept, untouched, installed);
  if (!rested) return rested;
  const auto rest = std::find(kept.begin(), kept.end(), installed.rest) - kept.begin();
  add_motion(untouched,
             rest < std::ssize(kept) ? untouched[static_cast<std::size_t>(rest)] : nullptr,
             report.coverage);
  report.error_median = studied->error_median;
  report.error_p95 = studied->error_p95;
  report.nearest_error_median = studied->nearest_error_median;
  report.by_own_mapping = finger.mapping.has_value();
  report.error_median_mm = report.error_median * mm_per_part(finger);
  report.error_p95_mm = report.error_p95 * mm_per_part(finger);
  return {};
}

// Of frames in the same pose the first stays: a finger that rests for a while would fill the
// neighbourhood of that pose with copies of one picture.
void thin(std::vector<std::size_t>& kept, Installed& installed) {
  if (kept.size() <= kFewFrames) return;
  const MarkerTable all = table_of(installed.numbered, kept);
  const double apart = kRepeatSigmas * installed.numbered.marker_noise_px *
                       std::sqrt(static_cast<double>(all.layouts.cols()));
  std::vector<std::size_t> spread;
  std::vector<Eigen::Index> rows;
  for (std::size_t i = 0; i < kept.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    const bool repeats = std::any_of(rows.begin(), rows.end(), [&](Eigen::Index other) {
      return (all.layouts.row(other) - all.layouts.row(row)).norm() < apart;
    });
    if (repeats && kept.size() - i + spread.size() > kFewFrames) continue;
    spread.push_back(kept[i]);
    rows.push_back(row);
  }
  installed.report.repeated = static_cast<int>(kept.size() - spread.size());
  kept = std::move(spread);
}

// Says what the finger lacks.
void tell_missing(Installed& installed) {
  const NumberedRecording& numbered = installed.numbered;
  ReferenceReport& report = installed.report;
  report.by_shape = numbered.places.has_value();
  report.missing = numbered.missing;
  if (!numbered.no_markers.empty())
    report.warnings.push_back(fmt::format(
        "No markers can be used: {}; poses are told by the shape of the face alone, "
        "which cannot tell twist; if the finger has dots, light both side faces so that "
        "they stand out, and focus",
        numbered.no_markers));
  if (!numbered.missing.empty())
    report.remarks.push_back(
        fmt::format("Markers {} were not found anywhere; the finger works with the other {}",
                    fmt::join(numbered.missing, ", "),
                    numbered.typical.size() - numbered.missing.size()));
}

// Fills `temporary` with the video, and gives what goes with it.
Status make_reference(Source& source,
                      const Camera& camera,
                      const Finger& finger,
                      const Job& job,
                      const ReferenceChoices& choices,
                      const fs::path& temporary,
                      Installed& installed) {
  const auto pass = read_recording(source, camera, finger, Job(job, 0.0, 0.5), temporary);
  if (!pass) return pass.error();
  installed.settings = pass->settings;
  ReferenceReport& report = installed.report;
  report.frames_read = static_cast<int>(pass->frames.size());
  if (pass->frames.size() < 2)
    return Error{fmt::format("the recording holds {} frame{}; at least 2 are needed",
                             pass->frames.size(),
                             pass->frames.size() == 1 ? "" : "s"),
                 "recording",
                 "record the finger while it bends slowly in every direction, untouched"};
  job.report(0.5, "numbering the markers");
  const auto draw = [&](const std::string& sentence) {
    return recording_problem(*pass, installed.numbered, installed.rest, finger.name, sentence);
  };
  const auto refuse = [&](const Error& error) -> Status {
    installed.problem = draw(error.sentence());
    return error;
  };
  auto result = number_recording(pass->frames, finger.markers);
  if (!result) return refuse(result.error());
  installed.numbered = std::move(*result);
  tell_missing(installed);
  std::vector<std::size_t> kept = numbered_frames(*pass, installed);
  if (kept.size() < 2) return refuse(too_few(report, kept.size()));
  const Status studied = study(temporary,
                               *pass,
                               camera,
                               with_markers(finger, installed.numbered),
                               Job(job, 0.5, 0.9),
                               choices,
                               kept,
                               installed);
  if (!studied) return studied;
  if (kept.size() < 2) return refuse(too_few(report, kept.size()));
  for (const auto* sentences : {&report.warnings, &report.remarks})
    if (!sentences->empty()) installed.problem = draw(sentences->front() + ".");
  thin(kept, installed);
  if (static_cast<int>(kept.size()) < pass->written) {
    std::vector<char> keep(static_cast<std::size_t>(pass->written), 0);
    for (const std::size_t i : kept) keep[static_cast<std::size_t>(pass->in_video[i])] = 1;
    const Status rewritten = keep_frames(temporary, keep, Job(job, 0.9, 1.0));
    if (!rewritten) return rewritten;
  }
  installed.table = table_of(installed.numbered, kept);
  report.frames_kept = static_cast<int>(kept.size());
  report.median_step_px = LayoutSearch(installed.table.layouts).median_step_px();
  return {};
}

void remark(const MarkerTable& table, ReferenceReport& report) {
  std::size_t estimated = 0;
  for (const auto& row : table.seen)
    estimated +=
        static_cast<std::size_t>(std::count(row.begin(), row.end(), 0)) - report.missing.size();
  if (estimated > 0)
    report.remarks.push_back(
        fmt::format("{} marker positions in {} frames are estimates, because the markers were "
                    "covered or not found",
                    estimated,
                    report.frames_kept));
  if (report.frames_kept + report.repeated < 100)
    report.remarks.push_back(
        fmt::format("{} frames are few: a recording of a minute (about 1500 frames) over all "
                    "directions of bending gives closer references",
                    report.frames_kept));
  for (const std::string& missing : report.coverage.missing())
    report.remarks.push_back("Not yet seen: " + missing);
}

// True: the picture lies in the folder. One of an earlier recording goes.
bool leave_problem(const fs::path& folder, const cv::Mat& problem) {
  std::error_code ignored;
  if (!problem.empty() && write_picture(folder / kReferenceProblem, problem)) return true;
  fs::remove(folder / kReferenceProblem, ignored);
  return false;
}

}  // namespace

Result<ReferenceReport> install_reference(Source& source,
                                          const fs::path& folder,
                                          Finger& finger,
                                          const Job& job,
                                          const ReferenceChoices& choices) {
  if (finger.face.kind != FaceKind::kFinRay)
    return Error{"this finger has no markers to record a reference with",
                 folder.string(),
                 "a flat sensor takes one untouched picture"};
  const auto camera = Camera::create(finger.camera);
  if (!camera) return camera.error();
  Installed installed;
  installed.report.coverage = MotionCoverage(choices.need);
  const Status written =
      write_file_atomically(folder / kVideo, [&](const fs::path& temporary) -> Status {
        try {
          const Status made =
              make_reference(source, *camera, finger, job, choices, temporary, installed);
          // The table first: should the disk fill up here, the old video still stands beside the
          // old table.
          return made ? installed.table.save(folder / kTable) : made;
        } catch (const std::exception& problem) {
          return Error{fmt::format("the recording could not be processed ({})", problem.what()),
                       folder.string(),
                       ""};
        }
      });
  const bool is_drawn = leave_problem(folder, installed.problem);
  if (!written) {
    Error error = written.error();
    if (is_drawn)
      error.advice +=
          fmt::format("; {} shows what was found", (folder / kReferenceProblem).string());
    return error;
  }
  const MarkerTable& table = installed.table;
  ReferenceReport& report = installed.report;
  Finger described = with_markers(finger, installed.numbered);
  finger.reference = described.reference;
  finger.markers = described.markers;
  ContactSettings contact;
  for (const Marker& marker : *installed.numbered.markers[installed.rest])
    contact.rest_markers.emplace_back(marker.u, marker.v);
  contact.threshold_px =
      touch_threshold_px(installed.numbered.marker_noise_px, contact.rest_markers.size());
  finger.contact = std::move(contact);
  for (std::string& warning :
       record_settings(installed.settings, RecordingKind::kReference, finger))
    report.warnings.push_back(std::move(warning));
  if (is_drawn)
    report.remarks.push_back(
        fmt::format("{} shows what was found", (folder / kReferenceProblem).string()));
  remark(table, report);
  job.report(1.0, "reference installed");
  return std::move(report);
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
