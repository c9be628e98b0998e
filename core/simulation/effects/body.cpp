// The finger's body: rubber of known hardness in the shape of a Fin Ray. It deflects under the
// effect `push` in the modes of `bend` and `sway` and by twisting. With `damping_s` it settles as 1
// - exp(-t / damping_s). With `creep`, a list of {share, time_s}, it deflects further by those
// shares of the elastic deflection, each with its time constant. Other deformation (bend, sway,
// give_mm) is its rest shape. Pushes beyond the model's limits (PushedFinger) are reduced to what
// the body carries; the truth holds the reduced force.
#include "core/simulation/effect.h"
#include "core/simulation/mechanics/rubber.h"
#include "core/simulation/scene_time.h"

#include <Eigen/Cholesky>

namespace alltact {

namespace {

KelvinChain read_chain(YamlSection& p) {
  std::vector<KelvinUnit> units;
  const bool is_damped = p.has("damping_s");
  if (is_damped) units.push_back({1, p.number("damping_s", strength_up_to(1e6))});
  if (p.has("creep"))
    for (YamlSection& unit : p.sections("creep"))
      units.push_back(
          {unit.number("share", strength_up_to(10)), unit.number("time_s", strength_up_to(1e6))});
  return {is_damped ? 0.0 : 1.0, std::move(units)};
}

class ElasticBody final : public GeometryEffect {
 public:
  explicit ElasticBody(YamlSection& p)
      : frames_(SceneTime::of(p).frames), presence_(Presence::read(p, SceneTime::of(p))) {
    const auto modulus =
        modulus_from_shore_a(p.number("shore_a", {kSoftestShoreA, kHardestShoreA}));
    elastic_.modulus_MPa = modulus.value();
    elastic_.wall_mm = p.number("wall_mm", strength_up_to(100));
    elastic_.base_depth_mm = p.number("base_depth_mm", strength_up_to(1000));
    elastic_.tip_depth_mm = p.number("tip_depth_mm", strength_up_to(1000));
    elastic_.coupling = p.number("coupling", {0, 1});
    elastic_.chain = read_chain(p);
  }

  const ElasticFinger* elastic() const override { return &elastic_; }

  Status validate(const SceneFacts& scene) const override {
    if (scene.finger.face.kind == FaceKind::kFlat)
      return Error{en::say("a flat sensor has no body that deforms"), "",
                   en::say("leave body out")};
    if (!scene.has_effect("push"))
      return Error{en::say("nothing pushes, so no body deforms"), "", en::say("name push too")};
    const auto body = elastic_.body(scene.finger.face, scene.length_mm);
    return body ? Status() : body.error();
  }

  void shape(const FrameContext& frame, FaceCurve& curve) const override {
    const auto body = elastic_.body(frame.finger.face, curve.length_mm());
    if (!body || curve.loads.empty()) return;
    const PushedFinger finger(*body, curve);
    const auto [forces, rest] =
        elastic_.chain.has_memory()
            ? after_history(frame, curve, *body, finger)
            : instantaneous(finger,
                            forces_at(curve, frame.frame, frame.frame_offset, frame.finger.face));
    std::vector<FaceLoad> loads = curve.loads;
    for (std::size_t i = 0; i < loads.size(); ++i)
      loads[i].response = {forces[i].times(rest.share), finger.surface(forces[i], rest.q),
                           elastic_.modulus_MPa};
    curve.bend(rest.q[0], rest.q[1]);
    curve.sway(rest.q[2]);
    if (rest.q[3] != 0) curve.twist(rest.q[3]);
    curve.loads = std::move(loads);
    curve.response = rest.q;
  }

 private:
  using Forces = std::vector<PointForce>;
  using Answer = std::pair<Forces, PushedFinger::Equilibrium>;

  static Answer instantaneous(const PushedFinger& finger, Forces forces) {
    const auto rest = finger.equilibrium(forces);
    return {std::move(forces), rest};
  }

  // On the contact face s is where a ball of that s_mm would press: the outer side above the view
  // face's point, along z. The section whose normal passes through that point lies further along.
  static Forces forces_at(const FaceCurve& curve, int frame, double frame_offset,
                          const Face& face) {
    Forces forces;
    for (const FaceLoad& load : curve.loads) {
      PointForce force = load.at(frame, frame_offset);
      if (force.face == PushedFace::kContact)
        force.s_mm += face.layer_mm * std::tan(curve.at(force.s_mm).theta);
      force.s_mm = std::clamp(force.s_mm, 0.0, curve.length_mm());
      forces.push_back(force);
    }
    return forces;
  }

  // Steps through the frames from the first one with this body, as playing the scene does, as far
  // back as the chain's memory.
  Answer after_history(const FrameContext& frame, const FaceCurve& curve, const FinRayBody& body,
                       const PushedFinger& finger) const {
    const int begin = frame.frame - frame.frame % frames_ + presence_.first;
    const double end = std::max<double>(begin, frame.frame + frame.frame_offset);
    const double remembered = std::floor(end - elastic_.chain.memory_s() * frame.frames_per_s);
    const double first = std::max<double>(begin, remembered);
    const auto compliance = body.stiffness().ldlt();
    KelvinChain::History history(elastic_.chain);
    double step_s = 0;
    for (double now = first;;) {
      const int base_frame = static_cast<int>(now);
      Forces forces = forces_at(curve, base_frame, now - base_frame, frame.finger.face);
      const auto rest = finger.equilibrium(forces, history.weight(step_s), history.before(step_s));
      if (now >= end) return {std::move(forces), rest};
      history.step(step_s, rest.share * compliance.solve(finger.generalised_force(forces, rest.q)));
      const double next = std::min(base_frame + 1.0, end);
      step_s = (next - now) / frame.frames_per_s;
      now = next;
    }
  }

  int frames_;
  Presence presence_;
  ElasticFinger elastic_;
};

}  // namespace

EffectKind effect_body() {
  return effect_kind<ElasticBody>(
      "body", 54, en::say("The finger's body deforms under load"),
      "shore_a: 40, wall_mm: 4, base_depth_mm: 30, tip_depth_mm: 10, coupling: 0.5", {"push"});
}

}  // namespace alltact
