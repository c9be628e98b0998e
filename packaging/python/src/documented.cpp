#include "packaging/python/src/documented.h"

#include <map>
#include <string_view>

namespace alltact::python {

const char* doc_of(const std::string& name) {
  static const std::map<std::string_view, const char*> docstrings = {
#include "docstrings.inc"
  };
  const auto found = docstrings.find(name);
  return found == docstrings.end() ? "" : found->second;
}

}  // namespace alltact::python
