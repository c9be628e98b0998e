#include "core/numerics/chebyshev.h"

#include <cmath>
#include <random>
#include <vector>

#include <boost/multiprecision/cpp_dec_float.hpp>
#include <gtest/gtest.h>

namespace alltact {
namespace {

using Exact = boost::multiprecision::cpp_dec_float_50;

// T_k(t) = cos(k acos t), in 50 digits.
double exactly(const Eigen::VectorXd& c, double t) {
  Exact sum = 0;
  const Exact angle = boost::multiprecision::acos(Exact(t));
  for (Eigen::Index k = 0; k < c.size(); ++k)
    sum += Exact(c[k]) * boost::multiprecision::cos(Exact(k) * angle);
  return static_cast<double>(sum);
}

TEST(Chebyshev, ValuesInVectorsAreThoseOneByOneAndTrueInFiftyDigits) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> coefficient(-5.0, 5.0);
  for (int count = 0; count <= 12; ++count) {
    Eigen::VectorXd c(count);
    for (double& value : c) value = coefficient(random);
    constexpr int kPlaces = 201;  // no multiple of a vector
    const double first = -1.0, step = 2.0 / (kPlaces - 1);
    std::vector<double> values(kPlaces, NAN);
    chebyshev_values(c, first, step, kPlaces, values.data());
    for (int i = 0; i < kPlaces; ++i) {
      const double t = first + static_cast<double>(i) * step;
      const double value = values[static_cast<std::size_t>(i)];
      EXPECT_EQ(value, chebyshev_value(c, t)) << count << ' ' << t;
      if (std::abs(t) <= 1.0 && i % 10 == 0) {
        EXPECT_NEAR(value, exactly(c, t), 1e-13 * (1.0 + c.lpNorm<1>())) << count << ' ' << t;
      }
    }
  }
}

}  // namespace
}  // namespace alltact
