// Classes and functions of the module, with the documentation of _alltact.pyi.
#pragma once

#include <string>
#include <utility>

#include <pybind11/pybind11.h>

namespace alltact::python {

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

}  // namespace alltact::python
