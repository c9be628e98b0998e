// Files that hold a camera: this program's own, and those of other programs.
//
// A file's content decides its format, not its name. Lengths are pixels of the image for which the
// file holds. This program's camera has pixel (0, 0) at the centre of the top-left pixel, as all
// formats below but Matlab's, where that centre is (1, 1): 1 is subtracted there.
//
//   ROS camera_info     YAML: camera_matrix, distortion_model, distortion_coefficients,
//                       image_width, image_height, or the message's K, D, width, height.
//                       K and D are read, which describe the raw image; P and R describe the
//                       rectified one.
//                       Source: sensor_msgs/CameraInfo.msg.
//   OpenCV              cv::FileStorage's YAML, XML or JSON, or other JSON and YAML with common
//                       names: camera_matrix, mtx, K; dist_coeffs, D; image_size, image_width.
//                       4, 5, 8, 12 or 14 coefficients, k1 k2 p1 p2 k3 k4 k5 k6 s1 s2 s3 s4
//                       tx ty, or a fisheye's 4. Two cameras of one file, with camera_matrix_1
//                       or M1 and so on, are named 1 and 2.
//                       Source: OpenCV's documentation of calib3d.
//   Kalibr camchain     cam0, cam1, ...: intrinsics [fx, fy, cx, cy], resolution [width, height],
//                       pinhole with radtan (k1 k2 p1 p2), equi (k1 k2 k3 k4) or none.
//   mrcal .cameramodel  LENSMODEL_PINHOLE, LENSMODEL_OPENCV4, 5, 8, 12: intrinsics fx fy cx cy
//                       and coefficients in OpenCV's order, imagersize [width, height].
//   PhotonVision JSON   cameraIntrinsics, distCoeffs (older: cameraExtrinsics), resolution.
//   Matlab              cameraParameters, cameraIntrinsics: jsonencode(toStruct(...)), or as
//                       printed. IntrinsicMatrix is transposed, ImageSize is [rows, columns],
//                       the coefficients are OpenCV's k1 k2 (k3) and p1 p2.
//                       Source: Matlab's documentation of cameraIntrinsics.
//   calibration.json    of `alltact export`
//
// The keys `orientation` and `port` of this program's format may stand in those files as well.
// What this program's camera cannot express is refused by name: another lens model, a skew, a
// tilted sensor, a binned or cut image of ROS, coefficients beyond k1 to s4 that are not 0.
#pragma once

#include "core/base/fields.h"
#include "core/base/result.h"
#include "core/camera/camera.h"

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace alltact {

/// Record of the lens calibration (date, views, standard deviations), for people and for the
/// report; the key `camera.lens`.
using LensRecord = std::map<std::string, std::string>;

struct CameraFile {
  CameraParameters parameters;
  LensRecord lens;                ///< empty: written by hand or by another program
  Message understood;             ///< "read as a ROS camera_info file: 960 x 540 px, fx 523.9, ..."
  std::vector<Message> warnings;  ///< keys that were not read, a guess
};

/// The key `camera:` of a finger file: `parameters` and `lens`. Refuses keys of other programs,
/// whose numbers would be lost.
void describe(Fields& fields, CameraFile& file);

/// Reads a camera from a file of any of the formats above, or from this program's own (with or
/// without the line `camera:`). `file` may end in '#NAME', the name of one camera of several:
/// "camchain.yaml#cam1". Errors: several cameras and no name; what is missing, contradictory, not
/// finite or out of the range of check_camera_range(), with file, line and key where known.
[[nodiscard]] Result<CameraFile> load_camera(const std::filesystem::path& file);

/// The camera in a file's content. `origin`: the file's name in errors; `name`: of one camera of
/// several, or empty.
[[nodiscard]] Result<CameraFile> parse_camera(const std::string& content,
                                              const std::filesystem::path& origin,
                                              const std::string& name = "");

/// The same for formats of other programs and calibration.json; nullopt: the content is of this
/// program's own format.
[[nodiscard]] Result<std::optional<CameraFile>> parse_foreign_camera(
    const std::string& content, const std::filesystem::path& origin, const std::string& name);

/// "read as WHAT: 960 x 540 px, fx 523.9, MODEL with 5 coefficients".
///   what: the format
///   model: name of the distortion's model; empty: none
///   count: number of coefficients in the file
[[nodiscard]] Message understood_camera(const CameraParameters& camera, const Message& what,
                                        const std::string& model, std::size_t count);

/// Sixteen hexadecimal digits that change with any number under `camera:` (FNV-1a).
[[nodiscard]] std::string camera_fingerprint(const CameraParameters& parameters);

/// Writes a file of this program's own format, without the line `camera:`. Error: no valid camera,
/// or not writable.
[[nodiscard]] Status save_camera(const std::filesystem::path& file,
                                 const CameraParameters& parameters, const LensRecord& record = {});

}  // namespace alltact
