// Distances of a plane's points, whose truth is known, over many draws of the edges' and the
// depths' noise.
#include "core/sensing/surface_measurement.h"
#include "tests/support/cameras.h"
#include "tests/support/noisy_plane_edges.h"

#include <gtest/gtest.h>

namespace alltact::test {
namespace {

constexpr double kSlope = 0.55, kEdgeNoise_px = 0.1;

FrameResult measured(const Camera& camera, double edge_noise_px, double depth_noise_mm, int seed) {
  FrameResult result;
  result.shape =
      FaceShape::fit(plane_edges(kSlope, camera, edge_noise_px, static_cast<unsigned>(seed)),
                     camera, plane_face(), 7)
          .value();
  DepthMap depth;
  depth.depth_mm.create(camera.size(), CV_32FC1);
  cv::theRNG().state = static_cast<std::uint64_t>(seed + 1);
  cv::randn(depth.depth_mm, 0.3, depth_noise_mm);
  depth.flags = cv::Mat::zeros(camera.size(), CV_8UC1);
  result.depth = std::move(depth);
  return result;
}

/// On the outer side of the plane's layer, as the header of FaceShape has it (MappingAlong::kZ).
Eigen::Vector3d true_point(const Camera& camera, cv::Point2d pixel) {
  const CameraParameters& lens = camera.parameters();
  const double x = (pixel.x - lens.cx_px) / lens.fx_px, y = (pixel.y - lens.cy_px) / lens.fy_px;
  const double z = 55.0 / (1.0 - kSlope * x);
  return {x * z, y * z, z + plane_face().layer_mm * std::hypot(1.0, kSlope) - 0.3};
}

TEST(PointDistance, IsAsSureAsItSays) {
  const Camera camera = Camera::create(pinhole()).value();
  constexpr double kDepthNoise_mm = 0.01;
  const cv::Mat sd_mm(camera.size(), CV_32FC1, cv::Scalar(kDepthNoise_mm));
  struct Pair {
    cv::Point2d from, to;
  };
  for (const Pair& pair : {Pair{{300, 240}, {600, 290}},     // far along the finger
                           Pair{{400, 200}, {400, 330}},     // across it
                           Pair{{500, 260}, {530, 262}}}) {  // near
    const double truth = (true_point(camera, pair.to) - true_point(camera, pair.from)).norm();
    double squares = 0;
    constexpr int kRuns = 60;
    for (int seed = 0; seed < kRuns; ++seed) {
      const FrameResult result = measured(camera, kEdgeNoise_px, kDepthNoise_mm, seed);
      const auto told = straight_distance(result, plane_face(), sd_mm, pair.from, pair.to);
      ASSERT_TRUE(told.ok()) << told.error().sentence();
      EXPECT_GT(told->sd, 0);
      squares += std::pow((told->value - truth) / told->sd, 2);
    }
    // Of so many draws the mean lies within 0.6 to 1.5 unless it is off; the correlation along the
    // face is a plain model, so half and twice are let pass.
    EXPECT_GT(squares / kRuns, 0.25) << pair.from << " to " << pair.to;
    EXPECT_LT(squares / kRuns, 2.25) << pair.from << " to " << pair.to;
  }
}

TEST(PointDistance, SaysWhyThereIsNone) {
  const Camera camera = Camera::create(pinhole()).value();
  const FrameResult result = measured(camera, 0, 0, 1);
  EXPECT_FALSE(straight_distance(result, plane_face(), {}, {400, 260}, {400, 2}).ok());
  EXPECT_FALSE(straight_distance(result, plane_face(), {}, {400, 260}, {400, 260}).ok());
}

}  // namespace
}  // namespace alltact::test
