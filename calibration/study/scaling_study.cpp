#include "calibration/study/scaling_study.h"

#include "calibration/joint/calibrate.h"
#include "calibration/study/calibrating_study.h"
#include "calibration/study/study_machine.h"
#include "calibration/study/study_world.h"
#include "core/base/job.h"
#include "core/base/result.h"
#include "core/batch/batch.h"
#include "core/finger/finger_store.h"
#include "core/image/frame.h"
#include "core/numerics/median.h"
#include "core/numerics/philox.h"
#include "core/recording/video_file.h"
#include "core/sensing/pipeline.h"
#include "core/sensing/reference/recorded_poses.h"
#include "core/sensing/reference/reference_library.h"
#include "core/sensing/result_json.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <ctime>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

namespace alltact {
namespace {

/// Images of a finger's recording in their original size, with the marker table; of a flat sensor
/// its single image.
struct RecordedImages {
  MarkerTable table;            ///< rows of `images`; empty of a flat sensor
  std::vector<cv::Mat> images;  ///< oriented
};

/// At most `count` images, evenly over the recording. Errors: the finger is not calibrated; those
/// of its recording; stopped.
[[nodiscard]] Result<RecordedImages> recorded_images(const FingerPtr& finger, int count,
                                                     const Job& job);

struct ScaledFinger {
  FingerSnapshot finger;  ///< its camera has the size of the images below, which are oriented
  ReferenceLibrary library;
  /// each with a ball painted into it, where a valid position was found
  std::vector<FramePtr> frames;

  [[nodiscard]] Pipeline pipeline() const { return Pipeline::with_library(library, finger, {}); }
};

/// by: factor on pixels a side, 0.05 to 8. Errors: those of Camera::create and ReferenceLibrary.
[[nodiscard]] Result<ScaledFinger> scaled_finger(const FingerSnapshot& finger,
                                                 const RecordedImages& recorded, double by,
                                                 std::uint64_t seed, const Job& job);

double scaled_px(double px, double by) { return (px + 0.5) * by - 0.5; }

FingerSnapshot at_scale(const FingerSnapshot& original, double by) {
  FingerSnapshot scaled = original;
  CameraParameters& camera = scaled.finger.camera;
  camera.orientation = Orientation::kNone;
  camera.width_px = static_cast<int>(std::lround(camera.width_px * by));
  camera.height_px = static_cast<int>(std::lround(camera.height_px * by));
  camera.fx_px *= by;
  camera.fy_px *= by;
  camera.cx_px = scaled_px(camera.cx_px, by);
  camera.cy_px = scaled_px(camera.cy_px, by);
  camera.mm_per_px /= by;
  for (double& sd : camera.sd_px) sd *= by;
  if (auto& contact = scaled.finger.contact) {
    contact->threshold_px *= by;
    for (Eigen::Vector2d& marker : contact->rest_markers)
      marker = {scaled_px(marker.x(), by), scaled_px(marker.y(), by)};
  }
  if (auto& reference = scaled.finger.reference; reference && reference->positions)
    reference->positions->from_u_px = scaled_px(reference->positions->from_u_px, by);
  scaled.force.reset();
  return scaled;
}

MarkerTable at_scale(MarkerTable table, double by) {
  table.layouts = ((table.layouts.array() + 0.5) * by - 0.5).matrix();
  for (Dot& dot : table.typical) {
    dot.u = scaled_px(dot.u, by);
    dot.v = scaled_px(dot.v, by);
    dot.radius_px *= by;
    dot.half_u_px *= by;
    dot.half_v_px *= by;
  }
  return table;
}

Result<RecordedImages> recorded_images(const FingerPtr& snapshot, int count, const Job& job) {
  const Finger& finger = snapshot->finger;
  StudyWorldOptions few;
  few.frames = 1;
  if (finger.face.kind == FaceKind::kFlat) {
    auto untouched = untouched_images(snapshot, few, job);
    if (!untouched) return untouched.error();
    return RecordedImages{{}, std::move(untouched->images)};
  }
  if (!snapshot->mapping || !finger.reference || finger.reference->video.empty())
    return Error{en::say("the finger has no reference recording, or is not calibrated yet"),
                 (snapshot->folder / Finger::kFileName).string(),
                 en::say("alltact reference, then alltact calibrate")};
  const auto table =
      MarkerTable::load(snapshot->folder / finger.reference->markers, finger.marker_count());
  if (!table) return table.error();
  const auto file = snapshot->folder / finger.reference->video;
  auto video = VideoFile::open(file, job);
  if (!video) return video.error();
  const std::size_t rows = table->frames.size();
  const std::size_t used = std::min(rows, static_cast<std::size_t>(count));
  RecordedImages recorded;
  recorded.table.typical = table->typical;
  recorded.table.layouts.resize(static_cast<Eigen::Index>(used), table->layouts.cols());
  for (std::size_t i = 0; i < used; ++i) {
    if (job.stop_requested()) return Error{en::say("stopped before the study was over"), "", ""};
    const std::size_t row = i * rows / used;
    const auto frame = video->frame(static_cast<std::size_t>(table->frames[row]));
    if (!frame) return frame.error();
    auto grey = oriented_for(finger.camera, (*frame)->grey, en::say("the recording's image"),
                             file.string(), "");
    if (!grey) return grey.error();
    recorded.table.frames.push_back(static_cast<int>(i));
    recorded.table.seen.push_back(table->seen[row]);
    recorded.table.layouts.row(static_cast<Eigen::Index>(i)) =
        table->layouts.row(static_cast<Eigen::Index>(row));
    recorded.images.push_back(grey->clone());
  }
  return recorded;
}

Result<ScaledFinger> scaled_finger(const FingerSnapshot& original, const RecordedImages& recorded,
                                   double by, std::uint64_t seed, const Job& job) {
  FingerSnapshot finger = at_scale(original, by);
  auto camera = Camera::create(finger.finger.camera);
  if (!camera) return camera.error();
  finger.camera = std::move(camera).value();
  std::vector<cv::Mat> images;
  for (const cv::Mat& image : recorded.images) {
    cv::Mat scaled;
    cv::resize(image, scaled, finger.camera.size(), 0, 0,
               by < 1 ? cv::INTER_AREA : cv::INTER_CUBIC);
    images.push_back(std::move(scaled));
  }
  const auto image_of = [&](std::size_t number) -> Result<cv::Mat> { return images[number]; };
  auto library = recorded.table.frames.empty()
                     ? ReferenceLibrary::single(images.front())
                     : ReferenceLibrary::from_frames(
                           {image_of, images.size(), original.folder, at_scale(recorded.table, by)},
                           finger.finger, finger.camera, job);
  if (!library) return library.error();
  ScaledFinger scaled{std::move(finger), std::move(library).value(), {}};
  Pipeline pipeline = scaled.pipeline();
  const PressPainter painter(scaled.finger, painted_radius_mm(scaled.finger));
  for (std::size_t i = 0; i < images.size(); ++i) {
    auto frame = std::make_shared<Frame>();
    frame->grey = images[i];
    frame->name = fmt::format("frame_{:05}", i);
    pipeline.forget();
    const auto seen = pipeline(frame);
    if (!seen) return seen.error();
    if (!seen->shape) continue;
    StudyDraws draws(seed, static_cast<std::uint32_t>(i));
    const auto painted =
        painter.ball(images[i], *seen->shape, draws, static_cast<FaceZone>(i % kFaceZones));
    if (painted) frame->grey = painted->image->grey;
    scaled.frames.push_back(std::move(frame));
  }
  if (scaled.frames.empty())
    return Error{en::say("no image of the reference recording shows the face"),
                 original.folder.string(),
                 en::say("record the finger bending through all its poses")};
  return scaled;
}

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
    for (Eigen::Index m = 0; m < markers; ++m) {
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
                  layouts(row, at + 1) + 0.3 * draws.normal(), m % 5 != number % 5, 0.05};
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
    study.about = en::say("how time and memory grow for {}", finger_->finger.name);
    auto recorded = recorded_images(finger_, kLibraryImages, job_);
    if (!recorded) return recorded.error();
    recorded_ = std::move(recorded).value();
    using Part = Result<ScalingCurve> (ScalingRun::*)();
    const std::vector<Part> parts{&ScalingRun::pixels, &ScalingRun::recorded_frames,
                                  &ScalingRun::markers, &ScalingRun::presses,
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
    ScalingCurve curve{"pixels", en::say("one frame"), en::say("pixels of the image"), {}, {}, {}};
    for (const double by : options_.quick ? std::vector<double>{0.25, 0.5, 1}
                                          : std::vector<double>{0.25, 0.5, 1, 2, 3}) {
      const auto scaled = scaled_finger(*finger_, recorded_, by, options_.seed, job_);
      if (!scaled) return scaled.error();
      const cv::Size size = scaled->finger.camera.size();
      report_step(en::say("images of {} x {}", size.width, size.height));
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
    curve.note = en::say("{} of {} searches gave the same result as a search of all frames", equal,
                         compared);
    return curve;
  }

  Result<ScalingCurve> markers() {
    constexpr Eigen::Index kFrames = 300;
    ScalingCurve curve{"markers", en::say("numbering dots seen anew"), en::say("markers"), {}, {},
                       {}};
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
      curve.points.push_back({static_cast<double>(count), 1000 * (thread_cpu_s() - begin_s),
                              after > before ? after - before : 0});
    }
    curve.note = en::count("{} presses are distinct, the others are their copies",
                           "{} press is distinct, the others are its copies", std::ssize(some));
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
        "{} frames of the longest were measured; memory: the maximum in addition to the reference",
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

Result<ScalingStudy> study_scaling(const FingerPtr& finger, const ScalingOptions& options,
                                   const Job& job) {
  return ScalingRun(finger, options, job).run();
}

namespace {

std::string megabytes(const std::optional<std::size_t>& bytes) {
  return bytes ? fmt::format("{:.2f}", static_cast<double>(*bytes) / 1e6) : "-";
}

}  // namespace

std::string text_of(const ScalingStudy& study) {
  std::string text =
      fmt::format("{}. Processor time; exponents over the upper half of the sizes.\n", study.about);
  for (const ScalingCurve& curve : study.curves) {
    text += fmt::format("{}, by {}", curve.what, curve.of);
    if (curve.exponent) text += fmt::format(": grows with its power {:.2f}", *curve.exponent);
    text += fmt::format("\n{:>12} {:>14} {:>14} {:>12}\n", "size", "ms", "us a piece", "MB");
    for (const ScalingPoint& point : curve.points)
      text += fmt::format("{:>12.0f} {:>14.4f} {:>14.4f} {:>12}\n", point.size, point.time_ms,
                          1000 * point.time_ms / point.size, megabytes(point.memory_bytes));
    if (!curve.note.empty()) text += fmt::format("  ({})\n", curve.note);
  }
  return text;
}

std::string csv_of(const ScalingStudy& study) {
  std::string csv = "what,size,time_ms,memory_bytes,exponent\n";
  for (const ScalingCurve& curve : study.curves)
    for (const ScalingPoint& point : curve.points)
      csv += fmt::format("{},{},{},{},{}\n", curve.key, point.size, point.time_ms,
                         point.memory_bytes ? fmt::format("{}", *point.memory_bytes) : "",
                         curve.exponent ? fmt::format("{}", *curve.exponent) : "");
  return csv;
}

nlohmann::json json_of(const ScalingStudy& study) {
  nlohmann::json json{{"about", study.about.english()}, {"curves", nlohmann::json::array()}};
  for (const ScalingCurve& curve : study.curves) {
    nlohmann::json entry{{"key", curve.key},
                         {"what", curve.what.english()},
                         {"of", curve.of.english()},
                         {"note", curve.note.english()},
                         {"points", nlohmann::json::array()}};
    if (curve.exponent) entry["exponent"] = *curve.exponent;
    for (const ScalingPoint& point : curve.points) {
      nlohmann::json point_json{{"size", point.size}, {"time_ms", point.time_ms}};
      if (point.memory_bytes) point_json["memory_bytes"] = *point.memory_bytes;
      entry["points"].push_back(std::move(point_json));
    }
    json["curves"].push_back(std::move(entry));
  }
  return json;
}

}  // namespace alltact
