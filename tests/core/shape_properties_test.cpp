// Laws that hold whatever is measured: in other units, turned, mirrored, a wider face nearer.
#include "core/geometry/ball.h"
#include "core/geometry/circle_fit.h"
#include "core/sensing/contact/contact_regions.h"
#include "core/sensing/contact/push.h"
#include "core/sensing/depth/depth_map.h"
#include "core/sensing/face/face_shape.h"
#include "tests/support/cameras.h"

#include <cmath>
#include <cstring>
#include <random>

#include <Eigen/Geometry>
#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>
#include <rapidcheck.h>

namespace alltact {
namespace {

double between(double low, double high) {
  return low + (high - low) * *rc::gen::inRange(0, 1000001) / 1e6;
}

bool near(double a, double b, double relative) {
  return std::abs(a - b) <= relative * std::max(std::abs(a), std::abs(b));
}

// ---- a Fin Ray face from its edges

struct Curve {
  double half_px, slope, bend, middle_px, lean;
  [[nodiscard]] double half(double t) const { return half_px + slope * t + bend * t * t; }
};

Curve any_curve() {
  return {between(90, 160), between(-60, 60), between(-20, 20), between(-20, 20), between(-15, 15)};
}

FaceEdges edges_of(const Curve& curve, double wider_px = 0, bool mirror_u = false) {
  const CameraParameters lens = pinhole();
  FaceEdges edges;
  for (double u = 3.5; u < lens.width_px; u += 8.0) {
    const double t = (mirror_u ? lens.width_px - 1 - u : u) / (lens.width_px - 1) * 2 - 1;
    const double middle = lens.cy_px + curve.middle_px + curve.lean * t;
    const double half = curve.half(t) + wider_px;
    edges.u.push_back(u);
    edges.upper.v.push_back(middle - half), edges.lower.v.push_back(middle + half);
    for (Edge* edge : {&edges.upper, &edges.lower})
      edge->sd.push_back(0.05), edge->valid.push_back(1);
  }
  return edges;
}

FaceShape shape_of(const FaceEdges& edges, double width_mm = 24.0) {
  Face face;
  face.width_mm = width_mm, face.layer_mm = 1.5;
  return FaceShape::fit(edges, Camera::create(pinhole()).value(), face, 7, 1e6).value();
}

TEST(FaceLaws, AFaceKTimesAsWideIsKTimesAsFar) {
  const bool holds = rc::check("units of the face", [] {
    const FaceEdges edges = edges_of(any_curve());
    const double k = std::pow(10.0, between(-2, 2));
    const FaceShape one = shape_of(edges), other = shape_of(edges, 24.0 * k);
    for (int u = 0; u < one.width_px(); u += 60) {
      const auto a = one.at(u, 250.5), b = other.at(u, 250.5);
      RC_ASSERT(a.has_value() && b.has_value());
      RC_ASSERT((b->view_point_mm - k * a->view_point_mm).norm() < 1e-12 * b->view_point_mm.norm());
      RC_ASSERT((b->normal - a->normal).norm() < 1e-12);
      RC_ASSERT(near(other.pixel_area(u, 250.5)->on_face_mm2,
                     k * k * one.pixel_area(u, 250.5)->on_face_mm2, 1e-12));
      RC_ASSERT(near(other.length_at(u), k * one.length_at(u), 1e-12));
      const auto at = static_cast<std::size_t>(u);
      RC_ASSERT(near(other.columns()[at].z_sd_mm, k * one.columns()[at].z_sd_mm, 1e-9));
    }
  });
  EXPECT_TRUE(holds);
}

TEST(FaceLaws, AWiderPictureOfTheFaceIsNearer) {
  const bool holds = rc::check("z falls as the edges part", [] {
    const Curve curve = any_curve();
    const FaceShape far = shape_of(edges_of(curve)),
                    close = shape_of(edges_of(curve, between(0.01, 20)));
    for (std::size_t u = 0; u < far.columns().size(); ++u) {
      RC_ASSERT(far.columns()[u].valid && close.columns()[u].valid);
      RC_ASSERT(close.columns()[u].z_mm < far.columns()[u].z_mm);
    }
  });
  EXPECT_TRUE(holds);
}

TEST(FaceLaws, AMirroredPictureShowsTheMirroredFace) {
  const bool holds = rc::check("mirror", [] {
    const Curve curve = any_curve();
    Curve upside_down = curve;
    upside_down.middle_px *= -1, upside_down.lean *= -1;
    const FaceShape face = shape_of(edges_of(curve)), across = shape_of(edges_of(upside_down)),
                    along = shape_of(edges_of(curve, 0, true));
    const int last = face.width_px() - 1;
    for (int u = 0; u <= last; u += 47) {
      const double v = 240.25;
      const auto a = face.at(u, v), b = across.at(u, 539 - v), c = along.at(last - u, v);
      RC_ASSERT(a.has_value() && b.has_value() && c.has_value());
      const Eigen::Vector3d p = a->view_point_mm, n = a->normal;
      const double size = p.norm();
      RC_ASSERT((b->view_point_mm - Eigen::Vector3d(p.x(), -p.y(), p.z())).norm() < 1e-11 * size);
      RC_ASSERT((c->view_point_mm - Eigen::Vector3d(-p.x(), p.y(), p.z())).norm() < 1e-11 * size);
      RC_ASSERT((c->normal - Eigen::Vector3d(-n.x(), n.y(), n.z())).norm() < 1e-9);
    }
  });
  EXPECT_TRUE(holds);
}

// ---- a ball and a circle

TEST(BallLaws, OtherUnitsAndAnyTurnGiveTheSameBall) {
  const bool holds = rc::check("scaled and turned", [] {
    const double radius = between(1, 6), depth = between(25, 90);
    const Eigen::Vector3d centre(between(-0.5, 0.5) * depth, between(-0.3, 0.3) * depth, depth);
    auto directions = ball_horizon_mm(true, centre, radius, 200);
    directions.resize(static_cast<std::size_t>(*rc::gen::inRange(40, 201)));
    std::mt19937 random(static_cast<unsigned>(*rc::gen::inRange(0, 1 << 30)));
    std::normal_distribution<double> noise(0.0, 3e-4 * depth);
    for (Eigen::Vector3d& direction : directions)
      direction += Eigen::Vector3d(noise(random), noise(random), 0);
    const auto found = fit_ball_to_outline(directions, radius);
    RC_PRE(found.has_value());

    const double k = std::pow(10.0, between(-3, 3));
    const auto scaled = fit_ball_to_outline(directions, k * radius);
    RC_ASSERT(scaled && (*scaled - k * *found).norm() < 1e-9 * k * found->norm());

    const Eigen::AngleAxisd turn(between(-1.5, 1.5), Eigen::Vector3d::UnitZ());
    auto turned = directions, mirrored = directions;
    for (Eigen::Vector3d& direction : turned) direction = turn * direction;
    for (Eigen::Vector3d& direction : mirrored) direction.x() *= -1;
    const auto there = fit_ball_to_outline(turned, radius);
    RC_ASSERT(there && (*there - turn * *found).norm() < 1e-8 * found->norm());
    const auto other = fit_ball_to_outline(mirrored, radius);
    RC_ASSERT(other && (*other - Eigen::Vector3d(-found->x(), found->y(), found->z())).norm() <
                           1e-8 * found->norm());
  });
  EXPECT_TRUE(holds);
}

TEST(CircleLaws, OtherUnitsPlacesAndTurnsGiveTheSameCircle) {
  const bool holds = rc::check("scaled, moved and turned", [] {
    std::mt19937 random(static_cast<unsigned>(*rc::gen::inRange(0, 1 << 30)));
    std::normal_distribution<double> noise(0.0, 0.3);
    const double arc = between(1, 6.2);
    std::vector<Eigen::Vector2d> points, others;
    const double k = std::pow(10.0, between(-3, 3));
    const Eigen::Rotation2Dd turn(between(-3, 3));
    const Eigen::Vector2d shift(between(-1000, 1000), between(-1000, 1000));
    for (int i = 0; i < 60; ++i) {
      const double angle = arc * i / 59;
      points.emplace_back(50 * std::cos(angle) + noise(random),
                          50 * std::sin(angle) + noise(random));
      others.push_back(k * (turn * points.back() + shift));
    }
    const auto one = fit_circle(points), other = fit_circle(others);
    RC_ASSERT(one && other);
    RC_ASSERT(near(other->radius, k * one->radius, 1e-8));
    RC_ASSERT((other->centre - k * (turn * one->centre + shift)).norm() < 1e-7 * k * 1000);
    RC_ASSERT(near(other->rms, k * one->rms, 1e-6));
  });
  EXPECT_TRUE(holds);
}

// ---- brightness and contacts on a flat sensor

constexpr int kSide = 128;

FaceShape flat_shape(double mm_per_px = 0.05) {
  CameraParameters p;
  p.model = CameraModel::kOrthographic;
  p.width_px = p.height_px = kSide;
  p.cx_px = p.cy_px = 0.5 * (kSide - 1);
  p.mm_per_px = mm_per_px;
  Face face;
  face.kind = FaceKind::kFlat;
  face.layer_mm = 1.5;
  face.plane_z_mm = 20.0;
  return FaceShape::plane(Camera::create(p).value(), face);
}

struct Pictures {
  cv::Mat live, untouched;
};

Pictures any_pictures() {
  cv::RNG random(static_cast<std::uint64_t>(*rc::gen::inRange(1, 1 << 30)));
  Pictures images{cv::Mat(kSide, kSide, CV_8UC1), cv::Mat(kSide, kSide, CV_8UC1)};
  random.fill(images.live, cv::RNG::UNIFORM, 0, 256);
  random.fill(images.untouched, cv::RNG::UNIFORM, 0, 256);
  images.untouched.convertTo(images.untouched, CV_32F);
  return images;
}

Difference compared(const Pictures& images, const FaceShape& shape, double smoothing_px) {
  Reference reference;
  reference.image = ReferenceImage(images.untouched);
  return difference(images.live, reference, shape, {.smoothing = smoothing_of(smoothing_px)});
}

bool same_bytes(const cv::Mat& a, const cv::Mat& b) {
  const cv::Mat x = a.clone(), y = b.clone();
  return x.size() == y.size() && x.type() == y.type() &&
         std::memcmp(x.data, y.data, x.total() * x.elemSize()) == 0;
}

TEST(BrightnessLaws, AMirroredPictureIsTheMirroredMeasurementToTheByte) {
  const FaceShape shape = flat_shape();
  const bool holds = rc::check("mirrored pictures", [&] {
    const Pictures images = any_pictures();
    const double smoothing = *rc::gen::element(0.0, 1.0, 2.0);
    const Difference one = compared(images, shape, smoothing);
    for (const int how : {0, 1, -1}) {
      Pictures mirrored;
      cv::flip(images.live, mirrored.live, how);
      cv::flip(images.untouched, mirrored.untouched, how);
      const Difference other = compared(mirrored, shape, smoothing);
      cv::Mat x, flags;
      cv::flip(one.x, x, how);
      cv::flip(one.flags, flags, how);
      RC_ASSERT(same_bytes(other.flags, flags));
      RC_ASSERT(same_bytes(other.x, x));
    }
  });
  EXPECT_TRUE(holds);
}

TEST(BrightnessLaws, ATurnedPictureIsTheTurnedMeasurement) {
  const FaceShape shape = flat_shape();
  const bool holds = rc::check("pictures turned by 90 degrees", [&] {
    const Pictures images = any_pictures();
    const double smoothing = *rc::gen::element(0.0, 1.0);
    const Difference one = compared(images, shape, smoothing);
    Pictures turned;
    cv::rotate(images.live, turned.live, cv::ROTATE_90_CLOCKWISE);
    cv::rotate(images.untouched, turned.untouched, cv::ROTATE_90_CLOCKWISE);
    const Difference other = compared(turned, shape, smoothing);
    cv::Mat x, flags;
    cv::rotate(one.x, x, cv::ROTATE_90_CLOCKWISE);
    cv::rotate(one.flags, flags, cv::ROTATE_90_CLOCKWISE);
    RC_ASSERT(same_bytes(other.flags, flags));
    for (int v = 0; v < kSide; ++v)
      for (int u = 0; u < kSide; ++u) {
        const float a = x.at<float>(v, u), b = other.x.at<float>(v, u);
        RC_ASSERT(std::isnan(a) == std::isnan(b));
        // Rows are smoothed before columns, in steps of a part of a grey level.
        RC_ASSERT(std::isnan(a) || std::abs(a - b) <= 0.02F * (1.0F + std::abs(a)));
      }
  });
  EXPECT_TRUE(holds);
}

/// An oblong contact somewhere near the middle.
cv::Mat any_contact() {
  const double angle = between(-1.5, 1.5), u0 = between(55, 72), v0 = between(55, 72);
  const double along = between(25, 40), across = between(10, 15);
  cv::Mat depth(kSide, kSide, CV_32FC1, cv::Scalar(0));
  for (int v = 0; v < kSide; ++v)
    for (int u = 0; u < kSide; ++u) {
      const double a = (std::cos(angle) * (u - u0) + std::sin(angle) * (v - v0)) / along;
      const double b = (-std::sin(angle) * (u - u0) + std::cos(angle) * (v - v0)) / across;
      depth.at<float>(v, u) = static_cast<float>(std::max(0.0, 1.0 - a * a - b * b));
    }
  return depth;
}

ContactRegion region_of(const cv::Mat& depth_mm, const FaceShape& shape) {
  DepthMap map;
  map.depth_mm = depth_mm;
  map.flags = cv::Mat(depth_mm.size(), CV_8UC1, cv::Scalar(kMeasured));
  map.cells_mm = depth_cells(depth_mm);
  const auto regions =
      contact_regions(map, shape, shape.face(), {.minimum_area_mm2 = 1e-9, .untouched = {}});
  RC_ASSERT(regions.size() == 1U);
  RC_ASSERT(regions[0].angle_deg.has_value());
  return regions[0];
}

/// Axes have no direction: 89 and -91 degrees are one.
double axis_difference(double a_deg, double b_deg) {
  return std::abs(std::remainder(a_deg - b_deg, 180.0));
}

TEST(ContactLaws, TurnedAndMirroredContactsHaveTurnedAndMirroredAxes) {
  const FaceShape shape = flat_shape();
  const bool holds = rc::check("turned and mirrored contacts", [&] {
    const cv::Mat depth = any_contact();
    const ContactRegion one = region_of(depth, shape);
    cv::Mat turned, mirrored;
    cv::rotate(depth, turned, cv::ROTATE_90_CLOCKWISE);
    cv::flip(depth, mirrored, 0);
    const ContactRegion quarter = region_of(turned, shape), mirror = region_of(mirrored, shape);
    for (const ContactRegion& other : {quarter, mirror}) {
      RC_ASSERT(near(other.volume_mm3, one.volume_mm3, 1e-12));
      RC_ASSERT(near(other.area_mm2, one.area_mm2, 1e-12));
      RC_ASSERT(other.deepest_mm == one.deepest_mm);
    }
    RC_ASSERT(axis_difference(*quarter.angle_deg, *one.angle_deg + 90.0) < 1e-3);
    RC_ASSERT(axis_difference(*mirror.angle_deg, -*one.angle_deg) < 1e-3);
    RC_ASSERT(std::abs(quarter.position_px.x() - (kSide - 1 - one.position_px.y())) < 1e-6);
    RC_ASSERT(std::abs(quarter.position_px.y() - one.position_px.x()) < 1e-6);
  });
  EXPECT_TRUE(holds);
}

TEST(ContactLaws, ACoarserPictureOfALargerWorldIsTheSameContact) {
  const bool holds = rc::check("units of a contact", [&] {
    const cv::Mat depth = any_contact();
    const double k = std::pow(10.0, between(-1, 1));
    const ContactRegion one = region_of(depth, flat_shape()),
                        other = region_of(depth, flat_shape(0.05 * k));
    RC_ASSERT(near(other.area_mm2, k * k * one.area_mm2, 1e-12));
    RC_ASSERT(near(other.volume_mm3, k * k * one.volume_mm3, 1e-12));
    RC_ASSERT(axis_difference(*other.angle_deg, *one.angle_deg) < 1e-9);
    RC_ASSERT((other.position_mm - k * one.position_mm).head<2>().norm() < 1e-10 * k);
  });
  EXPECT_TRUE(holds);
}

// ---- touch

TEST(TouchLaws, ATurnedOffsetIsATurnedDirectionAndUnitsDoNotMatter) {
  const bool holds = rc::check("turned and scaled offsets", [] {
    ContactSettings settings, turned_settings, scaled_settings;
    Markers markers, turned_markers, scaled_markers;
    const double angle = between(-3, 3), k = std::pow(10.0, between(-2, 2));
    const Eigen::Rotation2Dd turn(angle);
    const Eigen::Vector2d push(between(0.5, 3), between(-3, 3));
    settings.threshold_px = turned_settings.threshold_px = 1e-3;
    scaled_settings.threshold_px = 1e-3 * k;
    for (int m = 0; m < 12; ++m) {
      const Eigen::Vector2d rest(between(0, 900), between(0, 500));
      const Eigen::Vector2d now = rest + push + Eigen::Vector2d(between(-1, 1), between(-1, 1));
      const Eigen::Vector2d there = turn * now;
      const double sd = between(0.01, 0.3);
      settings.rest_markers.push_back(rest), markers.push_back({now.x(), now.y(), true, sd});
      turned_settings.rest_markers.emplace_back(turn * rest);
      turned_markers.push_back({there.x(), there.y(), true, sd});
      scaled_settings.rest_markers.emplace_back(k * rest);
      scaled_markers.push_back({k * now.x(), k * now.y(), true, k * sd});
    }
    const Push one = push_of(markers, settings, true);
    RC_PRE(one.direction && one.offset_px.norm() > 1.0);
    const Push turned = push_of(turned_markers, turned_settings, true);
    const Push scaled = push_of(scaled_markers, scaled_settings, true);
    RC_ASSERT(turned.direction && scaled.direction);
    RC_ASSERT((turned.direction->head<2>() - turn * one.direction->head<2>()).norm() < 1e-10);
    RC_ASSERT((*scaled.direction - *one.direction).norm() < 1e-10);
    RC_ASSERT(near(*turned.sd_deg, *one.sd_deg, 1e-10));
    RC_ASSERT(near(*scaled.sd_deg, *one.sd_deg, 1e-10));
  });
  EXPECT_TRUE(holds);
}

}  // namespace
}  // namespace alltact
