// One frame from picture to millimetres.
#pragma once

#include "core/finger/finger_store.h"
#include "core/finger/force_model.h"
#include "core/frame.h"
#include "core/job.h"
#include "core/message.h"
#include "core/result.h"
#include "core/sensing/contact/contact_regions.h"
#include "core/sensing/contact/face_touch.h"
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

/// How long each step took, milliseconds of wall clock.
struct StepTimes {
  double prepare = 0, edges = 0, global = 0, markers = 0, reference = 0, local = 0, contact = 0;
  double force = 0;
  double total = 0;
};

/// All that one frame tells. What could not be had is absent, and `problems` says why.
struct FrameResult {
  FramePtr frame;
  cv::Mat grey;          ///< the oriented picture, reduced and averaged where settings say so
  int reduced_by = 1;    ///< pixels a side of the frame in one of `grey`; all else is of `grey`
  int mesh_step_px = 1;  ///< from one vertex of its surface to the next, as settings say
  std::optional<FaceEdges> edges;
  std::optional<FaceShape> shape;  ///< turned by the twist that the markers tell
  std::optional<Markers> markers;
  MarkerMethod marker_method =
      MarkerMethod::kBlobs;  ///< that found them, where there is a reference
  /// Of a finger without a reference recording, in frames whose two rows are not plain: dots that
  /// are no markers yet.
  std::vector<Dot> dots;
  std::optional<Reference> reference;
  std::optional<Difference> difference;  ///< of a finger without a mapping
  std::optional<DepthMap> depth;         ///< of one with a mapping
  std::optional<Push> push;
  std::vector<ContactRegion> regions;
  /// While something touches a finger with a reference (contact_state.h says from when on and until
  /// when): of push and regions together.
  std::optional<FingerContact> contact;
  std::optional<Force> force;  ///< of a finger with a force model
  /// Against the reference; before there is one, against the frames before
  /// (reference_free_contact.h).
  FaceTouch touch = FaceTouch::kUnknown;
  StepTimes times_ms;
  std::vector<Message> problems;
};

/// Built once from what is known of a finger; turns frames into results. Each result goes as far as
/// that reaches:
///   nothing known                    edges
///   a finger                         and shape, markers or dots, touch; of a flat sensor edges
///   and its reference recording      all but depth and regions
///   and its mapping                  all
/// A force is told where the finger has a model of it besides, trained with the markers of this
/// reference; the place of the contact that it may ask for is that of the largest region.
/// Before there is a reference, nothing is said of the picture as a whole (frame_faults.h).
///
/// Remembers only what lies between frames of one continuous source: the last pictures where they
/// are averaged (PipelineSettings::average_frames), where the markers were, the last picture, how
/// they crept, what touched, and before there is a reference how bright the skin
/// was. Everything else depends on the frame alone. Another frame of the source (is_same_frame in
/// frame_faults.h) whose picture is the last one to the grey level is named as that of a camera
/// that stands still.
class Pipeline {
 public:
  /// Reads the finger's reference recording. A finger without a mapping works up to `difference`.
  /// Errors: those of ReferenceLibrary::load, and of DotNetwork::load where a network finds the
  /// markers.
  static Result<Pipeline> create(const FingerSnapshot& finger,
                                 const PipelineSettings& settings,
                                 const Job& job);

  /// A pipeline over a library that is already in memory (ReferenceLibrary::load of
  /// finger_as_measured()). A
  /// network for the markers that cannot be used is a problem of every frame.
  static Pipeline over(ReferenceLibrary library,
                       const FingerSnapshot& finger,
                       const PipelineSettings& settings);

  /// The source paper's method, which measures in place of all of ours.
  static Pipeline of_paper(PaperMethod method);

  /// Of a finger before its reference recording; one that it names is not read.
  static Pipeline before_reference(const FingerSnapshot& finger, const PipelineSettings& settings);

  /// Of a finger that nobody described: pictures of any size, as they come.
  static Pipeline of_unknown_finger(const PipelineSettings& settings = {});

  /// Error: the frame's size is not the finger's. Anything else that fails is a problem in the
  /// result.
  [[nodiscard]] Result<FrameResult> operator()(const FramePtr& frame);

  /// The same without what lasts over frames: no `contact`; `contacts` is what decides it once the
  /// frames before are known (contact_lines.h), nullopt where nothing does.
  [[nodiscard]] Result<FrameResult> alone(const FramePtr& frame,
                                          std::optional<FrameContacts>& contacts);

  /// Only what the next frame needs of this one: where the markers are, and the picture.
  void warm_up(const FramePtr& frame);

  /// Results depend on more than the few frames before: creep in the finger's force model, or the
  /// source paper's method. Such a recording is measured in one piece.
  [[nodiscard]] bool remembers_long() const;

  /// The next frame is not the neighbour of the last one in time.
  void forget();

  [[nodiscard]] bool has_reference() const;
  /// As it is in the pictures that are measured (reduced_finger.h). Not of an unknown finger; the
  /// same holds for camera().
  [[nodiscard]] const Finger& finger() const;
  [[nodiscard]] const Camera& camera() const;
  [[nodiscard]] const PipelineSettings& settings() const;

 private:
  struct State;
  [[nodiscard]] Result<FrameResult> measured(const FramePtr& frame,
                                             std::optional<FrameContacts>* contacts);
  explicit Pipeline(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;

 public:
  Pipeline(Pipeline&&) noexcept;
  Pipeline& operator=(Pipeline&&) noexcept;
  ~Pipeline();
};

/// 3D points of the pressed face, CV_32FC3 (x, y, z in mm, camera frame), NaN where there is no
/// depth: p_CF = p_LUF - (0, 0, d).
[[nodiscard]] cv::Mat contact_face_points_mm(const FrameResult& result, const Face& face);

/// The same and its depth at every mesh_step_px-th column and row: the vertices of a surface.
struct FaceVertices {
  cv::Mat points_mm;  ///< CV_32FC3
  cv::Mat depth_mm;   ///< CV_32FC1
};
[[nodiscard]] FaceVertices contact_face_vertices(const FrameResult& result, const Face& face);

}  // namespace alltact
