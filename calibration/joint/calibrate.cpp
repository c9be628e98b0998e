#include "calibration/joint/calibrate.h"

#include "calibration/joint/contact_model.h"
#include "calibration/joint/joint_fit.h"
#include "calibration/joint/known_shape.h"
#include "calibration/joint/light_spread_fit.h"
#include "calibration/joint/mapping_curve.h"
#include "calibration/joint/outline_methods.h"
#include "calibration/joint/spread_shapes.h"
#include "calibration/presses/press.h"
#include "calibration/verdict/verdict.h"
#include "core/base/job.h"
#include "core/base/message.h"
#include "core/finger/finger.h"
#include "core/sensing/depth/light_spread.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <future>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Dense>

namespace alltact {
namespace {

constexpr int kFineSamples = 1500;   // a press, for the solution
constexpr int kCoarseSamples = 400;  // a press, for the choice of the model
// of these in the inner zone, where skin and ball touch
constexpr std::ptrdiff_t kMinBallSamples = 16;
// Fractions of a calibration's progress, roughly as its time.
constexpr double kBallsFound = 0.2, kSpreadKnown = 0.5, kShapesKnown = 0.6, kModelKnown = 0.9;

bool same_image(const Press& a, const Press& b) {
  const cv::Mat& x = a.difference.x;
  const cv::Mat& y = b.difference.x;
  if (x.size() != y.size() || x.type() != y.type()) return false;
  for (int row = 0; row < x.rows; ++row)
    if (std::memcmp(x.ptr(row), y.ptr(row), static_cast<std::size_t>(x.cols) * x.elemSize()) != 0)
      return false;
  return true;
}

std::ptrdiff_t contact_samples(const PressSamples& press, const Eigen::Vector3d& centre_mm) {
  const ContactDisc disc(press, MappingAlong::kNormal, centre_mm);
  return std::count_if(press.samples.begin(), press.samples.end(), [&](const Sample& sample) {
    return disc.position_of(sample).radius < kInnerZone;
  });
}

/// An order by the measurements only, so that results do not depend on the order of the presses.
bool before(const FoundBall& a, const FoundBall& b) {
  const auto key = [](const FoundBall& f) {
    double sum = 0;
    for (const Sample& sample : f.fine.samples) sum += sample.x;
    return std::tuple(f.fine.samples.size(), sum, f.guess.centre_mm.x(), f.guess.centre_mm.y());
  };
  return key(a) < key(b);
}

/// Finds the balls of all presses made with one, in an order that depends only on the measurements.
/// `unusable` receives a sentence without full stop for each other press: no ball to be found, the
/// same image as another press, too few samples in the contact. A stopped job ends it early.
std::vector<FoundBall> find_balls(const std::vector<Press>& presses, const Face& face,
                                  const Job& job, std::vector<Message>* unusable) {
  std::vector<FoundBall> found;
  for (std::size_t i = 0; i < presses.size() && !job.stop_requested(); ++i) {
    const Press& press = presses[i];
    if (!press.is_ball()) continue;
    job.report(static_cast<double>(i) / static_cast<double>(presses.size()),
               en::say("looking for the ball in {}", press.name));
    const auto duplicate =
        std::find_if(presses.begin(), presses.begin() + static_cast<std::ptrdiff_t>(i),
                     [&](const Press& p) { return same_image(p, press); });
    if (duplicate != presses.begin() + static_cast<std::ptrdiff_t>(i)) {
      unusable->push_back(en::at(Message::typed(press.name),
                                 en::say("the same image as {}, counted once", duplicate->name)));
      continue;
    }
    auto guess =
        press.ball_mm ? guess_of_manual_ball(press, face, *press.ball_mm) : find_ball(press, face);
    if (!guess) {
      unusable->push_back(guess.error().message());
      continue;
    }
    const Eigen::Vector3d& centre = guess->centre_mm;
    const double reach = 1.06 * press.ball_radius_mm;
    FoundBall one{&press, *guess, sample_around(press, face, centre, reach, kFineSamples),
                  sample_around(press, face, centre, reach, kCoarseSamples)};
    if (contact_samples(one.coarse, centre) < kMinBallSamples) {
      unusable->push_back(Error{en::say("the contact covers too few pixels"), press.name,
                                en::say("pressing deeper, or a larger image")}
                              .message());
      continue;
    }
    found.push_back(std::move(one));
  }
  std::stable_sort(found.begin(), found.end(), before);
  return found;
}

bool is_far(double measured, double seen, double measured_sd, double seen_sd) {
  return std::abs(measured - seen) > kContradictionSds * std::hypot(measured_sd, seen_sd);
}

/// Steps and bodies as a fitted curve measures them.
void record_shapes(const std::vector<KnownShape>& shapes, const std::vector<Press>& presses,
                   const MappingCurve& curve, MappingAlong along, Calibration* calibration) {
  for (const KnownShape& shape : shapes) {
    const ScaleReading reading = read_scale(shape, curve, curve.values().data(), along);
    const std::string& name = press_of(shape);
    if (const auto* step = std::get_if<StepSamples>(&shape)) {
      calibration->steps.push_back(
          {name, step->step_mm, reading.scale * step->step_mm, reading.sd * step->step_mm});
      continue;
    }
    const auto press = std::find_if(presses.begin(), presses.end(),
                                    [&](const Press& one) { return one.name == name; });
    calibration->bodies.push_back({name, press->body->file, reading.scale, reading.sd});
  }
}

/// Why a shape was left out, where the balls give its scale.
Message contradiction(const KnownShape& shape, double scale, double sd) {
  const auto* step = std::get_if<StepSamples>(&shape);
  return en::at(
      Message::typed(press_of(shape)),
      step != nullptr
          ? en::say("its step of {:.3f} mm was left out, because the balls show "
                    "{:.3f} +- {:.3f} mm; check the balls' radius",
                    step->step_mm, scale * step->step_mm, sd * step->step_mm)
          : en::say("its body was left out, because the balls show {:.1f} +- {:.1f} % of the "
                    "depth that its shape has; check the balls' radius and the body's mesh",
                    100 * scale, 100 * sd));
}

/// What the balls show without measured depths and other bodies.
struct BallsAlone {
  std::vector<PressSamples> presses;  // coarse
  ModelChoice choice;
  Eigen::MatrixXd covariance;  // empty: the images leave the depth open
};

std::optional<BallsAlone> solve_balls_alone(const std::vector<FoundBall>& found,
                                            const CalibrationSettings& settings, const Job& job) {
  std::vector<PressSamples> presses;
  ChoiceInput input;
  for (const FoundBall& one : found) {
    presses.push_back(one.coarse);
    presses.back().given_depth.reset();
    input.centres_mm.push_back(one.guess.centre_mm);
  }
  for (const PressSamples& samples : presses) input.presses.push_back(&samples);
  auto choice = choose_model(input, settings, job);
  if (!choice) return std::nullopt;
  Eigen::MatrixXd covariance = covariance_of(input.presses, choice->fit, choice->options);
  return BallsAlone{std::move(presses), std::move(*choice), std::move(covariance)};
}

/// Drops measured depths that contradict the images by more than four standard deviations of both:
/// a gauge that was not set to zero must not stretch all depths. `reasons` receives why.
void drop_depths(const BallsAlone& alone, std::vector<FoundBall>& presses,
                 std::vector<Message>* reasons) {
  const JointFit& fit = alone.choice.fit;
  const Eigen::Index numbers = fit.curve.values().size();
  for (std::size_t i = 0; i < presses.size(); ++i) {
    const auto& measured = presses[i].fine.given_depth;
    if (!measured) continue;
    const PressedPlane plane = plane_below(alone.presses[i], fit.centres_mm[i]);
    const auto first = numbers + 3 * static_cast<Eigen::Index>(i);
    const double seen_mm = alone.presses[i].ball_radius_mm - plane.height_mm(fit.centres_mm[i]);
    const double seen_sd_mm = std::sqrt(
        std::max(0.0, plane.normal.dot(alone.covariance.block<3, 3>(first, first) * plane.normal)));
    if (!is_far(measured->mm, seen_mm, measured->sd_mm, seen_sd_mm)) continue;
    reasons->push_back(en::at(
        Message::typed(presses[i].press->name),
        en::say(
            "its measured depth of {:.3f} +- {:.3f} mm was left out, because the images show "
            "{:.3f} +- {:.3f} mm; depth counts from the ball's first contact, normal to the face",
            measured->mm, measured->sd_mm, seen_mm, seen_sd_mm)));
    presses[i].coarse.given_depth.reset();
    presses[i].fine.given_depth.reset();
  }
}

/// The same for the scale by steps and bodies.
void drop_shapes(const BallsAlone& alone, std::vector<KnownShape>& shapes,
                 std::vector<Message>* reasons) {
  const MappingCurve& curve = alone.choice.fit.curve;
  const Eigen::Index numbers = curve.values().size();
  std::erase_if(shapes, [&](const KnownShape& shape) {
    const ScaleReading seen =
        read_scale(shape, curve, curve.values().data(), alone.choice.options.along);
    const double seen_sd = std::sqrt(std::max(
        0.0,
        seen.by_values.dot(alone.covariance.topLeftCorner(numbers, numbers) * seen.by_values)));
    if (!is_far(1, seen.scale, seen.sd, seen_sd)) return false;
    reasons->push_back(contradiction(shape, seen.scale, std::hypot(seen.sd, seen_sd)));
    return true;
  });
}

/// Steps of punches, other bodies and measured depths that agree with the balls; the rest is
/// dropped, and `calibration` receives why. Nothing is dropped where the images of the balls leave
/// the depth open, and no body is found where they give no mapping.
std::vector<KnownShape> known_shapes(const std::vector<Press>& presses, const Face& face,
                                     const PressedArea& area, const CalibrationSettings& settings,
                                     const Job& job, std::vector<FoundBall>& found,
                                     Calibration* calibration) {
  std::vector<KnownShape> shapes = find_steps(presses, face, &calibration->left_out);
  for (KnownShape& shape : shapes) set_unit_positions(area, &samples_of(shape));
  const bool any_depth = std::any_of(found.begin(), found.end(), [](const FoundBall& one) {
    return one.fine.given_depth.has_value();
  });
  const bool any_body = std::any_of(presses.begin(), presses.end(),
                                    [](const Press& press) { return press.body.has_value(); });
  if (!any_depth && !any_body && shapes.empty()) return shapes;
  const auto alone = solve_balls_alone(found, settings, Job(job, 0, 0.5));
  if (!alone) return shapes;
  for (KnownShape& body :
       find_bodies(presses, face, area, alone->choice.fit.curve, alone->choice.options.along,
                   Job(job, 0.5, 1), &calibration->left_out))
    shapes.push_back(std::move(body));
  if (alone->covariance.size() == 0) return shapes;
  drop_depths(*alone, found, &calibration->left_out);
  drop_shapes(*alone, shapes, &calibration->left_out);
  return shapes;
}

Error no_press(const std::vector<Press>& presses, const std::vector<Message>& left_out) {
  if (presses.empty())
    return {en::say("no press was given"), "", en::say("at least one image of a pressed ball")};
  if (std::none_of(presses.begin(), presses.end(), [](const Press& p) { return p.is_ball(); }))
    return {en::say("there are only presses of bodies other than balls"), "",
            en::say("pressing a ball at least once as well: other bodies show the scale of depth, "
                    "not its curve")};
  return {
      en::say("none of {} presses could be used: {}", presses.size(), en::sentences(left_out)), "",
      en::say(
          "images in which the ball, and nothing else, is pressed 0.3 mm or more into the face")};
}

Error stopped() { return {en::say("stopped before there was a solution"), "", ""}; }

double deepest_mm(const FoundBall& found, const Eigen::Vector3d& centre) {
  double depth = 0;
  for (const Sample& sample : found.fine.samples) {
    const double here = ball_depth_mm(sample, MappingAlong::kZ, centre, found.fine.ball_radius_mm);
    if (std::isfinite(here)) depth = std::max(depth, here);
  }
  return depth;
}

/// Residuals are those of the inner zone, whichever zone the fit read, so that fits can be
/// compared.
JointOptions with_inner_zone(JointOptions options) {
  options.zone = kInnerZone;
  return options;
}

std::vector<BallFit> balls_of(const std::vector<FoundBall>& found, const ModelChoice& choice,
                              const JointFit& fit, const Eigen::MatrixXd& covariance,
                              const Job& job) {
  std::vector<const PressSamples*> presses;
  for (const FoundBall& f : found) presses.push_back(&f.fine);
  const FitQuality quality = quality_of(presses, fit, with_inner_zone(choice.options));
  std::vector<BallFit> balls;
  for (std::size_t i = 0; i < found.size(); ++i) {
    BallFit ball;
    ball.press = found[i].press->name;
    ball.radius_mm = found[i].press->ball_radius_mm;
    ball.centre_mm = fit.centres_mm[i];
    ball.centre_sd_mm.setZero();
    if (covariance.size() > 0) {
      const Eigen::Index first = fit.curve.values().size() + 3 * static_cast<Eigen::Index>(i);
      ball.centre_sd_mm = covariance.diagonal().segment<3>(first).cwiseSqrt();
    }
    ball.depth_mm = deepest_mm(found[i], ball.centre_mm);
    // The same measure and samples as for held-out presses.
    const double error_mm =
        error_of_press(found[i].coarse, fit, fit.centres_mm[i], choice.options, job);
    ball.residual_mm = std::isfinite(error_mm) ? error_mm : quality.residual_mm[i];
    ball.held_out_mm = i < choice.held_out_mm.size() ? choice.held_out_mm[i] : 0.0;
    ball.tangent_arc_deg = found[i].tangent_arc_deg;
    ball.cut_by_edge = found[i].guess.cut_by_edge;
    ball.given_depth = found[i].fine.given_depth;
    ball.indentation_mm =
        ball.radius_mm - plane_below(*presses[i], ball.centre_mm).height_mm(ball.centre_mm);
    balls.push_back(std::move(ball));
  }
  return balls;
}

/// Why no mapping fits: darkness does not show depths beyond the layer's thickness.
Error no_mapping(const std::vector<FoundBall>& found, const Face& face) {
  constexpr double kTooDeep = 0.8;  // of the layer
  const FoundBall* deepest = nullptr;
  double depth_mm = 0;
  for (const FoundBall& f : found) {
    const double here_mm = deepest_mm(f, f.guess.centre_mm);
    if (here_mm > depth_mm) depth_mm = here_mm, deepest = &f;
  }
  if (deepest != nullptr && depth_mm > kTooDeep * face.layer_mm)
    return {en::say("the ball is {:.1f} mm deep in a layer of {:g} mm", depth_mm, face.layer_mm),
            deepest->press->name,
            en::say("pressing less deep, and checking the ball's radius and the camera's scale in "
                    "mm per px")};
  return {
      en::say("no increasing mapping fits the presses"), "",
      en::say(
          "leaving out presses with the largest residual, a lower degree, or checking the ball's "
          "radius")};
}

double face_length_mm(const std::vector<FoundBall>& found) {
  double length = 0;
  for (const FoundBall& f : found) {
    const FaceShape& shape = f.press->shape;
    length = std::max({length, shape.length_at(0), shape.length_at(shape.width_px() - 1)});
  }
  return length;
}

double mean_of(const std::vector<BallFit>& balls, double BallFit::*member) {
  double mean = 0;
  for (const BallFit& ball : balls) mean += ball.*member / static_cast<double>(balls.size());
  return mean;
}

/// Mean absolute depth error over the domain of a curve with this covariance of its values.
double mean_error_mm(const MappingCurve& curve, const Eigen::MatrixXd& covariance) {
  constexpr int kPoints = 12;
  Eigen::VectorXd gradient(curve.values().size());
  double mean = 0;
  for (int i = 1; i <= kPoints; ++i) {
    (void)curve.depth_mm(curve.x_max() * i / kPoints, gradient.data());
    mean += kMeanOfSd * std::sqrt(std::max(0.0, gradient.dot(covariance * gradient))) / kPoints;
  }
  return mean;
}

void sort_as_given(const std::vector<Press>& presses, std::vector<BallFit>* balls) {
  const auto given_order = [&](const BallFit& ball) {
    return std::find_if(presses.begin(), presses.end(),
                        [&](const Press& p) { return p.name == ball.press; });
  };
  std::stable_sort(balls->begin(), balls->end(), [&](const BallFit& a, const BallFit& b) {
    return given_order(a) < given_order(b);
  });
}

/// The test for spread light; nullopt: the settings forbid it, or the presses do not allow it.
std::optional<LightSpreadFit> tested_light_spread(const std::vector<FoundBall>& found,
                                                  const Face& face,
                                                  const CalibrationSettings& settings,
                                                  const Job& job, SpreadShapes& shapes) {
  const bool is_allowed =
      settings.light_spread == LightSpreadChoice::kAuto && settings.degree == 0 &&
      (settings.family == FamilyChoice::kAuto || settings.family == FamilyChoice::kMoebius) &&
      (settings.along == AlongChoice::kAuto || settings.along == AlongChoice::kNormal);
  if (!is_allowed) return std::nullopt;
  job.report(0, en::say("looking for light that spreads"));
  std::vector<BallStart> balls;
  for (const FoundBall& one : found) balls.push_back({one.press, one.guess.centre_mm});
  return fit_light_spread(
      balls, face, [&](const MappingParameters& mapping) { return shapes.read(mapping); }, job);
}

/// The stored covariance, so that the mean error over the domain is at least `least_mm`.
Eigen::MatrixXd at_least(double least_mm, const MappingCurve& curve,
                         const Eigen::MatrixXd& covariance) {
  const double inflation = std::max(1.0, least_mm / mean_error_mm(curve, covariance));
  return inflation * inflation * covariance;
}

/// Steps and bodies that the fit of a layer that spreads light used, and why not the others.
void record_spread_shapes(const LightSpreadFit& fit, const SpreadShapes& shapes,
                          const std::vector<Press>& presses, const MappingParameters& mapping,
                          Calibration* calibration) {
  calibration->left_out.insert(calibration->left_out.end(), shapes.left_out().begin(),
                               shapes.left_out().end());
  std::vector<KnownShape> used;
  for (std::size_t i = 0; i < fit.scales.size(); ++i) {
    const ScaleByBalls& seen = fit.scales[i];
    const KnownShape& shape = shapes.shapes()[i];
    if (seen.agrees)
      used.push_back(shape);
    else
      calibration->left_out.push_back(contradiction(shape, seen.scale, seen.sd));
  }
  record_shapes(used, presses, curve_of(mapping), MappingAlong::kNormal, calibration);
}

/// The calibration of a layer that spreads light, from its fit. Figures of presses are those of
/// the brightness without the spread.
Result<Calibration> solve_with_spread(const std::vector<Press>& presses,
                                      const std::vector<FoundBall>& found, const Face& face,
                                      const LightSpreadFit& fit, const SpreadShapes& shapes,
                                      const Job& job, Calibration calibration) {
  // Error of the formulas of light_spread.h, of a depth, and common to all presses: together with
  // the fit's own deviation 0.06, as on fingers of the renderer in tests/foreign.
  constexpr double kFormula = 0.05;
  calibration.mapping = fit.mapping;
  std::vector<Press> local;
  for (const FoundBall& one : found) local.push_back(without_light_spread(*one.press, fit.mapping));
  std::vector<FoundBall> balls = found;
  ChoiceInput coarse;
  const PressedArea area{fit.mapping.variation.middle_mm, fit.mapping.variation.half_mm};
  for (std::size_t i = 0; i < balls.size(); ++i) {
    FoundBall& ball = balls[i];
    ball.press = &local[i];
    const double reach = 1.06 * ball.press->ball_radius_mm;
    ball.fine = sample_around(local[i], face, fit.centres_mm[i], reach, kFineSamples);
    ball.coarse = sample_around(local[i], face, fit.centres_mm[i], reach, kCoarseSamples);
    set_unit_positions(area, &ball.fine);
    set_unit_positions(area, &ball.coarse);
    coarse.presses.push_back(&ball.coarse);
    coarse.centres_mm.push_back(fit.centres_mm[i]);
  }
  calibration.mapping.x_max = domain_of(coarse, MappingAlong::kNormal);
  if (const auto mapping = Mapping::create(calibration.mapping); !mapping)
    return Error{en::say("the solution is not a valid mapping: {}", mapping.error().what), "",
                 en::say("more presses of different depth, or --light-spread local")};
  const JointFit solution{curve_of(calibration.mapping), fit.centres_mm, true, fit.lift_mm};
  JointOptions options;
  options.along = MappingAlong::kNormal;
  const ModelChoice choice{options, solution, {}, 0, {}, {}};

  const Eigen::Index n = solution.curve.values().size();
  Eigen::MatrixXd covariance =
      Eigen::MatrixXd::Zero(n + fit.centre_covariance.rows(), n + fit.centre_covariance.rows());
  covariance.topLeftCorner(n, n) = fit.mapping.covariance;
  for (Eigen::Index i = 0; i < fit.centre_covariance.rows(); i += 3)
    covariance.block<3, 3>(n + i, n + i) = fit.centre_covariance.block<3, 3>(i, 0);
  calibration.balls = balls_of(balls, choice, solution, covariance, job);
  for (std::size_t i = 0; i < calibration.balls.size(); ++i) {
    BallFit& ball = calibration.balls[i];
    if (i < fit.held_out_mm.size())
      ball.held_out_mm = std::hypot(ball.residual_mm, fit.held_out_mm[i]);
    calibration.spread_mm += std::hypot(ball.held_out_mm, kFormula * ball.indentation_mm) /
                             static_cast<double>(calibration.balls.size());
  }
  calibration.mapping.covariance =
      at_least(calibration.spread_mm, solution.curve, fit.mapping.covariance);
  calibration.weakest = weakest_direction(solution.curve, calibration.mapping.covariance);
  if (!job.stop_requested())
    calibration.radius_sensitivity = vary_radius(coarse.presses, solution, choice.options, job);
  if (!job.stop_requested())
    calibration.next_press =
        advise(coarse.presses, solution, choice.options, face_length_mm(balls));
  calibration.residual_mm = mean_of(calibration.balls, &BallFit::residual_mm);
  calibration.held_out_mm = mean_of(calibration.balls, &BallFit::held_out_mm);
  record_spread_shapes(fit, shapes, presses, calibration.mapping, &calibration);
  calibration.degree_choice =
      en::at(solution.curve.family().name(), en::say("the curve of a layer that spreads light"));
  const LightSpread& spread = fit.mapping.spread;
  calibration.remarks.push_back(
      en::say("the layer spreads light: {:.0f} % comes back where it went in, the rest from about "
              "{:.1f} mm around; depth is read with that undone",
              100.0 * oblique_spread(spread, 1.0).core, skirt_width_mm(spread, face.layer_mm)));
  return calibration;
}

/// Fits all fine samples, first by brightness alone. That fit shows where to search for the balls'
/// outlines; a second fit includes the outlines found.
JointFit fit_finely(std::vector<FoundBall>& found, const ModelChoice& choice, const Job& job,
                    const RoundListener& on_round) {
  std::vector<const PressSamples*> presses;
  for (const FoundBall& f : found) presses.push_back(&f.fine);
  JointOptions options = choice.options;
  options.watch = [&](int round, double change_mm, const JointFit& now) {
    job.report(kModelKnown, en::say("solving: round {}", round));
    if (!on_round) return;
    double residual_mm = 0;
    for (const double each_mm : quality_of(presses, now, with_inner_zone(options)).residual_mm)
      residual_mm += each_mm / static_cast<double>(presses.size());
    on_round({round, residual_mm, change_mm});
  };
  JointFit fit = fit_jointly(presses, choice.fit, options, job);
  if (!fit.converged) return choice.fit;  // stopped: returns the best so far
  bool seen = false;
  for (std::size_t i = 0; i < found.size(); ++i) {
    TangentArc arc =
        find_tangent_arc(*found[i].press, fit.centres_mm[i], found[i].press->ball_radius_mm);
    found[i].tangent_arc_deg = arc.arc_deg;
    found[i].fine.outline = std::move(arc.points);
    seen = seen || !found[i].fine.outline.empty();
  }
  if (!seen) return fit;
  JointFit with_outlines = fit_jointly(presses, fit, options, job);
  return with_outlines.converged ? with_outlines : fit;
}

/// Set where the balls would be deeper on average than the layer is thick, with a tenth for errors
/// of both: the brightness of these presses follows no curve.
std::optional<Error> beyond_layer(const std::vector<BallFit>& balls, const Face& face) {
  const double depth_mm = mean_of(balls, &BallFit::indentation_mm);
  if (!(depth_mm > 1.1 * face.layer_mm)) return std::nullopt;
  return Error{
      en::say("the balls would be {:.2f} mm deep in a layer of {:.2f} mm", depth_mm, face.layer_mm),
      "", en::say("checking the layer's thickness and the ball's radius, or more presses")};
}

Result<Calibration> solve_jointly(const std::vector<Press>& presses, std::vector<FoundBall> found,
                                  const Face& face, const CalibrationSettings& settings,
                                  const Job& job, const RoundListener& on_round,
                                  Calibration calibration) {
  std::vector<const PressSamples*> fine;
  for (const FoundBall& f : found) fine.push_back(&f.fine);
  const PressedArea part = pressed_area(fine);
  for (FoundBall& f : found) {
    set_unit_positions(part, &f.fine);
    set_unit_positions(part, &f.coarse);
  }
  const Job spread_job(job, kBallsFound, kSpreadKnown);
  SpreadShapes in_spread_light(presses, face, spread_job);
  if (const auto spread = tested_light_spread(found, face, settings, spread_job, in_spread_light)) {
    calibration.undetected_spread =
        spread->is_seen ? 0.0 : 1.0 / (1.0 + std::exp(-spread->log_evidence));
    if (spread->is_seen)
      return solve_with_spread(presses, found, face, *spread, in_spread_light, job,
                               std::move(calibration));
  }
  const std::vector<KnownShape> shapes = known_shapes(
      presses, face, part, settings, Job(job, kSpreadKnown, kShapesKnown), found, &calibration);
  ChoiceInput coarse;
  coarse.max_rounds = settings.iterations;
  if (!shapes.empty()) coarse.shapes = &shapes;
  for (const FoundBall& f : found) {
    coarse.presses.push_back(&f.coarse);
    coarse.centres_mm.push_back(f.guess.centre_mm);
  }
  auto choice = choose_model(coarse, settings, Job(job, kShapesKnown, kModelKnown));
  if (!choice && job.stop_requested()) return stopped();
  if (!choice) return no_mapping(found, face);
  job.report(kModelKnown, en::say("solving all presses together"));
  choice->options.settled_mm = JointOptions{}.settled_mm;
  JointFit fit = fit_finely(found, *choice, job, on_round);
  if (settings.family == FamilyChoice::kAuto && settings.degree == 0 && !job.stop_requested() &&
      fit.curve.family().kind == MappingKind::kPolynomial &&
      !increases(fit.curve, choice->options.along)) {
    // A polynomial that increases on the coarse samples may decrease on the fine ones.
    CalibrationSettings simple = settings;
    simple.family = FamilyChoice::kLayer;
    if (auto safe = choose_model(coarse, simple, Job(job, kModelKnown, kModelKnown))) {
      safe->sentence = en::say("{}, because the {} does not increase on all samples",
                               safe->fit.curve.family().name(), fit.curve.family().name());
      choice = std::move(safe);
      choice->options.settled_mm = JointOptions{}.settled_mm;
      fit = fit_finely(found, *choice, job, on_round);
    }
  }
  const Eigen::MatrixXd covariance =
      covariance_of(fine, fit, choice->options, &calibration.condition);

  calibration.mapping = mapping_parameters(fit.curve, choice->options.along, part);
  const Eigen::Index n = fit.curve.values().size();
  if (covariance.size() > 0) {
    Eigen::MatrixXd by_values;
    (void)stored_form(fit.curve, &by_values);
    const Eigen::MatrixXd by_residuals = covariance.topLeftCorner(n, n);
    // The jackknife may exceed the covariance of the residuals.
    const Eigen::MatrixXd stored =
        by_values * at_least(choice->spread_mm, fit.curve, by_residuals) * by_values.transpose();
    calibration.mapping.covariance = 0.5 * (stored + stored.transpose());
  }
  if (const auto mapping = Mapping::create(calibration.mapping); !mapping)
    return Error{en::say("the solution is not a valid mapping: {}", mapping.error().what), "",
                 en::say("more presses of different depth, or a lower degree")};
  if (covariance.size() > 0)
    calibration.weakest = weakest_direction(fit.curve, covariance.topLeftCorner(n, n));
  auto advice = std::async(std::launch::async, [&]() -> std::optional<PressAdvice> {
    if (job.stop_requested()) return std::nullopt;
    return advise(fine, fit, choice->options, face_length_mm(found));
  });
  if (!job.stop_requested())
    calibration.radius_sensitivity = vary_radius(coarse.presses, fit, choice->options, job);
  calibration.balls = balls_of(found, *choice, fit, covariance, job);
  calibration.next_press = advice.get();
  if (const auto impossible = beyond_layer(calibration.balls, face)) return *impossible;
  record_shapes(shapes, presses, fit.curve, choice->options.along, &calibration);
  calibration.residual_mm = mean_of(calibration.balls, &BallFit::residual_mm);
  calibration.held_out_mm = mean_of(calibration.balls, &BallFit::held_out_mm);
  calibration.spread_mm = choice->spread_mm;
  const Eigen::MatrixXd chance = chance_covariance_of(fine, fit, choice->options);
  if (chance.size() > 0 && found.size() > 1)
    calibration.spread_mm =
        std::max(calibration.spread_mm, mean_error_mm(fit.curve, chance.topLeftCorner(n, n)));
  calibration.degree_choice = choice->sentence;
  calibration.remarks.insert(calibration.remarks.end(), choice->remarks.begin(),
                             choice->remarks.end());
  if (found.size() == 1)
    calibration.remarks.push_back(
        en::say("one press cannot separate the ball's depth from the mapping: add presses of "
                "different depth at other positions"));
  if (covariance.size() == 0)
    calibration.remarks.push_back(
        en::say("the presses do not determine every unknown: add presses"));
  return calibration;
}

}  // namespace

Result<Calibration> calibrate(const std::vector<Press>& presses, const Camera& camera,
                              const Face& face, const CalibrationSettings& settings, const Job& job,
                              const RoundListener& on_round) {
  for (const Press& press : presses)
    if (press.is_ball() && (!(press.ball_radius_mm > 0.0) || !std::isfinite(press.ball_radius_mm)))
      return Error{en::say("a ball radius of {} mm is impossible", press.ball_radius_mm),
                   press.name, en::say("the radius in millimetres, as measured with callipers")};
  try {
    if (settings.method == CalibrationMethod::kPaper)
      return calibrate_as_paper(presses, camera, face, job);
    Calibration calibration;
    std::vector<Message> unusable;
    const std::vector<FoundBall> found =
        find_balls(presses, face, Job(job, 0, kBallsFound), &unusable);
    if (found.empty()) return job.stop_requested() ? stopped() : no_press(presses, unusable);
    for (const Message& reason : unusable) calibration.left_out.push_back(en::say("{}.", reason));
    Result<Calibration> result =
        settings.method == CalibrationMethod::kJoint
            ? solve_jointly(presses, found, face, settings, job, on_round, std::move(calibration))
            : calibrate_by_outline(found, settings.method, face, job, std::move(calibration));
    if (result) sort_as_given(presses, &result->balls);
    job.report(1.0, en::say("done"));
    return result;
  } catch (const std::exception& problem) {
    return Error{en::say("the calibration failed: {}", std::string(problem.what())), "",
                 en::say("fewer presses")};
  }
}

namespace {

MethodRow row_of(CalibrationMethod method, const Calibration& made, const Calibration& joint) {
  MethodRow row;
  row.method = method;
  row.presses = static_cast<int>(made.balls.size());
  row.residual_mm = made.residual_mm;
  for (const BallFit& ball : made.balls) row.press_depth_mm += ball.depth_mm / row.presses;
  const auto mapping = Mapping::create(made.mapping), reads = Mapping::create(joint.mapping);
  if (!mapping || !reads) {
    row.failed = en::say("no mapping resulted");
    return row;
  }
  const double x = std::min(mapping->x_max(), reads->x_max());
  row.at_depth_mm = mapping->depth_mm(x);
  row.joint_depth_mm = reads->depth_mm(x);
  return row;
}

}  // namespace

std::vector<MethodRow> compare_methods(const std::vector<Press>& presses,
                                       const Result<std::vector<Press>>& as_paper,
                                       const Camera& camera, const Face& face,
                                       const Calibration& joint, const Job& job) {
  std::vector<MethodRow> rows{row_of(CalibrationMethod::kJoint, joint, joint)};
  for (const CalibrationMethod method :
       {CalibrationMethod::kPaper, CalibrationMethod::kCircle, CalibrationMethod::kCone}) {
    CalibrationSettings settings;
    settings.method = method;
    const bool is_paper = method == CalibrationMethod::kPaper;
    const double made_before = static_cast<double>(rows.size() - 1);
    const Job section(job, made_before / 3, (made_before + 1) / 3);
    const auto made = is_paper && !as_paper ? Result<Calibration>(as_paper.error())
                                            : calibrate(is_paper ? *as_paper : presses, camera,
                                                        face, settings, section);
    if (job.stop_requested()) break;
    if (made) {
      rows.push_back(row_of(method, *made, joint));
    } else {
      rows.push_back({});
      rows.back().method = method;
      rows.back().failed = made.error().what;
    }
  }
  return rows;
}

}  // namespace alltact
