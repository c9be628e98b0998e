// NIST's Statistical Reference Datasets through the solvers that we use, against certified values.
#include "calibration/joint/ceres_solver.h"
#include "core/numerics/chebyshev.h"
#include "core/numerics/linear_algebra.h"
#include "tests/hard_cases/exact.h"

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <sstream>

#include <ceres/ceres.h>
#include <gtest/gtest.h>

namespace alltact {
namespace {

const std::filesystem::path kFolder =
    std::filesystem::path(ALLTACT_SOURCE_DIR) / "../shared/data/nist";

/// Correct digits of the worst value, at most 11: the certified ones have no more.
double digits(const Eigen::VectorXd& found, const Eigen::VectorXd& certified) {
  const double worst = ((found - certified).array() / certified.array()).abs().maxCoeff();
  return std::isfinite(worst) ? std::clamp(-std::log10(std::max(worst, 1e-300)), 0.0, 11.0) : 0.0;
}

struct Problem {
  Eigen::VectorXd start[2], certified;
  std::vector<std::vector<double>> data;  // y, x...
};

Problem read(const std::filesystem::path& file) {
  std::ifstream stream(file);
  Problem problem;
  std::vector<std::vector<double>> parameters;
  std::string line;
  for (int number = 1; std::getline(stream, line); ++number) {
    std::istringstream words(line);
    std::string name, equals;
    if (number >= 41 && number < 61) {
      std::vector<double> values(4);
      if (words >> name >> equals && name.front() == 'b' && equals == "=" &&
          words >> values[0] >> values[1] >> values[2] >> values[3])
        parameters.push_back(values);
    } else if (number >= 61) {
      std::vector<double> row;
      for (double value = 0; words >> value;) row.push_back(value);
      if (!row.empty()) problem.data.push_back(row);
    }
  }
  const auto n = static_cast<Eigen::Index>(parameters.size());
  for (Eigen::VectorXd* v : {&problem.start[0], &problem.start[1], &problem.certified})
    v->resize(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const auto& values = parameters[static_cast<std::size_t>(i)];
    problem.start[0][i] = values[0], problem.start[1][i] = values[1];
    problem.certified[i] = values[2];
  }
  return problem;
}

using Jet = ceres::Jet<double, 9>;
using Model = std::function<Jet(const std::vector<Jet>& b, const std::vector<double>& row)>;

std::map<std::string, Model> models() {
  using B = std::vector<Jet>;
  using R = std::vector<double>;
  std::map<std::string, Model> m;
  m["Bennett5"] = [](const B& b, const R& r) { return b[0] * pow(b[1] + r[1], -1.0 / b[2]); };
  m["BoxBOD"] = [](const B& b, const R& r) { return b[0] * (1.0 - exp(-b[1] * r[1])); };
  m["Chwirut1"] = m["Chwirut2"] = [](const B& b, const R& r) {
    return exp(-b[0] * r[1]) / (b[1] + b[2] * r[1]);
  };
  m["DanWood"] = [](const B& b, const R& r) { return b[0] * pow(Jet(r[1]), b[1]); };
  m["ENSO"] = [](const B& b, const R& r) {
    const double turn = 2 * M_PI * r[1];
    return b[0] + b[1] * std::cos(turn / 12) + b[2] * std::sin(turn / 12) +
           b[4] * cos(turn / b[3]) + b[5] * sin(turn / b[3]) + b[7] * cos(turn / b[6]) +
           b[8] * sin(turn / b[6]);
  };
  m["Eckerle4"] = [](const B& b, const R& r) {
    const Jet z = (r[1] - b[2]) / b[1];
    return b[0] / b[1] * exp(-0.5 * z * z);
  };
  m["Gauss1"] = m["Gauss2"] = m["Gauss3"] = [](const B& b, const R& r) {
    const Jet p = (r[1] - b[3]) / b[4], q = (r[1] - b[6]) / b[7];
    return b[0] * exp(-b[1] * r[1]) + b[2] * exp(-p * p) + b[5] * exp(-q * q);
  };
  m["Hahn1"] = m["Thurber"] = [](const B& b, const R& r) {
    const double x = r[1];
    return (b[0] + x * (b[1] + x * (b[2] + x * b[3]))) / (1.0 + x * (b[4] + x * (b[5] + x * b[6])));
  };
  m["Kirby2"] = [](const B& b, const R& r) {
    const double x = r[1];
    return (b[0] + x * (b[1] + x * b[2])) / (1.0 + x * (b[3] + x * b[4]));
  };
  m["Lanczos1"] = m["Lanczos2"] = m["Lanczos3"] = [](const B& b, const R& r) {
    return b[0] * exp(-b[1] * r[1]) + b[2] * exp(-b[3] * r[1]) + b[4] * exp(-b[5] * r[1]);
  };
  m["MGH09"] = [](const B& b, const R& r) {
    const double x = r[1];
    return b[0] * (x * x + x * b[1]) / (x * x + x * b[2] + b[3]);
  };
  m["MGH10"] = [](const B& b, const R& r) { return b[0] * exp(b[1] / (r[1] + b[2])); };
  m["MGH17"] = [](const B& b, const R& r) {
    return b[0] + b[1] * exp(-r[1] * b[3]) + b[2] * exp(-r[1] * b[4]);
  };
  m["Misra1a"] = m["BoxBOD"];
  m["Misra1b"] = [](const B& b, const R& r) {
    const Jet below = 1.0 + b[1] * r[1] / 2.0;
    return b[0] * (1.0 - 1.0 / (below * below));
  };
  m["Misra1c"] = [](const B& b, const R& r) {
    return b[0] * (1.0 - 1.0 / sqrt(1.0 + 2.0 * b[1] * r[1]));
  };
  m["Misra1d"] = [](const B& b, const R& r) { return b[0] * b[1] * r[1] / (1.0 + b[1] * r[1]); };
  m["Nelson"] = [](const B& b, const R& r) { return b[0] - b[1] * r[1] * exp(-b[2] * r[2]); };
  m["Rat42"] = [](const B& b, const R& r) { return b[0] / (1.0 + exp(b[1] - b[2] * r[1])); };
  m["Rat43"] = [](const B& b, const R& r) {
    return b[0] / pow(1.0 + exp(b[1] - b[2] * r[1]), 1.0 / b[3]);
  };
  m["Roszman1"] = [](const B& b, const R& r) {
    return b[0] - b[1] * r[1] - atan2(b[2], r[1] - b[3]) / M_PI;
  };
  return m;
}

/// Parameters in units of their start, as our own problems are scaled.
class Residuals final : public ceres::CostFunction {
 public:
  Residuals(const Problem& problem, const Model& model, Eigen::VectorXd units, bool of_logarithm)
      : problem_(problem), model_(model), units_(std::move(units)), of_logarithm_(of_logarithm) {
    set_num_residuals(static_cast<int>(problem.data.size()));
    mutable_parameter_block_sizes()->push_back(static_cast<int>(units_.size()));
  }
  bool Evaluate(double const* const* parameters, double* residuals,
                double** jacobians) const override {
    const Eigen::Index n = units_.size();
    std::vector<Jet> b;
    for (Eigen::Index k = 0; k < n; ++k)
      b.push_back(Jet(parameters[0][k], static_cast<int>(k)) * units_[k]);
    for (std::size_t i = 0; i < problem_.data.size(); ++i) {
      const auto& row = problem_.data[i];
      const Jet value = model_(b, row);
      if (!std::isfinite(value.a) || !value.v.allFinite()) return false;
      residuals[i] = value.a - (of_logarithm_ ? std::log(row[0]) : row[0]);
      if (jacobians != nullptr && jacobians[0] != nullptr)
        for (Eigen::Index k = 0; k < n; ++k)
          jacobians[0][static_cast<Eigen::Index>(i) * n + k] = value.v[k];
    }
    return true;
  }

 private:
  const Problem& problem_;
  const Model& model_;
  Eigen::VectorXd units_;
  bool of_logarithm_;
};

double solved_digits(const Problem& problem, const Model& model, const Eigen::VectorXd& start,
                     bool of_logarithm) {
  Eigen::VectorXd parameters = Eigen::VectorXd::Ones(start.size());
  ceres::Problem least_squares;
  least_squares.AddResidualBlock(new Residuals(problem, model, start, of_logarithm), nullptr,
                                 parameters.data());
  ceres::Solver::Summary summary;
  ceres::Solve(solver_settings(), &least_squares, &summary);
  return digits(parameters.cwiseProduct(start), problem.certified);
}

TEST(Nist, NonlinearProblemsFromBothStartsWithOurSettings) {
  if (!std::filesystem::exists(kFolder)) GTEST_SKIP() << "no reference problems in " << kFolder;
  int runs = 0, solved = 0;
  double sum = 0;
  for (const auto& [name, model] : models()) {
    const Problem problem = read(kFolder / (name + ".dat"));
    ASSERT_GT(problem.data.size(), 5U) << name;
    ASSERT_GE(problem.certified.size(), 2) << name;
    for (const Eigen::VectorXd& start : problem.start) {
      const double found = solved_digits(problem, model, start, name == "Nelson");
      ++runs;
      solved += found >= 4;
      sum += found;
      if (found < 4) std::printf("[ figures  ] %s: %.1f digits\n", name.c_str(), found);
    }
  }
  std::printf("[ figures  ] %d of %d solved to 4 digits, mean %.2f digits\n", solved, runs,
              sum / runs);
  EXPECT_EQ(runs, 54);
  EXPECT_GE(solved, 50);
  EXPECT_GE(sum / runs, 8.5);
}

TEST(Nist, FilipWithTheCurvesOfOurFits) {
  const auto file = kFolder / "Filip.csv";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "no reference problem " << file;
  std::ifstream stream(file);
  std::vector<double> x, y;
  std::string line;
  std::getline(stream, line);
  while (std::getline(stream, line)) {
    x.push_back(std::stod(line));
    y.push_back(std::stod(line.substr(line.find(',') + 1)));
  }
  ASSERT_EQ(x.size(), 82U);
  const Eigen::VectorXd certified = Eigen::VectorXd::Map(
      std::vector<double>{-1467.48961422980, -2772.17959193342, -2316.37108160893,
                          -1127.97394098372, -354.478233703349, -75.1242017393757,
                          -10.8753180355343, -1.06221498588947, -0.0670191154593408,
                          -0.00246781078275479, -0.0000402962525080404}
          .data(),
      11);
  const auto [low, high] = std::minmax_element(x.begin(), x.end());
  const double middle = 0.5 * (*low + *high), half = 0.5 * (*high - *low);
  Eigen::MatrixXd design(82, 11);
  Eigen::VectorXd target(82);
  for (Eigen::Index i = 0; i < 82; ++i) {
    const auto k = static_cast<std::size_t>(i);
    design.row(i) = chebyshev_row((x[k] - middle) / half, 11);
    target[i] = y[k];
  }
  const Eigen::VectorXd fit = least_squares(design, target);
  const Eigen::VectorXd found = Eigen::VectorXd::Map(exact::powers(fit, middle, half).data(), 11);
  std::printf("[ figures  ] Filip: %.1f digits of the coefficients\n", digits(found, certified));
  EXPECT_GE(digits(found, certified), 7.0);
  EXPECT_NEAR((design * fit - target).squaredNorm(), 0.795851382172941e-3, 1e-16);
}

/// Wampler's problems: 1 + x + .. + x^5 at 0..20, with `size` times values that are exactly at
/// right angles to it.
struct Wampler {
  Eigen::VectorXd x{21}, y{21}, certified = Eigen::VectorXd::Ones(6);

  explicit Wampler(double size) {
    constexpr double kDelta[] = {759,   -2048, 2048,  -2048, 2523,  -2048, 2048,
                                 -2048, 1838,  -2048, 2048,  -2048, 1838,  -2048,
                                 2048,  -2048, 2523,  -2048, 2048,  -2048, 759};
    for (int i = 0; i <= 20; ++i) {
      x[i] = i;
      y[i] = size * kDelta[i];
      for (int k = 0; k <= 5; ++k) y[i] += std::pow(i, k);
    }
  }
  /// Wampler2: powers of a tenth.
  static Wampler small() {
    Wampler two(0);
    two.y.setZero();
    for (int k = 0; k <= 5; ++k) {
      two.certified[k] = std::pow(0.1, k);
      for (int i = 0; i <= 20; ++i) two.y[i] += std::pow(i, k) / std::pow(10.0, k);
    }
    return two;
  }
};

/// Correct digits by the curves of our fits: Chebyshev columns on the data's range, then powers.
double wampler_digits(const Wampler& problem) {
  Eigen::MatrixXd design(21, 6);
  for (Eigen::Index i = 0; i < 21; ++i) design.row(i) = chebyshev_row((problem.x[i] - 10) / 10, 6);
  const Eigen::VectorXd fit = least_squares(design, problem.y);
  return digits(Eigen::VectorXd::Map(exact::powers(fit, 10, 10).data(), 6), problem.certified);
}

/// The same by normal equations in powers.
double wampler_plain_digits(const Wampler& problem) {
  Eigen::MatrixXd powers(21, 6);
  for (Eigen::Index i = 0; i < 21; ++i)
    for (int k = 0; k <= 5; ++k) powers(i, k) = std::pow(problem.x[i], k);
  return digits((powers.transpose() * powers).ldlt().solve(powers.transpose() * problem.y),
                problem.certified);
}

TEST(Nist, WamplersFiveWithTheCurvesOfOurFits) {
  struct Row {
    const char* name;
    Wampler problem;
    double least;
  };
  for (const Row& row : {Row{"Wampler1", Wampler(0), 9.0}, Row{"Wampler2", Wampler::small(), 9.0},
                         Row{"Wampler3", Wampler(1), 8.5}, Row{"Wampler4", Wampler(100), 7.5},
                         Row{"Wampler5", Wampler(10000), 5.5}}) {
    const double ours = wampler_digits(row.problem), plain = wampler_plain_digits(row.problem);
    std::printf("[ figures  ] %s: %.1f digits, by normal equations in powers %.1f\n", row.name,
                ours, plain);
    EXPECT_GE(ours, row.least) << row.name;
    EXPECT_LE(plain, ours) << row.name;  // Wampler2 is easy for both
  }
}

// Six columns that nearly depend on each other, of sizes from 80 to half a million.
TEST(Nist, LongleyWithOurLeastSquares) {
  constexpr double kData[16][7] = {{60323, 83.0, 234289, 2356, 1590, 107608, 1947},
                                   {61122, 88.5, 259426, 2325, 1456, 108632, 1948},
                                   {60171, 88.2, 258054, 3682, 1616, 109773, 1949},
                                   {61187, 89.5, 284599, 3351, 1650, 110929, 1950},
                                   {63221, 96.2, 328975, 2099, 3099, 112075, 1951},
                                   {63639, 98.1, 346999, 1932, 3594, 113270, 1952},
                                   {64989, 99.0, 365385, 1870, 3547, 115094, 1953},
                                   {63761, 100.0, 363112, 3578, 3350, 116219, 1954},
                                   {66019, 101.2, 397469, 2904, 3048, 117388, 1955},
                                   {67857, 104.6, 419180, 2822, 2857, 118734, 1956},
                                   {68169, 108.4, 442769, 2936, 2798, 120445, 1957},
                                   {66513, 110.8, 444546, 4681, 2637, 121950, 1958},
                                   {68655, 112.6, 482704, 3813, 2552, 123366, 1959},
                                   {69564, 114.2, 502601, 3931, 2514, 125368, 1960},
                                   {69331, 115.7, 518173, 4806, 2572, 127852, 1961},
                                   {70551, 116.9, 554894, 4007, 2827, 130081, 1962}};
  Eigen::MatrixXd design(16, 7);
  Eigen::VectorXd target(16);
  for (Eigen::Index i = 0; i < 16; ++i) {
    target[i] = kData[i][0];
    design(i, 0) = 1;
    for (Eigen::Index k = 1; k < 7; ++k) design(i, k) = kData[i][k];
  }
  Eigen::VectorXd certified(7);
  certified << -3482258.63459582, 15.0618722713733, -0.0358191792925910, -2.02022980381683,
      -1.03322686717359, -0.0511041056535807, 1829.15146461355;
  const Eigen::VectorXd ours = least_squares(design, target);
  const Eigen::VectorXd plain =
      (design.transpose() * design).ldlt().solve(design.transpose() * target);
  std::printf("[ figures  ] Longley: %.1f digits, by normal equations %.1f\n",
              digits(ours, certified), digits(plain, certified));
  EXPECT_GE(digits(ours, certified), 10.0);
  EXPECT_LT(digits(plain, certified), 9.0);
  EXPECT_NEAR(std::sqrt((design * ours - target).squaredNorm() / (16 - 7)), 304.854073561965, 1e-8);
}

}  // namespace
}  // namespace alltact
