#include "calibration/study/scaling_study.h"

#include "calibration/joint/calibrate.h"
#include "calibration/study/calibrating_bench.h"
#include "calibration/study/heap_bytes.h"
#include "calibration/study/painted_press.h"
#include "calibration/study/scaled_finger.h"
#include "calibration/study/study_clock.h"
#include "core/batch/batch.h"
#include "core/numerics/median.h"
#include "core/numerics/philox.h"
#include "core/sensing/markers/layout_search.h"
#include "core/sensing/result_json.h"

#include <algorithm>
#include <cmath>
#include <ctime>

#include <fmt/format.h>

namespace alltact {
namespace {

constexpr int kLibraryImages = 24;
constexpr int kSearches = 60, kBruteForceSearches = 20;

/// Processor seconds of all threads.
double process_cpu_s() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// A finger of so many markers that moves through three modes of motion, 30 frames a second; pixels
/// of an image of 960 x 540.
Eigen::MatrixXd synthetic_layouts(Eigen::Index frames, int markers) {
  Eigen::MatrixXd layouts(frames, 2 * markers);
  const int per_row = markers / 2;
  for (Eigen::Index i = 0; i < frames; ++i) {
    const double t = static_cast<double>(i) / 30;
    const double bend = 40 * std::sin(0.9 * t), curl = 15 * std::sin(0.37 * t + 1),
                 sway = 10 * std::sin(0.211 * t + 2);
    for (int m = 0; m < markers; ++m) {
      const double along = static_cast<double>(m % per_row) / std::max(1, per_row - 1);
      layouts(i, 2 * m) = 60 + 840 * along + bend * along * along;
      layouts(i, 2 * m + 1) = (m < per_row ? 80 : 460) + curl * along * (1 - along) + sway * along;
    }
  }
  return layouts;
}

/// A row with a little noise and each fifth marker hidden.
Markers noisy_query(const Eigen::MatrixXd& layouts, std::uint64_t seed, std::uint32_t number) {
  StudyDraws draws(seed, number);
  const auto row =
      static_cast<Eigen::Index>(draws.uniform() * static_cast<double>(layouts.rows() - 1));
  Markers markers(static_cast<std::size_t>(layouts.cols() / 2));
  for (std::size_t m = 0; m < markers.size(); ++m) {
    const auto at = static_cast<Eigen::Index>(2 * m);
    markers[m] = {layouts(row, at) + 0.3 * draws.normal(),
                  layouts(row, at + 1) + 0.3 * draws.normal(),
                  m % 5 != number % 5,
                  0.05};
  }
  return markers;
}

double brute_force_min_px(const Eigen::MatrixXd& layouts, const Markers& markers) {
  double least = std::numeric_limits<double>::infinity();
  for (Eigen::Index row = 0; row < layouts.rows(); ++row) {
    double sum = 0;
    int seen = 0;
    for (std::size_t m = 0; m < markers.size(); ++m) {
      if (!markers[m].seen) continue;
      const auto at = static_cast<Eigen::Index>(2 * m);
      sum += std::hypot(layouts(row, at) - markers[m].u, layouts(row, at + 1) - markers[m].v);
      ++seen;
    }
    least = std::min(least, sum / seen);
  }
  return least;
}

/// Repeats the same few frames, as a recording of any length.
class RepeatedSource : public Source {
 public:
  RepeatedSource(const std::vector<FramePtr>& frames, std::size_t count)
      : frames_(frames), count_(count) {}
  Result<FramePtr> next() override {
    if (at_ >= count_) return FramePtr();
    return frames_[at_++ % frames_.size()];
  }
  [[nodiscard]] std::optional<std::size_t> count() const override { return count_; }
  [[nodiscard]] bool is_continuous() const override { return true; }

 private:
  const std::vector<FramePtr>& frames_;
  std::size_t count_, at_ = 0;
};

class ScalingRun {
 public:
  ScalingRun(const FingerPtr& finger, const ScalingOptions& options, const Job& job)
      : finger_(finger), options_(options), job_(job) {}

  Result<ScalingStudy> run() {
    ScalingStudy study;
    study.about = en::say("how time and memory grow, of {}", finger_->finger.name);
    auto recorded = recorded_images(finger_, kLibraryImages, job_);
    if (!recorded) return recorded.error();
    recorded_ = std::move(recorded).value();
    using Part = Result<ScalingCurve> (ScalingRun::*)();
    const std::vector<Part> parts{&ScalingRun::pixels,
                                  &ScalingRun::recorded_frames,
                                  &ScalingRun::markers,
                                  &ScalingRun::presses,
                                  &ScalingRun::recordings};
    for (const Part part : parts) {
      done_ = static_cast<double>(study.curves.size()) / static_cast<double>(parts.size());
      auto curve = (this->*part)();
      if (job_.stop_requested()) return Error{en::say("stopped before the study was over"), "", ""};
      if (!curve) return curve.error();
      std::vector<double> sizes, times;
      for (const ScalingPoint& point : curve->points) {
        sizes.push_back(point.size);
        times.push_back(point.time_ms);
      }
      curve->exponent = exponent_of(sizes, times);
      study.curves.push_back(std::move(*curve));
    }
    return study;
  }

 private:
  void report_step(const Message& what) const { clock_.report(job_, done_, what); }

  /// Median time, ms, of a frame that follows one of the same pose.
  [[nodiscard]] Result<double> frame_ms(const ScaledFinger& scaled) const {
    Pipeline pipeline = scaled.pipeline();
    std::vector<double> times_ms;
    for (int round = 0; round < (options_.quick ? 1 : 3); ++round)
      for (const FramePtr& frame : scaled.frames) {
        if (job_.stop_requested()) return 0.0;
        pipeline.forget();
        if (const auto first = pipeline(frame); !first) return first.error();
        const double begin_s = thread_cpu_s();
        if (const auto next = pipeline(frame); !next) return next.error();
        times_ms.push_back(1000 * (thread_cpu_s() - begin_s));
      }
    return upper_median(times_ms);
  }

  Result<ScalingCurve> pixels() {
    ScalingCurve curve{
        "pixels", en::say("one frame"), en::say("pixels of the picture"), {}, {}, {}};
    for (const double by : options_.quick ? std::vector<double>{0.25, 0.5, 1}
                                          : std::vector<double>{0.25, 0.5, 1, 2, 3}) {
      const auto scaled = scaled_finger(*finger_, recorded_, by, options_.seed, job_);
      if (!scaled) return scaled.error();
      const cv::Size size = scaled->finger.camera.size();
      report_step(en::say("pictures of {} x {}", size.width, size.height));
      const auto time_ms = frame_ms(*scaled);
      if (!time_ms) return time_ms.error();
      curve.points.push_back(
          {static_cast<double>(size.area()), *time_ms, scaled->library.memory_bytes()});
    }
    curve.note = en::say("memory: of a reference of {} frames", recorded_.images.size());
    return curve;
  }

  Result<ScalingCurve> recorded_frames() {
    ScalingCurve curve{"recorded_frames",
                       en::say("finding the nearest pose"),
                       en::say("recorded frames"),
                       {},
                       {},
                       {}};
    int compared = 0, equal = 0;
    for (const Eigen::Index frames : options_.quick
                                         ? std::vector<Eigen::Index>{100, 1000, 10000}
                                         : std::vector<Eigen::Index>{100, 1000, 10000, 100000}) {
      report_step(en::say("a recording of {} frames", frames));
      const Eigen::MatrixXd layouts = synthetic_layouts(frames, 12);
      const LayoutSearch search(layouts);
      std::vector<double> times_ms;
      for (int i = 0; i < kSearches; ++i) {
        const Markers markers = noisy_query(layouts, options_.seed, static_cast<std::uint32_t>(i));
        const double begin_s = thread_cpu_s();
        const auto found = search.nearest(markers);
        times_ms.push_back(1000 * (thread_cpu_s() - begin_s));
        if (i >= kBruteForceSearches) continue;
        ++compared;
        const double least_px = brute_force_min_px(layouts, markers);
        // Layouts are stored as float.
        if (std::abs(found.distance_px - least_px) <= 1e-5 * (1000 + least_px)) ++equal;
      }
      curve.points.push_back(
          {static_cast<double>(frames), upper_median(times_ms), search.memory_bytes()});
    }
    curve.note =
        en::say("{} of {} searches found what looking at all frames finds", equal, compared);
    return curve;
  }

  Result<ScalingCurve> markers() {
    constexpr Eigen::Index kFrames = 300;
    ScalingCurve curve{
        "markers", en::say("numbering dots seen anew"), en::say("markers"), {}, {}, {}};
    int numbered = 0, asked = 0;
    for (const int count :
         options_.quick ? std::vector<int>{12, 24, 50} : std::vector<int>{12, 24, 50, 100, 200}) {
      report_step(en::count("{} markers", "{} marker", count));
      const Eigen::MatrixXd layouts = synthetic_layouts(kFrames, count);
      std::vector<Dot> typical(static_cast<std::size_t>(count));
      for (std::size_t m = 0; m < typical.size(); ++m) {
        typical[m].radius_px = 3;
        typical[m].contrast = 60;
        typical[m].sd_px = 0.05;
        typical[m].upper = m < typical.size() / 2;
      }
      const auto model = MarkerModel::learn(layouts, typical);
      if (!model) return model.error();
      std::vector<double> times_ms;
      for (std::uint32_t i = 0; i < (options_.quick ? 10U : 30U); ++i) {
        if (job_.stop_requested()) return curve;
        std::vector<Dot> dots;
        const Markers markers = noisy_query(layouts, options_.seed, i);
        for (std::size_t m = 0; m < markers.size(); ++m) {
          if (!markers[m].seen) continue;
          Dot dot = typical[m];
          dot.u = markers[m].u;
          dot.v = markers[m].v;
          dots.push_back(dot);
        }
        const double begin_s = thread_cpu_s();
        const auto found = model->number(dots);
        times_ms.push_back(1000 * (thread_cpu_s() - begin_s));
        ++asked;
        if (found) ++numbered;
      }
      curve.points.push_back({static_cast<double>(count), upper_median(times_ms), {}});
    }
    curve.note = en::say("{} of {} layouts were numbered", numbered, asked);
    return curve;
  }

  Result<ScalingCurve> presses() {
    ScalingCurve curve{"presses", en::say("calibrating"), en::say("presses"), {}, {}, {}};
    auto bench = CalibratingBench::make(finger_, options_.seed, job_);
    if (!bench) return bench.error();
    std::vector<Press> some;
    for (int draw = 0; draw < 2; ++draw) {
      const auto read = bench->presses(draw, 1);
      if (!read) return read.error();
      some.insert(some.end(), (*read)->presses.begin(), (*read)->presses.end());
    }
    for (const int count :
         options_.quick ? std::vector<int>{4, 8, 16} : std::vector<int>{6, 12, 25, 50, 100, 200}) {
      report_step(en::count("calibrating with {} presses", "calibrating with {} press", count));
      std::vector<Press> presses;
      for (int i = 0; i < count; ++i) {
        presses.push_back(some[static_cast<std::size_t>(i) % some.size()]);
        presses.back().name = fmt::format("press_{}", i);
      }
      const Job quiet(job_, done_, done_);
      const double begin_s = thread_cpu_s();
      const std::size_t before = heap_bytes();
      const auto made =
          calibrate(presses, bench->finger().camera, bench->finger().finger.face, {}, quiet);
      if (job_.stop_requested()) return curve;
      if (!made) continue;
      const std::size_t after = heap_bytes();
      curve.points.push_back({static_cast<double>(count),
                              1000 * (thread_cpu_s() - begin_s),
                              after > before ? after - before : 0});
    }
    curve.note = en::count("{} presses are different ones, the others their copies",
                           "{} press is a different one, the others its copies",
                           std::ssize(some));
    return curve;
  }

  Result<ScalingCurve> recordings() {
    constexpr double kPerSecond = 30;
    ScalingCurve curve{"recordings",
                       en::say("measuring a recording at a quarter of the pixels a side"),
                       en::say("seconds of the recording, at 30 frames each"),
                       {},
                       {},
                       {}};
    const auto scaled = scaled_finger(*finger_, recorded_, 0.25, options_.seed, job_);
    if (!scaled) return scaled.error();
    std::size_t most_frames = 0;
    for (const double seconds : options_.quick ? std::vector<double>{1, 10, 60}
                                               : std::vector<double>{1, 10, 60, 600, 3600}) {
      report_step(en::say("a recording of {:.0f} s", seconds));
      const auto frames = static_cast<std::size_t>(seconds * kPerSecond);
      RepeatedSource source(scaled->frames, frames);
      const std::size_t before = heap_bytes();
      std::size_t most = before;
      std::vector<Pipeline> pipelines;
      for (int i = 0; i < options_.threads; ++i) pipelines.push_back(scaled->pipeline());
      BatchWork work;
      work.write = [](BatchFrame& frame, const Pipeline&) -> Result<FrameLine> {
        FrameLine line;
        if (!frame.result) return line;
        line.line = result_line(*frame.result, frame.index, ReferenceMethod::kLocal);
        line.is_measured = frame.result->depth.has_value();
        return line;
      };
      std::size_t measured = 0;
      work.take = [&](std::size_t index, FrameLine&& line) -> Status {
        measured += line.is_measured ? 1 : 0;
        if (index % kPieceFrames == 0) most = std::max(most, heap_bytes());
        return {};
      };
      const double begin_s = process_cpu_s();
      if (const Status done = measure_batch(source, pipelines, {}, work, job_); !done)
        return done.error();
      if (job_.stop_requested()) return curve;
      curve.points.push_back({seconds, 1000 * (process_cpu_s() - begin_s), most - before});
      most_frames = std::max(most_frames, measured);
    }
    curve.note = en::say(
        "{} frames of the longest were measured; memory: the most that was held "
        "beside the reference",
        most_frames);
    return curve;
  }

  FingerPtr finger_;
  const ScalingOptions& options_;
  const Job& job_;
  const StudyClock clock_;
  RecordedImages recorded_;
  double done_ = 0;
};

}  // namespace

std::optional<double> exponent_of(const std::vector<double>& x, const std::vector<double>& y) {
  if (x.size() < 2) return std::nullopt;
  const auto [least, most] = std::minmax_element(x.begin(), x.end());
  if (!(*least > 0)) return std::nullopt;
  const double from = std::sqrt(*least * *most) * (1 - 1e-9);
  double n = 0, sum_x = 0, sum_y = 0, sum_xx = 0, sum_xy = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (x[i] < from) continue;
    if (!(y[i] > 0)) return std::nullopt;
    const double log_x = std::log(x[i] / *most), log_y = std::log(y[i]);
    n += 1, sum_x += log_x, sum_y += log_y, sum_xx += log_x * log_x, sum_xy += log_x * log_y;
  }
  const double spread = n * sum_xx - sum_x * sum_x;
  if (n < 2 || !(spread > 0)) return std::nullopt;
  return (n * sum_xy - sum_x * sum_y) / spread;
}

Result<ScalingStudy> study_scaling(const FingerPtr& finger,
                                   const ScalingOptions& options,
                                   const Job& job) {
  return ScalingRun(finger, options, job).run();
}

}  // namespace alltact
