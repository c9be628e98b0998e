// From a recording of the bending, untouched finger to its reference library.
#pragma once

#include "calibration/reference/motion_coverage.h"
#include "core/finger/finger.h"
#include "core/job.h"
#include "core/message.h"
#include "core/result.h"
#include "core/sources/source.h"

#include <filesystem>
#include <optional>
#include <vector>

namespace alltact {

/// Frames of a recording that follow each other and in which something pressed on the contact face,
/// or may have.
struct ReferenceStretch {
  int first = 0, last = 0;   ///< numbers in the recording
  bool is_doubtful = false;  ///< something may have pressed
  bool is_kept = false;      ///< all of it stays in: by ReferenceChoices, or as nobody can tell
  double darker = 0;         ///< at most, 0.1: by 10 %
  double along_mm = 0;       ///< where that is, from the base
  double across_mm = 0;      ///< and from the middle line
  int darkest = 0;           ///< number of the frame in which it is
  Message sentence;          ///< frames, what pressed where, how much darker
};

struct ReferenceReport {
  int frames_read = 0;
  int frames_kept = 0;
  /// "frame 17: only 5 of 12 markers found", "frames 120 to 163: something pressed ...", ...
  std::vector<Message> rejected;
  std::vector<ReferenceStretch> stretches;  ///< touched, or doubtful; ascending
  int touched = 0;                          ///< frames in which something pressed
  int doubtful = 0;                         ///< frames in which something may have pressed
  /// Frames of poses that no other frame shows at another time: a touch would not be seen in them.
  int uncompared = 0;
  std::vector<Message> remarks;
  std::vector<Message> warnings;  ///< sentences: settings of camera and light that do not fit
  double median_step_px = 0;      ///< mean marker distance from a frame to its nearest other
  int repeated = 0;               ///< frames left out because others show the same pose
  /// What references made from this recording are off by: half of the frames by less than the
  /// first, 95 % by less than the second. Parts of the brightness, and what that is in depth, by
  /// the finger's mapping or, before there is one, by that of a usual layer.
  double error_median = 0, error_p95 = 0;
  double error_median_mm = 0, error_p95_mm = 0;
  bool by_own_mapping = false;
  double nearest_error_median = 0;  ///< the same for the nearest frame alone
  MotionCoverage coverage{MotionNeed{}};
  std::vector<int> missing;  ///< numbers of markers that the finger does not have, ascending
  bool by_shape = false;     ///< poses are told by places of the face, because it has no markers
  int rest_frame = 0;        ///< number in the recording of the frame that counts as rest
};

/// Of a finger that somebody saw at rest: where a pair of its dots was then.
struct RestPose {
  std::size_t pair = 0;  ///< 0 at the base
  TipPlace place;
};

/// Frames of a recording, both ends included.
struct FrameRange {
  int first = 0, last = 0;

  [[nodiscard]] bool holds(int frame) const { return first <= frame && frame <= last; }
};
[[nodiscard]] bool is_in(const std::vector<FrameRange>& ranges, std::size_t frame);

/// Where something seems to press in more of the frames than this fraction, none is left out for it
/// and a warning says so: poses that were shown once look the same. Only an earlier reference can
/// tell, and a recording is refused if that shows that something pressed at one place.
inline constexpr double kMostTouchedFrames = 0.75;

/// What a recording is installed with.
struct ReferenceChoices {
  MotionNeed need;
  /// Number in the recording of the frame that shows the finger at rest; absent: the frame nearest
  /// to `rest_pose`, and without that the one nearest to the middle of all poses.
  std::optional<int> rest_frame;
  std::optional<RestPose> rest_pose;
  /// Frames that count as untouched whatever they look like, and frames that are not used at all,
  /// which wins where both name a frame.
  std::vector<FrameRange> keep, leave_out;
  /// The finger's earlier reference does not tell how its skin looks now: it was cleaned, painted
  /// or replaced.
  bool skin_was_changed = false;
};

/// Name of the picture that a refused recording leaves in the finger's folder.
inline constexpr const char* kReferenceProblem = "reference.problem.png";

/// Tracks the markers through the recording (see recording_layouts.h), rejects frames that cannot
/// be used or in which something presses on the contact face (see touch_search.h), thins those
/// that repeat a pose, and installs what is left in the folder: reference.mkv (lossless, grey, as
/// the source gave it), reference.csv, and in `finger` the file names, the markers' polarity and
/// the numbers of those it lacks, the layout at rest, the touch threshold (from the recording's own
/// marker noise) and what the camera was set to. Where there are no markers to be found, places of
/// the face stand in for them, and a warning says so. The files are written whole or not at all;
/// `finger` is changed only on success and not saved.
///   into: where the two files are put for now (FolderChange::staged); empty: in the folder
///
/// Where markers are missing or the recording is refused, reference.problem.png in the folder shows
/// what was found (problem_picture.h); it is removed by a recording without such a problem.
/// Errors: fewer than 2 frames, wrong size, no face, a frame at rest that cannot be used, something
/// that pressed at one place most of the time.
[[nodiscard]] Result<ReferenceReport> install_reference(Source& source,
                                                        const std::filesystem::path& folder,
                                                        Finger& finger,
                                                        const Job& job,
                                                        const ReferenceChoices& choices = {},
                                                        const std::filesystem::path& into = {});

/// Of a flat sensor.
struct UntouchedPicture {
  cv::Mat grey;          ///< CV_8UC1, as the camera gave it
  std::string controls;  ///< what camera and light were set to; empty: not told
  Where origin;          ///< for errors
};
[[nodiscard]] Result<UntouchedPicture> read_untouched_picture(const std::filesystem::path& file);

/// A flat sensor's one untouched picture: written into the folder as reference.png; `finger` is
/// changed and not saved. Gives warnings as above.
[[nodiscard]] Result<std::vector<Message>> install_flat_reference(
    const UntouchedPicture& picture, const std::filesystem::path& folder, Finger& finger);

}  // namespace alltact
