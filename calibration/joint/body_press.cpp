#include "calibration/joint/body_press.h"

#include "calibration/joint/body_pose.h"
#include "calibration/joint/pressed_part.h"
#include "core/mesh/mesh_distance.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include <Eigen/Dense>
#include <opencv2/imgproc.hpp>

namespace alltact {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;

constexpr int kMaxSamples = 6000;       // of the pressed skin and what is around it
constexpr double kRoughSamples = 6000;  // of the entire face
constexpr double kAroundMm = 1;
constexpr double kPressedPart = 0.35;  // of the greatest depth: skin that helps to find the pose
// Likewise: skin that rests on the body. It leaves a ball at half of the ball's depth on a half
// space (Hertz), and balls are read from 0.58 of it on (kInnerZone).
constexpr double kRestingPart = 0.6;
constexpr std::size_t kRead = 2000;  // samples are enough to read the factor
constexpr std::size_t kFewest = 60;
constexpr double kEdgeMm = 0.4;  // next to an edge the skin leaves the body
const double kEdgeCosine = std::cos(30 * M_PI / 180);
constexpr double kSteepest = 0.7;    // cosine of the body's slope against the face
constexpr double kOpenPart = 0.05;   // of the factor's effect that no pose imitates
constexpr double kUnevenPart = 0.3;  // of what the skin does not follow: as for steps
constexpr double kFormSdMm =
    0.003;  // of skin on a body, as of the rings of balls (uncertainty.cpp)

SkinLine skin_line(const Sample& sample, MappingAlong along) {
  if (along == MappingAlong::kNormal) return {sample.untouched_n, sample.normal};
  const double scale = along == MappingAlong::kProjected ? 1 / sample.cos_incline : 1.0;
  return {sample.untouched_z, scale * Vector3d::UnitZ()};
}

std::vector<SkinPoint> skin_of(const PressSamples& press, const MappingCurve& curve,
                               const double* values, MappingAlong along,
                               std::vector<Eigen::VectorXd>* gradients = nullptr) {
  std::vector<SkinPoint> skin;
  Eigen::VectorXd gradient(curve.family().numbers());
  const CurveAt at = curve.at(values);
  for (const Sample& sample : press.samples) {
    const double depth_mm = at.depth_mm(sample.x, sample.unit_position, gradient.data());
    skin.push_back({skin_line(sample, along), depth_mm});
    if (gradients != nullptr) gradients->push_back(gradient);
  }
  return skin;
}

/// Retains the largest connected part of what is pressed in. `depth_of`: or the brightness.
template <class DepthOf>
void select_pressed(PressSamples& press, const DepthOf& depth_of) {
  double deepest = 0;
  for (const Sample& sample : press.samples) deepest = std::max(deepest, depth_of(sample));
  const cv::Mat mask = largest_part(
      press, [&](const Sample& sample) { return depth_of(sample) > kPressedPart * deepest; }, 8);
  std::erase_if(press.samples, [&](const Sample& sample) {
    return mask.at<std::uint8_t>(cell_of(sample, press.block_px)) == 0;
  });
}

/// The body's surface under a point of the skin. nullopt: it has an edge within kEdgeMm, or is
/// steep against the face.
std::optional<BodyPatch> patch_under(const MeshDistance& shape, const Isometry3d& pose,
                                     const Vector3d& point, const Vector3d& normal) {
  const Isometry3d body_from_camera = pose.inverse(Eigen::Isometry);
  const Vector3d in_body = body_from_camera * point;
  const auto here = shape(in_body);
  if (here.outwards.dot(body_from_camera.linear() * -normal) < kSteepest) return std::nullopt;
  BodyPatch patch{here.point, here.outwards, Eigen::Matrix3d::Zero()};
  const Vector3d first = here.outwards.unitOrthogonal(), second = here.outwards.cross(first);
  for (const Vector3d& aside : {first, second}) {
    const Vector3d before = shape(here.point - kEdgeMm * aside).outwards,
                   behind = shape(here.point + kEdgeMm * aside).outwards;
    if (std::min(before.dot(here.outwards), behind.dot(here.outwards)) < kEdgeCosine)
      return std::nullopt;
    patch.bend += (behind - before) / (2 * kEdgeMm) * aside.transpose();
  }
  patch.bend = (0.5 * (patch.bend + patch.bend.transpose())).eval();
  return patch;
}

/// As blur_mm() of contact_model.h, with the body's depth by differences over the image.
double blur_of(const Sample& sample, const PressSamples& press, const MappingCurve& curve,
               MappingAlong along, const MeshDistance& shape, const BodyPose& posed,
               double depth_mm) {
  if (!(press.blur_px2 > 0)) return 0;
  const double px = std::sqrt(press.blur_px2);
  const SkinLine line = skin_line(sample, along);
  const Vector3d here = line.base - posed.factor * depth_mm * line.along;
  const Gap middle = gap_at(shape, posed.camera_from_body, here);
  const double by_depth = middle.outwards.dot(line.along);  // -1: along the body's normal
  if (!(by_depth < -0.3)) return 0;
  double laplacian = 0, gradient2 = 0;  // times px^2
  for (const Vector3d& by_px : {sample.by_u, sample.by_v}) {
    const double before = gap_at(shape, posed.camera_from_body, here - px * by_px).mm,
                 behind = gap_at(shape, posed.camera_from_body, here + px * by_px).mm;
    laplacian += (before + behind - 2 * middle.mm) / by_depth;
    const double slope = (behind - before) / 2 / by_depth;
    gradient2 += slope * slope;
  }
  const double step = 1e-3 * curve.x_max();
  const double slope = curve.slope_mm(sample.x);
  const double bend =
      (curve.slope_mm(sample.x + step) - curve.slope_mm(sample.x - step)) / 2 / step;
  return 0.5 * (laplacian - bend / (slope * slope) * gradient2);
}

/// Retains the skin that rests on the posed body.
void select_resting(BodySamples& body, const MeshDistance& shape, const MappingCurve& curve,
                    MappingAlong along, const BodyPose& posed) {
  const auto skin = skin_of(body.samples, curve, curve.values().data(), along);
  double deepest_mm = 0;
  for (const SkinPoint& point : skin) deepest_mm = std::max(deepest_mm, point.depth_mm);
  std::vector<Sample> resting;
  std::vector<BodyPatch> patches;
  std::vector<double> blur_mm;
  for (std::size_t i = 0; i < skin.size(); ++i) {
    const Sample& sample = body.samples.samples[i];
    if (skin[i].depth_mm < kRestingPart * deepest_mm) continue;
    const auto patch =
        patch_under(shape, posed.camera_from_body, skin[i].at(posed.factor), sample.normal);
    if (!patch) continue;
    resting.push_back(sample);
    patches.push_back(*patch);
    blur_mm.push_back(blur_of(sample, body.samples, curve, along, shape, posed, skin[i].depth_mm));
  }
  const std::size_t step = resting.size() / kRead + 1;
  body.samples.samples.clear();
  std::vector<double> retained;
  for (std::size_t i = 0; i < resting.size(); i += step) {
    body.samples.samples.push_back(resting[i]);
    body.patches.push_back(patches[i]);
    retained.push_back(blur_mm[i]);
  }
  body.blur_mm = Eigen::Map<Eigen::VectorXd>(retained.data(), std::ssize(retained));
}

Error refused(const std::string& press, Message what) {
  return {std::move(what), press,
          en::say("a body with slopes or curves, pressed in until 3 mm of skin rest on it")};
}

}  // namespace

PressSamples sample_for_body(const Press& press, const Face& face) {
  PressSamples rough = sample_press(press, face, block_px_for(press, kRoughSamples));
  if (!rough.samples.empty()) select_pressed(rough, [](const Sample& sample) { return sample.x; });
  if (rough.samples.empty()) return rough;
  Vector3d middle = Vector3d::Zero();
  for (const Sample& sample : rough.samples)
    middle += sample.untouched_n / static_cast<double>(rough.samples.size());
  double radius_mm = 0;
  for (const Sample& sample : rough.samples)
    radius_mm = std::max(radius_mm, (sample.untouched_n - middle).norm());
  return sample_around(press, face, middle, radius_mm + kAroundMm, kMaxSamples);
}

Result<BodySamples> find_body(const std::string& press, PressSamples samples,
                              const MeshDistance& shape, const MappingCurve& curve,
                              MappingAlong along, const Job& job) {
  BodySamples body{press, std::move(samples), {}, {}, Isometry3d::Identity()};
  if (!body.samples.samples.empty())
    select_pressed(body.samples, [&](const Sample& sample) {
      return curve.at().depth_mm(sample.x, sample.unit_position);
    });
  if (body.samples.samples.size() < kFewest)
    return refused(press, en::say("the body touches too little of the face"));
  Vector3d normal = Vector3d::Zero();
  double deepest_mm = 0;
  for (const Sample& sample : body.samples.samples) normal += sample.normal;
  normal.normalize();
  const auto skin = skin_of(body.samples, curve, curve.values().data(), along);
  for (const SkinPoint& point : skin) deepest_mm = std::max(deepest_mm, point.depth_mm);
  const auto posed = find_pose(skin, normal, shape, true, job);
  if (!posed) return posed.error();
  body.camera_from_body = posed->camera_from_body;
  constexpr double kWorstPart = 0.2, kWorstMm = 0.03;  // of the greatest depth
  if (!(posed->rms_mm < std::max(kWorstMm, kWorstPart * deepest_mm)))
    return refused(press,
                   en::say("the skin is {:.2f} mm off the body in its best pose", posed->rms_mm));
  select_resting(body, shape, curve, along, *posed);
  if (body.samples.samples.size() < kFewest)
    return refused(press, en::say("too little skin rests on the body away from its edges"));
  const BodyGaps at = gaps_at(skin_of(body.samples, curve, curve.values().data(), along),
                              BodySurface(body.patches), posed->camera_from_body, posed->factor);
  const Eigen::VectorXd ones = Eigen::VectorXd::Ones(at.mm.size());
  if (!(of_factor_alone(at, ones).norm() > kOpenPart * at.by_factor.norm()))
    return refused(press, en::say("the shape of this body leaves the scale of depth open"));
  return body;
}

BodyReading read_body(const BodySamples& body, const MappingCurve& curve, const double* values,
                      MappingAlong along) {
  constexpr int kRounds = 6;
  std::vector<Eigen::VectorXd> gradients;
  std::vector<SkinPoint> skin = skin_of(body.samples, curve, values, along, &gradients);
  for (std::size_t i = 0; i < skin.size(); ++i)
    skin[i].depth_mm -= body.blur_mm[static_cast<Eigen::Index>(i)];
  BodyPose posed{body.camera_from_body, 1, 0};
  const BodySurface surface(body.patches);
  for (int i = 0; i < kRounds; ++i) refine_pose(skin, surface, true, posed);
  const BodyGaps at = gaps_at(skin, surface, posed.camera_from_body, posed.factor);
  const Eigen::VectorXd roots = root_weights(at.mm);
  const Eigen::VectorXd alone = of_factor_alone(at, roots);
  BodyReading reading;
  reading.by_values = Eigen::VectorXd::Zero(curve.family().numbers());
  if (!(alone.squaredNorm() > kNoStrength)) {
    reading.sd = std::numeric_limits<double>::infinity();
    return reading;
  }
  reading.factor = posed.factor;
  // How much a gap changes the factor.
  const Eigen::VectorXd weight = -roots.cwiseProduct(alone) / alone.squaredNorm();
  const auto count = static_cast<Eigen::Index>(skin.size());
  Eigen::VectorXd noise_mm(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const double by_depth = -posed.factor * at.outwards[k].dot(skin[k].line.along);
    reading.by_values += weight[i] * by_depth * gradients[k];
    noise_mm[i] = by_depth * curve.slope_mm(body.samples.samples[k].x) * body.samples.x_sd;
  }
  reading.rms_mm = std::sqrt(at.mm.squaredNorm() / static_cast<double>(count));
  const double uneven_mm = std::sqrt(std::max(0.0, at.mm.squaredNorm() - noise_mm.squaredNorm()) /
                                     static_cast<double>(count));
  // As for a step, whose two levels have weights of 1 each in all.
  const double lever = 0.5 * weight.cwiseAbs().sum();
  reading.sd = std::hypot(2.0 * weight.cwiseProduct(noise_mm).norm(),  // neighbours share noise
                          lever * kUnevenPart * uneven_mm, lever * kFormSdMm);
  return reading;
}

}  // namespace alltact
