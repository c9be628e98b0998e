// The degree of the face's edges along the finger, where nobody chose another.
#pragma once

namespace alltact {

/// Chebyshev polynomials of FaceShape::fit; the default of --profile-degree, which a static
/// assertion in pipeline_settings.cpp holds to it.
inline constexpr int kUsualProfileDegree = 7;

}  // namespace alltact
