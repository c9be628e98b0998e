#include "app/console/load_library.h"
#include "app/figures/figures.h"

namespace alltact {

Result<const Figures*> load_figures() {
  static const Loaded loaded = load_function("figures", "alltact_figures");
  if (loaded.function == nullptr)
    return Error{
        en::say("the part of this program that draws cannot be loaded ({})", loaded.problem), "",
        en::say("installing AllTact Studio, which brings it")};
  return reinterpret_cast<const Figures* (*)()>(loaded.function)();
}

}  // namespace alltact
