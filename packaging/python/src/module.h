// Errors as Python exceptions: alltact.Error.
#pragma once

#include "core/base/message.h"
#include "core/base/result.h"
#include "core/base/settings.h"

#include <algorithm>
#include <exception>
#include <string>
#include <utility>
#include <vector>

#include <pybind11/pybind11.h>

namespace alltact::python {

namespace py = pybind11;

class Failure : public std::exception {
 public:
  explicit Failure(Error error) : error_(std::move(error)), sentence_(error_.sentence()) {}
  [[nodiscard]] const char* what() const noexcept override { return sentence_.c_str(); }
  [[nodiscard]] const Error& error() const { return error_; }

 private:
  Error error_;
  std::string sentence_;
};

/// The value, or the error thrown.
template <class T>
T value_of(Result<T> result) {
  if (!result) throw Failure(result.error());
  return std::move(result).value();
}
inline void check(const Status& status) {
  if (!status) throw Failure(status.error());
}

[[nodiscard]] inline std::vector<std::string> english(const std::vector<Message>& messages) {
  std::vector<std::string> sentences;
  for (const Message& message : messages) sentences.push_back(message.english());
  return sentences;
}

// Each adds its part of the module.
void bind_failure(py::module_& module);
void bind_sources(py::module_& module);
void bind_results(py::module_& module);
void bind_finger(py::module_& module);
void bind_simulation(py::module_& module);
void bind_calibration(py::module_& module);

// Classes and functions of the module, with the documentation of _alltact.pyi.

namespace py = pybind11;

/// The stub's documentation of "Finger.measure"; empty where there is none.
[[nodiscard]] const char* doc_of(const std::string& name);

template <class T>
class Documented {
 public:
  Documented(py::module_& module, std::string name)
      : name_(std::move(name)), class_(module, name_.c_str(), doc_of(name_)) {}

  template <class Get>
  Documented& property(const std::string& name, Get get) {
    class_.def_property_readonly(name.c_str(), get, doc_of(name_ + "." + name));
    return *this;
  }
  template <class Call, class... More>
  Documented& method(const std::string& name, Call call, const More&... more) {
    class_.def(name.c_str(), call, more..., doc_of(name_ + "." + name));
    return *this;
  }
  template <class Make, class... More>
  Documented& made_by(Make make, const More&... more) {
    class_.def(py::init(make), more..., doc_of(name_ + ".__init__"));
    return *this;
  }
  Documented& iterates_over_itself() {
    class_.def("__iter__", [](const std::shared_ptr<T>& all) { return all; });
    return *this;
  }

 private:
  std::string name_;
  py::class_<T, std::shared_ptr<T>> class_;
};

template <class Call, class... More>
void function(py::module_& module, const std::string& name, Call call, const More&... more) {
  module.def(name.c_str(), call, more..., doc_of(name));
}

// Settings by their Python names: smoothing_px=1.0 is --smoothing-px 1.0 of the command line.

[[nodiscard]] inline std::string flag_of(std::string name) {
  std::replace(name.begin(), name.end(), '_', '-');
  return name;
}

/// Takes one setting. False: the table has none of this name. Error: the value is out of range.
template <class S>
[[nodiscard]] Result<bool> take_setting(const std::vector<Setting<S>>& table,
                                        const std::string& name, const std::string& value,
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
