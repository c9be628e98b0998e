#include "calibration/hard_cases/groups.h"
#include "core/numerics/chebyshev.h"
#include "core/sensing/face_edges.h"
#include "core/sensing/face_shape.h"

#include <functional>
#include <random>

#include <Eigen/Dense>

namespace alltact {
namespace {

constexpr double kFocal = 1000.0, kFaceWidth = 20.0;
constexpr int kColumns = 1800, kRows = 1000;
constexpr int kDegree = 7;

struct View {
  Camera camera;
  Face face;
};

View view() {
  CameraParameters p;
  p.width_px = kColumns, p.height_px = kRows;
  p.fx_px = p.fy_px = kFocal;
  p.cx_px = 0.5 * (kColumns - 1), p.cy_px = 0.5 * (kRows - 1);
  Face face;
  face.width_mm = kFaceWidth;
  face.layer_mm = 1.5;
  return {Camera::create(p).value(), face};
}

/// Edges of a flat face that recedes: 1/z is linear along the picture.
FaceEdges edges_of(const std::function<double(double)>& z_at,
                   double sd_px,
                   const std::function<double()>& error) {
  FaceEdges edges;
  for (int u = 0; u < kColumns; ++u) {
    edges.u.push_back(u);
    const double half = 0.5 * kFocal * kFaceWidth / z_at(u), middle = 0.5 * (kRows - 1);
    for (auto [edge, sign] : {std::pair{&edges.upper, -1.0}, std::pair{&edges.lower, 1.0}}) {
      edge->v.push_back(middle + sign * half + error());
      edge->sd.push_back(sd_px);
      edge->valid.push_back(1);
    }
  }
  return edges;
}

double plain_z(const FaceEdges& edges, std::size_t i) {
  return kFocal * kFaceWidth / (edges.lower.v[i] - edges.upper.v[i]);
}

/// Least squares of z itself, column by column: the polynomial's values.
Eigen::VectorXd plain_fit(const FaceEdges& edges) {
  const auto n = static_cast<Eigen::Index>(edges.u.size());
  Eigen::MatrixXd design(n, kDegree + 1);
  Eigen::VectorXd z(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    design.row(i) =
        chebyshev_row(2.0 * static_cast<double>(i) / static_cast<double>(n - 1) - 1.0, kDegree + 1);
    z[i] = plain_z(edges, static_cast<std::size_t>(i));
  }
  return design * design.householderQr().solve(z);
}

HardCase exact_width() {
  // A width is worth no more than what it is the difference of: |v| / width roundings.
  HardCase one{"distance from the width of the face, no noise",
               "single precision",
               "roundings of the width",
               0,
               0,
               4};
  const View seen = view();
  const auto z_at = [](double u) {
    return 1.0 / (1.0 / 40 + (1.0 / 110 - 1.0 / 40) * u / kColumns);
  };
  const FaceEdges edges = edges_of(z_at, 0.5, [] { return 0.0; });
  const auto shape = FaceShape::fit(edges, seen.camera, seen.face, kDegree);
  for (std::size_t i = 0; i < edges.u.size(); ++i) {
    const double z = z_at(edges.u[i]);
    const double width = kFocal * kFaceWidth / z;
    const double rounding = 2.220446049250313e-16 * (1.0 + edges.lower.v[i] / width);
    keep_worst(shape ? std::abs(shape->columns()[i].z_mm - z) / z / rounding : NAN, one.our_error);
    const float narrow =
        static_cast<float>(kFocal * kFaceWidth) /
        (static_cast<float>(edges.lower.v[i]) - static_cast<float>(edges.upper.v[i]));
    keep_worst(std::abs(static_cast<double>(narrow) - z) / z / rounding, one.plain_error);
  }
  return one;
}

/// A face 95 mm away whose edges are noisy.
std::vector<HardCase> noisy_edges() {
  HardCase rms{
      "distance of a face 95 mm away, 0.5 px noise", "each column by itself", "mm", 0, 0, 0.03};
  HardCase bias{"the same, 5 px noise: bias", "a smooth curve through z", "mm", 0, 0, 0.03};
  HardCase gross{"the same, 0.5 px noise, 5 % of the edges wrong by 30 to 100 px",
                 "least squares",
                 "mm",
                 0,
                 0,
                 0.11};
  const View seen = view();
  const auto z_at = [](double) { return 95.0; };
  std::mt19937 random(8);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  const auto fitted = [&](const FaceEdges& edges) {
    return FaceShape::fit(edges, seen.camera, seen.face, kDegree, 2.0);
  };

  constexpr int kQuiet = 10;
  for (int trial = 0; trial < kQuiet; ++trial) {
    const FaceEdges quiet = edges_of(z_at, 0.5, [&] { return 0.5 * normal(random); });
    const auto shape = fitted(quiet);
    for (std::size_t i = 0; i < quiet.u.size(); ++i) {
      const double z = shape ? shape->columns()[i].z_mm : NAN;
      rms.plain_error += std::pow(plain_z(quiet, i) - 95.0, 2) / (kQuiet * kColumns);
      rms.our_error += std::pow(z - 95.0, 2) / (kQuiet * kColumns);
    }
  }
  rms.plain_error = std::sqrt(rms.plain_error);
  rms.our_error = std::sqrt(rms.our_error);

  constexpr int kTrials = 60;
  double ours = 0, plain = 0;
  for (int trial = 0; trial < kTrials; ++trial) {
    const FaceEdges loud = edges_of(z_at, 5.0, [&] { return 5.0 * normal(random); });
    const auto loud_shape = fitted(loud);
    plain += (plain_fit(loud).mean() - 95.0) / kTrials;
    double mean = 0;
    for (const FaceColumn& column : loud_shape ? loud_shape->columns() : std::vector<FaceColumn>{})
      mean += (column.z_mm - 95.0) / kColumns;
    ours += (loud_shape ? mean : NAN) / kTrials;
  }
  bias.our_error = std::abs(ours);
  bias.plain_error = std::abs(plain);

  for (int trial = 0; trial < 5; ++trial) {
    const FaceEdges spoiled = edges_of(z_at, 0.5, [&] {
      if (uniform(random) >= 0.05) return 0.5 * normal(random);
      return (uniform(random) < 0.5 ? -1.0 : 1.0) * (30.0 + 70.0 * uniform(random));
    });
    const auto spoiled_shape = fitted(spoiled);
    const Eigen::VectorXd z = plain_fit(spoiled);
    int told = 0;
    for (Eigen::Index i = 0; i < z.size(); ++i) {
      keep_worst(std::abs(z[i] - 95.0), gross.plain_error);
      if (!spoiled_shape) continue;
      const FaceColumn& column = spoiled_shape->columns()[static_cast<std::size_t>(i)];
      if (!column.valid) continue;
      ++told;
      keep_worst(std::abs(column.z_mm - 95.0), gross.our_error);
    }
    if (told < 0.98 * kColumns) keep_worst(NAN, gross.our_error);
  }
  return {rms, bias, gross};
}

/// Edges 2 px apart, noisy by half a pixel: 1/width has no mean worth the name.
HardCase meeting_edges() {
  HardCase one{"edges that nearly meet, 2 px apart: distances told that are wrong by more than 5 %",
               "f W / width",
               "part of columns",
               0,
               0,
               0};
  const View seen = view();
  const double z = kFocal * kFaceWidth / 2.0;
  std::mt19937 random(9);
  std::normal_distribution<double> noise(0.0, 0.5);
  const FaceEdges edges = edges_of([&](double) { return z; }, 0.5, [&] { return noise(random); });
  const auto shape = FaceShape::fit(edges, seen.camera, seen.face, kDegree);
  for (std::size_t i = 0; i < edges.u.size(); ++i) {
    const auto wrong = [&](double told) { return !(std::abs(told / z - 1.0) < 0.05); };
    one.plain_error += wrong(plain_z(edges, i)) / static_cast<double>(kColumns);
    if (shape && shape->columns()[i].valid)
      one.our_error += wrong(shape->columns()[i].z_mm) / static_cast<double>(kColumns);
  }
  return one;
}

/// A bright face with slanting edges.
HardCase blurred_edges(
    double contrast, double blur_px, double grey_noise, double bound, const char* what) {
  HardCase one{what, "steepest whole pixel", "px rms", 0, 0, bound};
  std::mt19937 random(10);
  std::normal_distribution<double> noise;
  const auto upper = [](double u) { return 150.3 + 0.07 * u; };
  const auto lower = [](double u) { return 400.6 - 0.05 * u; };
  cv::Mat grey(540, 960, CV_8UC1);
  for (int v = 0; v < grey.rows; ++v)
    for (int u = 0; u < grey.cols; ++u) {
      const auto step = [&](double d) {
        return 0.5 * (1.0 + std::erf(d / std::sqrt(2.0) / blur_px));
      };
      const double level =
          30.0 + contrast * step(v - upper(u)) * step(lower(u) - v) + grey_noise * noise(random);
      grey.at<std::uint8_t>(v, u) = cv::saturate_cast<std::uint8_t>(level);
    }
  const auto rms = [&](EdgeMethod method) {
    const auto edges = FaceEdgeFinder({method, 8})(grey);
    if (!edges) return std::numeric_limits<double>::infinity();
    double sum = 0;
    int count = 0;
    for (std::size_t i = 0; i < edges->u.size(); ++i)
      for (const auto& [edge, truth] : {std::pair{&edges->upper, upper(edges->u[i])},
                                        std::pair{&edges->lower, lower(edges->u[i])}})
        if (edge->valid[i]) sum += std::pow(edge->v[i] - truth, 2), ++count;
    // What is told of few columns shows nothing.
    return count > 0.95 * 2 * static_cast<double>(edges->u.size())
               ? std::sqrt(sum / count)
               : std::numeric_limits<double>::infinity();
  };
  one.our_error = rms(EdgeMethod::kCrossing);
  one.plain_error = rms(EdgeMethod::kInteger);
  return one;
}

}  // namespace

std::vector<HardCase> hard_faces() {
  std::vector<HardCase> all{exact_width()};
  for (HardCase& one : noisy_edges()) all.push_back(std::move(one));
  all.push_back(meeting_edges());
  all.push_back(
      blurred_edges(100, 1.0, 1.0, 0.03, "place of an edge, contrast 100, blur 1 px, noise 1"));
  all.push_back(
      blurred_edges(20, 1.5, 2.0, 0.25, "place of an edge, contrast 20, blur 1.5 px, noise 2"));
  all.push_back(
      blurred_edges(10, 1.5, 2.0, 0.4, "place of an edge, contrast 10, blur 1.5 px, noise 2"));
  return all;
}

}  // namespace alltact
