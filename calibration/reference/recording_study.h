// Quality of a reference recording: every frame compared with its estimate from the others.
#pragma once

#include "calibration/reference/motion_coverage.h"
#include "core/job.h"
#include "core/result.h"
#include "core/sensing/reference/reference_library.h"

#include <optional>
#include <string>
#include <vector>

namespace alltact {

/// One frame against the reference that the rest of the recording gives for its pose.
struct StudiedFrame {
  int number = 0;         ///< in the video
  bool compared = false;  ///< false: no face was found, or no other frame is near
  double error = 0;       ///< mean |x| over the face in patches of a millimetre or so, minus noise
  double nearest_error = 0;                   ///< the same with the nearest frame alone
  std::vector<std::optional<TipPose>> pairs;  ///< by pair of dots, from base to tip
};

struct RecordingStudy {
  std::vector<StudiedFrame> frames;  ///< by the library's index
  /// Brightness error of references from this recording, as fractions of the brightness.
  double error_median = 0, error_p95 = 0;
  double nearest_error_median = 0;
};

/// Compares every frame with the local regression over the others. Frames taken shortly before and
/// after show the same pose and are left out (an eighth of the recording, at most two seconds). The
/// frames must be untouched (touch_search.h). `numbered`: the markers of the library's frames, by
/// index. Errors: a stopped job; a frame that cannot be read.
[[nodiscard]] Result<RecordingStudy> study_recording(const ReferenceLibrary& library,
                                                     const std::vector<Markers>& numbered,
                                                     const RecordingFrameReader& frame,
                                                     double frames_per_s,
                                                     const Finger& finger,
                                                     const Camera& camera,
                                                     const Job& job);

}  // namespace alltact
