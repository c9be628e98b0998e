#include "core/devices/camera_list.h"

#include "core/open/open_source.h"

#include <cerrno>
#include <cstring>
#include <map>
#include <sstream>
#include <string_view>

#include <libudev.h>
#include <linux/videodev2.h>

namespace alltact {
namespace {

namespace fs = std::filesystem;

struct UdevDeleter {
  void operator()(udev* it) const { udev_unref(it); }
  void operator()(udev_enumerate* it) const { udev_enumerate_unref(it); }
  void operator()(udev_device* it) const { udev_device_unref(it); }
};
template <class T>
using UdevPtr = std::unique_ptr<T, UdevDeleter>;

std::string text_or_empty(const char* text) {
  return text == nullptr ? std::string() : std::string(text);
}

CameraIdentity identity_of(udev_device* device) {
  CameraIdentity identity;
  identity.node = text_or_empty(udev_device_get_devnode(device));
  identity.name = text_or_empty(udev_device_get_sysattr_value(device, "name"));
  identity.serial = text_or_empty(udev_device_get_property_value(device, "ID_SERIAL_SHORT"));
  std::istringstream links(text_or_empty(udev_device_get_property_value(device, "DEVLINKS")));
  for (std::string word; links >> word;) {
    const fs::path link = word;
    if (link.parent_path() == "/dev/v4l/by-id") identity.by_id = link.filename().string();
    if (link.parent_path() == "/dev/v4l/by-path") identity.by_path = link.filename().string();
  }
  return identity;
}

/// Clears by-id names that several cameras share, because cheap cameras have one serial number.
void drop_shared_names(std::vector<CameraIdentity>& nodes, std::string CameraIdentity::*name) {
  std::map<std::string, int> count;
  for (const CameraIdentity& node : nodes) ++count[node.*name];
  for (CameraIdentity& node : nodes)
    if (count[node.*name] > 1) (node.*name).clear();
}

std::vector<CameraIdentity> video_nodes() {
  std::vector<CameraIdentity> nodes;
  const UdevPtr<udev> context(udev_new());
  if (context == nullptr) return nodes;
  const UdevPtr<udev_enumerate> search(udev_enumerate_new(context.get()));
  udev_enumerate_add_match_subsystem(search.get(), "video4linux");
  udev_enumerate_scan_devices(search.get());
  for (udev_list_entry* entry = udev_enumerate_get_list_entry(search.get()); entry != nullptr;
       entry = udev_list_entry_get_next(entry)) {
    const UdevPtr<udev_device> device(
        udev_device_new_from_syspath(context.get(), udev_list_entry_get_name(entry)));
    if (device == nullptr) continue;
    CameraIdentity identity = identity_of(device.get());
    if (fs::path(identity.node).filename().string().starts_with("video"))
      nodes.push_back(std::move(identity));
  }
  // By number: video10 follows video9.
  std::sort(nodes.begin(), nodes.end(), [](const CameraIdentity& a, const CameraIdentity& b) {
    return std::pair(a.node.size(), a.node) < std::pair(b.node.size(), b.node);
  });
  drop_shared_names(nodes, &CameraIdentity::by_id);
  drop_shared_names(nodes, &CameraIdentity::by_path);
  return nodes;
}

/// Returns 0, or EBUSY where another program streams.
int probe_busy(const V4l2Device& device) {
  v4l2_format format;
  std::memset(&format, 0, sizeof format);
  format.type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
  if (device.ioctl(VIDIOC_G_FMT, &format) != 0) return 0;
  return device.ioctl(VIDIOC_S_FMT, &format) == EBUSY ? EBUSY : 0;
}

std::optional<Error> problem_of(const FoundCamera& camera,
                                const V4l2Device::Capability& capability) {
  const std::string& node = camera.identity.node;
  if (capability.is_multi_planar)
    return Error{en::say("it sends its images in several planes, which is not supported"), node,
                 en::say("a USB camera")};
  if (!capability.can_stream)
    return Error{en::say("it cannot stream"), node, en::say("a USB camera")};
  const bool is_readable =
      std::any_of(camera.formats.begin(), camera.formats.end(),
                  [](const CameraFormat& format) { return can_decode(format.fourcc); });
  if (!is_readable)
    return Error{en::say("it has no supported format"), node,
                 en::say("a camera with MJPG or YUYV")};
  return std::nullopt;
}

/// Empty for a node that is no camera.
std::optional<FoundCamera> probe_camera(V4l2Calls& calls, CameraIdentity identity,
                                        bool check_busy) {
  FoundCamera camera;
  camera.identity = std::move(identity);
  const auto device = V4l2Device::open(calls, camera.identity.node);
  if (!device) {
    camera.problem = device.error();
    return camera;
  }
  const auto capability = device->capability();
  if (!capability) {
    camera.problem = capability.error();
    return camera;
  }
  if (!capability->is_capture) return std::nullopt;
  camera.identity.bus = capability->bus;
  camera.identity.driver = capability->driver;
  if (camera.identity.name.empty()) camera.identity.name = capability->card;
  camera.formats = device->formats();
  camera.controls = list_controls(*device);
  camera.problem = problem_of(camera, *capability);
  if (!camera.problem && check_busy && probe_busy(*device) == EBUSY)
    camera.problem = camera_error(en::say("it cannot be used now"), camera.identity.node, EBUSY);
  return camera;
}

bool is_named(const CameraIdentity& identity, const std::string& requested) {
  return requested == identity.node || requested == identity.by_id ||
         requested == identity.by_path || requested == identity.serial;
}

Message names_of(const std::vector<const CameraIdentity*>& identities) {
  std::vector<Message> names;
  for (const CameraIdentity* identity : identities)
    names.push_back(
        Message::typed(fmt::format("{} ({})", identity->stable_name(), identity->node)));
  return en::list(names);
}

/// The file name of a path below /dev/v4l; other words unchanged.
std::string name_in(const std::string& requested) {
  const fs::path path = requested;
  const fs::path folder = path.parent_path();
  if (folder == "/dev/v4l/by-id" || folder == "/dev/v4l/by-path") return path.filename().string();
  return requested;
}

CameraAccess access_of(V4l2Calls& calls, const CameraIdentity& identity) {
  const std::string stable_name = identity.stable_name();
  return {
      &calls, stable_name,
      [stable_name]() -> Result<std::string> {
        // Without opening anything: called repeatedly while a camera is away.
        for (const CameraIdentity& now : video_nodes())
          if (is_named(now, stable_name)) return now.node;
        if (stable_name.starts_with("/dev/")) return stable_name;
        return Error{en::say("the camera is not connected"), stable_name, en::say("plug it in")};
      },
      identity.serial};
}

}  // namespace

const std::string& CameraIdentity::stable_name() const {
  if (!by_id.empty()) return by_id;
  return by_path.empty() ? node : by_path;
}

std::vector<FoundCamera> list_cameras(V4l2Calls& calls, bool check_busy) {
  std::vector<FoundCamera> cameras;
  for (CameraIdentity& identity : video_nodes())
    if (auto camera = probe_camera(calls, std::move(identity), check_busy))
      cameras.push_back(std::move(*camera));
  return cameras;
}

Result<CameraIdentity> find_camera(const std::string& requested,
                                   const std::vector<FoundCamera>& cameras) {
  const std::string name = name_in(requested);
  std::vector<const CameraIdentity*> all, fitting;
  for (const FoundCamera& camera : cameras) {
    all.push_back(&camera.identity);
    if (!name.empty() && is_named(camera.identity, name)) fitting.push_back(&camera.identity);
  }
  if (fitting.size() == 1) return *fitting.front();
  if (!fitting.empty())
    return Error{en::say("several cameras have this name: {}", names_of(fitting)), requested,
                 en::say("the name before the brackets")};
  // Without any listed device a node is accepted unchecked.
  if (cameras.empty() && requested.starts_with("/dev/")) {
    CameraIdentity identity;
    identity.node = requested;
    return identity;
  }
  return Error{all.empty() ? en::say("no camera was found")
                           : en::say("there is no such camera; available: {}", names_of(all)),
               requested,
               all.empty() ? en::say("plug one in; 'alltact devices' lists what is found")
                           : en::say("one of these names")};
}

Result<std::unique_ptr<V4l2Camera>> open_camera(const std::string& requested,
                                                const FormatCriteria& criteria,
                                                const std::vector<ControlValue>& controls,
                                                V4l2Calls& calls) {
  const auto identity = find_camera(requested, list_cameras(calls));
  if (!identity) return identity.error();
  return V4l2Camera::open(access_of(calls, *identity), criteria, controls);
}

namespace {

Result<std::unique_ptr<Source>> open_camera_input(const fs::path& name, const SourceOptions&) {
  auto camera = open_camera(name.string());
  if (!camera) return camera.error();
  return std::unique_ptr<Source>(std::make_unique<CameraSource>(std::move(*camera)));
}

[[maybe_unused]] const bool kIsCameraKnown = add_input_kind(InputKind::kCamera, open_camera_input);

}  // namespace

}  // namespace alltact
