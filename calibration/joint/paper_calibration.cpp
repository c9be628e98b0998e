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
  Calibration calibration;
  std::vector<BallCloud> clouds;
  Message reason;
  for (const Press& press : presses) {
    if (job.stop_requested()) break;
    auto cloud = cloud_of_press(press, camera, face);
    if (cloud) {
      clouds.push_back(std::move(*cloud));
    } else {
      calibration.left_out.push_back(en::say("{}.", cloud.error().message()));
      reason = cloud.error().what;
    }
  }
  if (clouds.empty() && job.stop_requested())
    return Error{en::say("stopped before the first solution"), "", ""};
  if (clouds.empty())
    return Error{en::say("the source paper's method finds a ball in none of {} presses ({})",
                         presses.size(),
                         reason),
                 "",
                 en::say("the joint method, which fits the ball itself")};
  return calibrate_through(clouds, std::move(calibration));
}

}  // namespace alltact
