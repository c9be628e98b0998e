// From a recording of the bending, untouched finger to its reference library.
#pragma once

#include "calibration/reference/motion_coverage.h"
#include "core/base/atomic_file.h"
#include "core/base/job.h"
#include "core/base/message.h"
#include "core/base/result.h"
#include "core/finger/finger.h"
#include "core/image/frame.h"
#include "core/sources/source.h"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <vector>

namespace alltact {

/// Consecutive frames of a recording with a certain or possible contact on the contact face.
struct ReferenceStretch {
  int first = 0, last = 0;   ///< numbers in the recording
  bool is_doubtful = false;  ///< the contact is not certain
  bool is_retained = false;  ///< all frames are retained: by ReferenceChoices, or undecided
  double darker = 0;         ///< maximum, 0.1: by 10 %
  double along_mm = 0;       ///< its position, from the base
  double across_mm = 0;      ///< and from the middle line
  int darkest = 0;           ///< number of its frame
  Message sentence;          ///< frames, position of the contact, darkening
};

/// What becomes of a recorded frame.
enum class FrameUse : std::uint8_t {
  kUnusable = 1,  ///< no face, too few markers, or unreadable
  kExcluded,      ///< by ReferenceChoices::leave_out
  kInContact,     ///< something presses on the contact face, or may do so
  kRepeatsPose,   ///< others show the same pose
  kRepresented,   ///< by neighbouring frames or those of near pose: the recording is long
  kRetained
};

struct ReferenceReport {
  std::vector<FrameUse> uses;  ///< by number in the recording
  int frames_read = 0;
  int frames_retained = 0;
  /// "frame 17: only 5 of 12 markers found", "frames 120 to 163: something pressed ...", ...
  std::vector<Message> rejected;
  std::vector<ReferenceStretch> stretches;  ///< with certain or doubtful contact; ascending
  int contact_frames = 0;                   ///< frames with a certain contact
  int doubtful = 0;                         ///< frames with a possible contact
  /// Frames of poses that no other frame shows at another time: a contact would be invisible in
  /// them.
  int uncompared = 0;
  std::vector<Message> remarks;
  std::vector<Message> warnings;  ///< sentences: settings of camera and light that do not fit
  double median_step_px = 0;      ///< mean marker distance from a frame to its nearest other
  int repeated = 0;               ///< frames left out because others show the same pose
  /// Errors of references from this recording: half of the frames are below the first, 95 % below
  /// the second. As fractions of the brightness, and as depth by the finger's mapping, or by that
  /// of a typical layer before there is one.
  double error_median = 0, error_p95 = 0;
  double error_median_mm = 0, error_p95_mm = 0;
  bool by_own_mapping = false;
  MotionCoverage coverage{MotionNeed{}};
  std::vector<int> missing;  ///< numbers of markers that the finger does not have, ascending
  bool by_shape = false;     ///< poses come from positions on the face, because it has no markers
  int rest_frame = 0;        ///< number in the recording of the rest frame
};

/// Frames of a recording, both ends included.
struct FrameRange {
  int first = 0, last = 0;

  [[nodiscard]] bool holds(int frame) const { return first <= frame && frame <= last; }
};
[[nodiscard]] bool is_in(const std::vector<FrameRange>& ranges, std::size_t frame);

/// Above this fraction of contact frames none is left out and a warning is given: poses shown once
/// look the same. Only an earlier reference can decide, and a recording with a contact at one
/// position is then refused.
inline constexpr double kMaxContactFraction = 0.75;

/// Options of installing a recording.
struct ReferenceChoices {
  MotionNeed need;
  /// Number in the recording of the rest frame, of a long one of the examined frame before it;
  /// empty: the frame nearest to `rest_pose`, else the one nearest to the middle of all poses.
  std::optional<int> rest_frame;
  std::optional<RestPose> rest_pose;
  /// Frames that count as untouched in any case, and frames that are not used at all. The second
  /// list wins where both name a frame.
  std::vector<FrameRange> keep, leave_out;
  /// The finger's earlier reference does not show its present skin: it was cleaned, painted or
  /// replaced.
  bool skin_was_changed = false;
};

/// Called once the last frame is read: of a recording that still runs, not all is chosen before.
using ChoicesWhenRead = std::function<ReferenceChoices()>;

/// Name of the image that a refused recording leaves in the finger's folder.
inline constexpr const char* kReferenceProblem = "reference.problem.png";

/// Tracks the markers through the recording (marker_numbering.h) and rejects unusable frames and
/// frames with a contact on the contact face (contact_search.h). Thins frames that repeat a pose.
/// Installs the others in the folder: reference.mkv (lossless, grey, as from the source) and
/// reference.csv. `finger` receives the file names, the markers' polarity, missing numbers and rest
/// layout, the contact threshold (from the recording's marker noise) and the camera settings.
/// Without detectable markers, positions on the face replace them, and a warning is given. The
/// files are written atomically; `finger` is changed only on success and not saved.
///   into: temporary folder of the two files (FolderChange::staged); empty: in the folder
///
/// Where markers are missing or the recording is refused, reference.problem.png in the folder shows
/// the problem (problem_image.h). A recording without such a problem removes the file. Errors:
/// fewer than 2 frames; wrong size; no face; an unusable rest frame; a contact at one position most
/// of the time.
[[nodiscard]] Result<ReferenceReport> install_reference(Source& source,
                                                        const std::filesystem::path& folder,
                                                        Finger& finger, const Job& job,
                                                        const ChoicesWhenRead& choices,
                                                        const std::filesystem::path& into = {});
/// The same with choices that are made before, in the folder itself.
[[nodiscard]] Result<ReferenceReport> install_reference(Source& source,
                                                        const std::filesystem::path& folder,
                                                        Finger& finger, const Job& job,
                                                        const ReferenceChoices& choices = {});

/// Of a flat sensor.
struct UntouchedImage {
  cv::Mat grey;          ///< CV_8UC1, as from the camera
  std::string controls;  ///< settings of camera and light; empty: unknown
  Where origin;          ///< for errors
};
[[nodiscard]] Result<UntouchedImage> read_untouched_image(const std::filesystem::path& file);

/// A flat sensor's untouched image: written into the folder as reference.png; `finger` is changed
/// and not saved. Returns warnings as above.
[[nodiscard]] Result<std::vector<Message>> install_flat_reference(
    const UntouchedImage& image, const std::filesystem::path& folder, Finger& finger);

// Replaces the reference of a finger on disk.

/// Makes a recording a Fin Ray finger's reference (install_reference). Concurrent changes of other
/// parts of the finger are preserved. Errors: those of open_source, install_reference and
/// FingerStore::update; another process works on the finger (FingerStore::lock_for_work).
[[nodiscard]] Result<ReferenceReport> set_reference(
    const std::filesystem::path& folder, const std::vector<std::filesystem::path>& inputs,
    const Job& job, const ReferenceChoices& choices = {});
/// The same of a source.
[[nodiscard]] Result<ReferenceReport> set_reference(const std::filesystem::path& folder,
                                                    Source& source, const Job& job,
                                                    const ChoicesWhenRead& choices);

/// Copies the result of set_reference() on a copy of the finger into the finger: the same bytes,
/// without the computation. Errors: the copy has no reference, or its files cannot be read; those
/// of FingerStore::update; another process works on the finger.
///   copy: a folder with finger.yaml and its reference; it is not changed
[[nodiscard]] Status copy_reference(const std::filesystem::path& copy,
                                    const std::filesystem::path& folder);

/// The same for a flat sensor's untouched image (install_flat_reference).
[[nodiscard]] Result<std::vector<Message>> set_untouched_image(const std::filesystem::path& folder,
                                                               const UntouchedImage& image);

/// Images of both are compared with the same reference, through the same camera.
[[nodiscard]] bool has_same_reference(const Finger& a, const Finger& b);

/// Replaces finger.yaml together with the files of a change. For FingerStore::update(), which
/// writes the same finger once more.
[[nodiscard]] Status commit_with(const Finger& finger, FolderChange& files);

/// Copies the fields that a reference defines: the reference, its markers, their rest, and the
/// recording settings.
void take_reference(const Finger& from, Finger& finger);

// Settings of a finger's recordings, in its provenance, and their inconsistencies.

/// Keys of Finger::provenance.
inline constexpr const char* kReferenceSettings = "reference_settings";
inline constexpr const char* kPressSettings = "press_settings";

enum class RecordingKind { kReference = 1, kPresses };

/// Writes the settings of camera and light to provenance (reference_settings or press_settings), or
/// removes them when the images have none. Returns a sentence where settings changed during the
/// recording, and where reference and presses differ: brightness is compared between them.
[[nodiscard]] std::vector<Message> record_settings(const SettingsMonitor& seen, RecordingKind kind,
                                                   Finger& finger);

/// A sentence where a frame's settings differ from those of the finger's calibration presses (of
/// its reference where the presses have none); else empty.
[[nodiscard]] Message other_settings_than_stored(const Frame& frame, const Finger& finger);

}  // namespace alltact
