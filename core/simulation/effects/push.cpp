// A ball pushes against a face of the finger with `force_N` along the face's normal, dragged with
// `along_N` towards the tip and `across_N`. On the contact and the back face `across_N` points to
// +y, on the side faces to the contact face. The forces rotate with the finger. Friction transmits
// at most `friction` * force_N of the drag; beyond that the ball slides. `y_mm` is measured across
// the face from its middle line. A force of 0 means no contact.
//   On the contact face the layer, of hardness `layer_shore_a`, deforms by BondedLayerContact and
// indented_surface_mm, including the bulge. s_mm and y_mm are as those of `ball`. With the effect
// `body` all faces deflect, and the dots of the side faces near the ball move with the surface
// (HalfSpaceContact).
#include "core/simulation/effect.h"
#include "core/simulation/mechanics/ball_contact.h"
#include "core/simulation/mechanics/rubber.h"
#include "core/simulation/scene_time.h"

#include <Eigen/LU>

namespace alltact {

namespace {

constexpr double kMaxForce_N = 10000;
// Below this the camera views the face edge on, and depth along z means nothing.
constexpr double kMinUpright = 0.05;

class PushedBall final : public GeometryEffect {
 public:
  explicit PushedBall(YamlSection& p)
      : face_(static_cast<PushedFace>(
            p.choice("face", {to_string(PushedFace::kContact), to_string(PushedFace::kBack),
                              to_string(PushedFace::kUpper), to_string(PushedFace::kLower)}) +
            1)),
        frames_(SceneTime::of(p).frames),
        presence_(Presence::read(p, SceneTime::of(p))),
        radius_(Varying::read(p, "radius_mm", strength_up_to(100))),
        s_(Varying::read(p, "s_mm", {-1000, 1000})),
        y_(Varying::read_or(p, "y_mm", 0, {-1000, 1000})),
        force_(Varying::read(p, "force_N", {0, kMaxForce_N})),
        along_(read_drag(p, "along_N")),
        across_(read_drag(p, "across_N")) {
    if (force_.max_value() == 0)
      p.refuse("force_N", en::say("the force is 0"), en::say("a force above 0, or no push"));
    if (p.has("along_N") || p.has("across_N")) friction_ = p.number("friction", strength_up_to(10));
    if (face_ == PushedFace::kContact)
      layer_modulus_MPa_ =
          modulus_from_shore_a(p.number("layer_shore_a", {kSoftestShoreA, kHardestShoreA})).value();
  }

  bool is_repeatable() const override { return true; }

  Status validate(const SceneFacts& scene) const override {
    if (scene.finger.face.kind == FaceKind::kFlat && face_ != PushedFace::kContact)
      return Error{en::say("a flat sensor has a contact face only"), "", en::say("face: contact")};
    if (const Status status = check_on_face(scene); !status) return status;
    if (const Status status = check_contact(scene); !status) return status;
    if (scene.elastic == nullptr || scene.finger.face.kind == FaceKind::kFlat) return {};
    if (scene.elastic->chain.has_memory() && presence_.end < frames_)
      return Error{en::say("a body with creep or damping still moves after a push ends"), "",
                   en::say("instead of 'until', a force_N that goes to 0")};
    return check_bending(scene);
  }

  void shape(const FrameContext& frame, FaceCurve& curve) const override {
    curve.loads.push_back(
        {[this, frame](int at, double frame_offset) { return force(frame, at, frame_offset); },
         this,
         {}});
  }

  void apply(const FrameContext& frame, FrameGeometry& geometry) const override {
    const FaceLoad::Response response = response_in(frame, geometry);
    if (!(response.force.normal_N > 0)) return;
    ContactTruth truth;
    truth.name = "push";
    truth.face = face_;
    truth.along_mm = frame(s_);
    truth.across_mm = frame(y_);
    truth.point_mm = response.surface.point_mm;
    const Eigen::Vector3d force_N = response.surface.vector_N(response.force);
    truth.direction = force_N.normalized();
    truth.force_N = force_N;
    if (face_ == PushedFace::kContact)
      indent(frame(radius_), response, geometry, truth);
    else if (face_ != PushedFace::kBack)
      drag(frame(radius_), response, geometry);
    geometry.contacts.push_back(truth);
  }

 private:
  static Varying read_drag(YamlSection& p, const std::string& key) {
    if (!p.has(key)) return Varying(0);
    const Varying drag = Varying::read(p, key, {-kMaxForce_N, kMaxForce_N});
    if (drag.min_value() == 0 && drag.max_value() == 0)
      p.refuse(key, en::say("the drag is 0"), en::say("another force, or leave it out"));
    return drag;
  }

  [[nodiscard]] PointForce force(const FrameContext& context, int frame,
                                 double frame_offset) const {
    const FrameContext then{
        context.seed,        frame,       context.motion, context.finger, context.frames_per_s,
        context.motion_seed, frame_offset};
    PointForce force{face_, then(s_), then(y_), 0, 0, 0};
    if (!presence_.holds(frame % frames_)) return force;
    force.normal_N = then(force_);
    const Eigen::Vector2d held =
        limited_by_friction({then(along_), then(across_)}, force.normal_N, friction_);
    force.along_N = held.x();
    force.across_N = held.y();
    return force;
  }

  // What the body carries; the full load on a rigid finger.
  [[nodiscard]] FaceLoad::Response response_in(const FrameContext& frame,
                                               const FrameGeometry& geometry) const {
    if (const FaceCurve* curve = geometry.curve())
      for (const FaceLoad& load : curve->loads)
        if (load.source == this && load.response) return *load.response;
    const PressPose pose = geometry.press_pose(frame(s_), frame(y_), 0);
    return {force(frame, frame.frame, frame.frame_offset),
            {pose.luf_mm, -pose.normal, pose.along, pose.normal.cross(pose.along)},
            0};
  }

  // Indents the layer as deep as the force requires, at the current position of the pushed surface
  // point.
  void indent(double radius_mm, const FaceLoad::Response& response, FrameGeometry& geometry,
              ContactTruth& truth) const {
    const auto layer =
        BondedLayerContact::create(layer_modulus_MPa_, geometry.face().layer_mm, radius_mm);
    const double force_N = std::min(response.force.normal_N, layer->max_force_N());
    const double depth_mm = layer->indentation_mm(force_N).value();
    const Eigen::Vector2d at =
        position_of(geometry, response.surface.point_mm, {truth.along_mm, truth.across_mm});
    PressPose pose = geometry.press_pose(at.x(), at.y(), 0);
    if (pose.normal.z() < kMinUpright) return;
    pose.depth_mm = depth_mm / pose.normal.z();
    truth.along_mm = at.x();
    truth.across_mm = at.y();
    truth.depth_mm = pose.depth_mm;
    BallPress press = make_ball_press(pose, radius_mm);
    press.contact_radius_mm = press.rim_mm = layer->contact_radius_mm(depth_mm);
    press.profile_mm = indented_surface_mm(*layer, depth_mm, BallPress::kStep_mm);
    geometry.presses.emplace_back(std::move(press));
  }

  // The s and y of a press whose outer point has the x and y of the given point.
  static Eigen::Vector2d position_of(const FrameGeometry& geometry, const Eigen::Vector3d& point_mm,
                                     Eigen::Vector2d at) {
    constexpr double kStep_mm = 1e-4;
    const auto off = [&](const Eigen::Vector2d& position) -> Eigen::Vector2d {
      return (geometry.luf_point_mm(position.x(), position.y()) - point_mm).head<2>();
    };
    for (int i = 0; i < 8; ++i) {
      const Eigen::Vector2d miss = off(at);
      Eigen::Matrix2d slope;
      for (int j = 0; j < 2; ++j) {
        const Eigen::Vector2d step = kStep_mm * Eigen::Vector2d::Unit(j);
        slope.col(j) = (off(at + step) - off(at - step)) / (2 * kStep_mm);
      }
      if (std::abs(slope.determinant()) < 0.05) break;  // viewed edge on: no press
      const Eigen::Vector2d change = slope.inverse() * miss;
      at -= change;
      if (change.norm() < 1e-9) break;
    }
    return at;
  }

  void drag(double radius_mm, const FaceLoad::Response& response, FrameGeometry& geometry) const {
    const auto contact =
        HalfSpaceContact::create(response.modulus_MPa, radius_mm, response.force.normal_N,
                                 {response.force.along_N, response.force.across_N}, friction_);
    if (!contact) return;  // validate() refused that
    geometry.drags.push_back(
        {face_ == PushedFace::kUpper ? -1 : 1, response.surface, contact.value()});
  }

  [[nodiscard]] Status check_on_face(const SceneFacts& scene) const {
    if (face_ == PushedFace::kContact || face_ == PushedFace::kBack || scene.elastic == nullptr)
      return check_position(scene, s_, y_);
    if (const Status status = check_position(scene, s_, Varying(0)); !status) return status;
    const auto body = scene.elastic->body(scene.finger.face, scene.length_mm);
    if (!body) return body.error();
    const FinRayGeometry& shape = body->geometry();
    const double half =
        std::min(shape.depth_mm(s_.min_value()), shape.depth_mm(s_.max_value())) / 2;
    if (y_.min_value() < -half || y_.max_value() > half)
      return Error{en::say("y_mm is outside the face"), "", en::say("{:g} to {:g}", -half, half)};
    return {};
  }

  [[nodiscard]] Status check_contact(const SceneFacts& scene) const {
    if (face_ == PushedFace::kContact) {
      const auto layer = BondedLayerContact::create(layer_modulus_MPa_, scene.finger.face.layer_mm,
                                                    radius_.min_value());
      if (!layer) return layer.error();
      const auto depth = layer->indentation_mm(force_.max_value());
      return depth ? Status() : depth.error();
    }
    if (scene.elastic == nullptr)
      return Error{en::say("without its body the finger deforms on its contact face only"), "",
                   en::say("name the effect body too")};
    const auto contact =
        HalfSpaceContact::create(scene.elastic->modulus_MPa, radius_.min_value(),
                                 force_.max_value(), Eigen::Vector2d::Zero(), friction_);
    return contact ? Status() : contact.error();
  }

  // Checks its maximum forces, acting alone.
  [[nodiscard]] Status check_bending(const SceneFacts& scene) const {
    const auto body = scene.elastic->body(scene.finger.face, scene.length_mm);
    if (!body) return body.error();
    const FaceCurve straight(Eigen::Vector3d::UnitZ(), 0, scene.length_mm);
    const PushedFinger finger(*body, straight);
    const double normal_N = force_.max_value();
    for (const double s_mm : {s_.min_value(), s_.max_value()})
      for (const double along_N : {along_.min_value(), along_.max_value()})
        for (const double across_N : {across_.min_value(), across_.max_value()})
          for (const double y_mm : {y_.min_value(), y_.max_value()}) {
            const Eigen::Vector2d held =
                limited_by_friction({along_N, across_N}, normal_N, friction_);
            const PointForce force{face_, s_mm, y_mm, normal_N, held.x(), held.y()};
            const double share = finger.equilibrium({&force, 1}).share;
            if (share < 1)
              return Error{en::say("the push bends the finger beyond the model's range"), "",
                           en::say("up to {:.2g} times these forces, or a stiffer body", share)};
          }
    return {};
  }

  PushedFace face_;
  int frames_;
  Presence presence_;
  Varying radius_, s_, y_, force_, along_, across_;
  double friction_ = 1;           // no effect without a drag
  double layer_modulus_MPa_ = 0;  // contact face only
};

}  // namespace

EffectKind effect_push() {
  return effect_kind<PushedBall>(
      "push",
      52,  // after rolloff and bulge, which apply to presses of given depth
      en::say("A ball pushes against the finger"),
      "face: contact, s_mm: 60, y_mm: 2, radius_mm: 4, force_N: 1.5, layer_shore_a: 5");
}

}  // namespace alltact
