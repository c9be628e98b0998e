// Lists cameras by stable names, with the problem of each unusable one.
#pragma once

#include "core/base/result.h"
#include "core/devices/v4l2_camera.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace alltact {

struct CameraIdentity {
  std::string node;   ///< /dev/video0: may change with the next start
  std::string name;   ///< the maker's name for it
  std::string by_id;  ///< file name below /dev/v4l/by-id: the same camera at any port; empty where
                      ///< several share it
  std::string by_path;  ///< file name below /dev/v4l/by-path: the camera at this port
  std::string serial;   ///< may be empty or, with cheap cameras, the same for all
  std::string bus;      ///< the driver's port name: usb-0000:00:14.0-2
  std::string driver;

  /// The most stable name: by_id, else by_path, else the node.
  [[nodiscard]] const std::string& stable_name() const;
};

struct FoundCamera {
  CameraIdentity identity;
  std::vector<CameraFormat> formats;
  std::vector<CameraControl> controls;
  std::optional<Error> problem;  ///< why it cannot be used now
};

/// Every camera, in the order of nodes, without nodes of other kinds (metadata, radio, converters).
/// check_busy: also detects a stream of another program, by setting the current format again.
[[nodiscard]] std::vector<FoundCamera> list_cameras(V4l2Calls& calls, bool check_busy = false);

/// The one camera that `requested` names: a node, a by-id or by-path name (complete or from
/// /dev/v4l/...), or a serial number. Errors: none, with a list of cameras; several, with their
/// names.
[[nodiscard]] Result<CameraIdentity> find_camera(const std::string& requested,
                                                 const std::vector<FoundCamera>& cameras);

/// Finds, opens and starts a camera. After re-plugging it is found by its stable name.
[[nodiscard]] Result<std::unique_ptr<V4l2Camera>> open_camera(
    const std::string& requested, const FormatCriteria& criteria = {},
    const std::vector<ControlValue>& controls = {}, V4l2Calls& calls = kernel_calls());

}  // namespace alltact
