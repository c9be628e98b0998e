// Documentation of the format for other programs, printed by `alltact serve --schema`.
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
/// All keys, in the order in which they are sent. Unknown values are absent, never zero.
[[nodiscard]] const std::vector<StreamKey>& stream_keys();

/// For people: request, layout, parts and keys.
[[nodiscard]] std::string stream_schema_text();
/// The same as one JSON object.
[[nodiscard]] std::string stream_schema_json();

}  // namespace alltact
