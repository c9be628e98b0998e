// Settings by their Python names: smoothing_px=1.0 is --smoothing-px 1.0 of the command line.
#pragma once

#include "core/either.h"
#include "core/settings.h"

#include <algorithm>
#include <string>
#include <vector>

#include "packaging/python/src/failure.h"
#include <pybind11/pybind11.h>

namespace alltact::python {

[[nodiscard]] inline std::string flag_of(std::string name) {
  std::replace(name.begin(), name.end(), '_', '-');
  return name;
}

/// Takes one setting. False: the table has none of this name. Error: the value is out of range.
template <class S>
[[nodiscard]] Result<bool> take_setting(const std::vector<Setting<S>>& table,
                                        const std::string& name,
                                        const std::string& value,
                                        S& settings) {
  for (const Setting<S>& setting : table) {
    if (setting.name != flag_of(name)) continue;
    const Status status = setting.set(settings, value);
    if (!status) return status.error();
    return true;
  }
  return false;
}

template <class S>
[[nodiscard]] std::vector<std::string> names_of(const std::vector<Setting<S>>& table) {
  std::vector<std::string> names;
  for (const Setting<S>& setting : table) {
    names.push_back(setting.name);
    std::replace(names.back().begin(), names.back().end(), '-', '_');
  }
  return names;
}

[[nodiscard]] inline Error no_setting(const std::string& name,
                                      const std::vector<std::string>& names) {
  return {en::say("there is no setting '{}', but {}", name, one_of(names, name)), "", ""};
}

template <class S>
[[nodiscard]] py::dict settings_dict(const std::vector<Setting<S>>& table, const S& settings) {
  py::dict all;
  const std::vector<std::string> names = names_of(table);
  for (std::size_t i = 0; i < table.size(); ++i) all[names[i].c_str()] = table[i].get(settings);
  return all;
}

}  // namespace alltact::python
