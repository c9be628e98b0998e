// Default degree of the face's edges along the finger.
#pragma once

namespace alltact {

/// Degree of the Chebyshev polynomials of FaceShape::fit; default of --profile-degree. A static
/// assertion in pipeline_settings.cpp holds both equal.
inline constexpr int kDefaultProfileDegree = 7;

}  // namespace alltact
