// Lenient reading of JSON that may be damaged: unexpected values become defaults.
#pragma once

#include <nlohmann/json.hpp>

namespace alltact {

/// The value of a key of `map`, which may be no map at all.
template <class T>
T value_or(const nlohmann::ordered_json& map, const char* key, T otherwise) {
  const auto found = map.find(key);
  if (found == map.end()) return otherwise;
  try {
    return found->template get<T>();
  } catch (const nlohmann::ordered_json::exception&) {
    return otherwise;
  }
}

}  // namespace alltact
