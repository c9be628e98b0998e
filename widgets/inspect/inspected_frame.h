// A frame of the page Inspect: measured, compared, converted to surfaces.
#pragma once

#include "calibration/live/frame_measurer.h"
#include "core/geometry/rigid_transform.h"
#include "core/geometry/surface_distance.h"
#include "core/inspection/inspection_recipe.h"
#include "core/sensing/surface_measurement.h"
#include "core/sources/file_source.h"
#include "widgets/scene3d/face_scene.h"
#include "widgets/scene3d/face_surface.h"

#include <array>
#include <filesystem>
#include <memory>
#include <optional>

#include <opencv2/core.hpp>

namespace alltact {

struct InspectedFrame : MeasuredFrame {
  std::optional<FaceSurface> surface;
  /// For a finger without calibration: the shape of its full face, all of its depth NaN.
  std::optional<FaceSurface> bare;
  std::optional<FaceSurface> other_surface;  ///< of `other`
  cv::Mat other_depth_mm;                    ///< on the first surface's grid
};

// State of the page Inspect as one value that can be undone, saved and restored.

enum class ShownAs { k3d = 1, kHeightMap };
enum class Comparison { kNone = 1, kSideBySide, kDifference };

/// Another finger of the same gripper, with its own recording.
struct SecondFinger {
  std::filesystem::path finger, recording;
  bool operator==(const SecondFinger&) const = default;
};

struct InspectOptions {
  std::filesystem::path recording;     ///< a video or a folder of images; empty: the live finger
  std::optional<SecondFinger> second;  ///< only with a recording
  ShownAs shown_as = ShownAs::k3d;
  Comparison comparison = Comparison::kNone;
  ComparisonSpec with{OtherMethod::kPaper};  ///< what is compared with, if anything is
  Viewpoint viewpoint = Viewpoint::kTilted;
  std::optional<ViewPose> view_pose;  ///< 3D camera moved by hand; none: as from the standpoint
  SceneOptions scene;
  std::optional<FacePosition> a, b;  ///< the two measuring points
  RoughnessFilter filter;            ///< of the roughness between them
  InspectionRecipe recipe;           ///< without readings: none

  /// With a second finger nothing is compared.
  [[nodiscard]] Comparison shown_comparison() const {
    return second ? Comparison::kNone : comparison;
  }
  [[nodiscard]] ComparisonSpec comparand() const {
    return shown_comparison() == Comparison::kNone ? ComparisonSpec() : with;
  }
  bool operator==(const InspectOptions&) const = default;
};

/// Which of a frame's measurements a pane shows.
enum class PaneContent { kFirst = 1, kSecond, kDifference };

// Summary of one frame of a recording, for plots over time.

struct FrameSummary {
  std::size_t number = 0;
  /// Empty for a finger without calibration and for a frame without a face.
  std::optional<double> deepest_mm, area_mm2;
  std::optional<double> force_N;  ///< magnitude
  bool has_contact = false;
  Message problem;  ///< the first one; empty: none
};

[[nodiscard]] FrameSummary summary_of(const MeasuredFrame& frame);

/// Of a frame with a mapping; `frame` must outlive it.
[[nodiscard]] inline MeasuredFace face_of(const InspectedFrame& frame) {
  return {frame.result, frame.face, *frame.mapping, frame.smoothing_px, frame.sd_mm};
}

// Converts between the points A and B on the face and pixels of a frame.

/// As pixel_of() of the frame's result; nullopt also without a position.
[[nodiscard]] std::optional<cv::Point2d> pixel_of(const InspectedFrame& frame,
                                                  const std::optional<FacePosition>& position);
/// nullopt: the frame has no face.
[[nodiscard]] std::optional<FacePosition> position_of(const InspectedFrame& frame,
                                                      cv::Point2d pixel);

/// Profile between both positions in the compared measurement; nullopt where there is none, or it
/// does not show them.
[[nodiscard]] std::optional<Profile> other_profile(const InspectedFrame& frame,
                                                   const FacePosition& a, const FacePosition& b);

/// Frame of `second` that belongs to a frame of `first`; see match_frame().
[[nodiscard]] MatchedFrame matched_frame(std::size_t number, const RecordingInfo& first,
                                         const RecordingInfo& second);

// Fills a 3D scene with the inspected faces, for the window, films and images.

/// Frames of one or two fingers at one moment.
struct FramePair {
  std::shared_ptr<const InspectedFrame> first = {};
  std::shared_ptr<const InspectedFrame> second = {};  ///< null without a second finger
  /// gripper_from_camera of both fingers, for one joint view; empty: they are shown side by side.
  std::optional<std::array<RigidTransform, 2>> poses = {};
  /// Shortest distance between the faces, gripper frame; empty: not measured.
  std::optional<NearestPoints> gap = {};
  std::optional<ViewPose> view_pose = {};  ///< for a film; empty: as in its options

  [[nodiscard]] bool is_joint() const { return second && poses; }
  /// All that it shows has a face.
  [[nodiscard]] bool has_face() const;
};

/// The first frame has a surface, or a bare one; in a joint pair both have a surface. Without a
/// compared surface, kSecond and kDifference are shown as kFirst.
void show_in(FaceScene& scene, const FramePair& frames, PaneContent content);

/// The points, and the path over the face between them.
[[nodiscard]] SceneMarks marks_of(const InspectedFrame& frame, const InspectOptions& options);

}  // namespace alltact
