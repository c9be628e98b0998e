// Images with known ground truth, to compare settings on.
//
// Two kinds:
//   simulated   a scene: the simulator gives image and ground truth. The measuring finger is
//               recorded and calibrated from scenes as well.
//   painted     a real finger: balls of known position and depth are painted into untouched images
//               of its own recording, so that shape, light, dirt and noise are this finger's. The
//               finger's mapping gives the darkening of a pixel at that depth. The reference is
//               computed from the recording without the image's neighbours in time. The mapping's
//               own error is not included: presses that the calibration left out show it.
#pragma once

#include "core/base/job.h"
#include "core/base/message.h"
#include "core/base/result.h"
#include "core/finger/finger_store.h"
#include "core/image/frame.h"
#include "core/numerics/philox.h"
#include "core/sensing/face/face_shape.h"
#include "core/sensing/pipeline_settings.h"
#include "core/sensing/reference/reference_library.h"

#include <cmath>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>
#include <opencv2/core.hpp>

namespace alltact {

/// Thirds of the face by z, from its end near the camera to the far one; of a flat sensor by
/// column.
enum class FaceZone { kBase = 0, kMiddle, kTip };
inline constexpr std::size_t kFaceZones = 3;

struct StudyFrame {
  FramePtr image;
  cv::Mat depth_mm;                   ///< CV_32FC1 along z; NaN off the face
  FaceZone zone = FaceZone::kMiddle;  ///< of the pressing body
  /// Position of the greatest depth, along and across the face (FaceShape::position_mm); empty:
  /// unknown.
  std::optional<Eigen::Vector2d> position_mm = std::nullopt;
  /// Of a bar: its orientation, as ContactRegion::angle_deg.
  std::optional<double> angle_deg = std::nullopt;
};

/// The library of the same images for pipelines with these settings (finger_as_measured()).
using LibraryForSettings =
    std::function<Result<ReferenceLibrary>(const PipelineSettings& settings, const Job& job)>;

struct StudyWorld {
  Message about;           ///< a phrase
  bool simulated = false;  ///< false: painted
  FingerPtr finger;
  /// Shared by all pipelines; a copy is cheap.
  ReferenceLibrary library;
  std::vector<StudyFrame> frames;
  std::uint64_t checksum = 0;         ///< of images and ground truth
  std::vector<StudyFrame> bars = {};  ///< used for angles only
  /// 95 % bound of the finger's mapping error where the images do not show it (painted); 0 where
  /// they do.
  double mapping_p95_mm = 0;
  LibraryForSettings library_for = {};
};

struct StudyWorldOptions {
  int frames = 24;         ///< at most
  std::uint64_t seed = 1;  ///< of everything random
  int threads = 1;         ///< for rendering; the images are the same for any number
};

/// Paints balls of the radius that the finger was calibrated with (3 mm if none is known). Errors:
/// the finger is not calibrated; those of its recording; fewer than 3 of its images show the face;
/// stopped.
[[nodiscard]] Result<StudyWorld> painted_world(const FingerPtr& finger,
                                               const StudyWorldOptions& options, const Job& job);

/// Untouched images of a finger to paint into, and their reference.
struct UntouchedImages {
  FingerPtr finger;          ///< whose images are oriented already
  ReferenceLibrary library;  ///< without the images and their neighbours in time
  std::vector<cv::Mat> images;
  LibraryForSettings library_for;
};

/// At most options.frames images, evenly over the recording; of a flat sensor its single image with
/// added noise, as much as two images differ by. Errors: as painted_world().
[[nodiscard]] Result<UntouchedImages> untouched_images(const FingerPtr& finger,
                                                       const StudyWorldOptions& options,
                                                       const Job& job);

/// Radius of the ball that the finger was calibrated with; 3 mm if none is known.
[[nodiscard]] double painted_radius_mm(const FingerSnapshot& finger);

/// Zone of the greatest depth of a ground truth. nullopt where nothing presses deeper than 0.02 mm.
///   depth_mm, view_z_mm: CV_32FC1, NaN off the face
[[nodiscard]] std::optional<FaceZone> zone_of_press(const cv::Mat& depth_mm,
                                                    const cv::Mat& view_z_mm);

/// Of everything in the frames that errors are computed from.
[[nodiscard]] std::uint64_t checksum_of(const std::vector<StudyFrame>& frames);

// A ball or a bar painted into an untouched image, with its ground truth.

/// Random numbers of one painted image, from its own counter.
class StudyDraws {
 public:
  StudyDraws(std::uint64_t seed, std::uint32_t frame) : seed_(seed), frame_(frame) {}
  double uniform() { return philox_uniform(seed_, "study", frame_, next_++); }
  /// Box and Muller.
  double normal() {
    const double radius = std::sqrt(-2 * std::log(uniform()));
    return radius * std::cos(2 * M_PI * uniform());
  }

 private:
  std::uint64_t seed_;
  std::uint32_t frame_;
  std::uint32_t next_ = 0;
};

/// The pressing body: all points within radius_mm of a straight line segment; a ball where the
/// segment has no length. Camera frame.
struct PaintedBody {
  Eigen::Vector3d centre_mm;
  double radius_mm = 0;
  Eigen::Vector3d axis = Eigen::Vector3d::UnitX();  ///< unit
  double half_length_mm = 0;
};

/// Distance, mm, along a line from `from` along the unit vector `direction` to its first point in
/// the body.
[[nodiscard]] std::optional<double> distance_to_body(const PaintedBody& body,
                                                     const Eigen::Vector3d& from,
                                                     const Eigen::Vector3d& direction);

class PressPainter {
 public:
  /// `finger` is calibrated and outlives this.
  PressPainter(const FingerSnapshot& finger, double radius_mm);

  /// grey: untouched, CV_8UC1; shape: of the face in it. The result includes the contact's
  /// position, from the same shape. nullopt: no valid position on this face.
  [[nodiscard]] std::optional<StudyFrame> ball(const cv::Mat& grey, const FaceShape& shape,
                                               StudyDraws& draws, FaceZone zone) const;
  /// A bar with round sides and ends, half as wide as the ball and 6 mm longer, with its angle.
  [[nodiscard]] std::optional<StudyFrame> bar(const cv::Mat& grey, const FaceShape& shape,
                                              StudyDraws& draws, FaceZone zone) const;

 private:
  struct Spot;
  [[nodiscard]] std::optional<Spot> spot_on(const FaceShape& shape, StudyDraws& draws,
                                            FaceZone zone) const;
  [[nodiscard]] StudyFrame painted_with(const PaintedBody& body, FaceZone zone, const cv::Mat& grey,
                                        const FaceShape& shape) const;

  const FingerSnapshot& finger_;
  const Mapping& mapping_;
  double radius_mm_;
  double deepest_mm_ = 0;
};

}  // namespace alltact
