// Which cameras there are, by names that stay the same, and what is wrong with those that cannot be
// used.
#pragma once

#include "core/result.h"
#include "core/sources/v4l2/v4l2_camera.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace alltact {

struct CameraIdentity {
  std::string node;   ///< /dev/video0: may be another after the next start
  std::string name;   ///< what the maker calls it
  std::string by_id;  ///< file name below /dev/v4l/by-id: the same camera at any port; empty where
                      ///< several share it
  std::string by_path;  ///< file name below /dev/v4l/by-path: whatever is at this port
  std::string serial;   ///< may be empty or, with cheap cameras, the same for all
  std::string bus;      ///< what the driver says of the place: usb-0000:00:14.0-2
  std::string driver;

  /// The name that lasts longest: by_id, else by_path, else the node.
  [[nodiscard]] const std::string& lasting() const;
};

struct FoundCamera {
  CameraIdentity identity;
  std::vector<CameraFormat> formats;
  std::vector<CameraControl> controls;
  std::optional<Error> problem;  ///< why it cannot be used now
};

/// Every camera, in the order of nodes. Nodes that are no camera (metadata, radio, converters) are
/// left out. is_busy_told: also finds out whether another program streams from it, by setting the
/// format that is set already.
[[nodiscard]] std::vector<FoundCamera> list_cameras(V4l2Calls& calls, bool is_busy_told = false);

/// The one camera that `wanted` names: a node, a by-id or by-path name (whole or from
/// /dev/v4l/...), or a serial number. Errors: none, with what there is; several, with their names.
[[nodiscard]] Result<CameraIdentity> find_camera(const std::string& wanted,
                                                 const std::vector<FoundCamera>& cameras);

/// Finds, opens and starts. It is found again after re-plugging by its lasting name.
[[nodiscard]] Result<std::unique_ptr<V4l2Camera>> open_camera(
    const std::string& wanted,
    const FormatWish& wish = {},
    const std::vector<ControlValue>& controls = {},
    V4l2Calls& calls = kernel_calls());

}  // namespace alltact
