// State of a pipeline between frames, and its steps in their order.
#pragma once

#include "core/force/force_meter.h"
#include "core/sensing/contact/finger_contact_tracker.h"
#include "core/sensing/contact/reference_free_contact.h"
#include "core/sensing/markers/even_rows.h"
#include "core/sensing/paper_method.h"
#include "core/sensing/pipeline.h"
#include "core/sensing/running_mean.h"
#include "core/sensing/stop_watch.h"

#include <memory>
#include <optional>

namespace alltact {

struct Pipeline::State {
  std::optional<PaperMethod> paper;  // replaces all that follows except finger and camera
  PipelineSettings settings;
  FaceEdgeFinder edge_finder;
  std::optional<Finger> finger;
  std::optional<Camera> camera;            // with the finger
  std::optional<FingerSnapshot> snapshot;  // the same, for converting frames
  RunningMean mean{1};
  // Before there is a reference.
  std::optional<EvenRows> rows;
  ReferenceFreeContactDetector contact;
  // With the reference.
  std::optional<ReferenceLibrary> library;
  std::optional<Mapping> mapping;
  std::optional<FaceShape> plane;         // known beforehand, of flat sensors
  std::unique_ptr<MarkerFinder> markers;  // fingers with markers,
  std::optional<Error> marker_problem;    // or why they cannot be found
  std::optional<ForceMeter> force;        // fingers with a force model,
  std::optional<Error> force_problem;     // or why it cannot be used
  FramePtr last;                          // of a continuous source
  // Covariance of the markers' displacements, in a frame with a push
  Eigen::MatrixXd displacement_cov_px2;
  FingerContactTracker contact_tracker;

  [[nodiscard]] Result<cv::Mat> oriented(const Frame& frame) const;
  void check_frame(FrameResult& result);
  void find_shape(FrameResult& result, StopWatch& watch) const;
  void find_without_reference(FrameResult& result, StopWatch& watch);
  bool find_markers(FrameResult& result);
  void find_markers_by_shape(FrameResult& result) const;
  void find_reference(FrameResult& result, StopWatch& watch);
  void find_depth(FrameResult& result, StopWatch& watch) const;
  void find_contact(FrameResult& result, StopWatch& watch) const;
  [[nodiscard]] Eigen::MatrixXd markers_covariance(const FrameResult& result) const;
  void track_contact(FrameResult& result, std::optional<FrameContacts>* contacts, StopWatch& watch);
  void find_force(FrameResult& result, StopWatch& watch);
};

}  // namespace alltact
