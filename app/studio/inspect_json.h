// What the place Inspect showed, as a part of the kept session.
#pragma once

#include "widgets/inspect/inspect_options.h"

#include <nlohmann/json.hpp>

namespace alltact {

/// What Inspect showed, and the frame of its recording.
struct InspectState {
  InspectOptions options;
  std::size_t frame = 0;
  bool operator==(const InspectState&) const = default;
};

[[nodiscard]] nlohmann::ordered_json inspect_to_json(const InspectState& state);
/// Kind: what it does not know is passed over, what is impossible becomes the default.
[[nodiscard]] InspectState inspect_from_json(const nlohmann::ordered_json& json);

}  // namespace alltact
