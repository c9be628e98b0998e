#include "calibration/checks/ball_by_shape.h"

#include "calibration/joint/joint_fit.h"
#include "calibration/presses/press_samples.h"
#include "calibration/report/press_residuals.h"

#include <algorithm>
#include <cmath>

namespace alltact {
namespace {

constexpr int kSamplesOfBall = 1500;
constexpr std::size_t kMinSamplesOfBall = 60;

}  // namespace

double reading_mm(const Mapping& mapping, double x) {
  return x < 0 ? mapping.slope_mm(0) * x : mapping.depth_mm(x);
}

Result<BallByShape> ball_by_shape(const Press& press,
                                  const Face& face,
                                  const Mapping& mapping,
                                  const Job& job) {
  const auto guess = find_ball(press, face);
  if (!guess) return guess.error();
  const Error too_small{en::say("{}: the contact covers too few pixels", press.name),
                        "",
                        en::say("pressing deeper, or a larger picture")};
  PressSamples samples =
      sample_around(press, face, guess->centre_mm, 1.06 * press.ball_radius_mm, kSamplesOfBall);
  if (samples.samples.size() < kMinSamplesOfBall) return too_small;
  JointOptions options;
  options.along = mapping.parameters().along;
  options.zone = kInnerRim;
  double deepest = 0;
  for (Sample& sample : samples.samples) {
    sample.x =
        mapping.parameters().variation.at(sample.position_mm) * reading_mm(mapping, sample.x);
    deepest = std::max(deepest, sample.x);
  }
  // Noise in mm near zero depth: it only weighs samples against kFloorMm.
  samples.x_sd *= mapping.slope_mm(0);
  MappingCurve line({MappingKind::kPolynomial, 1}, std::max(deepest, 1e-3));
  line.set_line(1.0);
  JointOptions fixed = options;
  fixed.fix_mapping = true;
  JointFit fit = fit_jointly({&samples}, {line, {guess->centre_mm}, false}, fixed, job);
  if (fit.converged) fit = fit_jointly({&samples}, fit, options, job);
  if (job.stop_requested()) return Error{en::say("stopped before the check was done"), "", ""};
  if (!fit.converged)
    return Error{en::say("{}: no ball fits the contact", press.name), "", en::say("a clean ball")};

  BallByShape ball{fit.centres_mm[0], fit.curve.values()[0], 0, Eigen::Vector2d::Zero(), {}};
  if (const Sample* nearest = nearest_sample(samples, ball.centre_mm))
    ball.on_face_mm = nearest->position_mm;
  const ContactDisc disc(samples, options.along, ball.centre_mm);
  for (const Sample& sample : samples.samples) {
    const double depth = ball_depth_mm(sample, options.along, ball.centre_mm, press.ball_radius_mm);
    if (!std::isfinite(depth) || !(disc.position_of(sample).radius <= kInnerRim)) continue;
    ball.errors_mm.push_back(sample.x - depth -
                             blur_mm(sample, samples, line, options.along, ball.centre_mm));
    ball.depth_mm = std::max(ball.depth_mm, depth);
  }
  if (ball.errors_mm.empty()) return too_small;
  return ball;
}

}  // namespace alltact
