// The first pass over a recording: its frames are written as a video, and the dots of each are
// found.
#pragma once

#include "calibration/reference/marker_numbering.h"
#include "calibration/reference/motion_coverage.h"
#include "core/base/job.h"
#include "core/base/result.h"
#include "core/image/frame.h"
#include "core/recording/video_file.h"
#include "core/sensing/face/face_edges.h"
#include "core/sensing/reference/marker_table.h"
#include "core/sensing/reference/reference_library.h"
#include "core/sources/source.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <opencv2/core.hpp>

namespace alltact {

/// Frames of a long recording beyond this number only repeat poses that the others show: the
/// library of a 960 x 540 camera retains 500 of them.
inline constexpr std::size_t kMaxExamined = 768;

/// Results of the first pass.
struct RecordingPass {
  std::filesystem::path video;  ///< that holds the frames
  /// Of this many frames the first is examined. A power of two, so that a recording is thinned
  /// while it runs as it is from its file.
  std::size_t every = 1;
  std::vector<FrameDots> frames;  ///< by number in the recording
  std::vector<int> in_video;      ///< by frame, its number in the video; -1: it is not in it
  int video_frames = 0;
  /// By number in the video, the oriented images, so that they need not be decoded again; empty
  /// where they are not examined or exceed 256 MB.
  std::vector<cv::Mat> greys;
  /// By number in the video; without columns: no face was found, or it is not examined.
  std::vector<FaceEdges> edges;
  SettingsMonitor settings;  ///< of the examined frames

  [[nodiscard]] bool is_examined(std::size_t frame) const { return frame % every == 0; }
};

/// Reads the source to its end and finds dots. Unless the source is a file without loss, writes the
/// examined readable frames to `video` (lossless grey, as from the source). Errors: a wrong size; a
/// source that fails permanently; the video cannot be written; a stopped job.
[[nodiscard]] Result<RecordingPass> read_recording(Source& source, const Camera& camera,
                                                   const Finger& finger, const Job& job,
                                                   const std::filesystem::path& video);

/// Makes `video` hold the selected frames (numbers in the recording) of the pass, in order.
[[nodiscard]] Status retain_frames(const RecordingPass& pass,
                                   const std::vector<std::size_t>& selected,
                                   const std::filesystem::path& video, const Job& job);

// Frames of a recording that was just written, by their number in it, and their marker positions.

/// A row for each of `selected`, numbered from 0 on.
[[nodiscard]] MarkerTable table_of(const NumberedRecording& numbered,
                                   const std::vector<std::size_t>& selected);
/// The same, numbered as the frames are in the video.
[[nodiscard]] MarkerTable table_in_video(const RecordingPass& pass,
                                         const NumberedRecording& numbered,
                                         const std::vector<std::size_t>& selected);

/// Frame `number` of a video, CV_8UC1, oriented as the camera.
[[nodiscard]] Result<cv::Mat> oriented_frame(VideoFile& video, std::size_t number,
                                             const CameraParameters& camera);

/// The referenced objects must outlive this.
struct RecordedVideo {
  const RecordingPass& pass;
  const Finger& finger;
  const Camera& camera;
  VideoFile reader;

  /// By its number in the video; CV_8UC1, oriented as the finger's camera.
  [[nodiscard]] Result<cv::Mat> frame(std::size_t number);
  /// Those of the pass, else traced in the frame's image. nullopt: the frame shows no face.
  [[nodiscard]] std::optional<FaceEdges> edges(std::size_t number, const cv::Mat& grey) const;
};

// Quality of a reference recording: frames compared with their estimates from the others.

/// One frame against the reference that the rest of the recording gives for its pose.
struct StudiedFrame {
  int number = 0;         ///< in the video
  bool compared = false;  ///< false: not chosen, no face was found, or no other frame is near
  double error = 0;       ///< mean |x| over the face in patches of a millimetre or so, minus noise
  std::vector<std::optional<TipPose>> pairs;  ///< by pair of dots, from base to tip
};

/// A frame of the library.
struct StudyInput {
  std::size_t number = 0;  ///< in the recording
  Markers markers;
};

struct RecordingStudy {
  std::vector<StudiedFrame> frames;  ///< by the library's index
  /// Brightness error of references from this recording, as fractions of the brightness.
  double error_median = 0, error_p95 = 0;
};

/// Compares frames, at most 120 spread over the recording, with the local regression over the
/// others. Those taken shortly before and after show the same pose and are left out (an eighth of
/// the recording, at most two seconds). The frames must be untouched (contact_search.h).
/// `recorded`: by the library's index. Errors: a stopped job; a frame that cannot be read.
[[nodiscard]] Result<RecordingStudy> study_recording(const ReferenceLibrary& library,
                                                     const std::vector<StudyInput>& recorded,
                                                     RecordedVideo& video, const Job& job);

}  // namespace alltact
