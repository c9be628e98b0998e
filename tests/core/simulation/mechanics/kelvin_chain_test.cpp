#include "core/simulation/mechanics/rubber.h"
#include "tests/core/simulation/effects/effect_scene.h"

namespace alltact {
namespace {

using Deflection = Eigen::Vector4d;

// One step, and the deflection after it.
Deflection stepped(KelvinChain::History& history, double step_s, const Deflection& elastic) {
  const Deflection q = history.before(step_s) + history.weight(step_s) * elastic;
  history.step(step_s, elastic);
  return q;
}

TEST(KelvinChain, FollowsTheCreepComplianceOfASteadyLoad) {
  Parameters random(6);
  const Deflection load(1, -2, 0.5, 0.1);
  for (int i = 0; i < 20; ++i) {
    const double instant = i % 2, a = random.between(0.1, 2), b = random.between(0.1, 2);
    const double fast = random.between(0.05, 1), slow = random.between(2, 50);
    const KelvinChain chain(instant, {{a, fast}, {b, slow}});
    KelvinChain::History history(chain);
    EXPECT_NEAR((stepped(history, 0, load) - instant * load).norm(), 0, 1e-15);
    double t = 0;
    for (int k = 0; k < 40; ++k) {
      const double step = random.between(0.001, 1);
      t += step;
      const double j = instant + a * (1 - std::exp(-t / fast)) + b * (1 - std::exp(-t / slow));
      EXPECT_NEAR((stepped(history, step, load) - j * load).norm(), 0, 1e-12);
      EXPECT_NEAR(chain.compliance(t), j, 1e-13);
    }
    EXPECT_NEAR((stepped(history, 1e4, load) - (instant + a + b) * load).norm(), 0, 0.02);
    EXPECT_NEAR(chain.compliance(1e9), instant + a + b, 1e-12);
    EXPECT_EQ(chain.compliance(0), instant);
  }
}

// time q' + q = share X(t), by Heun's method in long double, for an X of straight pieces.
TEST(KelvinChain, ObeysTheUnitsOwnLawForAnyLoad) {
  Parameters random(7);
  for (const double time : {0.03, 0.7, 400.0}) {
    const KelvinChain chain(1, {{0.8, time}});
    KelvinChain::History history(chain);
    stepped(history, 0, Deflection::Zero());
    long double late = 0;
    double from = 0;
    for (int k = 0; k < 20; ++k) {
      const double to = random.between(-3, 3), step = random.between(0.01, 0.2);
      const int n = 4000;
      const long double h = static_cast<long double>(step) / n;
      for (int i = 0; i < n; ++i) {
        const auto rate = [&](long double q, int at) {
          return (0.8L * (from + (to - from) * static_cast<long double>(at) / n) - q) / time;
        };
        const long double first = rate(late, i);
        late += h / 2 * (first + rate(late + h * first, i + 1));
      }
      const Deflection q = stepped(history, step, Deflection(to, 0, 0, 0));
      EXPECT_NEAR(q[0], to + static_cast<double>(late), 1e-6);
      from = to;
    }
  }
}

// A load of straight pieces may be cut into steps anywhere.
TEST(KelvinChain, DoesNotDependOnTheSteps) {
  const KelvinChain chain(0, {{1, 0.2}, {0.3, 5}});
  const auto load = [](double t) { return Deflection(t, 1 - t, 2 * t, 0); };
  KelvinChain::History whole(chain), cut(chain);
  stepped(whole, 0, load(0)), stepped(cut, 0, load(0));
  const Deflection at_once = stepped(whole, 1.7, load(1.7));
  Deflection bit_by_bit;
  for (int i = 1; i <= 1700; ++i) bit_by_bit = stepped(cut, 0.001, load(0.001 * i));
  EXPECT_NEAR((at_once - bit_by_bit).norm(), 0, 1e-11);
  EXPECT_FALSE(KelvinChain().has_memory());
  EXPECT_TRUE(chain.has_memory());
}

}  // namespace
}  // namespace alltact
