// What other programs have to know to be served: printed by `alltact serve --schema`.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace alltact {

/// A key of a message's JSON: "regions[].deepest_mm".
struct StreamKey {
  std::string_view message;  ///< as to_string(StreamType) names it
  std::string_view path;
  std::string_view what;  ///< with its unit
};
/// Of everything that is sent, in its order there. Whatever could not be had is absent, never zero.
[[nodiscard]] const std::vector<StreamKey>& stream_keys();

/// For people: request, layout, parts and keys.
[[nodiscard]] std::string stream_schema_text();
/// The same as one JSON object.
[[nodiscard]] std::string stream_schema_json();

}  // namespace alltact
