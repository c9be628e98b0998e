#include "calibration/joint/starting_balls.h"

#include "calibration/joint/sample_misfit.h"
#include "calibration/presses/manual_ball.h"

#include <algorithm>
#include <cstring>
#include <tuple>
#include <utility>

namespace alltact {
namespace {

constexpr int kFineSamples = 1500;   // a press, for the solution
constexpr int kCoarseSamples = 400;  // a press, for the choice of the model
// of these in the inner zone, where skin and ball touch
constexpr std::ptrdiff_t kMinSamples = 16;

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

}  // namespace

std::vector<FoundBall> find_balls(const std::vector<Press>& presses,
                                  const Face& face,
                                  const Job& job,
                                  std::vector<Message>* unusable) {
  std::vector<FoundBall> found;
  for (std::size_t i = 0; i < presses.size() && !job.stop_requested(); ++i) {
    const Press& press = presses[i];
    if (press.step_mm) continue;
    job.report(0.2 * static_cast<double>(i) / static_cast<double>(presses.size()),
               en::say("looking for the ball in {}", press.name));
    const auto duplicate = std::find_if(presses.begin(),
                                        presses.begin() + static_cast<std::ptrdiff_t>(i),
                                        [&](const Press& p) { return same_image(p, press); });
    if (duplicate != presses.begin() + static_cast<std::ptrdiff_t>(i)) {
      unusable->push_back(en::at(Message::typed(press.name),
                                 en::say("the same picture as {}, counted once", duplicate->name)));
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
    FoundBall one{&press,
                  *guess,
                  sample_around(press, face, centre, reach, kFineSamples),
                  sample_around(press, face, centre, reach, kCoarseSamples)};
    if (contact_samples(one.coarse, centre) < kMinSamples) {
      unusable->push_back(Error{en::say("the contact covers too few pixels"),
                                press.name,
                                en::say("pressing deeper, or a larger picture")}
                              .message());
      continue;
    }
    found.push_back(std::move(one));
  }
  std::stable_sort(found.begin(), found.end(), before);
  return found;
}

}  // namespace alltact
