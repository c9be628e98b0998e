#include "core/image/grey_range.h"
#include "core/sensing/contact/contact_regions.h"
#include "core/sensing/contact/push.h"
#include "core/sensing/depth/depth_map.h"
#include "core/sensing/markers/marker_model.h"
#include "core/sensing/markers/markers.h"
#include "core/sensing/reference/recorded_poses.h"
#include "tests/hard_cases/hard_cases.h"

#include <functional>
#include <random>

#include <Eigen/Dense>

namespace alltact {
namespace {

HardAnswer answer_at(const Difference& difference, int v, int u) {
  switch (difference.flags.at<std::uint8_t>(v, u)) {
    case kMeasured:
      return number(static_cast<double>(difference.x.at<float>(v, u)));
    case kTooDark:
      return refused(HardRefusal::kTooDark);
    case kSaturated:
      return refused(HardRefusal::kSaturated);
    default:
      return refused();
  }
}

/// Pairs of grey levels. A number is required where the face has 12 to 249 levels and the live
/// image is not clipped, else the reason. Live pixels below three noise deviations, and faces of 8
/// to 11 levels, are not tested.
HardRow grey_pairs() {
  HardRow row{"brightness differences of all pairs of grey levels: wrong ones",
              "bytes subtracted and divided", "part wrong", 0, HardMeasure::kWrong};
  constexpr int kDark = 12, kLeastLive = 3;
  cv::Mat live(256, 256, CV_8UC1), untouched(256, 256, CV_32FC1);
  for (int i = 0; i < 256; ++i)
    for (int k = 0; k < 256; ++k)
      live.at<std::uint8_t>(i, k) = static_cast<std::uint8_t>(i),
                               untouched.at<float>(i, k) = static_cast<float>(k);
  Reference reference;
  reference.image = ReferenceImage(untouched);
  const FaceShape shape = flat_sensor({256, 256}, 0.05);
  const Difference own = difference(live, reference, shape, {.smoothing = {}});
  for (int i = kLeastLive; i < 256; ++i)
    for (int k = 0; k < 256; ++k) {
      if (k >= kTooDarkBelow && k < kDark) continue;
      const double truth = static_cast<double>(k - i) / std::max(k, 1);
      const auto wrapped = static_cast<std::uint8_t>(k - i);
      row.ask(k < kTooDarkBelow ? expected_refusal(HardRefusal::kTooDark)
              : k >= kClippedFrom || i >= kClippedFrom
                  ? expected_refusal(HardRefusal::kSaturated)
                  : expected(truth, 1e-6 * (1.0 + std::abs(truth))),
              number(static_cast<double>(wrapped) / k), answer_at(own, i, k));
    }
  return row;
}

/// A press that takes a fifth of the brightness, on faces from 12 to 40 grey levels, 1 grey level
/// of noise in both images: the mean of the quotient is not the quotient of the means.
HardRow dark_reference() {
  HardRow row{"mean difference where the untouched face has 12 to 40 grey levels, truth 0.2: error",
              "(I_ref - I) / I_ref of each pixel", "of x", 0.0015};
  constexpr double kTruth = 0.2, kNoise = 1.0;
  constexpr int kSide = 512, kLeast = 12, kMost = 40;
  const FaceShape shape = flat_sensor({kSide, kSide}, 0.05);
  std::mt19937 random(17);
  std::normal_distribution<double> noise(0.0, kNoise);
  for (int level = kLeast; level <= kMost; level += 4) {
    cv::Mat live(kSide, kSide, CV_8UC1), untouched(kSide, kSide, CV_32FC1);
    double naive = 0;
    for (int v = 0; v < kSide; ++v)
      for (int u = 0; u < kSide; ++u) {
        const double below = std::round(level + noise(random));
        live.at<std::uint8_t>(v, u) =
            cv::saturate_cast<std::uint8_t>((1.0 - kTruth) * level + noise(random));
        untouched.at<float>(v, u) = static_cast<float>(std::max(0.0, below));
        naive += (below - live.at<std::uint8_t>(v, u)) / below / (kSide * kSide);
      }
    Reference reference;
    reference.image = ReferenceImage(untouched);
    const Difference own = difference(live, reference, shape, {});
    const cv::Mat measured = own.flags == kMeasured;
    const bool enough = cv::countNonZero(measured) > 0.99 * kSide * kSide;
    row.ask(expected(kTruth, 1), number(naive),
            enough ? number(cv::mean(own.x, measured)[0]) : refused(HardRefusal::kTooDark));
  }
  return row;
}

/// Brightness that follows three modes of the pose, smoothly.
double brightness_at(const Eigen::Vector3d& pose) {
  const Eigen::Vector3d m = pose / 60.0;
  return 100.0 + 25.0 * m[0] - 12.0 * m[1] + 8.0 * m[2] + 6.0 * m[0] * m[0] - 4.0 * m[0] * m[1];
}

HardRow reference_brightness() {
  HardRow row{"brightness of a pose between 1650 recorded ones", "nearest frame", "relative, rms",
              0.0008, HardMeasure::kRms};
  std::mt19937 random(11);
  std::uniform_real_distribution<double> coordinate(-60.0, 60.0);
  constexpr int kRecorded = 1650, kNear = 12;
  std::vector<Eigen::Vector3d> poses;
  for (int i = 0; i < kRecorded; ++i)
    poses.emplace_back(coordinate(random), coordinate(random), coordinate(random));
  for (int i = 0; i < 300; ++i) {
    const Eigen::Vector3d query =
        0.9 * Eigen::Vector3d(coordinate(random), coordinate(random), coordinate(random));
    std::partial_sort(poses.begin(), poses.begin() + kNear, poses.end(),
                      [&](const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
                        return (a - query).squaredNorm() < (b - query).squaredNorm();
                      });
    Eigen::MatrixXd points(kNear, 3);
    for (int k = 0; k < kNear; ++k) points.row(k) = poses[static_cast<std::size_t>(k)].transpose();
    const Eigen::VectorXd weights = local_linear_weights(points, query, 0.5, 3.0);
    double mixed = 0;
    for (int k = 0; k < kNear; ++k)
      mixed += weights[k] * brightness_at(poses[static_cast<std::size_t>(k)]);
    row.ask(expected(brightness_at(query)), number(brightness_at(poses.front())), number(mixed));
  }
  return row;
}

}  // namespace

std::vector<HardRow> hard_brightness() {
  return {grey_pairs(), dark_reference(), reference_brightness()};
}

namespace {

/// Answer on the angle of the only region.
HardAnswer angle_of(const std::vector<ContactRegion>& regions) {
  if (regions.size() != 1) return refused();
  return number_or(regions[0].angle_deg, HardRefusal::kNoAngle);
}

DepthMap untouched_map(const cv::Size& size) {
  DepthMap map;
  map.depth_mm = cv::Mat(size, CV_32FC1, cv::Scalar(0));
  map.flags = cv::Mat(size, CV_8UC1, cv::Scalar(kMeasured));
  return map;
}

/// A long contact at the far end of a very wide image.
HardRow far_contact() {
  HardRow row{"angle of a contact 16000 px from the origin", "E[x^2] - E[x]^2 in single precision",
              "degrees", 0.5};
  constexpr int kWidth = 16384, kHeight = 64;
  const FaceShape shape = flat_sensor({kWidth, kHeight}, 0.05);
  for (const double angle : {-50.0, -5.0, 30.0}) {
    const double c = std::cos(angle * M_PI / 180.0), s = std::sin(angle * M_PI / 180.0);
    DepthMap map = untouched_map({kWidth, kHeight});
    float n = 0, su = 0, sv = 0, suu = 0, suv = 0, svv = 0;
    for (int v = 0; v < kHeight; ++v)
      for (int u = 16000; u < 16200; ++u) {
        const double du = u - 16100.0, dv = v - 31.5;
        const double along = (c * du + s * dv) / 32.0, across = (-s * du + c * dv) / 16.0;
        const double depth = 1.0 - along * along - across * across;
        if (!(depth > 0.2)) continue;
        const auto d = static_cast<float>(depth), x = static_cast<float>(u),
                   y = static_cast<float>(v);
        map.depth_mm.at<float>(v, u) = d;
        n += d, su += d * x, sv += d * y, suu += d * x * x, suv += d * x * y, svv += d * y * y;
      }
    map.cells_mm = depth_cells(map.depth_mm);
    const float xx = suu / n - su / n * (su / n), xy = suv / n - su / n * (sv / n),
                yy = svv / n - sv / n * (sv / n);
    const double naive = 0.5 * std::atan2(2.0 * static_cast<double>(xy),
                                          static_cast<double>(xx) - static_cast<double>(yy));
    row.ask(expected(angle, 1), number(naive * 180.0 / M_PI),
            angle_of(contact_regions(map, shape, shape.face(), {})));
  }
  return row;
}

/// A contact over an entire wide image, with a depth small against the noise.
HardRow wide_contact() {
  HardRow row{"volume of a contact of 4 million pixels", "summed in single precision", "relative",
              1e-6};
  constexpr int kSide = 2048;
  constexpr double kMmPerPx = 0.01;
  const FaceShape shape = flat_sensor({kSide, kSide}, kMmPerPx);
  constexpr float kDepth = 0.3F;
  DepthMap map = untouched_map({kSide, kSide});
  map.depth_mm.setTo(static_cast<double>(kDepth));
  map.cells_mm = depth_cells(map.depth_mm);
  const auto regions = contact_regions(map, shape, shape.face(), {});
  const auto area = static_cast<float>(kMmPerPx * kMmPerPx);
  float sum = 0;
  for (int i = 0; i < kSide * kSide; ++i) sum += kDepth * area;
  row.ask(expected(static_cast<double>(kDepth) * std::pow(kSide * kMmPerPx, 2)),
          number(static_cast<double>(sum)),
          regions.size() == 1 ? number(regions[0].volume_mm3) : refused());
  return row;
}

/// A ball's contact is round: noise alone gives it an axis. Each is paired with a contact 1.5 times
/// as long as wide, which has an axis.
HardRow round_contact() {
  HardRow row{"angles told of 20 round contacts, and of 20 long ones not or wrong by 5 degrees",
              "principal axes", "part wrong", 0, HardMeasure::kWrong};
  constexpr int kSide = 96;
  constexpr double kNoise = 0.01;
  const FaceShape shape = flat_sensor({kSide, kSide}, 0.05);
  std::mt19937 random(18);
  std::normal_distribution<double> noise(0.0, kNoise);
  for (int trial = 0; trial < 40; ++trial) {
    const bool is_round = trial % 2 == 0;
    const int direction = trial / 2;
    const double angle = -80.0 + 8.0 * direction;
    const Eigen::Vector2d axis(std::cos(angle * M_PI / 180), std::sin(angle * M_PI / 180));
    DepthMap map = untouched_map({kSide, kSide});
    double sum = 0;
    Eigen::Vector2d first = Eigen::Vector2d::Zero();
    Eigen::Matrix2d second = Eigen::Matrix2d::Zero();
    for (int v = 0; v < kSide; ++v)
      for (int u = 0; u < kSide; ++u) {
        const Eigen::Vector2d off(u - 47.5, v - 47.5);
        const double along = off.dot(axis) / (is_round ? 30.0 : 36.0);
        const double across = (off.x() * axis.y() - off.y() * axis.x()) / (is_round ? 30.0 : 24.0);
        const double depth = 1.0 - along * along - across * across + noise(random);
        map.depth_mm.at<float>(v, u) = static_cast<float>(std::max(0.0, depth));
        if (depth < 0.1) continue;
        sum += depth, first += depth * off, second += depth * off * off.transpose();
      }
    map.cells_mm = depth_cells(map.depth_mm);
    const Eigen::Matrix2d spread = second / sum - first / sum * (first / sum).transpose();
    const double naive = 0.5 * std::atan2(2 * spread(0, 1), spread(0, 0) - spread(1, 1));
    row.ask(
        is_round ? expected_refusal(HardRefusal::kNoAngle) : expected(angle, 5),
        number(naive * 180 / M_PI),
        angle_of(contact_regions(map, shape, shape.face(), {.noise_mm = kNoise, .untouched = {}})));
  }
  return row;
}

/// Spread of a marker far from the origin through a recording. This program adds the minimum
/// variance of a recording, (0.05 px)^2: 0.0005 of the total.
HardRow marker_spread() {
  HardRow row{"spread of markers 4000 px from the origin through 2000 frames",
              "running sums of u and u^2 in single precision", "relative", 1e-3};
  constexpr int kFrames = 2001;
  Eigen::MatrixXd layouts(kFrames, 8);
  float sum = 0, squares = 0;
  double truth = 0;
  for (int i = 0; i < kFrames; ++i) {
    // Eight positions in step, from -1 to 1 px.
    const double moved = (i - 1000) / 1024.0;
    truth += 8 * moved * moved / (kFrames - 1);
    for (int k = 0; k < 8; ++k) layouts(i, k) = 4000.0 + 64.0 * k + moved;
    const auto u = static_cast<float>(layouts(i, 0));
    sum += u, squares += u * u;
  }
  std::vector<Dot> typical(4);
  for (std::size_t m = 0; m < 4; ++m) typical[m].upper = m < 2;
  const auto model = MarkerModel::learn(layouts, typical);
  const float n = kFrames;
  const auto variance = static_cast<double>((squares - sum * sum / n) / (n - 1));
  row.ask(expected(std::sqrt(truth)), number(std::sqrt(8 * variance)),
          model ? number(model->mode_sd_px()[0]) : refused(model.error()));
  return row;
}

/// Markers exactly at rest, which have no direction, and moved by a pixel each, which have one.
HardRow no_direction() {
  HardRow row{"direction of a touch that is none, and of pushes in 24 directions", "o / |o|",
              "part wrong", 0, HardMeasure::kWrong};
  ContactSettings settings;
  settings.threshold_px = 0.0;
  for (int m = 0; m < 24; ++m)
    settings.rest_markers.emplace_back(50.0 + 30.0 * (m % 12), m < 12 ? 60.0 : 300.0);
  for (int step = 0; step <= 24; ++step) {
    const double angle = 2 * M_PI * step / 24;
    const Eigen::Vector2d push =
        step == 24 ? Eigen::Vector2d(0, 0) : Eigen::Vector2d(std::cos(angle), std::sin(angle));
    Markers markers;
    Eigen::Vector2d offset(0, 0);
    for (const Eigen::Vector2d& rest : settings.rest_markers) {
      markers.push_back({rest.x() + push.x(), rest.y() + push.y(), true, 0.1});
      offset += push;
    }
    const Push found = push_of(markers, settings, true);
    const HardAnswer own = found.direction
                               ? HardAnswer{{found.direction->x(), found.direction->y()}}
                               : refused(HardRefusal::kNoContact);
    const Eigen::Vector2d naive = offset / offset.norm();
    row.ask(step == 24 ? expected_refusal(HardRefusal::kNoContact)
                       : HardQuestion{{push.x(), push.y()}, {}, 1e-9},
            {{naive.x(), naive.y()}}, own);
  }
  return row;
}

constexpr int kPerRow = 12;

/// Two rows of markers on a finger that bends, sways and twists.
Eigen::VectorXd layout(double bend, double sway, double twist) {
  Eigen::VectorXd coordinates(4 * kPerRow);
  for (int m = 0; m < 2 * kPerRow; ++m) {
    const double t = (m % kPerRow + 1.0) / kPerRow;
    const bool upper = m < kPerRow;
    const double half = 200.0 - 120.0 * t;
    coordinates[2 * m] = 60.0 + 820.0 * t - 90.0 * t * t - bend * (25.0 + 60.0 * t * t);
    coordinates[2 * m + 1] = 270.0 + (upper ? -half : half) * (1.0 + 0.1 * bend) +
                             40.0 * sway * t * t + (upper ? 12.0 : -12.0) * twist * t;
  }
  return coordinates;
}

Dot dot_of(const Eigen::VectorXd& coordinates, int m, const std::function<double()>& noise) {
  Dot dot;
  dot.u = coordinates[2 * m] + noise(), dot.v = coordinates[2 * m + 1] + noise();
  dot.radius_px = 5, dot.contrast = 60, dot.sd_px = 0.05, dot.upper = m < kPerRow;
  return dot;
}

/// The marker positions that the model computes from dots, and those of the n-th dot of a row taken
/// for the n-th marker. Returned are the positions of the markers `of`, in their order.
HardAnswer modelled(const MarkerModel& model, const std::vector<Dot>& dots,
                    const std::vector<int>& of) {
  const auto markers = model.number(dots);
  if (!markers) return refused();
  HardAnswer answer;
  for (const int m : of) {
    const Marker& marker = (*markers)[static_cast<std::size_t>(m)];
    if (!marker.seen) return refused();
    answer.values.insert(answer.values.end(), {marker.u, marker.v});
  }
  return answer;
}
HardAnswer sorted(std::vector<Dot> dots, const std::vector<int>& of) {
  std::sort(dots.begin(), dots.end(), [](const Dot& a, const Dot& b) { return a.u < b.u; });
  std::vector<Dot> rows[2];
  for (const Dot& dot : dots) rows[dot.upper ? 0 : 1].push_back(dot);
  HardAnswer answer;
  for (const int m : of) {
    const auto& row = rows[m / kPerRow];
    const auto slot = static_cast<std::size_t>(m % kPerRow);
    const bool is_there = slot < row.size();
    answer.values.push_back(is_there ? row[slot].u : NAN);
    answer.values.push_back(is_there ? row[slot].v : NAN);
  }
  return answer;
}

/// Six of 24 markers hidden, the others in any order: each dot must be assigned to its marker.
HardRow hidden_markers() {
  HardRow row{"numbers of markers, 6 of 24 hidden: frames with a dot not used, or 3 px off",
              "sorted along the picture", "part of frames", 0.001, HardMeasure::kWrong};
  std::mt19937 random(12);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  std::normal_distribution<double> normal(0.0, 0.05);
  const auto noise = [&] { return normal(random); };
  Eigen::MatrixXd recorded(300, 4 * kPerRow);
  for (Eigen::Index i = 0; i < recorded.rows(); ++i) {
    recorded.row(i) = layout(uniform(random), uniform(random), uniform(random)).transpose();
    for (Eigen::Index k = 0; k < recorded.cols(); ++k) recorded(i, k) += noise();
  }
  std::vector<Dot> typical;
  for (int m = 0; m < 2 * kPerRow; ++m) typical.push_back(dot_of(layout(0, 0, 0), m, noise));
  const auto model = MarkerModel::learn(recorded, typical);
  for (int frame = 0; frame < 1000; ++frame) {
    const Eigen::VectorXd truth = layout(uniform(random), uniform(random), uniform(random));
    std::vector<int> order(2 * kPerRow);
    for (int m = 0; m < 2 * kPerRow; ++m) order[static_cast<std::size_t>(m)] = m;
    std::shuffle(order.begin(), order.end(), random);
    order.resize(18);
    std::vector<Dot> dots;
    HardQuestion question;
    // An error is 3 px at the farthest of 18 dots, or 0.7 px at all.
    question.scale = 3;
    for (const int m : order) {
      dots.push_back(dot_of(truth, m, noise));
      question.truth.insert(question.truth.end(), {truth[2 * m], truth[2 * m + 1]});
    }
    row.ask(question, sorted(dots, order),
            model ? modelled(*model, dots, order) : refused(model.error()));
  }
  return row;
}

}  // namespace

std::vector<HardRow> hard_contacts() {
  return {far_contact(),  round_contact(),  wide_contact(),
          no_direction(), hidden_markers(), marker_spread()};
}

}  // namespace alltact
