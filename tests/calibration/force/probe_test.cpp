#include "calibration/force/train_force.h"
#include "tests/calibration/force/force_worlds.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
namespace alltact {
namespace {
TEST(Probe, Beams) {
  const int blocks = std::getenv("BLOCKS") ? std::atoi(std::getenv("BLOCKS")) : 20;
  Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(4, 2);
  double worst = 0;
  const int n = std::getenv("N") ? std::atoi(std::getenv("N")) : 6;
  for (int seed = 0; seed < n; ++seed) {
    made::BeamFinger finger(static_cast<std::uint64_t>(100 + seed));
    const ForceTable table = finger.rows(blocks, 40);
    ForceTraining o;
    o.comparison_only = true;
    o.network.members = 1;
    if (std::getenv("STEPS")) o.network.steps = std::atoi(std::getenv("STEPS"));
    auto t = train_force(table, finger.rest(), o, Job());
    fmt::print("{} ", to_string(t->model.kind));
    for (auto& c : t->comparison) {
      fmt::print(" {} {:.3f} {:.3f}", to_string(c.kind), c.mae_N[0], c.mae_N[1]);
      sum.row(static_cast<int>(c.kind) - 1) += c.mae_N.transpose() / n;
    }
    fmt::print("\n");
    finger.noise_N = 0;
    const ForceTable fresh = finger.rows(10, 40);
    const auto inputs = force_inputs(fresh, finger.rest());
    Eigen::Vector2d e(0, 0);
    for (std::size_t i = 0; i < inputs.size(); ++i) {
      auto f = t->model(inputs[i]);
      e += (f->force_N.head(2) - fresh.force_N.row(static_cast<long>(i)).transpose()).cwiseAbs() /
           static_cast<double>(inputs.size());
    }
    fmt::print("   fresh {:.4f} {:.4f}\n", e[0], e[1]);
    worst = std::max(worst, e.maxCoeff());
  }
  std::cout << sum << "\nworst " << worst << "\n";
}
}  // namespace
}  // namespace alltact
