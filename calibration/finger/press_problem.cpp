#include "calibration/finger/press_problem.h"

#include "calibration/report/problem_picture.h"
#include "core/io/picture.h"
#include "core/sensing/reference/pose_places.h"

#include <algorithm>

namespace alltact {
namespace {

constexpr std::size_t kMostShown = 8;
constexpr double kDarker = 0.02;  // of the untouched brightness: fainter, noise covers the picture

/// Why a press is not used; empty: it is, or somebody excluded it.
std::string reason_of(const TakenPress& press, const FingerCalibration& done) {
  if (done.inputs.said.of(press.name).excluded) return {};
  if (!press.left_out.empty()) return press.name + ": " + press.left_out.english();
  for (const Message& message : done.calibration.left_out)
    if (std::string sentence = message.english(); sentence.starts_with(press.name + ':'))
      return sentence;
  return {};
}

cv::Mat picture_of(const TakenPress& press, const std::string& words) {
  ProblemScene scene;
  scene.grey = press.grey;
  scene.words = {words};
  if (press.press) {
    scene.edges = edge_curves(press.press->shape);
    scene.darker = press.press->difference.x > kDarker;
  }
  return problem_picture(scene);
}

}  // namespace

cv::Mat press_problem(const FingerCalibration& done, const std::string& refused) {
  std::vector<cv::Mat> pictures;
  const auto add = [&](const TakenPress& press, const std::string& words) {
    if (pictures.size() < kMostShown && !press.grey.empty())
      pictures.push_back(picture_of(press, words));
  };
  for (const TakenPress& press : done.presses)
    if (const std::string reason = reason_of(press, done); !reason.empty()) add(press, reason);
  if (pictures.empty() && !refused.empty())
    for (const TakenPress& press : done.presses)
      if (press.left_out.empty()) add(press, press.name + ": " + refused);
  cv::Mat whole;
  if (!pictures.empty()) cv::vconcat(pictures, whole);  // one camera: all are equally wide
  return whole;
}

std::filesystem::path leave_press_problem(const std::filesystem::path& finger_folder,
                                          const FingerCalibration& done,
                                          const std::string& refused) {
  const auto file = finger_folder / kPressProblem;
  const cv::Mat picture = press_problem(done, refused);
  if (!picture.empty() && write_picture(file, picture)) return file;
  std::error_code absent;
  std::filesystem::remove(file, absent);
  return {};
}

}  // namespace alltact
