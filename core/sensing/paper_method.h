// The source paper's method from a grey picture to depth, the peer that ours is compared with.
// Nothing of our edges, face, numbering, reference or smoothing is in it:
//
//   edges       paper_face.h       binarise, border of the bright part, whole pixels
//   face        paper_face.h       z = fy W / (v2 - v1), polynomial profile, straight across
//   markers     paper_reference.h  two rows from left to right, hidden ones from their neighbours
//   reference   paper_reference.h  the nearest frame of the video as it is, nothing laid over
//   depth       here               x = (I_ref - I) / I_ref, d = M(x); no light's change, no
//                                  smoothing
//
// What the paper leaves open is decided as well as we can: the threshold by strips, the degree of
// the profile (5). Its detector of markers is a network with its authors' weights; ours finds the
// dots in its place. Contact direction and force are no part of it here.
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
  /// Reads the finger's recording (a flat sensor: its untouched picture), and takes its mapping,
  /// where it has one, for depth. Errors: no recording, no markers, those of PaperReference::read.
  [[nodiscard]] static Result<PaperMethod> create(const FingerSnapshot& finger, const Job& job);

  /// Of a flat sensor, whose face is known and has one untouched picture
  /// (ReferenceLibrary::single).
  [[nodiscard]] static PaperMethod flat(ReferenceLibrary untouched, const FingerSnapshot& finger);

  /// The same with another mapping.
  [[nodiscard]] PaperMethod with(std::optional<Mapping> mapping) const;

  /// As Pipeline; `push`, `contact` and `force` are absent.
  [[nodiscard]] Result<FrameResult> operator()(const FramePtr& frame);
  /// The next frame is not the neighbour of the last one in time.
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
  std::optional<ReferenceLibrary> untouched_;        // and its one picture
  std::optional<Markers> last_;
};

}  // namespace alltact
