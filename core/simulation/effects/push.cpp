// A ball is pushed against a face of the finger with `force_N` along the face's normal, and dragged
// with `along_N` towards the tip and `across_N` (on the contact and the back face towards +y, on
// the side faces towards the contact face); the forces turn with the finger. Of the drag it hands
// on `friction` * force_N at most, and slides beyond that. `y_mm` is measured across the face from
// its middle line. In frames in which the force is 0 nothing touches.
//   On the contact face the layer, of hardness `layer_shore_a`, gives way as BondedLayerContact
// and dented_surface_mm have it, bulge and all, and s_mm and y_mm are as those of `ball`. With the
// effect `body` the finger gives way too, on all faces, and on the side faces the dots near the
// ball move with the skin (HalfSpaceContact).
#include "core/simulation/effect.h"
#include "core/simulation/mechanics/bonded_layer.h"
#include "core/simulation/mechanics/dented_surface.h"
#include "core/simulation/mechanics/shore.h"
#include "core/simulation/scene_time.h"

#include <Eigen/LU>

namespace alltact {

namespace {

constexpr double kGreatestForce_N = 10000;
// Below this the camera sees the face edge on, and depth along z means nothing.
constexpr double kLeastUpright = 0.05;

class PushedBall final : public GeometryEffect {
 public:
  explicit PushedBall(YamlSection& p)
      : face_(static_cast<PushedFace>(p.choice("face",
                                               {to_string(PushedFace::kContact),
                                                to_string(PushedFace::kBack),
                                                to_string(PushedFace::kUpper),
                                                to_string(PushedFace::kLower)}) +
                                      1)),
        frames_(SceneTime::of(p).frames),
        presence_(Presence::read(p, SceneTime::of(p))),
        radius_(Varying::read(p, "radius_mm", strength_up_to(100))),
        s_(Varying::read(p, "s_mm", {-1000, 1000})),
        y_(Varying::read_or(p, "y_mm", 0, {-1000, 1000})),
        force_(Varying::read(p, "force_N", {0, kGreatestForce_N})),
        along_(read_drag(p, "along_N")),
        across_(read_drag(p, "across_N")) {
    if (force_.greatest() == 0)
      p.refuse("force_N", en::say("nothing pushes"), en::say("a force above 0, or no push"));
    if (p.has("along_N") || p.has("across_N")) friction_ = p.number("friction", strength_up_to(10));
    if (face_ == PushedFace::kContact)
      layer_modulus_MPa_ =
          modulus_from_shore_a(p.number("layer_shore_a", {kSoftestShoreA, kHardestShoreA})).value();
  }

  Message sentence() const override { return en::say("A ball pushes against the finger"); }
  bool may_be_several() const override { return true; }

  Status fits(const SceneFacts& scene) const override {
    if (scene.finger.face.kind == FaceKind::kFlat && face_ != PushedFace::kContact)
      return Error{en::say("a flat sensor has a contact face only"), "", en::say("face: contact")};
    if (const Status status = is_on_face(scene); !status) return status;
    if (const Status status = contact_fits(scene); !status) return status;
    if (scene.elastic == nullptr || scene.finger.face.kind == FaceKind::kFlat) return {};
    if (scene.elastic->chain.remembers() && presence_.end < frames_)
      return Error{en::say("a body that creeps or is damped remembers a push that is over"),
                   "",
                   en::say("instead of 'until', a force_N that goes to 0")};
    return bending_fits(scene);
  }

  void shape(const FrameContext& frame, FaceCurve& curve) const override {
    curve.loads.push_back(
        {[this, frame](int at, double later) { return force(frame, at, later); }, this, {}});
  }

  void place(const FrameContext& frame, FrameGeometry& geometry) const override {
    const FaceLoad::Borne borne = borne_in(frame, geometry);
    if (!(borne.force.normal_N > 0)) return;
    ContactTruth truth;
    truth.name = "push";
    truth.face = face_;
    truth.along_mm = frame(s_);
    truth.across_mm = frame(y_);
    truth.point_mm = borne.surface.point_mm;
    const Eigen::Vector3d force_N = borne.surface.vector_N(borne.force);
    truth.direction = force_N.normalized();
    truth.force_N = force_N;
    if (face_ == PushedFace::kContact)
      indent(frame(radius_), borne, geometry, truth);
    else if (face_ != PushedFace::kBack)
      drag(frame(radius_), borne, geometry);
    geometry.contacts.push_back(truth);
  }

 private:
  static Varying read_drag(YamlSection& p, const std::string& key) {
    if (!p.has(key)) return Varying(0);
    const Varying drag = Varying::read(p, key, {-kGreatestForce_N, kGreatestForce_N});
    if (drag.least() == 0 && drag.greatest() == 0)
      p.refuse(key, en::say("nothing drags"), en::say("another force, or leave it out"));
    return drag;
  }

  [[nodiscard]] PointForce force(const FrameContext& context, int frame, double later) const {
    const FrameContext then{context.seed,
                            frame,
                            context.motion,
                            context.finger,
                            context.frames_per_s,
                            context.motion_seed,
                            later};
    PointForce force{face_, then(s_), then(y_), 0, 0, 0};
    if (!presence_.holds(frame % frames_)) return force;
    force.normal_N = then(force_);
    const Eigen::Vector2d held =
        held_by_friction({then(along_), then(across_)}, force.normal_N, friction_);
    force.along_N = held.x();
    force.across_N = held.y();
    return force;
  }

  // What the body bears, or on a finger that stands firm all of it.
  [[nodiscard]] FaceLoad::Borne borne_in(const FrameContext& frame,
                                         const FrameGeometry& geometry) const {
    if (const FaceCurve* curve = geometry.curve())
      for (const FaceLoad& load : curve->loads)
        if (load.source == this && load.borne) return *load.borne;
    const PressPlace place = geometry.press_place(frame(s_), frame(y_), 0);
    return {force(frame, frame.frame, frame.later),
            {place.luf_mm, -place.normal, place.along, place.normal.cross(place.along)},
            0};
  }

  // A dent as deep as the force makes it, where the pushed point of the skin is now.
  void indent(double radius_mm,
              const FaceLoad::Borne& borne,
              FrameGeometry& geometry,
              ContactTruth& truth) const {
    const auto layer =
        BondedLayerContact::create(layer_modulus_MPa_, geometry.face().layer_mm, radius_mm);
    const double force_N = std::min(borne.force.normal_N, layer->greatest_force_N());
    const double depth_mm = layer->indentation_mm(force_N).value();
    const Eigen::Vector2d at =
        place_of(geometry, borne.surface.point_mm, {truth.along_mm, truth.across_mm});
    PressPlace place = geometry.press_place(at.x(), at.y(), 0);
    if (place.normal.z() < kLeastUpright) return;
    place.depth_mm = depth_mm / place.normal.z();
    truth.along_mm = at.x();
    truth.across_mm = at.y();
    truth.depth_mm = place.depth_mm;
    BallPress press = make_ball_press(place, radius_mm);
    press.contact_radius_mm = press.rim_mm = layer->contact_radius_mm(depth_mm);
    press.profile_mm = dented_surface_mm(*layer, depth_mm, BallPress::kStep_mm);
    geometry.presses.emplace_back(std::move(press));
  }

  // The s and y of a press whose place has the x and y of a point of the outer side.
  static Eigen::Vector2d place_of(const FrameGeometry& geometry,
                                  const Eigen::Vector3d& point_mm,
                                  Eigen::Vector2d at) {
    constexpr double kStep_mm = 1e-4;
    const auto off = [&](const Eigen::Vector2d& place) -> Eigen::Vector2d {
      return (geometry.luf_point_mm(place.x(), place.y()) - point_mm).head<2>();
    };
    for (int i = 0; i < 8; ++i) {
      const Eigen::Vector2d miss = off(at);
      Eigen::Matrix2d slope;
      for (int j = 0; j < 2; ++j) {
        const Eigen::Vector2d step = kStep_mm * Eigen::Vector2d::Unit(j);
        slope.col(j) = (off(at + step) - off(at - step)) / (2 * kStep_mm);
      }
      if (std::abs(slope.determinant()) < 0.05) break;  // seen edge on: no place of a press
      const Eigen::Vector2d change = slope.inverse() * miss;
      at -= change;
      if (change.norm() < 1e-9) break;
    }
    return at;
  }

  void drag(double radius_mm, const FaceLoad::Borne& borne, FrameGeometry& geometry) const {
    const auto contact = HalfSpaceContact::create(borne.modulus_MPa,
                                                  radius_mm,
                                                  borne.force.normal_N,
                                                  {borne.force.along_N, borne.force.across_N},
                                                  friction_);
    if (!contact) return;  // fits() refused that
    geometry.drags.push_back(
        {face_ == PushedFace::kUpper ? -1 : 1, borne.surface, contact.value()});
  }

  [[nodiscard]] Status is_on_face(const SceneFacts& scene) const {
    if (face_ == PushedFace::kContact || face_ == PushedFace::kBack || scene.elastic == nullptr)
      return place_fits(scene, s_, y_);
    if (const Status status = place_fits(scene, s_, Varying(0)); !status) return status;
    const auto body = scene.elastic->body(scene.finger.face, scene.length_mm);
    if (!body) return body.error();
    const FinRayGeometry& shape = body->geometry();
    const double half = std::min(shape.depth_mm(s_.least()), shape.depth_mm(s_.greatest())) / 2;
    if (y_.least() < -half || y_.greatest() > half)
      return Error{en::say("y_mm is beside the face"), "", en::say("{:g} to {:g}", -half, half)};
    return {};
  }

  [[nodiscard]] Status contact_fits(const SceneFacts& scene) const {
    if (face_ == PushedFace::kContact) {
      const auto layer = BondedLayerContact::create(
          layer_modulus_MPa_, scene.finger.face.layer_mm, radius_.least());
      if (!layer) return layer.error();
      const auto depth = layer->indentation_mm(force_.greatest());
      return depth ? Status() : depth.error();
    }
    if (scene.elastic == nullptr)
      return Error{en::say("without its body the finger gives way on its contact face only"),
                   "",
                   en::say("name the effect body too")};
    const auto contact = HalfSpaceContact::create(scene.elastic->modulus_MPa,
                                                  radius_.least(),
                                                  force_.greatest(),
                                                  Eigen::Vector2d::Zero(),
                                                  friction_);
    return contact ? Status() : contact.error();
  }

  // With its greatest forces, by itself.
  [[nodiscard]] Status bending_fits(const SceneFacts& scene) const {
    const auto body = scene.elastic->body(scene.finger.face, scene.length_mm);
    if (!body) return body.error();
    const FaceCurve straight(Eigen::Vector3d::UnitZ(), 0, scene.length_mm);
    const PushedFinger finger(*body, straight);
    const double normal_N = force_.greatest();
    for (const double s_mm : {s_.least(), s_.greatest()})
      for (const double along_N : {along_.least(), along_.greatest()})
        for (const double across_N : {across_.least(), across_.greatest()})
          for (const double y_mm : {y_.least(), y_.greatest()}) {
            const Eigen::Vector2d held = held_by_friction({along_N, across_N}, normal_N, friction_);
            const PointForce force{face_, s_mm, y_mm, normal_N, held.x(), held.y()};
            const double share = finger.equilibrium({&force, 1}).share;
            if (share < 1)
              return Error{en::say("the push bends the finger further than the model reaches"),
                           "",
                           en::say("up to {:.2g} of these forces, or a stiffer body", share)};
          }
    return {};
  }

  PushedFace face_;
  int frames_;
  Presence presence_;
  Varying radius_, s_, y_, force_, along_, across_;
  double friction_ = 1;           // of no effect without a drag
  double layer_modulus_MPa_ = 0;  // contact face only
};

}  // namespace

const EffectKind& effect_push() {
  static const EffectKind kKind{
      "push",
      Stage::kGeometry,
      52,  // after rolloff and bulge, which are for dents whose depth is told
      [](YamlSection& p) -> std::shared_ptr<const Effect> {
        return std::make_shared<PushedBall>(p);
      },
      "face: contact, s_mm: 60, y_mm: 2, radius_mm: 4, force_N: 1.5, layer_shore_a: 5"};
  return kKind;
}

}  // namespace alltact
