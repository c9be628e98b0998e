#include "packaging/python/src/module.h"

#include "core/base/program.h"

#include <map>
#include <string_view>

#include <opencv2/core/utils/logger.hpp>
#include <pybind11/pybind11.h>

namespace alltact::python {

const char* doc_of(const std::string& name) {
  static const std::map<std::string_view, const char*> docstrings = {
#include "docstrings.inc"
  };
  const auto found = docstrings.find(name);
  return found == docstrings.end() ? "" : found->second;
}

// The module _alltact: core and calibration for Python. Its documentation is in
// alltact/_alltact.pyi.

void bind_failure(py::module_& module) {
  static const py::handle error =
      PyErr_NewExceptionWithDoc("alltact.Error", doc_of("Error"), nullptr, nullptr);
  module.attr("Error") = error;
  py::register_exception_translator([](std::exception_ptr thrown) {
    try {
      if (thrown) std::rethrow_exception(thrown);
    } catch (const Failure& failure) {
      const py::object raised = error(failure.what());
      raised.attr("what") = failure.error().what.english();
      raised.attr("where") = failure.error().where.english();
      raised.attr("advice") = failure.error().advice.english();
      PyErr_SetObject(error.ptr(), raised.ptr());
    }
  });
}

}  // namespace alltact::python

PYBIND11_MODULE(_alltact, module) {
  using namespace alltact;
  using namespace alltact::python;
  // Decoders' own messages would mix with this program's sentences.
  cv::utils::logging::setLogLevel(cv::utils::logging::LOG_LEVEL_SILENT);
  py::options docstrings;
  docstrings.disable_function_signatures();  // the stub has them, in Python's own types
  module.attr("__version__") = program_version();
  bind_failure(module);
  bind_sources(module);
  bind_results(module);
  bind_finger(module);
  bind_simulation(module);
  bind_calibration(module);
}
