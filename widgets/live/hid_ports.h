// Functions behind a pedal or a lamp, replaceable in tests.
#pragma once

#include "core/sources/hid/hid_port.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace alltact {

/// Called on background threads.
struct HidPorts {
  std::function<std::vector<FoundHid>()> list = &list_hids;
  std::function<Result<std::unique_ptr<HidPort>>(const std::string& requested)> open = &open_hid;
};

}  // namespace alltact
