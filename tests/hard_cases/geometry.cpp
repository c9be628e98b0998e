#include "core/geometry/ball.h"
#include "core/geometry/circle_fit.h"
#include "core/numerics/chebyshev.h"
#include "core/numerics/linear_algebra.h"
#include "core/sensing/face/face_edges.h"
#include "core/sensing/face/face_shape.h"
#include "tests/hard_cases/hard_cases.h"

#include <algorithm>
#include <functional>
#include <random>

#include <Eigen/Dense>

namespace alltact {
namespace {

constexpr double kFocal = 1000.0;  // px

/// Directions along part of a ball's outline, noisy in the image.
std::vector<Eigen::Vector3d> outline(const Eigen::Vector3d& centre, double radius, double arc_deg,
                                     double noise_px, std::mt19937& random) {
  const int all = 540;
  const auto horizon = ball_horizon_mm(true, centre, radius, all);
  const auto used = static_cast<std::size_t>(all * arc_deg / 360.0);
  std::normal_distribution<double> normal;
  const auto noise = [&] { return noise_px / kFocal * normal(random); };
  std::vector<Eigen::Vector3d> directions;
  for (std::size_t i = 0; i < used; ++i) {
    const Eigen::Vector3d& p = horizon[i];
    if (noise_px > 0.0)
      directions.emplace_back(p.x() / p.z() + noise(), p.y() / p.z() + noise(), 1.0);
    else
      directions.push_back(p);
  }
  return directions;
}

/// The source paper's method: a circle in the image, z from its radius, x and y from its middle.
HardAnswer circle_ball(const std::vector<Eigen::Vector3d>& directions, double radius) {
  std::vector<Eigen::Vector2d> points;
  for (const auto& d : directions) points.emplace_back(kFocal * d.head<2>() / d.z());
  const auto circle = fit_circle(points);
  if (!circle) return refused(HardRefusal::kNoCircle);
  const double z = kFocal * radius / circle->radius;
  const Eigen::Vector2d middle = z / kFocal * circle->centre;
  return {{middle.x(), middle.y(), z}};
}

/// Gauss-Newton on the distance of the centre from each ray, minus the radius, in millimetres.
double millimetre_z(const std::vector<Eigen::Vector3d>& directions, double radius,
                    Eigen::Vector3d c) {
  for (int round = 0; round < 30; ++round) {
    Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
    Eigen::Vector3d pull = Eigen::Vector3d::Zero();
    for (const auto& d : directions) {
      const Eigen::Vector3d u = d.normalized();
      const Eigen::Vector3d aside = c - u.dot(c) * u;
      const Eigen::Vector3d by = aside.normalized();
      normal += by * by.transpose();
      pull += by * (aside.norm() - radius);
    }
    c -= normal.ldlt().solve(pull);
  }
  return c.z();
}

HardAnswer ball_of(const std::vector<Eigen::Vector3d>& directions, double radius) {
  const auto found = fit_ball_to_outline(directions, radius);
  if (!found) return refused();
  return {{found->x(), found->y(), found->z()}};
}

HardRow exact_outline() {
  HardRow row{"ball from its outline, up to 42 degrees off the axis, arcs from 40 degrees",
              "a circle in the picture", "relative", 1e-12};
  std::mt19937 random(4);
  for (int theta = 0; theta <= 42; theta += 6)
    for (const double arc : {40.0, 90.0, 180.0, 360.0}) {
      const double t = theta * M_PI / 180.0;
      const Eigen::Vector3d c(40.0 * std::sin(t), 0.0, 40.0 * std::cos(t));
      const auto directions = outline(c, 3.0, arc, 0.0, random);
      row.ask({{c.x(), c.y(), c.z()}, {}, c.norm()}, circle_ball(directions, 3.0),
              ball_of(directions, 3.0));
    }
  return row;
}

/// From 90 degrees of outline, 0.5 px noise. An efficient estimate at 40 mm reaches a bias below
/// 0.05 mm and a standard deviation of 0.25 mm to 15 %.
std::vector<HardRow> noisy_outlines() {
  HardRow bias{"ball's distance from 90 degrees of outline, 0.5 px noise: bias",
               "distance to the rays in mm", "mm", 0.05, HardMeasure::kBias};
  HardRow spread{"the same: spread, against the 0.25 mm there must be",
                 "a circle through its ends and its middle", "relative", 0.15,
                 HardMeasure::kSpread};
  HardRow aside{"the same, 30 degrees off the axis: bias", "a circle in the picture", "mm", 0.05,
                HardMeasure::kBias};
  std::mt19937 random(5);
  const Eigen::Vector3d c(0.0, 0.0, 40.0);
  const Eigen::Vector3d off_axis(20.0, 0.0, 34.641016151377545);
  const auto distance = [](const HardAnswer& ball) {
    return ball.values.empty() ? ball : number(ball.values[2]);
  };
  for (int i = 0; i < 800; ++i) {
    const auto directions = outline(c, 3.0, 90.0, 0.5, random);
    const HardAnswer own = distance(ball_of(directions, 3.0));
    bias.ask(expected(c.z(), 1), number(millimetre_z(directions, 3.0, c)), own);
    const std::vector<Eigen::Vector3d> three{directions.front(), directions[directions.size() / 2],
                                             directions.back()};
    spread.ask(expected(c.z(), 0.25), distance(circle_ball(three, 3.0)), own);
    const auto seen_aside = outline(off_axis, 3.0, 90.0, 0.5, random);
    aside.ask(expected(off_axis.z(), 1), distance(circle_ball(seen_aside, 3.0)),
              distance(ball_of(seen_aside, 3.0)));
  }
  return {bias, spread, aside};
}

/// Kasa: linear least squares of x^2 + y^2 = 2 a x + 2 b y + c, of raw points.
double kasa_radius(const std::vector<Eigen::Vector2d>& points) {
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
  Eigen::Vector3d pull = Eigen::Vector3d::Zero();
  for (const auto& p : points) {
    const Eigen::Vector3d row(2.0 * p.x(), 2.0 * p.y(), 1.0);
    normal += row * row.transpose();
    pull += row * p.squaredNorm();
  }
  const Eigen::Vector3d found = normal.ldlt().solve(pull);
  return std::sqrt(found[2] + found.head<2>().squaredNorm());
}

std::vector<Eigen::Vector2d> arc(const Eigen::Vector2d& centre, double radius, double arc_deg,
                                 double noise, std::mt19937& random) {
  std::normal_distribution<double> normal;
  std::vector<Eigen::Vector2d> points;
  const int count = static_cast<int>(1.5 * arc_deg);
  for (int i = 0; i < count; ++i) {
    const double angle = arc_deg * M_PI / 180.0 * i / (count - 1);
    const Eigen::Vector2d aside(noise > 0 ? noise * normal(random) : 0.0,
                                noise > 0 ? noise * normal(random) : 0.0);
    points.emplace_back(centre + radius * Eigen::Vector2d(std::cos(angle), std::sin(angle)) +
                        aside);
  }
  return points;
}

HardAnswer radius_of(const std::optional<Circle>& circle) {
  return circle ? number(circle->radius) : refused(HardRefusal::kNoCircle);
}

HardRow short_arc() {
  HardRow row{"circle from 60 degrees of arc, 0.5 px noise: bias of its radius",
              "linear fit (Kasa)", "of its sd", 0.1, HardMeasure::kBiasInSd};
  std::mt19937 random(6);
  for (int i = 0; i < 4000; ++i) {
    const auto points = arc({0.0, 0.0}, 75.0, 60.0, 0.5, random);
    row.ask(expected(75.0), number(kasa_radius(points)), radius_of(fit_circle_taubin(points)));
  }
  return row;
}

HardRow far_circle() {
  HardRow row{"exact circle far from the origin, 40 degrees of arc", "linear fit (Kasa)",
              "relative", 1e-10};
  std::mt19937 random(7);
  const auto points = arc({20000.0, 10000.0}, 75.0, 40.0, 0.0, random);
  row.ask(expected(75.0), number(kasa_radius(points)), radius_of(fit_circle(points)));
  return row;
}

/// Points on lines in all directions, and as many on arcs so flat that they look like one.
HardRow straight_line() {
  HardRow row{
      "points on a line: circles invented; on an arc of 3 degrees: circles missed, or wrong "
      "by 1e-6",
      "linear fit (Kasa)", "part wrong", 0, HardMeasure::kWrong};
  constexpr double kArc = 3.0 * M_PI / 180.0, kRadius = 500.0;
  for (int step = 0; step < 12; ++step) {
    const double turn = M_PI * step / 12;
    const Eigen::Vector2d along(std::cos(turn), std::sin(turn));
    std::vector<Eigen::Vector2d> line, arc;
    for (int i = 0; i < 40; ++i) {
      line.emplace_back(Eigen::Vector2d(100.0, 50.0) + 0.7 * i * along);
      const double angle = turn + kArc * i / 39;
      arc.emplace_back(Eigen::Vector2d(100.0, 50.0) +
                       kRadius * Eigen::Vector2d(std::cos(angle), std::sin(angle)));
    }
    for (const auto fit : {fit_circle, fit_circle_taubin}) {
      row.ask(expected_refusal(HardRefusal::kNoCircle), number(kasa_radius(line)),
              radius_of(fit(line)));
      row.ask(expected(kRadius, 1e-6 * kRadius), number(kasa_radius(arc)), radius_of(fit(arc)));
    }
  }
  return row;
}

}  // namespace

std::vector<HardRow> hard_outlines() {
  std::vector<HardRow> all{exact_outline()};
  for (HardRow& row : noisy_outlines()) all.push_back(std::move(row));
  for (const HardRow& row : {short_arc(), far_circle(), straight_line()}) all.push_back(row);
  return all;
}

namespace {

constexpr double kFaceFocal = 1000.0, kFaceWidth = 20.0;
constexpr int kColumns = 1800, kRows = 1000;
constexpr int kDegree = 7;

struct View {
  Camera camera;
  Face face;
};

View view(double width_mm) {
  CameraParameters p;
  p.width_px = kColumns, p.height_px = kRows;
  p.fx_px = p.fy_px = kFaceFocal;
  p.cx_px = 0.5 * (kColumns - 1), p.cy_px = 0.5 * (kRows - 1);
  Face face;
  face.width_mm = width_mm;
  face.layer_mm = 1.5;
  return {Camera::create(p).value(), face};
}

/// Edges of a face `width_mm` wide.
FaceEdges edges_of(const std::function<double(double)>& z_at, double width_mm, double sd_px,
                   const std::function<double()>& error) {
  FaceEdges edges;
  for (int u = 0; u < kColumns; ++u) {
    edges.u.push_back(u);
    const double half = 0.5 * kFaceFocal * width_mm / z_at(u), middle = 0.5 * (kRows - 1);
    for (auto [edge, sign] : {std::pair{&edges.upper, -1.0}, std::pair{&edges.lower, 1.0}}) {
      edge->v.push_back(middle + sign * half + error());
      edge->sd.push_back(sd_px);
      edge->valid.push_back(1);
    }
  }
  return edges;
}

double naive_z(const FaceEdges& edges, std::size_t i) {
  return kFaceFocal * kFaceWidth / (edges.lower.v[i] - edges.upper.v[i]);
}

/// Least squares of z itself, column by column: the polynomial's values.
Eigen::VectorXd naive_fit(const FaceEdges& edges) {
  const auto n = static_cast<Eigen::Index>(edges.u.size());
  Eigen::MatrixXd design(n, kDegree + 1);
  Eigen::VectorXd z(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    design.row(i) =
        chebyshev_row(2.0 * static_cast<double>(i) / static_cast<double>(n - 1) - 1.0, kDegree + 1);
    z[i] = naive_z(edges, static_cast<std::size_t>(i));
  }
  return design * least_squares(design, z);
}

/// A shape's answer in each column.
class ShapeAnswers {
 public:
  explicit ShapeAnswers(const Result<FaceShape>& shape) : shape_(shape) {}
  [[nodiscard]] HardAnswer z_mm(std::size_t column) const {
    if (!shape_) return refused(shape_.error());
    const FaceColumn& one = shape_->columns()[column];
    return one.valid ? number(one.z_mm) : refused(HardRefusal::kNoDistance);
  }

 private:
  const Result<FaceShape>& shape_;
};

HardRow exact_width() {
  // The relative error of a width is |v| / width roundings: it is a difference of both edges. Each
  // edge adds those of its series' first coefficient, of its sum and of its change to directions.
  HardRow row{"distance from the width of the face, no noise", "single precision",
              "roundings of the width", 8};
  const View seen = view(kFaceWidth);
  const auto z_at = [](double u) {
    return 1.0 / (1.0 / 40 + (1.0 / 110 - 1.0 / 40) * u / kColumns);
  };
  const FaceEdges edges = edges_of(z_at, kFaceWidth, 0.5, [] { return 0.0; });
  const auto shape = FaceShape::fit(edges, seen.camera, seen.face, kDegree);
  for (std::size_t i = 0; i < edges.u.size(); ++i) {
    const double z = z_at(edges.u[i]);
    const double width = kFaceFocal * kFaceWidth / z;
    const double rounding = 2.220446049250313e-16 * (1.0 + edges.lower.v[i] / width);
    const float narrow =
        static_cast<float>(kFaceFocal * kFaceWidth) /
        (static_cast<float>(edges.lower.v[i]) - static_cast<float>(edges.upper.v[i]));
    row.ask(expected(z, z * rounding), number(static_cast<double>(narrow)),
            ShapeAnswers(shape).z_mm(i));
  }
  return row;
}

constexpr double kFar = 95.0;  // mm

double far_face(double /*u*/) { return kFar; }

/// The sd of z, mm, from noise of `edge_sd_px` in both edges, for a width fitted by least squares
/// over all columns with a constant and kDegree more terms.
double least_squares_sd_mm(double edge_sd_px) {
  return std::sqrt(2.0 * (kDegree + 1) / kColumns) * edge_sd_px * kFar * kFar /
         (kFaceFocal * kFaceWidth);
}

HardRow quiet_edges() {
  constexpr double kNoise = 0.5;
  constexpr int kTrials = 40;
  // Tukey's weights cost a twentieth of the variance, and the root of 40 x 8 squares is known to 4
  // %.
  HardRow row{"distance of a face 95 mm away, 0.5 px noise", "each column by itself", "mm rms",
              1.15 * least_squares_sd_mm(kNoise), HardMeasure::kRms};
  const View seen = view(kFaceWidth);
  std::mt19937 random(8);
  std::normal_distribution<double> normal;
  for (int trial = 0; trial < kTrials; ++trial) {
    const FaceEdges edges =
        edges_of(far_face, kFaceWidth, kNoise, [&] { return kNoise * normal(random); });
    const auto shape = FaceShape::fit(edges, seen.camera, seen.face, kDegree, 2.0);
    for (std::size_t i = 0; i < edges.u.size(); ++i)
      row.ask(expected(kFar, 1), number(naive_z(edges, i)), ShapeAnswers(shape).z_mm(i));
  }
  return row;
}

HardRow loud_edges() {
  HardRow row{"the same, 5 px noise: bias", "a smooth curve through z", "mm", 0.03,
              HardMeasure::kBias};
  const View seen = view(kFaceWidth);
  std::mt19937 random(19);
  std::normal_distribution<double> normal;
  for (int trial = 0; trial < 60; ++trial) {
    const FaceEdges edges =
        edges_of(far_face, kFaceWidth, 5.0, [&] { return 5.0 * normal(random); });
    const auto shape = FaceShape::fit(edges, seen.camera, seen.face, kDegree, 2.0);
    const Eigen::VectorXd naive = naive_fit(edges);
    for (std::size_t i = 0; i < edges.u.size(); ++i)
      row.ask(expected(kFar, 1), number(naive[static_cast<Eigen::Index>(i)]),
              ShapeAnswers(shape).z_mm(i));
  }
  return row;
}

/// At the ends of the face a curve is known sqrt(terms) times worse than on average.
HardRow spoiled_edges() {
  HardRow row{"the same, 0.5 px noise, 5 % of the edges wrong by 30 to 100 px", "least squares",
              "mm", 4 * std::sqrt(kDegree + 1.0) * least_squares_sd_mm(0.5)};
  row.min_answered = 0.98;
  const View seen = view(kFaceWidth);
  std::mt19937 random(20);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  for (int trial = 0; trial < 5; ++trial) {
    const FaceEdges edges = edges_of(far_face, kFaceWidth, 0.5, [&] {
      if (uniform(random) >= 0.05) return 0.5 * normal(random);
      return (uniform(random) < 0.5 ? -1.0 : 1.0) * (30.0 + 70.0 * uniform(random));
    });
    const auto shape = FaceShape::fit(edges, seen.camera, seen.face, kDegree, 2.0);
    const Eigen::VectorXd naive = naive_fit(edges);
    for (std::size_t i = 0; i < edges.u.size(); ++i)
      row.ask(expected(kFar, 1), number(naive[static_cast<Eigen::Index>(i)]),
              ShapeAnswers(shape).z_mm(i));
  }
  return row;
}

/// Faces at 60 mm so narrow that their edges nearly meet. Below 8 px 1/width has no useful mean and
/// must be refused; from there on z is required, within 5 %.
HardRow meeting_edges() {
  HardRow row{"edges that nearly meet: none told below 8 px, those from 8.5 to 12 px within 5 %",
              "f W / width", "part of columns wrong", 0, HardMeasure::kWrong};
  constexpr double kZ = 60.0, kNoise = 0.25;
  std::mt19937 random(9);
  std::normal_distribution<double> noise(0.0, kNoise);
  for (const double width_px : {2.0, 6.0, 7.0, 7.5, 8.5, 9.0, 10.0, 12.0}) {
    const double width_mm = width_px * kZ / kFaceFocal;
    const View seen = view(width_mm);
    const FaceEdges edges =
        edges_of([](double) { return kZ; }, width_mm, kNoise, [&] { return noise(random); });
    const auto shape = FaceShape::fit(edges, seen.camera, seen.face, kDegree, 2.0);
    for (std::size_t i = 0; i < edges.u.size(); ++i)
      row.ask(width_px < 8 ? expected_refusal(HardRefusal::kNoDistance) : expected(kZ, 0.05 * kZ),
              number(kFaceFocal * width_mm / (edges.lower.v[i] - edges.upper.v[i])),
              ShapeAnswers(shape).z_mm(i));
  }
  return row;
}

/// A bright face with slanting edges.
HardRow blurred_edges(double contrast, double blur_px, double grey_noise, double bound,
                      const char* what) {
  HardRow row{what, "steepest whole pixel", "px rms", bound, HardMeasure::kRms, 0.95};
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
  const auto found = FaceEdgeFinder({EdgeMethod::kCrossing, 8})(grey),
             naive = FaceEdgeFinder({EdgeMethod::kInteger, 8})(grey);
  for (double u = 3.5; u < grey.cols; u += 8)
    for (const bool is_upper : {true, false}) {
      const auto answer_of = [&](const Result<FaceEdges>& edges) {
        if (!edges) return refused(edges.error());
        const auto found_u = std::find(edges->u.begin(), edges->u.end(), u);
        const auto i = static_cast<std::size_t>(found_u - edges->u.begin());
        const Edge& edge = is_upper ? edges->upper : edges->lower;
        if (found_u == edges->u.end() || !edge.valid[i]) return refused(HardRefusal::kNoDistance);
        return number(edge.v[i]);
      };
      row.ask(expected(is_upper ? upper(u) : lower(u), 1), answer_of(naive), answer_of(found));
    }
  return row;
}

}  // namespace

std::vector<HardRow> hard_faces() {
  return {exact_width(),
          quiet_edges(),
          loud_edges(),
          spoiled_edges(),
          meeting_edges(),
          blurred_edges(100, 1.0, 1.0, 0.026, "place of an edge, contrast 100, blur 1 px, noise 1"),
          blurred_edges(20, 1.5, 2.0, 0.25, "place of an edge, contrast 20, blur 1.5 px, noise 2"),
          blurred_edges(10, 1.5, 2.0, 0.61, "place of an edge, contrast 10, blur 1.5 px, noise 2")};
}

}  // namespace alltact
