#include "calibration/finger/press_problem.h"

#include "calibration/report/problem_image.h"
#include "core/io/image_file.h"
#include "core/sensing/reference/edge_positions.h"

#include <algorithm>

namespace alltact {
namespace {

constexpr std::size_t kMaxShown = 8;
constexpr double kDarker = 0.02;  // of the untouched brightness: fainter marks are noise

/// Why a press is not used; empty: it is, or a person excluded it.
std::string reason_of(const TakenPress& press, const FingerCalibration& done) {
  if (done.inputs.press_set.of(press.name).excluded) return {};
  if (!press.left_out.empty()) return press.name + ": " + press.left_out.english();
  for (const Message& message : done.calibration.left_out)
    if (std::string sentence = message.english(); sentence.starts_with(press.name + ':'))
      return sentence;
  return {};
}

cv::Mat image_of(const TakenPress& press, const std::string& words) {
  ProblemScene scene;
  scene.grey = press.grey;
  scene.words = {words};
  if (press.press) {
    scene.edges = edge_curves(press.press->shape);
    scene.darker = press.press->difference.x > kDarker;
  }
  return problem_image(scene);
}

}  // namespace

cv::Mat press_problem(const FingerCalibration& done, const std::string& refused) {
  std::vector<cv::Mat> images;
  const auto add = [&](const TakenPress& press, const std::string& words) {
    if (images.size() < kMaxShown && !press.grey.empty()) images.push_back(image_of(press, words));
  };
  for (const TakenPress& press : done.presses)
    if (const std::string reason = reason_of(press, done); !reason.empty()) add(press, reason);
  if (images.empty() && !refused.empty())
    for (const TakenPress& press : done.presses)
      if (press.left_out.empty()) add(press, press.name + ": " + refused);
  cv::Mat stacked;
  if (!images.empty()) cv::vconcat(images, stacked);  // one camera: all are equally wide
  return stacked;
}

std::filesystem::path leave_press_problem(const std::filesystem::path& finger_folder,
                                          const FingerCalibration& done,
                                          const std::string& refused) {
  const auto file = finger_folder / kPressProblem;
  const cv::Mat image = press_problem(done, refused);
  if (!image.empty() && write_image(file, image)) return file;
  std::error_code absent;
  std::filesystem::remove(file, absent);
  return {};
}

}  // namespace alltact
