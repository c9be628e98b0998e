// One frame from picture to millimetres.
#pragma once

#include "core/finger/finger_store.h"
#include "core/frame.h"
#include "core/job.h"
#include "core/message.h"
#include "core/result.h"
#include "core/sensing/contact/contact_regions.h"
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

/// How long each step took, milliseconds of wall clock.
struct StepTimes {
  double prepare = 0, edges = 0, global = 0, markers = 0, reference = 0, local = 0, contact = 0;
  double total = 0;
};

/// All that one frame tells. What could not be had is absent, and `problems` says why.
struct FrameResult {
  FramePtr frame;
  cv::Mat grey;  ///< the oriented picture
  std::optional<FaceEdges> edges;
  std::optional<FaceShape> shape;  ///< turned by the twist that the markers tell
  std::optional<Markers> markers;
  std::optional<Reference> reference;
  std::optional<Difference> difference;  ///< of a finger without a mapping
  std::optional<DepthMap> depth;         ///< of one with a mapping
  std::optional<Push> push;
  std::vector<ContactRegion> regions;
  StepTimes times_ms;
  std::vector<Message> problems;
};

/// Built once from a finger; turns frames into results. Remembers only where the markers were and
/// the last picture (between frames of one continuous source); everything else depends on the frame
/// alone. Another frame of the source (is_same_frame in frame_faults.h) whose picture is the last
/// one to the grey level is named as that of a camera that stands still.
class Pipeline {
 public:
  /// Reads the finger's reference recording. A finger without a mapping works up to `difference`.
  /// Errors: those of ReferenceLibrary::load.
  static Result<Pipeline> create(const FingerSnapshot& finger,
                                 const PipelineSettings& settings,
                                 const Job& job);

  /// A pipeline over a library that is already in memory.
  static Pipeline over(ReferenceLibrary library,
                       const FingerSnapshot& finger,
                       const PipelineSettings& settings);

  /// Error: the frame's size is not the finger's. Anything else that fails is a problem in the
  /// result.
  [[nodiscard]] Result<FrameResult> operator()(const FramePtr& frame);

  /// The next frame is not the neighbour of the last one in time.
  void forget();

  [[nodiscard]] const Finger& finger() const;
  [[nodiscard]] const Camera& camera() const;
  [[nodiscard]] const PipelineSettings& settings() const;

 private:
  struct State;
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

}  // namespace alltact
