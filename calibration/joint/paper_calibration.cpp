#include "calibration/joint/paper_calibration.h"

#include "calibration/joint/ball_clouds.h"
#include "calibration/joint/circle_search.h"

namespace alltact {
namespace {

Result<BallCloud> cloud_of_press(const Press& press, const Camera& camera, const Face& face) {
  const auto dark = dark_circle(press, camera);
  if (!dark) return dark.error();
  const std::vector<Sample> samples = samples_inside(press, face, *dark);
  const auto found = search_circle(press, *dark, samples, camera, face);
  if (!found) return found.error();
  return cloud_of_ball(press, samples, found->ball_mm, false);
}

}  // namespace

Result<Calibration> calibrate_as_paper(const std::vector<Press>& presses,
                                       const Camera& camera,
                                       const Face& face,
                                       const Job& job) {
  CloudsFound found = clouds_of(
      presses, [&](const Press& press) { return cloud_of_press(press, camera, face); }, job);
  if (found.clouds.empty() && found.stopped)
    return Error{en::say("stopped before the first solution"), "", ""};
  if (found.clouds.empty())
    return Error{en::say("the source paper's method finds a ball in none of {} presses ({})",
                         presses.size(),
                         found.reason),
                 "",
                 en::say("the joint method, which fits the ball itself")};
  Calibration calibration;
  calibration.left_out = std::move(found.left_out);
  return fit_cubic_mapping(found.clouds, std::move(calibration));
}

}  // namespace alltact
