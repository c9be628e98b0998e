// The data of one finger, and its folder on the disk.
#pragma once

#include "core/base/result.h"
#include "core/camera/camera_file.h"
#include "core/finger/mapping.h"
#include "core/geometry/rigid_transform.h"

#include <array>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

namespace alltact {

enum class FaceKind { kFinRay = 1, kFlat };
enum class Polarity { kBright = 1, kDark, kAuto };

struct Face {
  FaceKind kind = FaceKind::kFinRay;
  double width_mm = 0;    ///< fin_ray: distance between the two edges of the view face, kFaceWidth
  double layer_mm = 0;    ///< thickness of the translucent layer along its normal, kLayerThickness
  double plane_z_mm = 0;  ///< flat: the view face is the plane z = plane_z_mm
};

struct MarkerRows {
  int per_row = 0;  ///< dots on the longer of both rows, 0..64; 0: none
  Polarity polarity =
      Polarity::kAuto;  ///< relative to their surroundings; auto until a recording determines it
  /// Numbers without a dot, ascending: never engraved, lost, or of a shorter row. The others retain
  /// their numbers.
  std::vector<int> missing = {};
};

/// Positions on both edges of the face that replace markers on a finger without usable ones:
/// kPerEdge on each edge, numbered like markers. They are `step_mm` apart along the face, starting
/// where it crosses the column `from_u_px`.
struct EdgePositions {
  static constexpr int kPerEdge = 8;
  double from_u_px = 0;
  double step_mm = 0;  ///< (0, 500]
};

/// A contradiction between a calibration's data and a number given for it.
struct RecordedContradiction {
  std::string kind;           ///< as calibration/verdict/verdict.h writes it
  int presses = 0, of = 0;    ///< number of presses that show it, and of all
  double given_mm = 0;        ///< the given number
  double measured_mm = 0;     ///< minimum of the value measured from the presses
  double measured_to_mm = 0;  ///< maximum
  bool operator==(const RecordedContradiction&) const = default;
};

/// Inputs of a calibration: the given numbers, and the range of its presses. Standard deviations
/// are of depth, in mm along z.
struct CalibrationBasis {
  std::vector<double> ball_radii_mm;                  ///< of the balls used, ascending, without
                                                      ///< duplicates
  double layer_mm = 0, width_mm = 0, plane_z_mm = 0;  ///< the face at that time
  std::string camera;                                 ///< camera_fingerprint() at that time
  std::string reference;           ///< checksum of the reference's files; empty: none
  int positions = 0;               ///< distinct positions on the face; repeats count once
  std::array<int, 3> thirds = {};  ///< of them in base, middle, tip (flat: left, middle, right)
  double position_leverage = 0;    ///< mean over the face, of a line along it; 0: unknown
  double shallowest_mm = 0, deepest_mm = 0;  ///< of the balls
  /// Of the mapping, where it reads the mean depth of the presses' contacts.
  double scale_sd_mm = 0;
  double pixel_sd_mm = 0;  ///< of a pixel in a contact, without the mapping's share; 0: unknown
  double halo_mm = 0;      ///< light that scatters sideways; 0: not significant
  /// Probability, by the presses, that light spreads in the layer and the mapping does not know it;
  /// 1: not tested.
  double undetected_spread = 1;
  double depth_per_radius = 0;  ///< relative change of depth per relative change of the ball's
                                ///< radius
  int left_out = 0;             ///< number of given presses that failed
  bool is_complete = true;      ///< false: stopped before convergence
  std::vector<RecordedContradiction> contradictions;
  bool operator==(const CalibrationBasis&) const = default;
};

/// Record of a calibration, written next to the mapping for people and for `check`.
struct MappingRecord {
  std::string method;                ///< joint | paper | circle | cone
  std::vector<std::string> presses;  ///< names of the images used
  double residual_mm = 0;            ///< mean absolute residual inside the contacts
  double held_out_mm = 0;     ///< mean absolute error on presses left out; 0 when only one press
  double spread_mm = 0;       ///< systematic error of the depth, mean absolute; 0: unknown
  double pixel_mm = 0;        ///< error of a pixel in a contact, mean absolute; 0: unknown
  std::string degree_choice;  ///< a sentence
  std::optional<CalibrationBasis> basis = {};  ///< absent in files of earlier versions
};

struct ReferenceFiles {
  std::string video;    ///< relative path of the recording; empty for a flat sensor
  std::string markers;  ///< relative path of its marker table (CSV)
  std::string image;    ///< flat: relative path of the one reference image without contact
  /// Set: the table holds these positions instead of markers, and the face's shape determines
  /// poses.
  std::optional<EdgePositions> positions = {};
};

struct ContactSettings {
  double threshold_px = 0;  ///< threshold for a push on the sum of marker offsets (push.h)
  std::vector<Eigen::Vector2d> rest_markers;  ///< 2n positions of the finger at rest, px
};

/// A value with the content of `finger.yaml`.
class Finger {
 public:
  static constexpr const char* kFormat = "alltact-finger/1";
  static constexpr const char* kFileName = "finger.yaml";

  std::string name;
  CameraParameters camera;
  LensRecord lens_record;  ///< empty: the camera was written by hand
  Face face;
  MarkerRows markers;
  std::optional<MappingParameters> mapping;
  std::optional<MappingRecord> mapping_record;
  std::optional<ReferenceFiles> reference;
  std::optional<ContactSettings> contact;
  std::string force_model;  ///< relative path of a ForceModel; empty when there is none
  /// Pose of the camera in the gripper (see RigidTransform), for opposing fingers; absent: unknown.
  /// Stored as written: rotation within 0.001 of unit length, each coordinate within 10000 mm.
  std::optional<RigidTransform> gripper_from_camera;
  std::map<std::string, std::string> provenance;  ///< date, program version, ball_radius_mm, ...

  /// Reads FOLDER/finger.yaml. A missing, mistyped or impossible value is an error with file, line,
  /// key and the correct form. Unknown keys are retained (save() writes them back) and listed in
  /// `warnings`. Referenced files must lie inside the folder.
  static Result<Finger> load(const std::filesystem::path& folder,
                             std::vector<Message>* warnings = nullptr);

  /// Parses a file's content like load(); `origin` is its name in errors.
  static Result<Finger> parse(const std::string& yaml, const std::filesystem::path& origin,
                              std::vector<Message>* warnings = nullptr);

  /// Writes FOLDER/finger.yaml atomically; an invalid finger is refused. Keys have the order of the
  /// format, numbers all their digits: load, save, load gives an equal value and the same bytes.
  [[nodiscard]] Status save(const std::filesystem::path& folder) const;

  /// The content that save() writes.
  [[nodiscard]] Result<std::string> to_yaml() const;

  /// Checks values like load(), for a finger composed in memory. The error's `where` is the key
  /// ("face.width_mm"). A fin_ray needs a perspective camera. A flat sensor has no markers, and its
  /// plane lies in front of a perspective camera. rest_markers are as many as marker_count().
  /// Referenced files lie inside the folder.
  [[nodiscard]] Status validate() const;

  /// Possible but implausible numbers, by their keys (typed_number.h); load() warns of them.
  [[nodiscard]] std::vector<Error> implausible() const;

  /// Number of markers, including missing ones, or of the positions that replace them.
  [[nodiscard]] int marker_count() const {
    return 2 * (reference && reference->positions ? EdgePositions::kPerEdge : markers.per_row);
  }

 private:
  struct Unknown;  // keys of the file that this version does not know
  std::shared_ptr<const Unknown> unknown_;
};

// The faces of a finger.

/// Upper is the side face at small v (y < 0), lower the one at large v.
enum class PushedFace { kContact = 1, kBack, kUpper, kLower };
[[nodiscard]] std::string_view to_string(PushedFace face);

}  // namespace alltact
