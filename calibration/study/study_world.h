// Pictures whose answer is known, to measure settings by.
//
// Two kinds:
//   simulated   a scene: the picture and its truth come from the simulator, the finger that
//   measures
//               it is recorded and calibrated from scenes as well.
//   painted     a finger that is at hand: balls of known place and depth are painted into untouched
//               pictures of its own recording, so that shape, light, dirt and noise are this
//               finger's. A pixel under the ball is made darker by what the finger's mapping says
//               of that depth; the reference is computed from what remains of the recording when
//               the picture's neighbours in time are left out. What the mapping itself is wrong by
//               is not in there: presses that the calibration left out tell that.
#pragma once

#include "core/finger/finger_store.h"
#include "core/frame.h"
#include "core/job.h"
#include "core/message.h"
#include "core/result.h"
#include "core/sensing/pipeline_settings.h"
#include "core/sensing/reference/reference_library.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>
#include <opencv2/core.hpp>

namespace alltact {

/// Thirds of the face from its end near the camera to the far one, by z; of a flat sensor by
/// column.
enum class FaceZone { kBase = 0, kMiddle, kTip };
inline constexpr std::size_t kFaceZones = 3;

struct StudyFrame {
  FramePtr picture;
  cv::Mat depth_mm;                   ///< CV_32FC1 along z; NaN off the face
  FaceZone zone = FaceZone::kMiddle;  ///< of what presses
  /// Where the skin is pressed deepest, along the face and across it (FaceShape::place_mm); absent:
  /// nobody knows.
  std::optional<Eigen::Vector2d> place_mm = std::nullopt;
  /// Of a bar: how it is turned, as ContactRegion::angle_deg.
  std::optional<double> angle_deg = std::nullopt;
};

/// The library of the same pictures that pipelines of these settings need (finger_as_measured()).
using LibraryForSettings =
    std::function<Result<ReferenceLibrary>(const PipelineSettings& settings, const Job& job)>;

struct StudyWorld {
  Message about;           ///< a phrase
  bool simulated = false;  ///< false: painted
  FingerPtr finger;
  /// Of which every pipeline takes its share; a copy costs nothing.
  ReferenceLibrary library;
  std::vector<StudyFrame> frames;
  std::uint64_t checksum = 0;         ///< of pictures and truth
  std::vector<StudyFrame> bars = {};  ///< only the angles are told of them
  /// 95 % of what the finger's mapping is wrong by, where the pictures do not show it (painted);
  /// 0 where they do.
  double mapping_p95_mm = 0;
  LibraryForSettings library_for = {};
};

struct StudyWorldOptions {
  int frames = 24;         ///< at most
  std::uint64_t seed = 1;  ///< of everything random
  int threads = 1;         ///< that render; the pictures are the same for any number
};

/// Paints balls of the radius that the finger was calibrated with (3 mm if none is known).
/// Errors: the finger is not calibrated; those of its recording; fewer than 3 of its pictures show
/// the face; stopped.
[[nodiscard]] Result<StudyWorld> painted_world(const FingerPtr& finger,
                                               const StudyWorldOptions& options,
                                               const Job& job);

/// Untouched pictures of a finger, for painting into, and what they are compared with.
struct UntouchedPictures {
  FingerPtr finger;          ///< whose pictures are turned already
  ReferenceLibrary library;  ///< without the pictures and their neighbours in time
  std::vector<cv::Mat> pictures;
  LibraryForSettings library_for;
};

/// At most so many as the options say, evenly over the recording; of a flat sensor its one picture
/// with as much more noise as two pictures differ by. Errors: as painted_world().
[[nodiscard]] Result<UntouchedPictures> untouched_pictures(const FingerPtr& finger,
                                                           const StudyWorldOptions& options,
                                                           const Job& job);

/// Of the ball that the finger was calibrated with; 3 mm if none is known.
[[nodiscard]] double painted_radius_mm(const FingerSnapshot& finger);

/// Where on the face a truth is deepest. nullopt where nothing presses deeper than 0.02 mm.
///   depth_mm, view_z_mm: CV_32FC1, NaN off the face
[[nodiscard]] std::optional<FaceZone> zone_of_press(const cv::Mat& depth_mm,
                                                    const cv::Mat& view_z_mm);

/// Of everything in the frames that errors are computed from.
[[nodiscard]] std::uint64_t checksum_of(const std::vector<StudyFrame>& frames);

}  // namespace alltact
