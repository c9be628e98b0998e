#include "calibration/twin/twin_contact.h"

#include "calibration/twin/contact_study.h"

#include <algorithm>
#include <cmath>

namespace alltact {
namespace {

constexpr double kMaxKindResidual = 0.99;  // of the residual with the simpler kind
constexpr double kNothing_sd = 2;          // nearer to zero counts as zero
constexpr double kLeastBlur_px = 0.25;     // narrower is invisible

struct ContactRound {
  TwinScene scene;
  ContactSpread spread;
  double rms = 0;
};

class ContactSearch {
 public:
  ContactSearch(const std::vector<TwinPatch>& patches,
                const std::vector<TwinPress>& presses,
                const Job& job)
      : patches_(patches), presses_(presses), job_(job) {}

  [[nodiscard]] Result<ContactRound> solve(const TwinScene& from,
                                           ContactChoice choice,
                                           TwinEffort effort) const {
    if (job_.stop_requested()) return Error{en::say("stopped before the twin was found"), "", ""};
    const ContactStudy study(from, patches_, presses_, choice);
    auto solution = solve_twin(
        [&](const Eigen::VectorXd& x, Eigen::VectorXd& r, Eigen::MatrixXd* slopes) {
          return study.evaluate(x, r, slopes);
        },
        study.unknowns(),
        study.residuals(),
        effort,
        job_);
    if (!solution) return solution.error();
    return ContactRound{study.scene_at(solution->x), study.spread_of(*solution), solution->rms()};
  }

  /// One kind of roll-off and halo, first with fixed light: a halo must not be explained by
  /// brighter lamps.
  [[nodiscard]] Result<ContactRound> solve_kind(TwinScene from,
                                                TwinRolloff rolloff,
                                                TwinHalo halo) const {
    if (from.rolloff != rolloff) from.rolloff_mm = 0.15;
    from.rolloff = rolloff;
    from.halo = halo;
    return solve(from, {true, true, false}, {40, 1e-5});
  }

 private:
  const std::vector<TwinPatch>& patches_;
  const std::vector<TwinPress>& presses_;
  const Job& job_;
};

bool is_nothing(double value, const std::optional<double>& sd) {
  return !sd || value < kNothing_sd * *sd;
}

/// The simplest scene with an equally small residual.
Result<ContactRound> simplify(const ContactSearch& search, ContactRound round) {
  ContactChoice choice;
  TwinScene simple = round.scene;
  choice.coat = !is_nothing(simple.layer.coat, round.spread.coat);
  choice.blur = simple.blur_px > kLeastBlur_px && !is_nothing(simple.blur_px, round.spread.blur_px);
  const bool no_halo = is_nothing(simple.halo_share, round.spread.halo_share);
  if (!choice.coat) simple.layer.coat = 0;
  if (!choice.blur) simple.blur_px = 0;
  if (no_halo) simple.halo = TwinHalo::kNone;
  if (choice.coat && choice.blur && !no_halo) return round;
  // The powers follow the layer.
  const double t = simple.face.layer_mm;
  const double share = round.scene.layer.reflectance(t) / simple.layer.reflectance(t);
  for (TwinLamp& lamp : simple.lamps) lamp.power *= share;
  simple.room_level *= share;
  auto last = search.solve(simple, choice, {});
  if (!last) return last.error();
  // A removed part was significant after all: the presses need it.
  if (last->rms > 1.02 * round.rms) return search.solve(round.scene, {}, {});
  return last;
}

}  // namespace

Result<TwinContact> fit_contact(const TwinScene& scene,
                                const std::vector<TwinPatch>& coarse,
                                const std::vector<TwinPatch>& patches,
                                const std::vector<TwinPress>& presses,
                                const Job& job) {
  const ContactSearch search(coarse, presses, job);
  job.report(0.0, en::say("fitting the presses"));
  // Starts over a black coat, with the visible halo or a typical one. Depth and scattering are
  // correlated, and a fit of all parameters at once may converge anywhere.
  std::optional<ContactRound> begun;
  TwinScene typical = scene;
  typical.halo_share = 0.06, typical.halo_width_mm = scene.face.layer_mm;
  for (const TwinScene& from : {scene, typical}) {
    auto round = search.solve(from, {false, true, false}, {40, 1e-4});
    if (!round) return round.error();
    if (!begun || round->rms < begun->rms) begun = std::move(*round);
  }
  auto hertz = search.solve_kind(begun->scene, TwinRolloff::kHertz, TwinHalo::kGaussian);
  if (!hertz) return hertz.error();
  auto exponential = search.solve_kind(hertz->scene, TwinRolloff::kHertz, TwinHalo::kExponential);
  if (!exponential) return exponential.error();
  const bool is_long = exponential->rms < kMaxKindResidual * hertz->rms;
  if (is_long) hertz = std::move(exponential);
  job.report(0.3, en::say("fitting the presses"));
  auto smooth = search.solve_kind(hertz->scene, TwinRolloff::kSmooth, hertz->scene.halo);
  if (!smooth) return smooth.error();
  const bool is_smooth = smooth->rms < kMaxKindResidual * hertz->rms;
  job.report(0.5, en::say("fitting the presses"));
  const ContactSearch closer(patches, presses, job);
  auto all = closer.solve((is_smooth ? smooth : hertz)->scene, {}, {40, 1e-5});
  if (!all) return all.error();
  auto best = simplify(closer, *all);
  if (!best) return best.error();
  return TwinContact{best->scene,
                     best->spread,
                     best->rms,
                     is_smooth ? TwinRolloff::kHertz : TwinRolloff::kSmooth,
                     (is_smooth ? hertz : smooth)->rms / (is_smooth ? smooth : hertz)->rms};
}

}  // namespace alltact
