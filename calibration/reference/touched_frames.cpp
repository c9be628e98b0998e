#include "calibration/reference/touched_frames.h"

#include "calibration/reference/lasting_touch.h"
#include "calibration/reference/skin_patches.h"
#include "calibration/reference/touch_search.h"
#include "core/sensing/reference/recorded_faces.h"

#include <algorithm>

namespace alltact {
namespace {

using FrameJudgements = std::vector<FrameEvidence>;

/// Brightness and pose of frames in order, and their numbers.
struct PosedRows {
  SkinPatches patches;
  Eigen::MatrixXd modes;
  Eigen::VectorXd off_px;
  std::vector<int> numbers;

  [[nodiscard]] FrameJudgements search() const {
    return find_touches(patches, modes, off_px, numbers);
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

/// Frames of the recording that show a face, and those of the earlier reference behind them.
struct ReadFrames {
  PosedRows rows;
  std::vector<std::size_t> numbers;   ///< in the recording, of the first rows
  std::vector<std::size_t> faceless;  ///< in the recording, of those that show no face
};

/// The rows of one table below those of the other, whose frames are numbered on from `offset`.
MarkerTable joined(MarkerTable table, const MarkerTable& below, int offset) {
  const Eigen::Index rows = table.layouts.rows();
  table.layouts.conservativeResize(rows + below.layouts.rows(), Eigen::NoChange);
  table.layouts.bottomRows(below.layouts.rows()) = below.layouts;
  for (const int frame : below.frames) table.frames.push_back(offset + frame);
  table.seen.insert(table.seen.end(), below.seen.begin(), below.seen.end());
  return table;
}

Result<ReadFrames> read_frames(RecordedVideo& video,
                               const NumberedRecording& numbered,
                               std::optional<EarlierReference>& earlier,
                               const std::vector<std::size_t>& kept,
                               const Job& job) {
  MarkerTable table = table_in_video(video.pass, numbered, kept);
  const std::size_t recorded = video.pass.greys.size();
  std::size_t all = recorded, most_bytes = std::size_t{512} << 20;
  if (earlier) {
    table = joined(std::move(table), earlier->table(), static_cast<int>(recorded));
    all += static_cast<std::size_t>(earlier->table().frames.back()) + 1;
    most_bytes += most_bytes / kept.size() * earlier->table().frames.size();
  }
  const FrameOfRecording frame = [&](std::size_t number) {
    return number < recorded ? video.frame(number) : earlier->frame(number - recorded);
  };
  const auto read = read_recorded_faces(
      {frame, all, video.file, table}, video.finger, video.camera, most_bytes, job);
  if (!read) return read.error();
  const std::vector<int> missing = numbered.places ? std::vector<int>{} : numbered.missing;
  const auto model = MarkerModel::learn(table.layouts, table.typical, missing);
  if (!model) return Error{model.error().what, video.file.string(), model.error().advice};
  const Eigen::VectorXd mode_sd = model->mode_sd_px();
  ReadFrames result;
  PosedRows& rows = result.rows;
  rows.modes.resize(std::ssize(read->kept), mode_sd.size());
  rows.off_px.resize(std::ssize(read->kept));
  // So far away that none of the earlier frames counts as taken shortly before or after.
  const int apart = static_cast<int>(kept.back() + table.frames.size());
  for (Eigen::Index i = 0; i < std::ssize(read->kept); ++i) {
    const std::size_t row = read->kept[static_cast<std::size_t>(i)];
    const Markers markers =
        row < kept.size()
            ? *numbered.markers[kept[row]]
            : markers_of(table.layouts, static_cast<Eigen::Index>(row), table.seen[row]);
    rows.modes.row(i) = model->modes(markers).cwiseProduct(mode_sd).transpose();
    rows.off_px[i] = model->residual_px(markers);
    if (row < kept.size()) result.numbers.push_back(kept[row]);
    rows.numbers.push_back(row < kept.size()
                               ? static_cast<int>(kept[row])
                               : apart + table.frames[row] - static_cast<int>(recorded));
  }
  for (std::size_t row = 0; row < kept.size(); ++row)
    if (!std::binary_search(read->seen.begin(), read->seen.end(), static_cast<Eigen::Index>(row)))
      result.faceless.push_back(kept[row]);
  rows.patches = skin_patches(read->grid, read->faces, video.finger.face.width_mm);
  return result;
}

bool is_suspect(const FrameEvidence& frame) {
  return frame.touch == FrameTouch::kTouched || frame.touch == FrameTouch::kDoubtful;
}

/// Frames that are chosen to count as untouched do not count.
bool is_mostly_touched(const FrameJudgements& evidence,
                       const std::vector<std::size_t>& numbers,
                       const ReferenceChoices& choices) {
  std::size_t touched = 0;
  for (std::size_t i = 0; i < numbers.size(); ++i)
    touched += evidence[i].touch == FrameTouch::kTouched && !is_in(choices.keep, numbers[i]);
  return static_cast<double>(touched) > kMostTouchedFrames * static_cast<double>(numbers.size());
}

/// A frame that could not be compared and lies beside a touched one in time counts as touched, too.
void spread_to_uncompared(FrameJudgements& frames) {
  const auto pass_on = [&](std::size_t from, std::size_t to) {
    if (frames[from].touch == FrameTouch::kTouched && frames[to].touch == FrameTouch::kUncompared)
      frames[to] = frames[from];
  };
  for (std::size_t i = 1; i < frames.size(); ++i) pass_on(i - 1, i);
  for (std::size_t i = frames.size(); i-- > 1;) pass_on(i, i - 1);
}

Message sentence_of(const ReferenceStretch& stretch) {
  const double percent = 100.0 * stretch.darker;
  if (stretch.is_doubtful)
    return en::say(
        "frames {} to {}: something may have pressed on the contact face, {:.0f} mm from "
        "its base (up to {:.1f} % darker than untouched)",
        stretch.first,
        stretch.last,
        stretch.along_mm,
        percent);
  if (stretch.first == stretch.last)
    return en::say(
        "frame {}: something pressed on the contact face, {:.0f} mm from its base "
        "({:.0f} % darker than untouched)",
        stretch.first,
        stretch.along_mm,
        percent);
  return en::say(
      "frames {} to {}: something pressed on the contact face, {:.0f} mm from its base "
      "(up to {:.0f} % darker than untouched)",
      stretch.first,
      stretch.last,
      stretch.along_mm,
      percent);
}

void report_stretches(const FrameJudgements& evidence,
                      const std::vector<std::size_t>& numbers,
                      const ReferenceChoices& choices,
                      ReferenceReport& report) {
  for (const FrameEvidence& frame : evidence) {
    report.touched += frame.touch == FrameTouch::kTouched;
    report.doubtful += frame.touch == FrameTouch::kDoubtful;
    report.uncompared += frame.touch == FrameTouch::kUncompared;
  }
  for (const TouchStretch& found : stretches_of(evidence)) {
    if (found.touch == FrameTouch::kUncompared) continue;
    const FrameEvidence& darkest = evidence[found.darkest];
    ReferenceStretch stretch;
    stretch.first = static_cast<int>(numbers[found.first]);
    stretch.last = static_cast<int>(numbers[found.last]);
    stretch.is_doubtful = found.touch != FrameTouch::kTouched;
    stretch.is_kept = true;
    stretch.darker = darkest.darker;
    stretch.along_mm = darkest.along_mm;
    stretch.across_mm = darkest.across_mm;
    stretch.darkest = static_cast<int>(numbers[found.darkest]);
    for (std::size_t i = found.first; i <= found.last && found.touch != FrameTouch::kUnexplained;
         ++i)
      stretch.is_kept = stretch.is_kept && is_in(choices.keep, numbers[i]);
    stretch.sentence = sentence_of(stretch);
    if (!stretch.is_kept) report.rejected.push_back(stretch.sentence);
    report.stretches.push_back(std::move(stretch));
  }
}

/// Most frames are darker than the rest. Poses that were shown once look the same as something that
/// pressed most of the time, so that no frame may be left out for it.
void leave_all_in(std::size_t frames, ReferenceReport& report) {
  report.warnings.push_back(
      en::say("In {} of {} frames the face is darker than in the others: something pressed on it "
              "most of the time, or most poses were shown once. All frames stay in; if anything "
              "touched the face, record again, and show each pose several times",
              report.touched + report.doubtful,
              frames));
  report.doubtful += report.touched;
  report.touched = 0;
  for (ReferenceStretch& stretch : report.stretches) {
    std::erase(report.rejected, stretch.sentence);
    stretch.is_doubtful = stretch.is_kept = true;
    stretch.sentence = sentence_of(stretch);
  }
}

/// Frames of which nobody can tell stay in.
void warn_of_unexplained(const FrameJudgements& evidence, ReferenceReport& report) {
  const auto unexplained =
      std::count_if(evidence.begin(), evidence.end(), [](const FrameEvidence& frame) {
        return frame.touch == FrameTouch::kUnexplained;
      });
  if (unexplained == 0) return;
  report.warnings.push_back(en::say(
      "In {} of {} frames the face is darker than in the brightest, and so are frames of near "
      "poses: something pressed on it for long, or these poses were shown once. They stay in; if "
      "anything touched the face, record again, and show each pose several times",
      unexplained,
      evidence.size()));
}

/// The stretch is told, so that its darkest frame can be shown.
Error refuse(const LastingTouch& touch,
             const std::vector<std::size_t>& numbers,
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
  return {en::say("something pressed on the contact face {:.0f} mm from its base in {} of {} "
                  "frames: it is {:.0f} % darker there than in the reference from before",
                  touch.along_mm,
                  touch.frames,
                  numbers.size(),
                  100.0 * touch.darker),
          en::say("recording"),
          en::say("record again with nothing on the contact face, or say that its skin was changed "
                  "since")};
}

}  // namespace

Status leave_out_touched(RecordedVideo& video,
                         const NumberedRecording& numbered,
                         std::optional<EarlierReference>& earlier,
                         const ReferenceChoices& choices,
                         const Job& job,
                         std::vector<std::size_t>& kept,
                         ReferenceReport& report) {
  const auto read = read_frames(video, numbered, earlier, kept, job);
  if (!read) return read.error();
  const std::vector<std::size_t>& numbers = read->numbers;
  for (const std::size_t number : read->faceless)
    report.rejected.push_back(en::at(en::say("frame {}", number),
                                     en::say("the two long edges of the face were not found")));
  if (earlier)
    if (const auto touch = find_lasting_touch(
            read->rows.patches, read->rows.modes, static_cast<int>(numbers.size())))
      return refuse(*touch, numbers, report);
  FrameJudgements evidence = read->rows.first(numbers.size()).search();
  const bool is_unsure = is_mostly_touched(evidence, numbers, choices);
  spread_to_uncompared(evidence);
  report_stretches(evidence, numbers, choices, report);
  if (is_unsure)
    leave_all_in(numbers.size(), report);
  else
    warn_of_unexplained(evidence, report);
  kept.clear();
  for (std::size_t i = 0; i < numbers.size(); ++i)
    if (is_unsure || !is_suspect(evidence[i]) || is_in(choices.keep, numbers[i]))
      kept.push_back(numbers[i]);
  return {};
}

}  // namespace alltact
