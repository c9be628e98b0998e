#include "app/console/load_library.h"
#include "app/pictures/pictures.h"

namespace alltact {

Result<const Pictures*> load_pictures() {
  static const Loaded loaded = load_function("pictures", "alltact_pictures");
  if (loaded.function == nullptr)
    return Error{
        en::say("the part of this program that draws cannot be loaded ({})", loaded.problem),
        "",
        en::say("installing AllTact Studio, which brings it")};
  return reinterpret_cast<const Pictures* (*)()>(loaded.function)();
}

}  // namespace alltact
