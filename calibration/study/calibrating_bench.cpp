#include "calibration/study/calibrating_bench.h"

#include "calibration/finger/measuring_settings.h"
#include "calibration/study/truth_limits.h"

#include <algorithm>
#include <cmath>
#include <ctime>

#include <fmt/format.h>
#include <opencv2/imgproc.hpp>

namespace alltact {
namespace {

constexpr int kTestImages = 6;      // that measure the error
constexpr double kNoiseBeyond = 4;  // px: slower variation is not sensor noise
constexpr std::size_t kMinCanvases = 3;
constexpr std::uint64_t kDrawSeedStep =
    0x9e3779b97f4a7c15U;  // spreads the seeds of the draws far apart

cv::Mat noise_of(const cv::Mat& grey, const cv::Mat& reference) {
  cv::Mat off;
  grey.convertTo(off, CV_32FC1);
  off -= reference;
  cv::patchNaNs(off, 0.0);
  cv::Mat slow;
  cv::GaussianBlur(off, slow, {}, kNoiseBeyond);
  return off - slow;
}

}  // namespace

double thread_cpu_s() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

Result<CalibratingBench> CalibratingBench::make(const FingerPtr& finger,
                                                std::uint64_t seed,
                                                const Job& job) {
  StudyWorldOptions options;
  options.frames = kMaxPresses + kTestImages;
  options.seed = seed;
  auto untouched = untouched_images(finger, options, job);
  if (!untouched) return untouched.error();
  CalibratingBench bench(std::move(untouched).value(), seed);
  bench.is_turned_ = finger->finger.camera.orientation != Orientation::kNone;
  if (const Status looked = bench.analyse_images(); !looked) return looked.error();
  return bench;
}

Status CalibratingBench::analyse_images() {
  Pipeline pipeline = Pipeline::with_library(
      untouched_.library, finger(), settings_for_presses(measuring_settings(finger().folder)));
  for (const cv::Mat& grey : untouched_.images) {
    auto frame = std::make_shared<Frame>();
    frame->grey = grey;
    pipeline.forget();
    auto seen = pipeline(frame);
    if (!seen) return seen.error();
    if (!seen->shape || !seen->reference) continue;
    canvases_.push_back(
        {seen->grey, noise_of(seen->grey, seen->reference->image.grey()), *seen->shape});
  }
  if (canvases_.size() < kMinCanvases)
    return Error{en::say("too few pictures of the reference recording show the face"),
                 finger().folder.string(),
                 en::say("record the finger bending through all its poses")};
  std::vector<StudyFrame> frames;
  for (int number = 0; number < kMaxPresses; ++number)
    if (auto frame = painted(0, number, 1, false)) frames.push_back(std::move(*frame));
  checksum_ = checksum_of(frames);
  return {};
}

std::optional<StudyFrame> CalibratingBench::painted(int draw, int number, int images, bool is_new) {
  // Presses and test images take turns over the recording.
  const std::size_t at =
      (is_new ? 3 * static_cast<std::size_t>(number) + 2
              : 3 * (static_cast<std::size_t>(number) / 2) + static_cast<std::size_t>(number) % 2) %
      canvases_.size();
  const Canvas& canvas = canvases_[at];
  cv::Mat grey;
  canvas.grey.convertTo(grey, CV_32FC1);
  grey -= canvas.noise * (1 - 1 / std::sqrt(static_cast<double>(images)));
  grey.convertTo(grey, CV_8UC1);
  StudyDraws draws(seed_ + kDrawSeedStep * static_cast<std::uint64_t>(2 * draw + (is_new ? 1 : 0)),
                   static_cast<std::uint32_t>(number));
  const PressPainter painter(finger(), painted_radius_mm(finger()));
  return painter.ball(grey, canvas.shape, draws, static_cast<FaceZone>(number % 3));
}

Result<const ReadPresses*> CalibratingBench::presses(int draw, int images) {
  const auto key = std::make_pair(draw, images);
  if (const auto known = read_.find(key); known != read_.end()) return &known->second;
  ReadPresses read;
  Pipeline pipeline =
      Pipeline::with_library(untouched_.library,
                             finger().without_mapping(),
                             settings_for_presses(measuring_settings(finger().folder)));
  for (int number = 0; number < kMaxPresses; ++number) {
    auto press = painted(draw, number, images, false);
    if (!press) continue;
    auto frame = std::make_shared<Frame>(*press->image);
    frame->name = fmt::format("press_{}", number);
    pipeline.forget();
    const double begin_s = thread_cpu_s();
    auto seen = pipeline(frame);
    if (!seen) return seen.error();
    if (!seen->difference || !seen->shape || seen->reference->by_shape) continue;
    read.presses.push_back(Press{frame->name,
                                 std::move(*seen->difference),
                                 std::move(*seen->shape),
                                 painted_radius_mm(finger())});
    read.read_s.push_back(thread_cpu_s() - begin_s);
    read.frames.push_back(std::move(frame));
  }
  return &read_.emplace(key, std::move(read)).first->second;
}

Status CalibratingBench::need_paper(const Job& job) {
  if (paper_) return {};
  if (is_turned_)
    return Error{en::say("the source paper's method is not studied with a turned camera"),
                 finger().folder.string(),
                 ""};
  const FingerSnapshot blank = finger().without_mapping();
  if (finger().finger.face.kind == FaceKind::kFlat) {
    paper_ = PaperMethod::flat(untouched_.library, blank);
    return {};
  }
  auto method = PaperMethod::create(blank, job);
  if (!method) return method.error();
  paper_ = std::move(method).value();
  return {};
}

Result<std::vector<Press>> CalibratingBench::as_paper(const std::vector<FramePtr>& frames,
                                                      const Job& job) {
  if (const Status ready = need_paper(job); !ready) return ready.error();
  PressSet press_set;
  press_set.ball_radius_mm = painted_radius_mm(finger());
  return paper_presses(*paper_, frames, press_set, job);
}

Result<std::vector<float>> CalibratingBench::errors_mm(const Mapping& mapping,
                                                       bool is_paper,
                                                       int draw,
                                                       const Job& job) {
  auto& frames = new_[draw];
  if (frames.empty())
    for (int number = 0; number < kTestImages; ++number)
      if (auto frame = painted(draw, number, 1, true)) frames.push_back(std::move(*frame));
  std::optional<Pipeline> pipeline;
  if (is_paper) {
    if (const Status ready = need_paper(job); !ready) return ready.error();
    pipeline = Pipeline::with_paper_method(paper_->with(mapping));
  } else {
    FingerSnapshot measuring = finger();
    measuring.mapping = mapping;
    measuring.finger.mapping = mapping.parameters();
    pipeline = Pipeline::with_library(
        untouched_.library, measuring, settings_for_presses(measuring_settings(finger().folder)));
  }
  std::vector<float> errors;
  for (const StudyFrame& frame : frames) {
    if (job.stop_requested()) return Error{en::say("stopped before the study was over"), "", ""};
    pipeline->forget();
    const auto seen = (*pipeline)(frame.image);
    if (!seen) return seen.error();
    if (!seen->depth) continue;
    for (int v = 0; v < frame.depth_mm.rows; ++v)
      for (int u = 0; u < frame.depth_mm.cols; ++u) {
        const float truly = frame.depth_mm.at<float>(v, u);
        const float read = seen->depth->depth_mm.at<float>(v, u);
        if (truly > kPressedMm && std::isfinite(read)) errors.push_back(std::abs(read - truly));
      }
  }
  return errors;
}

}  // namespace alltact
