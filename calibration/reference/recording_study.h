// What a reference recording is worth: every frame compared with what the others say it should look
// like.
#pragma once

#include "calibration/reference/motion_coverage.h"
#include "core/job.h"
#include "core/result.h"
#include "core/sensing/reference/reference_library.h"

#include <optional>
#include <string>
#include <vector>

namespace alltact {

/// One frame against the reference that the rest of the recording makes of its pose.
struct StudiedFrame {
  int number = 0;         ///< in the video
  bool compared = false;  ///< false: no face was found, or no other frame is near
  double error = 0;       ///< mean |x| over the face in patches of a millimetre or so, less noise
  double nearest_error = 0;  ///< the same with the nearest frame alone
  /// The darkest patch in each zone of the face (FaceZones): how much darker than it should be
  /// (0.1: by 10 %); NaN where the zone is not seen.
  std::vector<float> darkest;
  std::vector<std::optional<TipPlace>> pairs;  ///< by pair of dots, from base to tip
};

/// Zones of the face in which frames are compared: pieces of its length, each in thirds across.
struct FaceZones {
  static constexpr int kAcross = 3;
  double piece_mm = 5.0;
  int pieces = 40;

  [[nodiscard]] int count() const { return pieces * kAcross; }
  [[nodiscard]] double along_mm(int zone) const { return (zone / kAcross + 0.5) * piece_mm; }
};

/// A frame in which something pressed on the face: its darkest patch.
struct DentedFrame {
  double darker = 0;    ///< 0.1: by 10 %
  double along_mm = 0;  ///< from the base
};

struct RecordingStudy {
  std::vector<StudiedFrame> frames;  ///< by the library's index
  /// By the library's index: something pressed on the face.
  std::vector<std::optional<DentedFrame>> dented;
  /// Over the frames that are not dented: what references of this recording are off by in
  /// brightness, as parts of it.
  double error_median = 0, error_p95 = 0;
  double nearest_error_median = 0;
};

/// Compares every frame with the local regression over the others, leaving out those taken shortly
/// before and after, which show the same pose and the same dent (an eighth of the recording, at
/// most two seconds of it). A frame counts as dented where a patch is darker by 4 % and by far
/// more than patches of its zone typically are (the dark end of a finger is told less well), also
/// when no other dented frame has part in its reference. `numbered`: the markers of the library's
/// frames, by index. Errors: a stopped job; a frame that cannot be read.
[[nodiscard]] Result<RecordingStudy> study_recording(const ReferenceLibrary& library,
                                                     const std::vector<Markers>& numbered,
                                                     const FrameOfRecording& frame,
                                                     double frames_per_s,
                                                     const Finger& finger,
                                                     const Camera& camera,
                                                     const Job& job);

}  // namespace alltact
