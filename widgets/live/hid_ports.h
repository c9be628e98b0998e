// What is behind a pedal or a lamp, for tests to replace.
#pragma once

#include "core/sources/hid/hid_port.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace alltact {

/// Called on threads of their own.
struct HidPorts {
  std::function<std::vector<FoundHid>()> list = &list_hids;
  std::function<Result<std::unique_ptr<HidPort>>(const std::string& wanted)> open = &open_hid;
};

}  // namespace alltact
