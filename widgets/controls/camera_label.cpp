#include "widgets/controls/camera_label.h"

#include "widgets/controls/control_panel.h"

#include <algorithm>

namespace alltact {
namespace {

/// "1.4" of "usb-0000:00:14.0-1.4"; empty where the driver reports no USB port.
std::string usb_port(const std::string& bus) {
  const std::size_t dash = bus.rfind('-');
  return bus.rfind("usb-", 0) == 0 && dash > 3 ? bus.substr(dash + 1) : std::string();
}

}  // namespace

QString camera_label(const FoundCamera& camera, const std::vector<FoundCamera>& cameras) {
  const CameraIdentity& identity = camera.identity;
  const QString name = QString::fromStdString(identity.name);
  const auto alike = std::count_if(cameras.begin(), cameras.end(), [&](const FoundCamera& one) {
    return one.identity.name == identity.name;
  });
  if (alike < 2) return name;
  const std::string port = usb_port(identity.bus);
  return port.empty()
             ? ControlPanel::tr("%1 (%2)").arg(name, QString::fromStdString(identity.stable_name()))
             : ControlPanel::tr("%1 (USB port %2)").arg(name, QString::fromStdString(port));
}

}  // namespace alltact
