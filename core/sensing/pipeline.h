// Measures one frame: from an image to millimetres.
#pragma once

#include "core/finger/finger_store.h"
#include "core/finger/force_model.h"
#include "core/frame.h"
#include "core/job.h"
#include "core/message.h"
#include "core/result.h"
#include "core/sensing/contact/contact_regions.h"
#include "core/sensing/contact/face_contact.h"
#include "core/sensing/contact/finger_contact.h"
#include "core/sensing/contact/finger_contact_tracker.h"
#include "core/sensing/contact/push.h"
#include "core/sensing/depth/local_depth.h"
#include "core/sensing/face/face_edges.h"
#include "core/sensing/face/face_shape.h"
#include "core/sensing/markers/markers.h"
#include "core/sensing/pipeline_settings.h"
#include "core/sensing/reference/reference_library.h"

#include <memory>
#include <optional>
#include <vector>

namespace alltact {

class PaperMethod;

/// Duration of each step, milliseconds of wall clock.
struct StepTimes {
  double prepare = 0, edges = 0, global = 0, markers = 0, reference = 0, local = 0, contact = 0;
  double force = 0;
  double total = 0;
};

/// Everything that is measured in one frame. Fields that could not be estimated are empty;
/// `problems` holds the reasons.
struct FrameResult {
  FramePtr frame;
  cv::Mat grey;  ///< the oriented image, reduced and averaged as the settings require
  /// Binning factor from the frame to `grey`; everything else is in pixels of `grey`
  int reduced_by = 1;
  int mesh_step_px = 1;  ///< from one vertex of its surface to the next
  std::optional<FaceEdges> edges;
  std::optional<FaceShape> shape;  ///< with the twist that the markers show
  std::optional<Markers> markers;
  MarkerMethod marker_method =
      MarkerMethod::kBlobs;  ///< that found them, where there is a reference
  /// Unnumbered dots of a finger without a reference recording, in frames whose two rows are not
  /// even.
  std::vector<Dot> dots;
  std::optional<Reference> reference;
  std::optional<Difference> difference;  ///< of a finger without a mapping
  std::optional<DepthMap> depth;         ///< of a finger with a mapping
  std::optional<Push> push;
  std::vector<ContactRegion> regions;
  /// During contact of a finger with a reference: estimated from push and regions together.
  /// contact_state.h defines its begin and end.
  std::optional<FingerContact> contact;
  std::optional<Force> force;  ///< of a finger with a force model
  /// Relative to the reference; without one, relative to earlier frames (reference_free_contact.h).
  FaceContact touch = FaceContact::kUnknown;
  StepTimes times_ms;
  std::vector<Message> problems;
};

/// Turns frames into results. Built once from what is known of a finger, which decides how far each
/// result reaches:
///   nothing known                    edges
///   a finger                         and shape, markers or dots, touch; of a flat sensor edges
///   and its reference recording      all but depth and regions
///   and its mapping                  all
/// A force is estimated where the finger also has a force model that was trained with the markers
/// of this reference. Its contact position is that of the largest region. Without a reference the
/// full image is not checked (frame_faults.h).
///
/// State between frames of one continuous source: the last images where they are averaged
/// (PipelineSettings::average_frames), the marker positions, the last frame, the creep of the
/// markers and the tracked contact. Before there is a reference also the brightness of the skin.
/// Everything else depends on the frame only. A new frame of the source (is_same_frame in
/// frame_faults.h) that equals the last one to the grey level is reported as that of a frozen
/// camera.
class Pipeline {
 public:
  /// Reads the finger's reference recording. A finger without a mapping is measured up to
  /// `difference`. Errors: those of ReferenceLibrary::load, and of DotNetwork::load where a network
  /// finds the markers.
  static Result<Pipeline> create(const FingerSnapshot& finger,
                                 const PipelineSettings& settings,
                                 const Job& job);

  /// Uses a library that is already in memory (ReferenceLibrary::load of finger_as_measured()). A
  /// marker network that cannot be used is a problem of every frame.
  static Pipeline with_library(ReferenceLibrary library,
                               const FingerSnapshot& finger,
                               const PipelineSettings& settings);

  /// Measures by the source paper's method instead of the program's own.
  static Pipeline with_paper_method(PaperMethod method);

  /// For a finger before its reference recording; one that it names is not read.
  static Pipeline without_reference(const FingerSnapshot& finger, const PipelineSettings& settings);

  /// For an unknown finger: images of any size.
  static Pipeline without_finger(const PipelineSettings& settings = {});

  /// Error: the frame's size is not the finger's. Any other failure is a problem in the result.
  [[nodiscard]] Result<FrameResult> operator()(const FramePtr& frame);

  /// Measures a frame without tracking: `contact` stays empty. `contacts` receives the input of the
  /// tracker for when the frames before are known (contact_lines.h); nullopt where there is none.
  [[nodiscard]] Result<FrameResult> measure_untracked(const FramePtr& frame,
                                                      std::optional<FrameContacts>& contacts);

  /// Updates only the state that the next frame needs: the marker positions and the last frame.
  void warm_up(const FramePtr& frame);

  /// True when results depend on more than the few frames before: averaged frames, creep in the
  /// force model, or the source paper's method. Such a recording is measured in one piece.
  [[nodiscard]] bool has_long_memory() const;

  /// Call before a frame that does not follow the last one in time.
  void forget();

  [[nodiscard]] bool has_reference() const;
  /// As it appears in the measured images (reduced_finger.h). An unknown finger has neither
  /// finger() nor camera().
  [[nodiscard]] const Finger& finger() const;
  [[nodiscard]] const Camera& camera() const;
  [[nodiscard]] const PipelineSettings& settings() const;

 private:
  struct State;
  [[nodiscard]] Result<FrameResult> measure(const FramePtr& frame,
                                            std::optional<FrameContacts>* contacts);
  explicit Pipeline(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;

 public:
  Pipeline(Pipeline&&) noexcept;
  Pipeline& operator=(Pipeline&&) noexcept;
  ~Pipeline();
};

/// 3D points of the contact face, CV_32FC3 (x, y, z in mm, camera frame), NaN without depth: p_CF =
/// p_LUF - (0, 0, d).
[[nodiscard]] cv::Mat contact_face_points_mm(const FrameResult& result, const Face& face);

/// The same points and their depth at every mesh_step_px-th column and row: the vertices of a
/// surface.
struct FaceVertices {
  cv::Mat points_mm;  ///< CV_32FC3
  cv::Mat depth_mm;   ///< CV_32FC1
};
[[nodiscard]] FaceVertices contact_face_vertices(const FrameResult& result, const Face& face);

}  // namespace alltact
