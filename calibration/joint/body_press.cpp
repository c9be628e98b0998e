#include "calibration/joint/body_press.h"

#include "calibration/joint/pressed_part.h"
#include "core/mesh/mesh_distance.h"
#include "core/numerics/median.h"

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
constexpr std::size_t kTried = 60;   // and to try a pose
constexpr std::size_t kFewest = 60;
constexpr double kEdgeMm = 0.4;  // next to an edge the skin leaves the body
const double kEdgeCosine = std::cos(30 * M_PI / 180);
constexpr double kSteepest = 0.7;    // cosine of the body's slope against the face
constexpr double kOpenPart = 0.05;   // of the factor's effect that no pose imitates
constexpr double kUnevenPart = 0.3;  // of what the skin does not follow: as for steps
constexpr double kFormSdMm =
    0.003;  // of skin on a body, as of the rings of balls (uncertainty.cpp)

/// A point of the skin at a sample: base - depth * along.
struct SkinLine {
  Vector3d base, along;
};

SkinLine skin_line(const Sample& sample, MappingAlong along) {
  if (along == MappingAlong::kNormal) return {sample.untouched_n, sample.normal};
  const double scale = along == MappingAlong::kProjected ? 1 / sample.cos_incline : 1.0;
  return {sample.untouched_z, scale * Vector3d::UnitZ()};
}

struct SkinPoint {
  SkinLine line;
  double depth_mm = 0;
  [[nodiscard]] Vector3d at(double factor) const {
    return line.base - factor * depth_mm * line.along;
  }
};

/// Distance of a point in the camera frame from the posed body, with its gradient.
struct Gap {
  double mm = 0;
  Vector3d outwards;
};
Gap gap_at(const MeshDistance& shape, const Isometry3d& camera_from_body, const Vector3d& point) {
  const auto nearest = shape(camera_from_body.inverse(Eigen::Isometry) * point);
  return {nearest.distance, camera_from_body.linear() * nearest.outwards};
}
Gap gap_at(const BodyPatch& patch, const Isometry3d& camera_from_body, const Vector3d& point) {
  const Vector3d off = camera_from_body.inverse(Eigen::Isometry) * point - patch.point;
  const double height = patch.outwards.dot(off);
  const Vector3d aside = off - height * patch.outwards, turned = patch.bend * aside;
  return {height + 0.5 * aside.dot(turned),
          camera_from_body.linear() * (patch.outwards + turned).normalized()};
}

/// What gaps of skin points are measured from: the mesh in a search, patches in a reading.
class Surface {
 public:
  explicit Surface(const MeshDistance& shape) : shape_(&shape) {}
  explicit Surface(const std::vector<BodyPatch>& patches) : patches_(&patches) {}
  [[nodiscard]] Gap operator()(std::size_t i, const Isometry3d& camera_from_body,
                               const Vector3d& point) const {
    return shape_ != nullptr ? gap_at(*shape_, camera_from_body, point)
                             : gap_at((*patches_)[i], camera_from_body, point);
  }

 private:
  const MeshDistance* shape_ = nullptr;
  const std::vector<BodyPatch>* patches_ = nullptr;
};

/// A small motion: rotation about `centre`, then translation.
Isometry3d moved(const Isometry3d& pose, const Vector3d& turn, const Vector3d& shift,
                 const Vector3d& centre) {
  Isometry3d result = pose;
  const double angle = turn.norm();
  if (angle > 0) {
    const Eigen::Matrix3d rotation = Eigen::AngleAxisd(angle, turn / angle).toRotationMatrix();
    result.linear() = rotation * pose.linear();
    result.translation() = rotation * (pose.translation() - centre) + centre;
  }
  result.translation() += shift;
  return result;
}

/// The linear problem at a pose: gaps by the pose (turn about the centre, shift) and the factor.
struct Linear {
  Eigen::MatrixXd by_pose;
  Eigen::VectorXd by_factor, gaps;
  std::vector<Vector3d> outwards;
  Vector3d centre = Vector3d::Zero();
  double reach_mm = 1;  ///< makes turns as large as shifts
};

Linear linear_at(const std::vector<SkinPoint>& skin, const Surface& surface, const Isometry3d& pose,
                 double factor) {
  Linear at;
  const auto count = static_cast<Eigen::Index>(skin.size());
  at.by_pose.resize(count, 6);
  at.by_factor.resize(count);
  at.gaps.resize(count);
  for (const SkinPoint& point : skin) at.centre += point.at(factor) / static_cast<double>(count);
  double squares = 0;
  for (const SkinPoint& point : skin) squares += (point.at(factor) - at.centre).squaredNorm();
  at.reach_mm = std::max(1e-3, std::sqrt(squares / static_cast<double>(count)));
  for (Eigen::Index i = 0; i < count; ++i) {
    const SkinPoint& point = skin[static_cast<std::size_t>(i)];
    const Vector3d here = point.at(factor);
    const Gap gap = surface(static_cast<std::size_t>(i), pose, here);
    at.gaps[i] = gap.mm;
    at.by_pose.row(i) << (gap.outwards.cross(here - at.centre) / at.reach_mm).transpose(),
        -gap.outwards.transpose();
    at.by_factor[i] = -point.depth_mm * gap.outwards.dot(point.line.along);
    at.outwards.push_back(gap.outwards);
  }
  return at;
}

/// Least squares whose rank shows which motions change nothing, such as turns of a rod.
Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> solver_of(const Eigen::MatrixXd& rows) {
  Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> solver;
  solver.setThreshold(1e-4);
  solver.compute(rows);
  return solver;
}

/// Weights against points that do not rest on the body (Huber, 2 standard deviations).
Eigen::VectorXd root_weights(const Eigen::VectorXd& gaps) {
  std::vector<double> sizes(gaps.data(), gaps.data() + gaps.size());
  for (double& size : sizes) size = std::abs(size);
  const double limit = std::max(1e-4, 2 * 1.4826 * upper_median(sizes));
  return gaps.unaryExpr(
      [&](double gap) { return std::sqrt(limit / std::max(limit, std::abs(gap))); });
}

struct Posed {
  Isometry3d camera_from_body = Isometry3d::Identity();
  double factor = 1;
  double rms_mm = std::numeric_limits<double>::infinity();
};

constexpr double kNoStrength = 1e-12;  // mm^2: a factor on depths of 0 changes nothing

/// What of the factor's effect no motion of the body imitates.
Eigen::VectorXd of_factor_alone(const Linear& at, const Eigen::VectorXd& roots) {
  const Eigen::MatrixXd rows = roots.asDiagonal() * at.by_pose;
  const Eigen::VectorXd column = roots.cwiseProduct(at.by_factor);
  return column - rows * solver_of(rows).solve(column);
}

void step(const std::vector<SkinPoint>& skin, const Surface& surface, bool frees_factor,
          Posed& posed) {
  const Linear at = linear_at(skin, surface, posed.camera_from_body, posed.factor);
  const Eigen::VectorXd roots = root_weights(at.gaps);
  const Eigen::MatrixXd rows = roots.asDiagonal() * at.by_pose;
  Eigen::VectorXd left = roots.cwiseProduct(at.gaps);
  double change = 0;
  if (frees_factor) {
    const Eigen::VectorXd alone = of_factor_alone(at, roots);
    const double strength = alone.squaredNorm();
    if (strength > kNoStrength) change = std::clamp(-alone.dot(left) / strength, -0.3, 0.3);
    left += change * roots.cwiseProduct(at.by_factor);
  }
  const Eigen::Matrix<double, 6, 1> motion = -solver_of(rows).solve(left);
  const Vector3d turn = motion.head<3>() / at.reach_mm, shift = motion.tail<3>();
  // A step as long as the contact is no small motion.
  const double size = std::max(turn.norm() * at.reach_mm, shift.norm());
  const double shorten = std::min(1.0, 0.5 * at.reach_mm / std::max(size, 1e-12));
  posed.camera_from_body =
      moved(posed.camera_from_body, shorten * turn, shorten * shift, at.centre);
  posed.factor = std::clamp(posed.factor + shorten * change, 0.2, 5.0);
}

double rms_of(const std::vector<SkinPoint>& skin, const MeshDistance& shape, const Posed& posed) {
  double squares = 0;
  for (const SkinPoint& point : skin) {
    const double gap = gap_at(shape, posed.camera_from_body, point.at(posed.factor)).mm;
    squares += gap * gap;
  }
  return std::sqrt(squares / static_cast<double>(skin.size()));
}

std::vector<SkinPoint> every(const std::vector<SkinPoint>& skin, std::size_t limit) {
  std::vector<SkinPoint> some;
  const std::size_t step = skin.size() / limit + 1;
  for (std::size_t i = 0; i < skin.size(); i += step) some.push_back(skin[i]);
  return some;
}

// Where a search for the pose starts.

/// Directions to the faces, edges and corners of a cube: meshes are mostly made along their axes.
std::vector<Vector3d> directions() {
  std::vector<Vector3d> all;
  for (int x = -1; x <= 1; ++x)
    for (int y = -1; y <= 1; ++y)
      for (int z = -1; z <= 1; ++z)
        if (x != 0 || y != 0 || z != 0) all.push_back(Vector3d(x, y, z).normalized());
  return all;
}

/// Middles of the parts of a mesh that lie furthest in a direction, each at most `extent_mm` wide.
std::vector<Vector3d> tops_of(const TriangleMesh& mesh, const Vector3d& direction,
                              double extent_mm) {
  constexpr std::size_t kMost = 6;
  double top = -std::numeric_limits<double>::infinity();
  for (const Vector3d& point : mesh.points) top = std::max(top, direction.dot(point));
  struct Part {
    Vector3d sum;
    double count;
  };
  std::vector<Part> parts;
  for (const Vector3d& point : mesh.points) {
    if (direction.dot(point) < top - 0.02 * extent_mm) continue;
    const auto near = std::find_if(parts.begin(), parts.end(), [&](const Part& part) {
      return (part.sum / part.count - point).norm() < 0.5 * extent_mm;
    });
    if (near != parts.end())
      near->sum += point, near->count += 1;
    else if (parts.size() < kMost)
      parts.push_back({point, 1});
  }
  std::vector<Vector3d> middles;
  Vector3d middle = Vector3d::Zero();
  for (const Part& part : parts) {
    middles.emplace_back(part.sum / part.count);
    middle += middles.back() / static_cast<double>(parts.size());
  }
  if (middles.size() > 1) middles.push_back(middle);
  return middles;
}

std::vector<Isometry3d> starts(const std::vector<SkinPoint>& skin, const Vector3d& normal,
                               const TriangleMesh& mesh) {
  constexpr int kTurns = 12;
  const auto deepest = std::max_element(
      skin.begin(), skin.end(),
      [](const SkinPoint& a, const SkinPoint& b) { return a.depth_mm < b.depth_mm; });
  // The middle of what is nearly as deep.
  Vector3d middle = Vector3d::Zero();
  double count = 0, extent_mm = 0;
  for (const SkinPoint& point : skin)
    if (point.depth_mm > 0.9 * deepest->depth_mm) middle += point.at(1), count += 1;
  middle /= count;
  for (const SkinPoint& point : skin)
    extent_mm = std::max(extent_mm, 2 * (point.at(1) - middle).norm());
  std::vector<Isometry3d> poses;
  for (const Vector3d& direction : directions()) {
    const Eigen::Quaterniond facing = Eigen::Quaterniond::FromTwoVectors(direction, -normal);
    for (const Vector3d& top : tops_of(mesh, direction, extent_mm))
      for (int i = 0; i < kTurns; ++i) {
        Isometry3d pose = Isometry3d::Identity();
        pose.linear() =
            (Eigen::AngleAxisd(2 * M_PI * i / kTurns, normal) * facing).toRotationMatrix();
        pose.translation() = middle - pose.linear() * top;
        poses.push_back(pose);
      }
  }
  return poses;
}

/// The best pose of all starts: a few steps from each, more from the best.
Result<Posed> search(const std::vector<SkinPoint>& skin, const Vector3d& normal,
                     const MeshDistance& shape, const Job& job) {
  constexpr std::size_t kBest = 12;
  const std::vector<SkinPoint> few = every(skin, kTried);
  const Surface surface(shape);
  std::vector<Posed> tried;
  for (const Isometry3d& start : starts(skin, normal, shape.mesh())) {
    if (job.stop_requested()) return Error{en::say("stopped before the body was found"), "", ""};
    Posed posed{start, 1, 0};
    for (int i = 0; i < 3; ++i) step(few, surface, false, posed);
    posed.rms_mm = rms_of(few, shape, posed);
    tried.push_back(posed);
  }
  const auto is_better = [](const Posed& a, const Posed& b) { return a.rms_mm < b.rms_mm; };
  std::stable_sort(tried.begin(), tried.end(), is_better);
  tried.resize(std::min(tried.size(), kBest));
  for (Posed& posed : tried) {
    for (int i = 0; i < 25; ++i) step(few, surface, i > 8, posed);
    posed.rms_mm = rms_of(few, shape, posed);
  }
  return *std::min_element(tried.begin(), tried.end(), is_better);
}

std::vector<SkinPoint> skin_of(const PressSamples& press, const MappingCurve& curve,
                               const double* values, MappingAlong along,
                               std::vector<Eigen::VectorXd>* gradients = nullptr) {
  std::vector<SkinPoint> skin;
  Eigen::VectorXd gradient(curve.family().numbers());
  for (const Sample& sample : press.samples) {
    const double depth_mm = curve.evaluate(values, sample.x, sample.unit_position, gradient.data());
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
               MappingAlong along, const MeshDistance& shape, const Posed& posed, double depth_mm) {
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
                    MappingAlong along, const Posed& posed) {
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
      return curve.depth_mm(sample.x, sample.unit_position);
    });
  if (body.samples.samples.size() < kFewest)
    return refused(press, en::say("the body touches too little of the face"));
  Vector3d normal = Vector3d::Zero();
  double deepest_mm = 0;
  for (const Sample& sample : body.samples.samples) normal += sample.normal;
  normal.normalize();
  const auto skin = skin_of(body.samples, curve, curve.values().data(), along);
  for (const SkinPoint& point : skin) deepest_mm = std::max(deepest_mm, point.depth_mm);
  const auto posed = search(skin, normal, shape, job);
  if (!posed) return posed.error();
  body.camera_from_body = posed->camera_from_body;
  constexpr double kWorstPart = 0.2, kWorstMm = 0.03;  // of the greatest depth
  if (!(posed->rms_mm < std::max(kWorstMm, kWorstPart * deepest_mm)))
    return refused(press,
                   en::say("the skin is {:.2f} mm off the body in its best pose", posed->rms_mm));
  select_resting(body, shape, curve, along, *posed);
  if (body.samples.samples.size() < kFewest)
    return refused(press, en::say("too little skin rests on the body away from its edges"));
  const Linear at = linear_at(skin_of(body.samples, curve, curve.values().data(), along),
                              Surface(body.patches), posed->camera_from_body, posed->factor);
  const Eigen::VectorXd ones = Eigen::VectorXd::Ones(at.gaps.size());
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
  Posed posed{body.camera_from_body, 1, 0};
  const Surface surface(body.patches);
  for (int i = 0; i < kRounds; ++i) step(skin, surface, true, posed);
  const Linear at = linear_at(skin, surface, posed.camera_from_body, posed.factor);
  const Eigen::VectorXd roots = root_weights(at.gaps);
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
  reading.rms_mm = std::sqrt(at.gaps.squaredNorm() / static_cast<double>(count));
  const double uneven_mm = std::sqrt(std::max(0.0, at.gaps.squaredNorm() - noise_mm.squaredNorm()) /
                                     static_cast<double>(count));
  // As for a step, whose two levels have weights of 1 each in all.
  const double lever = 0.5 * weight.cwiseAbs().sum();
  reading.sd = std::hypot(2.0 * weight.cwiseProduct(noise_mm).norm(),  // neighbours share noise
                          lever * kUnevenPart * uneven_mm, lever * kFormSdMm);
  return reading;
}

}  // namespace alltact
