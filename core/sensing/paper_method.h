// The source paper's method from a grey image to depth: the reference method that the program's own
// method is compared with. It shares no edges, face, numbering, reference or smoothing with the own
// method:
//
//   edges       paper_face.h       binarise, border of the bright part, integer pixels
//   face        paper_face.h       z = fy W / (v2 - v1), polynomial profile, straight across
//   markers     paper_reference.h  two rows from left to right, hidden ones from their neighbours
//   reference   paper_reference.h  the nearest frame of the video as it is, without warping
//   depth       here               x = (I_ref - I) / I_ref, d = M(x); no correction of the light,
//                                  no smoothing
//
// What the paper leaves open is chosen to its advantage: the threshold by strips, the degree of the
// profile (5). Its detector of markers is a network with its authors' weights; MarkerDetector
// replaces it. Contact direction and force are not part of it here.
#pragma once

#include "core/finger/finger_store.h"
#include "core/job.h"
#include "core/result.h"
#include "core/sensing/paper_reference.h"
#include "core/sensing/pipeline.h"

#include <memory>
#include <optional>

namespace alltact {

class PaperMethod {
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

  /// As Pipeline::operator(), without `push`, `contact` and `force`.
  [[nodiscard]] Result<FrameResult> operator()(const FramePtr& frame);
  /// Call before a frame that does not follow the last one in time.
  void forget() { last_.reset(); }

  [[nodiscard]] const Finger& finger() const { return finger_; }
  [[nodiscard]] const Camera& camera() const { return camera_; }

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

}  // namespace alltact
