#include "core/simulation/mechanics/shore.h"

namespace alltact {

Result<double> modulus_from_shore_a(double shore_a) {
  if (!(shore_a >= kSoftestShoreA && shore_a <= kHardestShoreA))
    return Error{en::say("a hardness of {:g} Shore A has no known modulus", shore_a),
                 "",
                 en::say("{:g} to {:g}", kSoftestShoreA, kHardestShoreA)};
  return 0.0981 * (56 + 7.66 * shore_a) / (0.137505 * (254 - 2.54 * shore_a));
}

}  // namespace alltact
