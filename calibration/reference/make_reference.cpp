#include "calibration/reference/make_reference.h"

#include "calibration/reference/contact_search.h"
#include "calibration/reference/marker_numbering.h"
#include "calibration/reference/recording_pass.h"
#include "calibration/reference/reference_recording.h"
#include "calibration/reference/skin_brightness.h"
#include "calibration/report/problem_image.h"
#include "core/base/job.h"
#include "core/base/result.h"
#include "core/finger/finger.h"
#include "core/numerics/median.h"
#include "core/recording/video_file.h"
#include "core/sensing/face/face_edges.h"
#include "core/sensing/face/face_shape.h"
#include "core/sensing/markers/marker_model.h"
#include "core/sensing/reference/marker_table.h"
#include "core/sensing/reference/recorded_faces.h"
#include "core/sensing/reference/recorded_poses.h"
#include "core/sensing/reference/reference_library.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Core>
#include <fmt/format.h>
#include <opencv2/core.hpp>

namespace alltact {
namespace {

class EarlierReference {
 public:
  /// At most kMostFrames of it, spread evenly. nullopt: there is none, it cannot be read, or its
  /// poses rely on other markers than those of the new recording.
  static std::optional<EarlierReference> open(const std::filesystem::path& folder,
                                              const Finger& finger,
                                              const NumberedRecording& recording, const Job& job);

  static constexpr std::size_t kMostFrames = 300;

  [[nodiscard]] const MarkerTable& table() const { return table_; }
  /// By its number in the video; CV_8UC1, oriented as the finger's camera.
  [[nodiscard]] Result<cv::Mat> frame(std::size_t number);

 private:
  EarlierReference(CameraParameters camera, VideoFile video, MarkerTable table)
      : camera_(std::move(camera)), video_(std::move(video)), table_(std::move(table)) {}

  CameraParameters camera_;
  VideoFile video_;
  MarkerTable table_;
};

/// Rows spread evenly, at most `most`.
MarkerTable thinned(const MarkerTable& all, std::size_t most) {
  const std::size_t step = (all.frames.size() + most - 1) / most;
  std::vector<std::size_t> rows;
  for (std::size_t row = 0; row < all.frames.size(); row += step) rows.push_back(row);
  return rows_of(all, rows);
}

std::optional<EarlierReference> EarlierReference::open(const std::filesystem::path& folder,
                                                       const Finger& finger,
                                                       const NumberedRecording& recording,
                                                       const Job& job) {
  if (!finger.reference || finger.reference->video.empty() || finger.reference->positions ||
      recording.positions || finger.markers.missing != recording.missing)
    return std::nullopt;
  auto table = MarkerTable::load(folder / finger.reference->markers, finger.marker_count());
  if (!table || table->typical.size() != recording.typical.size() || table->frames.empty())
    return std::nullopt;
  auto video = VideoFile::open(folder / finger.reference->video, job);
  if (!video || static_cast<std::size_t>(table->frames.back()) >= video->frame_count())
    return std::nullopt;
  EarlierReference earlier(finger.camera, std::move(*video), thinned(*table, kMostFrames));
  // The first frame shows whether image size or orientation of the camera have changed.
  if (!earlier.frame(static_cast<std::size_t>(earlier.table_.frames.front()))) return std::nullopt;
  return earlier;
}

Result<cv::Mat> EarlierReference::frame(std::size_t number) {
  return oriented_frame(video_, number, camera_);
}

using FrameJudgements = std::vector<FrameEvidence>;

/// Brightness and pose of frames in order, and their numbers.
struct PosedRows {
  SkinPatches patches;
  Eigen::MatrixXd modes;
  Eigen::VectorXd off_px;
  std::vector<int> numbers;

  [[nodiscard]] FrameJudgements search() const {
    return find_contacts(patches, modes, off_px, numbers);
  }
  [[nodiscard]] PosedRows first(std::size_t count) const {
    const auto n = static_cast<Eigen::Index>(count);
    PosedRows some{patches,
                   modes.topRows(n),
                   off_px.head(n),
                   {numbers.begin(), numbers.begin() + static_cast<std::ptrdiff_t>(count)}};
    some.patches.log_level = patches.log_level.topRows(n);
    return some;
  }
};

/// Frames of the recording that show a face, then those of the earlier reference.
struct ReadFrames {
  PosedRows rows;
  RecordedFaces faces;                ///< of `selected`, then of the earlier reference
  std::vector<std::size_t> numbers;   ///< in the recording, of the first rows
  std::vector<std::size_t> faceless;  ///< in the recording, of those that show no face
};

/// Appends the rows of `below`, whose frames are numbered on from `offset`.
MarkerTable joined(MarkerTable table, const MarkerTable& below, int offset) {
  const Eigen::Index rows = table.layouts.rows();
  table.layouts.conservativeResize(rows + below.layouts.rows(), Eigen::NoChange);
  table.layouts.bottomRows(below.layouts.rows()) = below.layouts;
  for (const int frame : below.frames) table.frames.push_back(offset + frame);
  table.seen.insert(table.seen.end(), below.seen.begin(), below.seen.end());
  return table;
}

Result<ReadFrames> read_frames(RecordedVideo& video, const NumberedRecording& numbered,
                               std::optional<EarlierReference>& earlier,
                               const std::vector<std::size_t>& selected, const Job& job) {
  MarkerTable table = table_in_video(video.pass, numbered, selected);
  const std::size_t recorded = video.pass.greys.size();
  std::size_t all = recorded, most_bytes = std::size_t{512} << 20;
  if (earlier) {
    table = joined(std::move(table), earlier->table(), static_cast<int>(recorded));
    all += static_cast<std::size_t>(earlier->table().frames.back()) + 1;
    most_bytes += most_bytes / selected.size() * earlier->table().frames.size();
  }
  const RecordingFrameReader frame = [&](std::size_t number) {
    return number < recorded ? video.frame(number) : earlier->frame(number - recorded);
  };
  auto read = read_recorded_faces({frame, all, video.pass.video, table, video.pass.edges},
                                  video.finger, video.camera, most_bytes, job);
  if (!read) return read.error();
  const std::vector<int> missing = numbered.positions ? std::vector<int>{} : numbered.missing;
  const auto model = MarkerModel::learn(table.layouts, table.typical, missing);
  if (!model) return Error{model.error().what, video.pass.video.string(), model.error().advice};
  const Eigen::VectorXd mode_sd = model->mode_sd_px();
  ReadFrames result;
  PosedRows& rows = result.rows;
  rows.modes.resize(std::ssize(read->retained), mode_sd.size());
  rows.off_px.resize(std::ssize(read->retained));
  // Far enough apart that no earlier frame counts as taken shortly before or after.
  const int apart = static_cast<int>(selected.back() + table.frames.size());
  for (Eigen::Index i = 0; i < std::ssize(read->retained); ++i) {
    const std::size_t row = read->retained[static_cast<std::size_t>(i)];
    const Markers markers =
        row < selected.size()
            ? *numbered.markers[selected[row]]
            : markers_of(table.layouts, static_cast<Eigen::Index>(row), table.seen[row]);
    rows.modes.row(i) = model->modes(markers).cwiseProduct(mode_sd).transpose();
    rows.off_px[i] = model->residual_px(markers);
    if (row < selected.size()) result.numbers.push_back(selected[row]);
    rows.numbers.push_back(row < selected.size()
                               ? static_cast<int>(selected[row])
                               : apart + table.frames[row] - static_cast<int>(recorded));
  }
  for (std::size_t row = 0; row < selected.size(); ++row)
    if (!std::binary_search(read->seen.begin(), read->seen.end(), static_cast<Eigen::Index>(row)))
      result.faceless.push_back(selected[row]);
  rows.patches = skin_patches(read->grid, read->faces, video.finger.face.width_mm);
  result.faces = std::move(*read);
  return result;
}

bool is_suspect(const FrameEvidence& frame) {
  return frame.contact == FrameContact::kContact || frame.contact == FrameContact::kDoubtful;
}

/// Frames that are chosen to count as untouched are ignored.
bool is_mostly_contact(const FrameJudgements& evidence, const std::vector<std::size_t>& numbers,
                       const ReferenceChoices& choices) {
  std::size_t contact_frames = 0;
  for (std::size_t i = 0; i < numbers.size(); ++i)
    contact_frames +=
        evidence[i].contact == FrameContact::kContact && !is_in(choices.keep, numbers[i]);
  return static_cast<double>(contact_frames) >
         kMaxContactFraction * static_cast<double>(numbers.size());
}

/// An uncompared frame next to a contact frame in time counts as a contact frame, too.
void spread_to_uncompared(FrameJudgements& frames) {
  const auto pass_on = [&](std::size_t from, std::size_t to) {
    if (frames[from].contact == FrameContact::kContact &&
        frames[to].contact == FrameContact::kUncompared)
      frames[to] = frames[from];
  };
  for (std::size_t i = 1; i < frames.size(); ++i) pass_on(i - 1, i);
  for (std::size_t i = frames.size(); i-- > 1;) pass_on(i, i - 1);
}

Message sentence_of(const ReferenceStretch& stretch) {
  const double percent = 100.0 * stretch.darker;
  if (stretch.is_doubtful && stretch.first == stretch.last)
    return en::say(
        "frame {}: something may have pressed on the contact face, {:.0f} mm from its base "
        "({:.1f} % darker than untouched)",
        stretch.first, stretch.along_mm, percent);
  if (stretch.is_doubtful)
    return en::say(
        "frames {} to {}: something may have pressed on the contact face, {:.0f} mm from "
        "its base (up to {:.1f} % darker than untouched)",
        stretch.first, stretch.last, stretch.along_mm, percent);
  if (stretch.first == stretch.last)
    return en::say(
        "frame {}: something pressed on the contact face, {:.0f} mm from its base "
        "({:.0f} % darker than untouched)",
        stretch.first, stretch.along_mm, percent);
  return en::say(
      "frames {} to {}: something pressed on the contact face, {:.0f} mm from its base "
      "(up to {:.0f} % darker than untouched)",
      stretch.first, stretch.last, stretch.along_mm, percent);
}

void report_stretches(const FrameJudgements& evidence, const std::vector<std::size_t>& numbers,
                      const ReferenceChoices& choices, ReferenceReport& report) {
  for (const FrameEvidence& frame : evidence) {
    report.contact_frames += frame.contact == FrameContact::kContact;
    report.doubtful += frame.contact == FrameContact::kDoubtful;
    report.uncompared += frame.contact == FrameContact::kUncompared;
  }
  for (const ContactStretch& found : stretches_of(evidence)) {
    if (found.contact == FrameContact::kUncompared) continue;
    const FrameEvidence& darkest = evidence[found.darkest];
    ReferenceStretch stretch;
    stretch.first = static_cast<int>(numbers[found.first]);
    stretch.last = static_cast<int>(numbers[found.last]);
    stretch.is_doubtful = found.contact != FrameContact::kContact;
    stretch.is_retained = true;
    stretch.darker = darkest.darker;
    stretch.along_mm = darkest.along_mm;
    stretch.across_mm = darkest.across_mm;
    stretch.darkest = static_cast<int>(numbers[found.darkest]);
    for (std::size_t i = found.first;
         i <= found.last && found.contact != FrameContact::kUnexplained; ++i)
      stretch.is_retained = stretch.is_retained && is_in(choices.keep, numbers[i]);
    stretch.sentence = sentence_of(stretch);
    if (!stretch.is_retained) report.rejected.push_back(stretch.sentence);
    report.stretches.push_back(std::move(stretch));
  }
}

/// Most frames are darker than the rest. Poses shown once look the same as a contact most of the
/// time, so that no frame may be left out for it.
void leave_all_in(std::size_t frames, ReferenceReport& report) {
  report.warnings.push_back(
      en::say("In {} of {} frames the face is darker than in the others. Something pressed on it "
              "most of the time, or most poses occur once. All frames stay in use. If there was "
              "contact, record again, and show each pose several times",
              report.contact_frames + report.doubtful, frames));
  report.doubtful += report.contact_frames;
  report.contact_frames = 0;
  for (ReferenceStretch& stretch : report.stretches) {
    std::erase(report.rejected, stretch.sentence);
    stretch.is_doubtful = stretch.is_retained = true;
    stretch.sentence = sentence_of(stretch);
  }
}

/// Undecided frames are retained.
void warn_of_unexplained(const FrameJudgements& evidence, ReferenceReport& report) {
  const auto unexplained = std::count_if(
      evidence.begin(), evidence.end(),
      [](const FrameEvidence& frame) { return frame.contact == FrameContact::kUnexplained; });
  if (unexplained == 0) return;
  report.warnings.push_back(
      en::say("In {} of {} frames the face is darker than in the brightest, and so are frames of "
              "near poses. Something pressed on it for long, or these poses occur once. They stay "
              "in use. If there was contact, record again, and show each pose several times",
              unexplained, evidence.size()));
}

/// Reports the stretch, so that its darkest frame can be shown.
Error refuse(const PersistentContact& touch, const std::vector<std::size_t>& numbers,
             ReferenceReport& report) {
  ReferenceStretch stretch;
  stretch.first = static_cast<int>(numbers.front());
  stretch.last = static_cast<int>(numbers.back());
  stretch.darker = touch.darker;
  stretch.along_mm = touch.along_mm;
  stretch.across_mm = touch.across_mm;
  stretch.darkest = static_cast<int>(numbers[static_cast<std::size_t>(touch.darkest)]);
  stretch.sentence = sentence_of(stretch);
  report.stretches = {stretch};
  return {
      en::say("something pressed on the contact face {:.0f} mm from its base in {} of {} "
              "frames: it is {:.0f} % darker there than in the reference from before",
              touch.along_mm, touch.frames, numbers.size(), 100.0 * touch.darker),
      en::say("recording"),
      en::say(
          "record again with nothing on the contact face, or specify that its skin has changed")};
}

/// Reduces `selected` (numbers in the recording) to frames that show a face and have no certain or
/// doubtful contact, or are chosen explicitly, and returns their faces. Fills the report's
/// stretches and counts. Frames are compared with others of near pose in the recording; the earlier
/// reference reveals a persistent contact (contact_search.h). Errors: stopped; a contact at one
/// position in most frames.
Result<RecordedFaces> exclude_contacts(RecordedVideo& video, const NumberedRecording& numbered,
                                       std::optional<EarlierReference>& earlier,
                                       const ReferenceChoices& choices, const Job& job,
                                       std::vector<std::size_t>& selected,
                                       ReferenceReport& report) {
  auto read = read_frames(video, numbered, earlier, selected, job);
  if (!read) return read.error();
  const std::vector<std::size_t>& numbers = read->numbers;
  for (const std::size_t number : read->faceless) {
    report.uses[number] = FrameUse::kUnusable;
    report.rejected.push_back(en::at(en::say("frame {}", number),
                                     en::say("the two long edges of the face were not found")));
  }
  if (earlier)
    if (const auto touch = find_persistent_contact(read->rows.patches, read->rows.modes,
                                                   static_cast<int>(numbers.size())))
      return refuse(*touch, numbers, report);
  FrameJudgements evidence = read->rows.first(numbers.size()).search();
  const bool is_unsure = is_mostly_contact(evidence, numbers, choices);
  spread_to_uncompared(evidence);
  report_stretches(evidence, numbers, choices, report);
  if (is_unsure)
    leave_all_in(numbers.size(), report);
  else
    warn_of_unexplained(evidence, report);
  std::vector<std::size_t> untouched, rows;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (!is_unsure && is_suspect(evidence[i]) && !is_in(choices.keep, numbers[i])) {
      report.uses[numbers[i]] = FrameUse::kInContact;
      continue;
    }
    untouched.push_back(numbers[i]);
    rows.push_back(read->faces.retained[i]);
  }
  selected = std::move(untouched);
  return faces_of_rows(std::move(read->faces), rows, table_of(numbered, selected),
                       kRecordedFaces_bytes);
}

constexpr double kTouchRadiusMm = 3.0;  // of the circle that is drawn

bool is_cached(const RecordingPass& pass, std::size_t frame) {
  return pass.in_video[frame] >= 0 &&
         !pass.greys[static_cast<std::size_t>(pass.in_video[frame])].empty();
}

/// nullptr: no contact, or its frame is not cached.
const ReferenceStretch* darkest_stretch(const RecordingPass& pass, const ReferenceReport& report) {
  const ReferenceStretch* darkest = nullptr;
  for (const ReferenceStretch& stretch : report.stretches)
    if ((!darkest || stretch.darker > darkest->darker) &&
        is_cached(pass, static_cast<std::size_t>(stretch.darkest)))
      darkest = &stretch;
  return darkest;
}

/// One of the cached frames; their number where there is none.
std::size_t frame_to_show(const RecordingPass& pass, const MadeReference& made) {
  const std::size_t count = pass.frames.size();
  std::size_t frame = count;
  for (std::size_t i = 0; i < count; ++i) {
    if (!is_cached(pass, i)) continue;
    const bool is_numbered = i < made.numbered.markers.size() && made.numbered.markers[i];
    if (frame == count || (i == made.rest && is_numbered)) frame = i;
    if (pass.frames[frame].curves.u.empty() && !pass.frames[i].curves.u.empty()) frame = i;
  }
  return frame;
}

/// The contact's position; nullopt where the face is not found.
std::optional<ProblemMark> mark_of(const ReferenceStretch& stretch, const cv::Mat& grey,
                                   const Camera& camera, const Face& face) {
  const auto edges = FaceEdgeFinder({.view = FaceView{camera, face.width_mm}})(grey);
  if (!edges) return std::nullopt;
  constexpr int kDegree = 7;
  const auto shape = FaceShape::fit(*edges, camera, face, kDegree);
  if (!shape) return std::nullopt;
  for (int u = 0; u < shape->width_px(); ++u) {
    const FaceColumn& column = shape->columns()[static_cast<std::size_t>(u)];
    if (!column.valid || shape->length_at(u) < stretch.along_mm) continue;
    const double part = stretch.across_mm / face.width_mm;  // -0.5 at the upper edge
    return ProblemMark{ProblemMark::Kind::kDarker, static_cast<double>(u),
                       std::lerp(column.upper_v, column.lower_v, 0.5 + part),
                       kTouchRadiusMm / camera.mm_per_px_at(column.z_mm), -1};
  }
  return std::nullopt;
}

void add_dots(const RecordingPass& pass, const NumberedRecording& numbered, std::size_t frame,
              ProblemScene& scene) {
  const bool by_dots =
      !numbered.positions && frame < numbered.markers.size() && numbered.markers[frame];
  if (by_dots)
    for (std::size_t m = 0; m < numbered.markers[frame]->size(); ++m) {
      const Marker& marker = (*numbered.markers[frame])[m];
      scene.marks.push_back({marker.seen ? ProblemMark::Kind::kUsed : ProblemMark::Kind::kExpected,
                             marker.u, marker.v, numbered.typical[m].radius_px,
                             static_cast<int>(m)});
    }
  const bool is_dark = numbered.polarity == Polarity::kDark;
  for (const Dot& dot : is_dark ? pass.frames[frame].dark : pass.frames[frame].bright)
    if (std::none_of(scene.marks.begin(), scene.marks.end(), [&](const ProblemMark& mark) {
          return std::hypot(mark.u - dot.u, mark.v - dot.v) < 1.0;
        }))
      scene.marks.push_back({ProblemMark::Kind::kRefused, dot.u, dot.v, dot.radius_px, -1});
}

/// One frame with its face, markers (missing ones at their expected positions) and rejected dots.
/// With a contact: the frame in which it is darkest, and its position. Else the rest frame where it
/// was numbered, or the first frame with a face, or any. Empty when no frame could be read. `made`:
/// may be partly filled. `sentence`: the problem, in English.
cv::Mat recording_problem(const RecordingPass& pass, const MadeReference& made,
                          const Camera& camera, const Finger& finger, const std::string& sentence) {
  const ReferenceStretch* touch = darkest_stretch(pass, made.report);
  const std::size_t frame =
      touch ? static_cast<std::size_t>(touch->darkest) : frame_to_show(pass, made);
  if (frame == pass.frames.size()) return {};
  ProblemScene scene;
  scene.grey = pass.greys[static_cast<std::size_t>(pass.in_video[frame])];
  scene.edges = pass.frames[frame].curves;
  add_dots(pass, made.numbered, frame, scene);
  scene.words = {
      fmt::format("{} in its frame {} out of {}", finger.name, frame, pass.frames.size()),
      sentence};
  if (touch) {
    if (const auto mark = mark_of(*touch, scene.grey, camera, finger.face))
      scene.marks.push_back(*mark);
    scene.words.push_back(touch->sentence.english());
  }
  return problem_image(scene);
}

/// The row nearest to the median of every coordinate, which does not depend on the time spent at
/// either end of the motion. At least one row, finite.
Eigen::Index middle_pose(const Eigen::MatrixXd& layouts) {
  Eigen::RowVectorXd middle(layouts.cols());
  for (Eigen::Index k = 0; k < layouts.cols(); ++k) {
    const Eigen::VectorXd column = layouts.col(k);
    std::vector<double> values(column.begin(), column.end());
    middle[k] = upper_median(values);
  }
  Eigen::Index nearest = 0;
  (layouts.rowwise() - middle).rowwise().squaredNorm().minCoeff(&nearest);
  return nearest;
}

namespace fs = std::filesystem;

constexpr double kRepeatSigmas = 2.0;    // of marker noise: poses nearer than that are the same
constexpr std::size_t kFewFrames = 100;  // below that number even repetitions help against noise

// The usable frames of the new video, by their number in the recording.
std::vector<std::size_t> numbered_frames(const RecordingPass& pass, MadeReference& made) {
  std::vector<std::size_t> selected;
  made.report.uses.assign(pass.frames.size(), FrameUse::kRepresented);
  for (std::size_t i = 0; i < pass.frames.size(); i += pass.every) {
    if (made.numbered.markers[i]) {
      selected.push_back(i);
      continue;
    }
    made.report.uses[i] = FrameUse::kUnusable;
    made.report.rejected.push_back(en::at(en::say("frame {}", i), made.numbered.problems[i]));
  }
  return selected;
}

Error too_few(const ReferenceReport& report, std::size_t selected) {
  return {en::say("only {} of {} frames can be used ({})", selected, report.frames_read,
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
void add_motion(const std::vector<const StudiedFrame*>& frames, const StudiedFrame* rest,
                MotionCoverage& coverage) {
  constexpr double kNearlyAll = 0.8;
  const std::size_t pairs = frames.empty() ? 0 : frames.front()->pairs.size();
  for (std::size_t pair = pairs; pair-- > 0;) {
    std::vector<TipPose> poses;
    for (const StudiedFrame* frame : frames)
      if (pair < frame->pairs.size() && frame->pairs[pair]) poses.push_back(*frame->pairs[pair]);
    if (static_cast<double>(poses.size()) < kNearlyAll * static_cast<double>(frames.size()) ||
        poses.empty())
      continue;
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
    const double apart = std::hypot(off.bend_mm / need.bend_mm, off.sway_mm / need.sway_mm,
                                    off.twist_deg / need.twist_deg);
    if (apart < least) least = apart, nearest = i;
  }
  return nearest;
}

// The requested frame, the one closest to the requested pose, or the middle one of those selected.
// every: RecordingPass::every.
Status choose_rest(const ReferenceChoices& choices, std::size_t every,
                   const std::vector<std::size_t>& selected,
                   const std::vector<const StudiedFrame*>& frames, MadeReference& made) {
  std::optional<std::size_t> nearest;
  if (choices.rest_pose) nearest = frame_nearest_to(*choices.rest_pose, frames, choices.need);
  if (!nearest)
    nearest = static_cast<std::size_t>(middle_pose(table_of(made.numbered, selected).layouts));
  made.rest = selected[*nearest];
  if (const auto& requested = choices.rest_frame) {
    auto number = static_cast<std::size_t>(*requested);
    const auto& markers = made.numbered.markers;
    const bool is_there = *requested >= 0 && number < markers.size();
    number -= number % every;
    if (!is_there || !markers[number]) {
      const Message why =
          is_there ? made.numbered.problems[number] : en::say("the recording has no such frame");
      return Error{en::say("frame {} cannot be the rest pose: {}", *requested, why),
                   en::say("recording"), en::say("another frame in which the finger rests")};
    }
    made.rest = number;
  }
  made.report.rest_frame = static_cast<int>(made.rest);
  return {};
}

// Finds contacts in the recording, excludes their frames, and evaluates the others.
Status study(const RecordingPass& pass, const Camera& camera, const Finger& finger, const Job& job,
             const ReferenceChoices& choices, std::optional<EarlierReference>& earlier,
             std::vector<std::size_t>& selected, MadeReference& made) {
  auto reader = VideoFile::open(pass.video, job);
  if (!reader) return reader.error();
  RecordedVideo video{pass, finger, camera, std::move(*reader)};
  ReferenceReport& report = made.report;
  auto faces = exclude_contacts(video, made.numbered, earlier, choices, Job(job, 0.0, 0.4),
                                selected, report);
  if (!faces) return faces.error();
  if (selected.size() < 2) return {};
  const MarkerTable table = table_in_video(pass, made.numbered, selected);
  const auto library =
      ReferenceLibrary::from_faces(std::move(*faces), table, finger, camera, pass.video);
  if (!library) return library.error();
  std::vector<std::size_t> of_library;  // by the library's index, the number in the recording
  std::vector<StudyInput> recorded;
  for (std::size_t i = 0, row = 0; row < library->frame_count(); ++i) {
    if (table.frames[i] != library->frame_numbers()[row]) continue;
    of_library.push_back(selected[i]);
    recorded.push_back({selected[i], *made.numbered.markers[selected[i]]});
    ++row;
  }
  selected = std::move(of_library);
  const auto studied = study_recording(*library, recorded, video, Job(job, 0.6, 1.0));
  if (!studied) return studied.error();
  std::vector<const StudiedFrame*> untouched;
  for (const StudiedFrame& one : studied->frames) untouched.push_back(&one);
  const Status rested = choose_rest(choices, pass.every, selected, untouched, made);
  if (!rested) return rested;
  const auto rest = std::find(selected.begin(), selected.end(), made.rest) - selected.begin();
  add_motion(untouched,
             rest < std::ssize(selected) ? untouched[static_cast<std::size_t>(rest)] : nullptr,
             report.coverage);
  report.error_median = studied->error_median;
  report.error_p95 = studied->error_p95;
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
    if (repeats && selected.size() - i + spread.size() > kFewFrames) {
      made.report.uses[selected[i]] = FrameUse::kRepeatsPose;
      continue;
    }
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
    report.warnings.push_back(en::say(
        "No markers can be used: {}. Poses are estimated from the shape of the face alone, without "
        "twist. If the finger has dots, light both side faces so that they stand out, and focus",
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

Status make_reference(Source& source, const Camera& camera, const Finger& finger, const Job& job,
                      const ChoicesWhenRead& choices_when_read, const fs::path& folder,
                      const fs::path& video, MadeReference& made) {
  const auto pass = read_recording(source, camera, finger, Job(job, 0.0, 0.5), video);
  if (!pass) return pass.error();
  const ReferenceChoices choices = choices_when_read();
  made.settings = pass->settings;
  ReferenceReport& report = made.report;
  report.coverage = MotionCoverage(choices.need);
  report.frames_read = static_cast<int>(pass->frames.size());
  if (pass->frames.size() < 2)
    return Error{
        en::count("the recording holds {} frames; at least 2 are needed",
                  "the recording holds {} frame; at least 2 are needed", pass->frames.size()),
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
  std::erase_if(selected, [&](std::size_t frame) {
    const bool is_excluded = is_in(choices.leave_out, frame);
    if (is_excluded) report.uses[frame] = FrameUse::kExcluded;
    return is_excluded;
  });
  if (selected.size() < 2)
    return Error{en::say("only {} frames are left to use", selected.size()), en::say("recording"),
                 en::say("leave out fewer frames")};
  std::optional<EarlierReference> earlier;
  if (!choices.skin_was_changed)
    earlier = EarlierReference::open(folder, finger, made.numbered, job);
  const Status studied = study(*pass, camera, with_markers(finger, made.numbered),
                               Job(job, 0.5, 0.9), choices, earlier, selected, made);
  if (!studied) {
    // The stretches found are part of the refusal.
    if (!report.stretches.empty()) return refuse(studied.error());
    return studied;
  }
  if (selected.size() < 2) return refuse(too_few(report, selected.size()));
  for (const auto* sentences : {&report.warnings, &report.remarks})
    if (!sentences->empty()) made.problem = draw(sentences->front().english() + ".");
  thin(selected, made);
  if (const Status retained = retain_frames(*pass, selected, video, Job(job, 0.9, 1.0)); !retained)
    return retained;
  made.table = table_of(made.numbered, selected);
  for (const std::size_t frame : selected) report.uses[frame] = FrameUse::kRetained;
  report.frames_retained = static_cast<int>(selected.size());
  report.median_step_px = LayoutSearch(made.table.layouts).median_step_px();
  return {};
}

}  // namespace alltact
