// Errors as Python exceptions: alltact.Error.
#pragma once

#include "core/result.h"

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

}  // namespace alltact::python
