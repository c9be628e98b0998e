#include "calibration/joint/stored_curve.h"

namespace alltact {

MappingParameters mapping_parameters(const MappingCurve& curve,
                                     MappingAlong along,
                                     const PressedArea& part) {
  MappingParameters parameters;
  const MappingCurve stored = stored_form(curve).curve;
  parameters.kind = stored.family().kind;
  parameters.along = along;
  parameters.x_max = stored.x_max();
  if (stored.family().kind == MappingKind::kMoebius) {
    parameters.a_mm = stored.values()[0];
    parameters.b = stored.values()[1];
  } else {
    const auto numbers = stored.values().head(stored.family().coefficients);
    parameters.chebyshev.assign(numbers.begin(), numbers.end());
  }
  if (stored.family().varies)
    parameters.variation = {stored.values().tail<2>(), part.middle_mm, part.half_mm};
  return parameters;
}

bool increases(const MappingCurve& curve, MappingAlong along) {
  return Mapping::create(mapping_parameters(curve, along)).ok();
}

}  // namespace alltact
