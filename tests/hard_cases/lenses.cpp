#include "calibration/lens/calibrate_lens.h"
#include "core/camera/camera.h"
#include "tests/hard_cases/hard_cases.h"

#include <random>

#include <Eigen/Geometry>

namespace alltact {
namespace {

/// Brown's formula, as in the textbook: the distorted position of the direction x.
Eigen::Vector2d brown(const std::vector<double>& k, const Eigen::Vector2d& x) {
  const auto at = [&](std::size_t i) { return i < k.size() ? k[i] : 0.0; };
  const double r2 = x.squaredNorm(), xy = x.x() * x.y();
  const double factor = 1 + r2 * (at(0) + r2 * (at(1) + r2 * at(4)));
  return factor * x + Eigen::Vector2d(2 * at(2) * xy + at(3) * (r2 + 2 * x.x() * x.x()),
                                      at(2) * (r2 + 2 * x.y() * x.y()) + 2 * at(3) * xy);
}

/// Five steps of x = (seen - tangential part) / radial factor.
Eigen::Vector2d fixed_point(const std::vector<double>& k, const Eigen::Vector2d& seen) {
  std::vector<double> radial = k;
  for (std::size_t i = 2; i < std::min<std::size_t>(4, radial.size()); ++i) radial[i] = 0;
  Eigen::Vector2d x = seen;
  for (int i = 0; i < 5; ++i) {
    const double length = x.norm();
    const double factor = length > 0 ? brown(radial, x).norm() / length : 1.0;
    x = (seen - (brown(k, x) - brown(radial, x))) / factor;
  }
  return x;
}

CameraParameters full_hd(const std::vector<double>& distortion, double focal_px) {
  CameraParameters p;
  p.model = CameraModel::kBrown;
  p.width_px = 1920, p.height_px = 1080;
  p.cx_px = 959.5, p.cy_px = 539.5;
  p.fx_px = p.fy_px = focal_px;
  p.distortion = distortion;
  return p;
}

/// Directions up to the corner of a Full HD image, 85 degrees wide, recovered from their pixels.
HardRow undistorting(const std::vector<double>& distortion, const char* what) {
  HardRow row{what, "fixed-point steps, 5 of them", "px", 1e-9};
  // The ray 46.4 degrees off the axis is seen in the corner.
  constexpr double kCorner = 1.0513;
  const CameraParameters p = full_hd(distortion, 1101.5 / brown(distortion, {kCorner, 0.0}).x());
  const auto camera = Camera::create(p);
  constexpr int kRings = 40, kDirections = 72;
  for (int ring = 0; ring <= kRings; ++ring)
    for (int azimuth = 0; azimuth < (ring == 0 ? 1 : kDirections); ++azimuth) {
      const double angle = 2 * M_PI * azimuth / kDirections, radius = kCorner * ring / kRings;
      const Eigen::Vector2d truth(radius * std::cos(angle), radius * std::sin(angle));
      const Eigen::Vector2d seen = brown(distortion, truth);
      const Eigen::Vector2d pixel(p.cx_px + p.fx_px * seen.x(), p.cy_px + p.fy_px * seen.y());
      if (pixel.minCoeff() < 0 || pixel.x() > p.width_px - 1 || pixel.y() > p.height_px - 1)
        continue;
      const auto ray = camera ? camera->unproject(pixel) : std::nullopt;
      const Eigen::Vector2d naive = fixed_point(distortion, seen);
      HardAnswer own = refused();
      if (ray) {
        const Eigen::Vector2d found = ray->direction.head<2>() / ray->direction.z();
        own = {{found.x(), found.y()}};
      }
      row.ask({{truth.x(), truth.y()}, {}, 1 / p.fx_px}, {{naive.x(), naive.y()}}, own);
    }
  return row;
}

/// Lenses that fold over inside the image, and lenses that do not.
HardRow fold() {
  HardRow row{"where lenses show a direction; refused by name where they fold over in the picture",
              "no look at the fold", "part wrong", 0, HardMeasure::kWrong};
  constexpr double kFocal = 1047.7;
  const Eigen::Vector2d x(0.6, 0.35);
  for (const std::vector<double>& k : std::vector<std::vector<double>>{
           {-0.32}, {-0.5}, {0.1, -0.4}, {-0.1, 0.02}, {0.1}, {-0.2, 0.1, 0.001, -0.002}}) {
    // 1 + 3 k1 r^2 + 5 k2 r^4, the slope of the radius seen, must not vanish for a ray seen in the
    // corner, 1101.5 px from the middle.
    bool folds = true;
    for (double r = 0; r < 2 && folds; r += 1e-4) {
      const double k2 = k.size() > 1 ? k[1] : 0;
      if (1 + 3 * k[0] * r * r + 5 * k2 * std::pow(r, 4) <= 0) break;
      folds = kFocal * r * (1 + k[0] * r * r + k2 * std::pow(r, 4)) < 1101.5;
    }
    const Eigen::Vector2d seen = brown(k, x);
    const std::vector<double> pixel{959.5 + kFocal * seen.x(), 539.5 + kFocal * seen.y()};
    const auto camera = Camera::create(full_hd(k, kFocal));
    HardAnswer own = camera ? refused() : refused(camera.error());
    if (const auto found = camera ? camera->project({x.x(), x.y(), 1.0}) : std::nullopt)
      own = {{found->x(), found->y()}};
    row.ask(folds ? expected_refusal(HardRefusal::kFoldedLens) : HardQuestion{pixel, {}, 1e-9},
            {pixel}, own);
  }
  return row;
}

/// A lens and boards of 9 x 7 corners at random positions in front of it, seen with 0.2 px of
/// noise.
struct SeenBoards {
  CameraParameters lens;
  std::vector<BoardView> views;
  std::vector<BoardPose> poses;
};

SeenBoards seen_boards(std::size_t count, double tilt_deg, std::mt19937& random) {
  constexpr double kSquareMm = 2.5, kNoisePx = 0.2;
  SeenBoards seen;
  seen.lens.model = CameraModel::kBrown;
  seen.lens.width_px = 640, seen.lens.height_px = 480;
  seen.lens.fx_px = 521.4, seen.lens.fy_px = 522.9;
  seen.lens.cx_px = 325.3, seen.lens.cy_px = 236.8;
  seen.lens.distortion = {-0.21, 0.07, 0.0008, -0.0005, -0.008};
  const Camera camera = Camera::create(seen.lens).value();
  std::uniform_real_distribution<double> unit(-1, 1);
  std::normal_distribution<double> noise(0, kNoisePx);
  while (seen.views.size() < count) {
    const double azimuth = M_PI * unit(random);
    const double tilt = tilt_deg * M_PI / 180 * std::sqrt(std::abs(unit(random)));
    BoardPose pose;
    pose.turn = tilt * Eigen::Vector3d(std::cos(azimuth), std::sin(azimuth), 0);
    const double z = 35 * (1 + 0.15 * unit(random));
    pose.shift_mm = Eigen::Vector3d(0.25 * z * unit(random), 0.2 * z * unit(random), z) -
                    pose.rotation() * Eigen::Vector3d(4 * kSquareMm, 3 * kSquareMm, 0);
    BoardView view;
    view.name = "view " + std::to_string(seen.views.size());
    view.edge_px = 1.5;
    bool is_visible = true;
    for (int i = 0; i < 63; ++i) {
      const int row = i / 9, column = i % 9;
      view.board_mm.emplace_back(kSquareMm * column, kSquareMm * row, 0.0);
      const auto pixel = camera.project(pose(view.board_mm.back()));
      is_visible &= pixel && pixel->minCoeff() >= 0 && pixel->x() <= seen.lens.width_px - 1 &&
                    pixel->y() <= seen.lens.height_px - 1;
      const Eigen::Vector2d error(noise(random), noise(random));
      view.pixels.emplace_back(pixel.value_or(Eigen::Vector2d::Zero()) + error);
    }
    if (!is_visible) continue;
    seen.views.push_back(std::move(view));
    seen.poses.push_back(pose);
  }
  return seen;
}

/// Corners fit to a quarter of a pixel however poorly the boards determine the lens: the reported
/// error must be true.
HardRow few_boards() {
  HardRow row{
      "focal length from 3 boards tilted by up to 15 degrees: its squared error over what "
      "is said of it, against 1",
      "residual of the corners over half the picture", "of 1", 0.15, HardMeasure::kSdAccuracy};
  std::mt19937 random(15);
  constexpr int kTrials = 400;
  for (int trial = 0; trial < kTrials; ++trial) {
    const SeenBoards seen = seen_boards(3, 15, random);
    LensFit start;
    start.lens = seen.lens;
    start.poses = seen.poses;
    const auto fit = fit_lens(seen.views, start, kAllCoefficients, Job{});
    // An infinite uncertainty makes no false statement.
    const HardQuestion question = expected(seen.lens.fx_px);
    if (!fit) {
      row.ask(question, refused(fit.error()), refused(fit.error()));
      continue;
    }
    const double focal_px = fit->lens.fx_px;
    row.ask(question, {{focal_px, fit->sigma_px / 320 * seen.lens.fx_px}},
            {{focal_px, fit->sd(0)}});
  }
  return row;
}

/// Boards held straight give the focal length to a tenth at best and must be refused. Ten boards
/// tilted by up to 35 degrees give it to 0.14 %, 0.08 mm at 60 mm (one standard deviation).
HardRow frontal_boards() {
  HardRow row{
      "lenses from 3 to 6 boards held nearly straight: let pass; from 10 tilted ones: not "
      "let pass, or wrong by 0.4 mm at 60 mm",
      "residual of the corners below 0.3 px", "part wrong", 0, HardMeasure::kWrong};
  std::mt19937 random(16);
  for (std::size_t trial = 0; trial < 20; ++trial) {
    const bool is_straight = trial < 12;
    const SeenBoards seen =
        is_straight ? seen_boards(3 + trial % 4, 2, random) : seen_boards(10, 35, random);
    LensSettings settings;
    settings.distance_mm = 60;
    const auto found =
        calibrate_lens(seen.views, {seen.lens.width_px, seen.lens.height_px}, settings, Job{});
    const HardQuestion question = is_straight ? expected_refusal(HardRefusal::kUnprovenLens)
                                              : expected(settings.distance_mm, 5 * 0.08);
    if (!found) {
      row.ask(question, refused(found.error()), refused(found.error()));
      continue;
    }
    const HardAnswer value = number(settings.distance_mm * found->fit.lens.fx_px / seen.lens.fx_px);
    const Grade grade = found->verdict.grade;
    row.ask(question, found->fit.sigma_px < 0.3 ? value : refused(),
            grade == Grade::kGood || grade == Grade::kUsable ? value
                                                             : refused(HardRefusal::kUnprovenLens));
  }
  return row;
}

}  // namespace

std::vector<HardRow> hard_lenses() {
  return {undistorting({-0.3, 0.1}, "undistorting, k = -0.3, 0.1"),
          undistorting({-0.35, 0.12, 0.0, 0.0, -0.02}, "undistorting, k = -0.35, 0.12, -0.02"),
          undistorting({0.3, 0.1}, "undistorting, k = 0.3, 0.1"),
          undistorting({-0.3, 0.1, 0.002, -0.003}, "undistorting, with tangential parts"),
          fold(),
          few_boards(),
          frontal_boards()};
}

}  // namespace alltact
