// Finger: everything that is known of one finger, and the folder it lives in.
#pragma once

#include "core/camera/camera.h"
#include "core/finger/mapping.h"
#include "core/geometry/rigid_transform.h"
#include "core/result.h"

#include <array>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace alltact {

enum class FaceKind { kFinRay = 1, kFlat };
enum class Polarity { kBright = 1, kDark, kAuto };

struct Face {
  FaceKind kind = FaceKind::kFinRay;
  double width_mm = 0;    ///< fin_ray: distance of the two edges of the view face, kFaceWidth
  double layer_mm = 0;    ///< of the translucent layer along its normal, kLayerThickness
  double plane_z_mm = 0;  ///< flat: the view face is the plane z = plane_z_mm
};

struct MarkerRows {
  int per_row = 0;  ///< dots on the longer of both rows, 0..64; 0: none
  Polarity polarity =
      Polarity::kAuto;  ///< against their surroundings; auto until a recording tells
  /// Numbers that no dot has, ascending: never engraved, lost, or of a shorter row. The others keep
  /// their numbers.
  std::vector<int> missing = {};
};

/// Places on both edges of the face that stand in for markers where a finger has none that could be
/// used: kPerEdge on each edge, numbered like markers, `step_mm` apart along the face and counted
/// from where it crosses the column `from_u_px`.
struct PosePlaces {
  static constexpr int kPerEdge = 8;
  double from_u_px = 0;
  double step_mm = 0;  ///< (0, 500]
};

/// A statement of a calibration's data that contradicts a number which was given for it.
struct RecordedContradiction {
  std::string kind;           ///< as calibration/verdict/contradiction.h writes it
  int presses = 0, of = 0;    ///< how many presses show it, of how many
  double given_mm = 0;        ///< the number
  double measured_mm = 0;     ///< what the presses show: least
  double measured_to_mm = 0;  ///< greatest
  bool operator==(const RecordedContradiction&) const = default;
};

/// What a calibration rests on: the numbers that were given for it, and what its presses cover.
/// Standard deviations are of depth, in mm along z.
struct CalibrationBasis {
  std::vector<double> ball_radii_mm;                  ///< of the balls used, ascending, each once
  double layer_mm = 0, width_mm = 0, plane_z_mm = 0;  ///< the face, as it was then
  std::string camera;                                 ///< camera_fingerprint(), as it was then
  std::string reference;           ///< checksum of the reference's files; empty: none
  int positions = 0;               ///< distinct positions on the face: repeats at one count once
  std::array<int, 3> thirds = {};  ///< of them in base, middle, tip (flat: left, middle, right)
  double position_leverage = 0;    ///< mean over the face, of a line along it; 0: unknown
  double shallowest_mm = 0, deepest_mm = 0;  ///< of the balls
  double scale_sd_mm = 0;  ///< of the whole mapping, root mean square over its domain
  double pixel_sd_mm = 0;  ///< of a pixel in a contact, without the mapping's share; 0: unknown
  double halo_mm = 0;      ///< light that scatters sideways; 0: not significant
  double depth_per_radius = 0;  ///< relative change of depth for one of the ball's radius
  int left_out = 0;             ///< presses that were given and failed
  bool is_complete = true;      ///< false: stopped before the solution had settled
  std::vector<RecordedContradiction> contradictions;
  bool operator==(const CalibrationBasis&) const = default;
};

/// How a calibration came about; written beside the mapping for people and for `check`.
struct MappingRecord {
  std::string method;                ///< joint | paper | circle | cone
  std::vector<std::string> presses;  ///< picture names that were used
  double residual_mm = 0;            ///< mean absolute residual inside the contacts
  double held_out_mm = 0;     ///< mean absolute error on presses left out; 0 when only one press
  double spread_mm = 0;       ///< how far depth may be off as a whole, mean absolute; 0: unknown
  double pixel_mm = 0;        ///< what a pixel in a contact may be off by, likewise; 0: unknown
  std::string degree_choice;  ///< a sentence
  std::optional<CalibrationBasis> basis = {};  ///< absent in files of earlier versions
};

struct ReferenceFiles {
  std::string video;    ///< relative path of the recording; empty for a flat sensor
  std::string markers;  ///< relative path of its marker table (CSV)
  std::string image;    ///< flat: relative path of the one untouched picture
  /// The table holds these places instead of markers: poses are told by the shape of the face.
  std::optional<PosePlaces> places = {};
};

struct ContactSettings {
  double threshold_px = 0;  ///< sum of marker offsets that counts as a push (push.h)
  std::vector<Eigen::Vector2d> rest_markers;  ///< 2n positions of the finger at rest, px
};

/// How the camera's lens was calibrated (date, views, standard deviations), for people and for the
/// report; what stands under `camera.lens`.
using LensRecord = std::map<std::string, std::string>;

/// A value: all that `finger.yaml` says.
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
  /// Where the camera sits in the gripper (see RigidTransform), for fingers that look at each
  /// other; absent: not known. Kept as written: rotation within 0.001 of unit length, each
  /// coordinate within 10000 mm.
  std::optional<RigidTransform> gripper_from_camera;
  std::map<std::string, std::string> provenance;  ///< date, program version, ball_radius_mm, ...

  /// Reads FOLDER/finger.yaml. Strict: a missing, misspelt-in-type or impossible value is an error
  /// with file, line, key and what would be right. Kind: unknown keys are kept (save() writes them
  /// back) and named in `warnings`. Files that are named must lie inside the folder.
  static Result<Finger> load(const std::filesystem::path& folder,
                             std::vector<Message>* warnings = nullptr);

  /// What load() does with the file's content; `origin` names it in errors.
  static Result<Finger> parse(const std::string& yaml,
                              const std::filesystem::path& origin,
                              std::vector<Message>* warnings = nullptr);

  /// Writes FOLDER/finger.yaml whole or not at all; a finger that is not valid is refused. Keys are
  /// written in the order of the format, numbers with all their digits: load, save, load gives an
  /// equal value and the same bytes.
  [[nodiscard]] Status save(const std::filesystem::path& folder) const;

  /// The content that save() writes.
  [[nodiscard]] Result<std::string> to_yaml() const;

  /// What load() checks of values, for a finger that was put together in memory. The error's
  /// `where` is the key ("face.width_mm"). A fin_ray needs a perspective camera; a flat sensor has
  /// no markers, and its plane lies in front of a perspective camera. rest_markers are as many as
  /// marker_count(). Named files lie inside the folder.
  [[nodiscard]] Status validate() const;

  /// Numbers that are possible and unusual, by their keys (quantity.h); load() warns of them.
  [[nodiscard]] std::vector<Error> implausible() const;

  /// Of the numbers, missing ones too; of the places that stand in for markers where these do.
  [[nodiscard]] int marker_count() const {
    return 2 * (reference && reference->places ? PosePlaces::kPerEdge : markers.per_row);
  }

 private:
  struct Unknown;  // keys of the file that this version does not know
  std::shared_ptr<const Unknown> unknown_;
};

/// Reads what stands under `camera:` in a finger from a file of its own (CAMERA.yaml, with or
/// without the `camera:` line above it). `record`: may be null.
[[nodiscard]] Result<CameraParameters> load_camera(const std::filesystem::path& file,
                                                   LensRecord* record = nullptr);

/// Sixteen hexadecimal digits that change with any number under `camera:` (FNV-1a).
[[nodiscard]] std::string camera_fingerprint(const CameraParameters& parameters);

/// Writes such a file, without the `camera:` line. Error: no valid camera, or not writable.
[[nodiscard]] Status save_camera(const std::filesystem::path& file,
                                 const CameraParameters& parameters,
                                 const LensRecord& record = {});

}  // namespace alltact
