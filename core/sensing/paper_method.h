// The source paper's method from a grey image to depth: the reference method that the program's own
// method is compared with. It shares no edges, face, numbering, reference or smoothing with the own
// method:
//
//   edges       binarise, border of the bright part, integer pixels
//   face        z = fy W / (v2 - v1), polynomial profile, straight across
//   markers     two rows from left to right, hidden ones from their neighbours
//   reference   the nearest frame of the video as it is, without warping
//   depth       here               x = (I_ref - I) / I_ref, d = M(x); no correction of the light,
//                                  no smoothing
//
// What the paper leaves open is chosen to its advantage: the threshold by strips, the degree of the
// profile (5). Its detector of markers is a network with its authors' weights; MarkerDetector
// replaces it. Contact direction and force are not part of it here.
#pragma once

#include "core/base/job.h"
#include "core/base/result.h"
#include "core/camera/camera.h"
#include "core/finger/finger.h"
#include "core/finger/finger_store.h"
#include "core/sensing/face/face_shape.h"
#include "core/sensing/frame_result.h"
#include "core/sensing/markers/markers.h"
#include "core/sensing/pipeline.h"
#include "core/sensing/reference/reference_library.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include <Eigen/Core>
#include <opencv2/core.hpp>

namespace alltact {

// The source paper's reference: the frame with the nearest markers from a video of the untouched
// finger.

/// The markers of a frame by the paper's sorting into two rows. MarkerDetector finds
/// the dots instead of the paper's network, whose weights are its authors'. `before`: the markers
/// of an earlier frame; may be null. nullopt: too few dots.
[[nodiscard]] std::optional<Markers> paper_markers(const cv::Mat& grey, const FaceShape& shape,
                                                   const MarkerRows& rows, const Markers* before);

class PaperReference {
 public:
  struct Recorded {
    cv::Mat grey;
    Markers markers;
    int number = 0;  ///< in the video
  };

  /// Reads a recording with the paper's own steps, without a marker table. Frames in which face or
  /// markers are not found are left out. A video larger than `memory_limit_bytes` is read at every
  /// second, third, ... frame. Errors: the video cannot be read, or shows the markers in no frame;
  /// stopped.
  [[nodiscard]] static Result<PaperReference> read(const std::filesystem::path& video,
                                                   const Finger& finger, const Camera& camera,
                                                   const Job& job,
                                                   std::size_t memory_limit_bytes = std::size_t{512}
                                                                                    << 20);

  [[nodiscard]] std::size_t frame_count() const { return frames_.size(); }
  [[nodiscard]] const Recorded& frame(std::size_t index) const { return frames_[index]; }

  /// The frame with the smallest sum of distances over all markers, seen or estimated, and that sum
  /// divided by their number. `markers`: as many as were recorded.
  [[nodiscard]] NearestFrame nearest(const Markers& markers) const;

 private:
  std::vector<Recorded> frames_;  // at least one
};

class PaperMethod : public MeasuringMethod {
 public:
  /// Reads the finger's recording (of a flat sensor: its reference image). Takes the mapping of the
  /// finger for depth, where it has one. Errors: no recording, no markers, those of
  /// PaperReference::read.
  [[nodiscard]] static Result<PaperMethod> create(const FingerSnapshot& finger, const Job& job);

  /// For a flat sensor, whose face is known and which has one reference image
  /// (ReferenceLibrary::single).
  [[nodiscard]] static PaperMethod flat(ReferenceLibrary untouched, const FingerSnapshot& finger);

  /// A copy with another mapping.
  [[nodiscard]] PaperMethod with(std::optional<Mapping> mapping) const;

  /// Without `push`, `contact` and `force`.
  [[nodiscard]] Result<FrameResult> measure(const FramePtr& frame) override;
  void forget() override { last_.reset(); }
  [[nodiscard]] const Finger& finger() const override { return finger_; }
  [[nodiscard]] const Camera& camera() const override { return camera_; }

 private:
  explicit PaperMethod(const FingerSnapshot& finger)
      : finger_(finger.finger), camera_(finger.camera), mapping_(finger.mapping) {}
  bool find_face(FrameResult& result) const;
  bool find_reference(FrameResult& result);
  void find_depth(FrameResult& result) const;
  void find_regions(FrameResult& result) const;

  Finger finger_;
  Camera camera_;
  std::optional<Mapping> mapping_;
  std::shared_ptr<const PaperReference> reference_;  // of a finger
  std::optional<FaceShape> plane_;                   // of a flat sensor,
  std::optional<ReferenceLibrary> untouched_;        // and its reference image
  std::optional<Markers> last_;
};

// The source paper's reconstruction of the untouched face from a grey image. It binarises and takes
// the border of the bright part for the two edges of the face. Then z = fy W / (v2 - v1) in every
// column, one polynomial along the finger, straight lines across it.

/// Edges of the view face by column, at integer pixels and a half (between the last dark and the
/// first bright pixel). NaN where the column does not show both: no bright pixel, or one at the
/// border of the image.
struct PaperEdges {
  std::vector<double> upper_v, lower_v;
  int seen = 0;  ///< columns that show both edges
};

/// Binarises strips of 32 columns, each by Otsu's threshold, and takes the largest connected bright
/// part for the face. The light falls by ten times from base to tip, so that one threshold would
/// cut off the tip.
[[nodiscard]] PaperEdges paper_edges(const cv::Mat& grey);

/// The face as a profile z = P(x) in the plane of the finger, P of degree 5, and a middle line.
class PaperFace {
 public:
  /// Errors: both edges are seen in fewer than a fifth of the columns; no z is finite and positive;
  /// an orthographic camera.
  [[nodiscard]] static Result<PaperFace> fit(const PaperEdges& edges, const Camera& camera,
                                             const Face& face);

  /// z of the profile by column, mm; NaN where the column does not show both edges.
  [[nodiscard]] const std::vector<double>& z_mm() const { return z_mm_; }

  /// The same face as a FaceShape: within 0.01 mm of z_mm() on its columns.
  [[nodiscard]] Result<FaceShape> shape(const Camera& camera, const Face& face) const;

 private:
  std::vector<double> z_mm_, middle_y_;  // by column; middle: y / z of the line between the edges
};

}  // namespace alltact
