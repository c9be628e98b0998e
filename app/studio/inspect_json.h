// The state of the page Inspect, as a part of the saved session.
#pragma once

#include "widgets/inspect/inspect_options.h"

#include <nlohmann/json.hpp>

namespace alltact {

/// The options of Inspect, and the frame of its recording.
struct InspectState {
  InspectOptions options;
  std::size_t frame = 0;
  bool operator==(const InspectState&) const = default;
};

[[nodiscard]] nlohmann::ordered_json inspect_to_json(const InspectState& state);
/// Lenient: ignores unknown entries; impossible values become defaults.
[[nodiscard]] InspectState inspect_from_json(const nlohmann::ordered_json& json);

}  // namespace alltact
