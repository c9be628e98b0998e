#include "calibration/reference/make_reference.h"

#include "calibration/reference/contact_frames.h"
#include "calibration/reference/recorded_frames.h"
#include "calibration/reference/recording_problem.h"
#include "calibration/reference/recording_study.h"
#include "calibration/reference/rest_pose.h"
#include "core/sensing/markers/layout_search.h"
#include "core/sensing/reference/reference_library.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

namespace alltact {
namespace {

namespace fs = std::filesystem;

constexpr double kRepeatSigmas = 2.0;    // of marker noise: poses nearer than that are the same
constexpr std::size_t kFewFrames = 100;  // below that number even repetitions help against noise

// The usable frames of the new video, by their number in the recording.
std::vector<std::size_t> numbered_frames(const RecordingPass& pass, MadeReference& made) {
  std::vector<std::size_t> selected;
  for (std::size_t i = 0; i < pass.frames.size(); ++i) {
    if (made.numbered.markers[i])
      selected.push_back(i);
    else
      made.report.rejected.push_back(en::at(en::say("frame {}", i), made.numbered.problems[i]));
  }
  return selected;
}

Error too_few(const ReferenceReport& report, std::size_t selected) {
  return {en::say("only {} of {} frames can be used ({})",
                  selected,
                  report.frames_read,
                  report.rejected.front()),
          en::say("recording"),
          en::say("record again with every marker in view and nothing on the contact face")};
}

// Depth, mm, per relative difference in brightness.
double mm_per_part(const Finger& finger) {
  if (finger.mapping)
    if (const auto mapping = Mapping::create(*finger.mapping)) return mapping->slope_mm(0.0);
  // Kubelka and Munk's layer over black, with the scattering of ordinary white silicone, 0.6 / mm.
  return finger.face.layer_mm * (1.0 + 0.6 * finger.face.layer_mm);
}

// Motion from the pair of dots nearest to the tip between which the face is visible in nearly all
// frames, relative to the rest frame.
void add_motion(const std::vector<const StudiedFrame*>& frames,
                const StudiedFrame* rest,
                MotionCoverage& coverage) {
  constexpr double kNearlyAll = 0.8;
  const std::size_t pairs = frames.empty() ? 0 : frames.front()->pairs.size();
  for (std::size_t pair = pairs; pair-- > 0;) {
    std::vector<TipPose> poses;
    for (const StudiedFrame* frame : frames)
      if (pair < frame->pairs.size() && frame->pairs[pair]) poses.push_back(*frame->pairs[pair]);
    if (poses.size() < kNearlyAll * static_cast<double>(frames.size()) || poses.empty()) continue;
    const TipPose& from =
        rest && pair < rest->pairs.size() && rest->pairs[pair] ? *rest->pairs[pair] : poses.front();
    for (const TipPose& pose : poses) coverage.add(motion_between(from, pose));
    return;
  }
}

// Index of the frame closest to the pose; nullopt where no frame shows its dots.
std::optional<std::size_t> frame_nearest_to(const RestPose& pose,
                                            const std::vector<const StudiedFrame*>& frames,
                                            const MotionNeed& need) {
  std::optional<std::size_t> nearest;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const auto& pairs = frames[i]->pairs;
    if (pose.pair >= pairs.size() || !pairs[pose.pair]) continue;
    const TipMotion off = motion_between(pose.pose, *pairs[pose.pair]);
    const double apart = std::hypot(
        off.bend_mm / need.bend_mm, off.sway_mm / need.sway_mm, off.twist_deg / need.twist_deg);
    if (apart < least) least = apart, nearest = i;
  }
  return nearest;
}

// The requested frame, the one closest to the requested pose, or the middle one of those selected.
Status choose_rest(const ReferenceChoices& choices,
                   const std::vector<std::size_t>& selected,
                   const std::vector<const StudiedFrame*>& frames,
                   MadeReference& made) {
  std::optional<std::size_t> nearest;
  if (choices.rest_pose) nearest = frame_nearest_to(*choices.rest_pose, frames, choices.need);
  if (!nearest)
    nearest = static_cast<std::size_t>(middle_pose(table_of(made.numbered, selected).layouts));
  made.rest = selected[*nearest];
  if (const auto& requested = choices.rest_frame) {
    const auto number = static_cast<std::size_t>(*requested);
    const auto& markers = made.numbered.markers;
    const bool is_there = *requested >= 0 && number < markers.size();
    if (!is_there || !markers[number]) {
      const Message why =
          is_there ? made.numbered.problems[number] : en::say("the recording has no such frame");
      return Error{en::say("frame {} cannot be the finger's rest: {}", *requested, why),
                   en::say("recording"),
                   en::say("another frame in which the finger rests")};
    }
    made.rest = number;
  }
  made.report.rest_frame = static_cast<int>(made.rest);
  return {};
}

// Finds contacts in the recording, excludes their frames, and evaluates the others.
Status study(const fs::path& file,
             const RecordingPass& pass,
             const Camera& camera,
             const Finger& finger,
             const Job& job,
             const ReferenceChoices& choices,
             std::optional<EarlierReference>& earlier,
             std::vector<std::size_t>& selected,
             MadeReference& made) {
  auto reader = VideoFile::open(file, job);
  if (!reader) return reader.error();
  const double frames_per_s = reader->frames_per_s();
  RecordedVideo video{pass, file, finger, camera, std::move(*reader)};
  ReferenceReport& report = made.report;
  const Status left_out = exclude_contacts(
      video, made.numbered, earlier, choices, Job(job, 0.0, 0.4), selected, report);
  if (!left_out) return left_out;
  if (selected.size() < 2) return {};
  const MarkerTable table = table_in_video(pass, made.numbered, selected);
  const RecordingFrameReader frame = [&](std::size_t number) { return video.frame(number); };
  const auto library = ReferenceLibrary::from_frames(
      frame, pass.greys.size(), file, table, finger, camera, Job(job, 0.4, 0.6));
  if (!library) return library.error();
  std::vector<std::size_t> of_library;  // by the library's index, the number in the recording
  std::vector<Markers> markers;
  for (std::size_t i = 0, row = 0; row < library->frame_count(); ++i) {
    if (table.frames[i] != library->frame_numbers()[row]) continue;
    of_library.push_back(selected[i]);
    markers.push_back(*made.numbered.markers[selected[i]]);
    ++row;
  }
  selected = std::move(of_library);
  const auto studied =
      study_recording(*library, markers, frame, frames_per_s, finger, camera, Job(job, 0.6, 1.0));
  if (!studied) return studied.error();
  std::vector<const StudiedFrame*> untouched;
  for (const StudiedFrame& one : studied->frames) untouched.push_back(&one);
  const Status rested = choose_rest(choices, selected, untouched, made);
  if (!rested) return rested;
  const auto rest = std::find(selected.begin(), selected.end(), made.rest) - selected.begin();
  add_motion(untouched,
             rest < std::ssize(selected) ? untouched[static_cast<std::size_t>(rest)] : nullptr,
             report.coverage);
  report.error_median = studied->error_median;
  report.error_p95 = studied->error_p95;
  report.nearest_error_median = studied->nearest_error_median;
  report.by_own_mapping = finger.mapping.has_value();
  report.error_median_mm = report.error_median * mm_per_part(finger);
  report.error_p95_mm = report.error_p95 * mm_per_part(finger);
  return {};
}

// Of frames in the same pose only the first is selected: a finger at rest would fill the
// neighbourhood of that pose with copies of one image.
void thin(std::vector<std::size_t>& selected, MadeReference& made) {
  if (selected.size() <= kFewFrames) return;
  const MarkerTable all = table_of(made.numbered, selected);
  const double apart = kRepeatSigmas * made.numbered.marker_noise_px *
                       std::sqrt(static_cast<double>(all.layouts.cols()));
  std::vector<std::size_t> spread;
  std::vector<Eigen::Index> rows;
  for (std::size_t i = 0; i < selected.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    const bool repeats = std::any_of(rows.begin(), rows.end(), [&](Eigen::Index other) {
      return (all.layouts.row(other) - all.layouts.row(row)).norm() < apart;
    });
    if (repeats && selected.size() - i + spread.size() > kFewFrames) continue;
    spread.push_back(selected[i]);
    rows.push_back(row);
  }
  made.report.repeated = static_cast<int>(selected.size() - spread.size());
  selected = std::move(spread);
}

// Reports the missing markers.
void report_missing(MadeReference& made) {
  const NumberedRecording& numbered = made.numbered;
  ReferenceReport& report = made.report;
  report.by_shape = numbered.positions.has_value();
  report.missing = numbered.missing;
  if (!numbered.no_markers.empty())
    report.warnings.push_back(
        en::say("No markers can be used: {}; poses are told by the shape of the face alone, "
                "which cannot tell twist; if the finger has dots, light both side faces so that "
                "they stand out, and focus",
                numbered.no_markers));
  if (!numbered.missing.empty())
    report.remarks.push_back(
        en::say("Markers {} were not found anywhere; the finger works with the other {}",
                fmt::format("{}", fmt::join(numbered.missing, ", ")),
                numbered.typical.size() - numbered.missing.size()));
}

}  // namespace

Finger with_markers(const Finger& finger, const NumberedRecording& numbered) {
  Finger described = finger;
  described.markers.missing = numbered.missing;
  if (!numbered.positions) described.markers.polarity = numbered.polarity;
  described.reference = ReferenceFiles{kReferenceVideo, kReferenceTable, "", numbered.positions};
  return described;
}

Status make_reference(Source& source,
                      const Camera& camera,
                      const Finger& finger,
                      const Job& job,
                      const ReferenceChoices& choices,
                      const fs::path& folder,
                      const fs::path& video,
                      MadeReference& made) {
  const auto pass = read_recording(source, camera, finger, Job(job, 0.0, 0.5), video);
  if (!pass) return pass.error();
  made.settings = pass->settings;
  ReferenceReport& report = made.report;
  report.frames_read = static_cast<int>(pass->frames.size());
  if (pass->frames.size() < 2)
    return Error{en::count("the recording holds {} frames; at least 2 are needed",
                           "the recording holds {} frame; at least 2 are needed",
                           pass->frames.size()),
                 en::say("recording"),
                 en::say("record the finger while it bends slowly in every direction, untouched")};
  job.report(0.5, en::say("numbering the markers"));
  const auto draw = [&](const std::string& sentence) {
    return recording_problem(*pass, made, camera, finger, sentence);
  };
  const auto refuse = [&](const Error& error) -> Status {
    made.problem = draw(error.sentence());
    return error;
  };
  auto result = number_recording(pass->frames, finger.markers);
  if (!result) return refuse(result.error());
  made.numbered = std::move(*result);
  report_missing(made);
  std::vector<std::size_t> selected = numbered_frames(*pass, made);
  if (selected.size() < 2) return refuse(too_few(report, selected.size()));
  std::erase_if(selected, [&](std::size_t frame) { return is_in(choices.leave_out, frame); });
  if (selected.size() < 2)
    return Error{en::say("only {} frames are left of those that are to be used", selected.size()),
                 en::say("recording"),
                 en::say("leave out fewer frames")};
  std::optional<EarlierReference> earlier;
  if (!choices.skin_was_changed)
    earlier = EarlierReference::open(folder, finger, made.numbered, job);
  const Status studied = study(video,
                               *pass,
                               camera,
                               with_markers(finger, made.numbered),
                               Job(job, 0.5, 0.9),
                               choices,
                               earlier,
                               selected,
                               made);
  if (!studied) {
    // The stretches found are part of the refusal.
    if (!report.stretches.empty()) return refuse(studied.error());
    return studied;
  }
  if (selected.size() < 2) return refuse(too_few(report, selected.size()));
  for (const auto* sentences : {&report.warnings, &report.remarks})
    if (!sentences->empty()) made.problem = draw(sentences->front().english() + ".");
  thin(selected, made);
  if (static_cast<int>(selected.size()) < pass->written) {
    std::vector<char> keep(static_cast<std::size_t>(pass->written), 0);
    for (const std::size_t i : selected) keep[static_cast<std::size_t>(pass->in_video[i])] = 1;
    const Status rewritten = retain_frames(video, keep, Job(job, 0.9, 1.0));
    if (!rewritten) return rewritten;
  }
  made.table = table_of(made.numbered, selected);
  report.frames_retained = static_cast<int>(selected.size());
  report.median_step_px = LayoutSearch(made.table.layouts).median_step_px();
  return {};
}

}  // namespace alltact
