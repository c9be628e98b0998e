#include "calibration/reference/contact_frames.h"

#include "calibration/reference/contact_search.h"
#include "calibration/reference/persistent_contact.h"
#include "calibration/reference/skin_patches.h"
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

Result<ReadFrames> read_frames(RecordedVideo& video,
                               const NumberedRecording& numbered,
                               std::optional<EarlierReference>& earlier,
                               const std::vector<std::size_t>& selected,
                               const Job& job) {
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
  const auto read = read_recorded_faces(
      {frame, all, video.file, table}, video.finger, video.camera, most_bytes, job);
  if (!read) return read.error();
  const std::vector<int> missing = numbered.positions ? std::vector<int>{} : numbered.missing;
  const auto model = MarkerModel::learn(table.layouts, table.typical, missing);
  if (!model) return Error{model.error().what, video.file.string(), model.error().advice};
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
  return result;
}

bool is_suspect(const FrameEvidence& frame) {
  return frame.touch == FrameContact::kContact || frame.touch == FrameContact::kDoubtful;
}

/// Frames that are chosen to count as untouched are ignored.
bool is_mostly_contact(const FrameJudgements& evidence,
                       const std::vector<std::size_t>& numbers,
                       const ReferenceChoices& choices) {
  std::size_t contact_frames = 0;
  for (std::size_t i = 0; i < numbers.size(); ++i)
    contact_frames +=
        evidence[i].touch == FrameContact::kContact && !is_in(choices.keep, numbers[i]);
  return static_cast<double>(contact_frames) >
         kMaxContactFraction * static_cast<double>(numbers.size());
}

/// An uncompared frame next to a contact frame in time counts as a contact frame, too.
void spread_to_uncompared(FrameJudgements& frames) {
  const auto pass_on = [&](std::size_t from, std::size_t to) {
    if (frames[from].touch == FrameContact::kContact &&
        frames[to].touch == FrameContact::kUncompared)
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
    report.contact_frames += frame.touch == FrameContact::kContact;
    report.doubtful += frame.touch == FrameContact::kDoubtful;
    report.uncompared += frame.touch == FrameContact::kUncompared;
  }
  for (const ContactStretch& found : stretches_of(evidence)) {
    if (found.touch == FrameContact::kUncompared) continue;
    const FrameEvidence& darkest = evidence[found.darkest];
    ReferenceStretch stretch;
    stretch.first = static_cast<int>(numbers[found.first]);
    stretch.last = static_cast<int>(numbers[found.last]);
    stretch.is_doubtful = found.touch != FrameContact::kContact;
    stretch.is_retained = true;
    stretch.darker = darkest.darker;
    stretch.along_mm = darkest.along_mm;
    stretch.across_mm = darkest.across_mm;
    stretch.darkest = static_cast<int>(numbers[found.darkest]);
    for (std::size_t i = found.first; i <= found.last && found.touch != FrameContact::kUnexplained;
         ++i)
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
      en::say("In {} of {} frames the face is darker than in the others: something pressed on it "
              "most of the time, or most poses were shown once. All frames stay in; if anything "
              "touched the face, record again, and show each pose several times",
              report.contact_frames + report.doubtful,
              frames));
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
  const auto unexplained =
      std::count_if(evidence.begin(), evidence.end(), [](const FrameEvidence& frame) {
        return frame.touch == FrameContact::kUnexplained;
      });
  if (unexplained == 0) return;
  report.warnings.push_back(en::say(
      "In {} of {} frames the face is darker than in the brightest, and so are frames of near "
      "poses: something pressed on it for long, or these poses were shown once. They stay in; if "
      "anything touched the face, record again, and show each pose several times",
      unexplained,
      evidence.size()));
}

/// Reports the stretch, so that its darkest frame can be shown.
Error refuse(const PersistentContact& touch,
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

Status exclude_contacts(RecordedVideo& video,
                        const NumberedRecording& numbered,
                        std::optional<EarlierReference>& earlier,
                        const ReferenceChoices& choices,
                        const Job& job,
                        std::vector<std::size_t>& selected,
                        ReferenceReport& report) {
  const auto read = read_frames(video, numbered, earlier, selected, job);
  if (!read) return read.error();
  const std::vector<std::size_t>& numbers = read->numbers;
  for (const std::size_t number : read->faceless)
    report.rejected.push_back(en::at(en::say("frame {}", number),
                                     en::say("the two long edges of the face were not found")));
  if (earlier)
    if (const auto touch = find_persistent_contact(
            read->rows.patches, read->rows.modes, static_cast<int>(numbers.size())))
      return refuse(*touch, numbers, report);
  FrameJudgements evidence = read->rows.first(numbers.size()).search();
  const bool is_unsure = is_mostly_contact(evidence, numbers, choices);
  spread_to_uncompared(evidence);
  report_stretches(evidence, numbers, choices, report);
  if (is_unsure)
    leave_all_in(numbers.size(), report);
  else
    warn_of_unexplained(evidence, report);
  selected.clear();
  for (std::size_t i = 0; i < numbers.size(); ++i)
    if (is_unsure || !is_suspect(evidence[i]) || is_in(choices.keep, numbers[i]))
      selected.push_back(numbers[i]);
  return {};
}

}  // namespace alltact
