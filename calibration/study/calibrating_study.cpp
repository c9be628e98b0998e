#include "calibration/study/calibrating_study.h"

#include "calibration/finger/measuring_presets.h"
#include "calibration/joint/calibrate.h"
#include "calibration/study/evaluate.h"
#include "calibration/study/study_machine.h"
#include "core/numerics/philox.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numeric>

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <opencv2/imgproc.hpp>

namespace alltact {
namespace {

constexpr int kQuickDraws = 1, kDraws = 3;

/// How presses become a mapping; without the number of presses and images.
CalibrationSettings fit_settings(const CalibratingChoice& choice) {
  CalibrationSettings settings;
  settings.method = choice.method;
  settings.family = choice.family;
  settings.iterations = choice.iterations;
  return settings;
}

Result<Calibration> calibrate_with(const std::vector<Press>& presses, const FingerSnapshot& finger,
                                   const CalibratingChoice& choice, const Job& job) {
  return calibrate(presses, finger.camera, finger.finger.face, fit_settings(choice), job);
}

double median_of(std::vector<double> values) {
  if (values.empty()) return 0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

template <class T>
std::vector<T> first_of(const std::vector<T>& all, int count) {
  return {all.begin(), all.begin() + std::min<std::ptrdiff_t>(count, std::ssize(all))};
}

Error stopped_calibrating() { return {en::say("stopped before the study was over"), "", ""}; }

/// Errors of one choice, summed over draws.
struct PaintedSum {
  int draws = 0, failed = 0;
  std::vector<float> errors_mm;
  std::vector<double> seconds;  // by draw; 0 where it failed
};

Result<PaintedSum> paint_and_calibrate(CalibratingBench& bench, const CalibratingChoice& choice,
                                       int draws, const Job& job) {
  PaintedSum sum;
  const bool is_paper = choice.method == CalibrationMethod::kPaper;
  for (int draw = 0; draw < draws; ++draw) {
    const auto read = bench.presses(draw, choice.images);
    if (!read) return read.error();
    const auto read_s = first_of((*read)->read_s, choice.presses);
    const auto frames = first_of((*read)->frames, choice.presses);
    const auto taken =
        is_paper ? bench.as_paper(frames, job) : Result(first_of((*read)->presses, choice.presses));
    ++sum.draws;
    sum.seconds.push_back(0);
    const double begin_s = thread_cpu_s();
    const auto made = taken ? calibrate_with(*taken, bench.finger(), choice, job)
                            : Result<Calibration>(taken.error());
    if (job.stop_requested()) return stopped_calibrating();
    const auto mapping = made ? Mapping::create(made->mapping) : Result<Mapping>(made.error());
    if (!mapping) {
      ++sum.failed;
      continue;
    }
    sum.seconds.back() =
        thread_cpu_s() - begin_s + std::accumulate(read_s.begin(), read_s.end(), 0.0);
    const auto errors = bench.errors_mm(*mapping, is_paper, draw, job);
    if (!errors) return errors.error();
    sum.errors_mm.insert(sum.errors_mm.end(), errors->begin(), errors->end());
  }
  return sum;
}

/// The finger's own presses, as read by this pipeline and by the paper's steps.
class RealSplits {
 public:
  static Result<RealSplits> open(const FingerPtr& finger, std::uint64_t seed, const Job& job) {
    auto presses = RealPresses::open(finger, job);
    if (!presses) return presses.error();
    RealSplits splits(std::move(presses).value(), seed);
    auto own = splits.presses_.measured(measuring_settings(finger->folder), job);
    if (!own) return own.error();
    splits.own_presses_ = std::move(own).value();
    if (splits.own_presses_.size() < RealPresses::kMinPresses)
      return Error{en::say("the finger has too few stored presses to leave one out: {}",
                           splits.own_presses_.size()),
                   finger->folder.string(), en::say("calibrating it with three presses or more")};
    return splits;
  }

  void measure(const CalibratingChoice& choice, int splits, const Job& job, CalibratingRow& row) {
    if (choice.images != 1 || choice.presses >= std::ssize(own_presses_)) return;
    const bool is_paper = choice.method == CalibrationMethod::kPaper;
    if (is_paper) read_as_paper(job);
    const std::vector<Press>& all = is_paper ? paper_presses_ : own_presses_;
    if (choice.presses >= std::ssize(all)) return;
    RealErrorSum sum;
    for (int split = 0; split < splits; ++split) {
      std::vector<Press> training, left;
      for (const std::size_t i : shuffled(all.size(), split))
        (std::ssize(training) < choice.presses ? training : left).push_back(all[i]);
      ++row.splits;
      const auto made = calibrate_with(training, presses_.finger(), choice, job);
      const auto mapping = made ? Mapping::create(made->mapping) : Result<Mapping>(made.error());
      if (!mapping) {
        ++row.splits_failed;
        continue;
      }
      for (const Press& press : left) sum.add(press, presses_.finger().finger.face, *mapping, job);
    }
    row.real = sum.errors();
  }

 private:
  RealSplits(RealPresses presses, std::uint64_t seed) : presses_(std::move(presses)), seed_(seed) {}

  void read_as_paper(const Job& job) {
    if (tried_as_paper_) return;
    tried_as_paper_ = true;
    auto method = PaperMethod::create(presses_.finger().without_mapping(), job);
    if (!method) return;
    auto read = paper_presses(*method, presses_.frames(), presses_.inputs().press_set, job);
    if (read) paper_presses_ = std::move(read).value();
  }

  /// Fisher-Yates shuffle.
  [[nodiscard]] std::vector<std::size_t> shuffled(std::size_t count, int split) const {
    std::vector<std::size_t> order(count);
    std::iota(order.begin(), order.end(), std::size_t{0});
    for (std::size_t i = count; i > 1; --i) {
      const double drawn = philox_uniform(seed_, "press split", static_cast<std::uint32_t>(split),
                                          static_cast<std::uint32_t>(i));
      std::swap(order[i - 1],
                order[std::min(i - 1, static_cast<std::size_t>(drawn * static_cast<double>(i)))]);
    }
    return order;
  }

  RealPresses presses_;
  std::uint64_t seed_;
  std::vector<Press> own_presses_, paper_presses_;
  bool tried_as_paper_ = false;
};

double ratio_to(const std::vector<double>& seconds, const std::vector<double>& base) {
  std::vector<double> ratios;
  for (std::size_t i = 0; i < std::min(seconds.size(), base.size()); ++i)
    if (seconds[i] > 0 && base[i] > 0) ratios.push_back(seconds[i] / base[i]);
  return ratios.empty() ? 1 : median_of(ratios);
}

double middle_seconds(const std::vector<double>& seconds) {
  std::vector<double> known;
  for (const double each : seconds)
    if (each > 0) known.push_back(each);
  return median_of(known);
}

/// The values of a setting that are worth trying.
template <class T>
std::vector<T> tried(const std::string& name, T CalibrationSettings::*member) {
  std::vector<T> values;
  for (const auto& setting : calibration_settings()) {
    if (setting.name != name) continue;
    for (const std::string& text : setting.trade->tried) {
      CalibrationSettings settings;
      [[maybe_unused]] const Status known = setting.set(settings, text);
      assert(known.ok());  // the table's own value
      values.push_back(settings.*member);
    }
  }
  assert(!values.empty());
  return values;
}

/// The smallest above a value, where there is one.
std::vector<int> next_above(const std::vector<int>& values, int value) {
  int next = std::numeric_limits<int>::max();
  for (const int each : values)
    if (each > value) next = std::min(next, each);
  return next == std::numeric_limits<int>::max() ? std::vector<int>() : std::vector<int>{next};
}

}  // namespace

std::vector<CalibratingChoice> calibrating_choices(const CalibratingChoice& base, bool quick) {
  constexpr int kFew = 3, kMany = 12;
  constexpr int kMaxImages = 16;  // more of them hardly change a press's result
  const auto all_presses = tried("presses", &CalibrationSettings::presses);
  const auto all_images = tried("pictures-per-press", &CalibrationSettings::frames_per_press);
  std::vector<CalibratingChoice> choices;
  const auto add = [&](const CalibratingChoice& choice) {
    if (std::find(choices.begin(), choices.end(), choice) == choices.end())
      choices.push_back(choice);
  };
  const auto with_presses = [&](int presses) {
    CalibratingChoice choice = base;
    choice.presses = presses;
    return choice;
  };
  add(base);
  if (base.presses < CalibratingBench::kMaxPresses) add(with_presses(base.presses + 1));
  for (const int presses : all_presses)
    if (presses > 0 && presses <= CalibratingBench::kMaxPresses &&
        (!quick || presses < base.presses - 1))
      add(with_presses(presses));
  const std::vector<int> counts =
      quick ? std::vector<int>{base.presses} : std::vector<int>{kFew, base.presses};
  for (const int images : quick ? next_above(all_images, base.images) : all_images)
    for (const int presses : counts) {
      CalibratingChoice choice = with_presses(presses);
      choice.images = images;
      if (images > base.images && images <= kMaxImages) add(choice);
    }
  for (const CalibrationMethod method : tried("method", &CalibrationSettings::method))
    for (const int presses : quick ? counts : std::vector<int>{kFew, base.presses, kMany}) {
      CalibratingChoice choice = with_presses(presses);
      choice.method = method;
      add(choice);
    }
  if (quick) return choices;
  for (const FamilyChoice family : tried("family", &CalibrationSettings::family)) {
    CalibratingChoice choice = base;
    choice.family = family;
    add(choice);
  }
  for (const int iterations : tried("iterations", &CalibrationSettings::iterations)) {
    CalibratingChoice choice = base;
    choice.iterations = iterations;
    add(choice);
  }
  return choices;
}

CalibratingChoice choice_of_finger(const Finger& finger) {
  CalibratingChoice choice;
  if (!finger.mapping_record || finger.mapping_record->presses.empty()) return choice;
  choice.presses = static_cast<int>(
      std::min<std::size_t>(finger.mapping_record->presses.size(), CalibratingBench::kMaxPresses));
  return choice;
}

Result<CalibratingStudy> study_calibrating(const FingerPtr& finger,
                                           const CalibratingOptions& options, const Job& job) {
  auto bench = CalibratingBench::make(finger, options.seed, job);
  if (!bench) return bench.error();
  CalibratingStudy study;
  study.about = en::say("calibrating {} anew", finger->finger.name);
  study.world_checksum = bench->checksum();
  study.technician = options.technician;
  auto splits = RealSplits::open(finger, options.seed, job);
  if (!splits) study.no_real_reason = splits.error().what;
  const CalibratingChoice base = options.base.value_or(choice_of_finger(finger->finger));
  const auto choices = calibrating_choices(base, options.quick);
  const int draws = options.quick ? kQuickDraws : kDraws;
  std::vector<double> base_seconds;
  const StudyClock clock;
  for (std::size_t i = 0; i < choices.size(); ++i) {
    if (job.stop_requested()) return stopped_calibrating();
    const auto part = [&](std::size_t at) {
      return static_cast<double>(at) / static_cast<double>(choices.size());
    };
    clock.report(job, part(i), en::say("calibrating with {}", words_of(choices[i])));
    Job quiet(job, part(i), part(i));  // the calibration's own progress is not the study's
    auto sum = paint_and_calibrate(*bench, choices[i], draws, quiet);
    if (!sum) return sum.error();
    if (i == 0) base_seconds = sum->seconds;
    CalibratingRow row;
    row.choice = choices[i];
    row.draws = sum->draws;
    row.failed = sum->failed;
    row.painted = spread_of_errors(sum->errors_mm);
    row.computing_s = middle_seconds(sum->seconds);
    row.time_ratio = ratio_to(sum->seconds, base_seconds);
    row.technician_min = options.technician.minutes(row.choice.presses, row.choice.images);
    if (splits) splits->measure(choices[i], draws, quiet, row);
    study.rows.push_back(row);
  }
  return study;
}

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

Result<CalibratingBench> CalibratingBench::make(const FingerPtr& finger, std::uint64_t seed,
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
    return Error{en::say("too few images of the reference recording show the face"),
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
      Pipeline::with_library(untouched_.library, finger().without_mapping(),
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
    read.presses.push_back(Press{frame->name, std::move(*seen->difference), std::move(*seen->shape),
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
                 finger().folder.string(), ""};
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

Result<std::vector<float>> CalibratingBench::errors_mm(const Mapping& mapping, bool is_paper,
                                                       int draw, const Job& job) {
  auto& frames = new_[draw];
  if (frames.empty())
    for (int number = 0; number < kTestImages; ++number)
      if (auto frame = painted(draw, number, 1, true)) frames.push_back(std::move(*frame));
  std::optional<Pipeline> pipeline;
  if (is_paper) {
    if (const Status ready = need_paper(job); !ready) return ready.error();
    pipeline.emplace(std::make_unique<PaperMethod>(paper_->with(mapping)));
  } else {
    FingerSnapshot measuring = finger();
    measuring.mapping = mapping;
    measuring.finger.mapping = mapping.parameters();
    pipeline = Pipeline::with_library(untouched_.library, measuring,
                                      settings_for_presses(measuring_settings(finger().folder)));
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

namespace {

std::string family_name(FamilyChoice family) {
  CalibrationSettings settings;
  settings.family = family;
  for (const auto& setting : calibration_settings())
    if (setting.name == "family") return setting.get(settings);
  return {};
}

double painted_median_mm(const CalibratingRow& row) {
  return row.painted && row.failed == 0 ? row.painted->median_mm
                                        : std::numeric_limits<double>::infinity();
}

const CalibratingRow* row_of_choice(const CalibratingStudy& study,
                                    const CalibratingChoice& choice) {
  const auto found = std::find_if(study.rows.begin(), study.rows.end(),
                                  [&](const auto& row) { return row.choice == choice; });
  return found == study.rows.end() || !found->painted ? nullptr : &*found;
}

Message benefit_of(const Message& what, const CalibratingRow& now, const CalibratingRow& then) {
  return en::say(
      "{}: median depth error {:.1f} instead of {:.1f} micrometres, 95 % within {:.1f} instead of "
      "{:.1f}, for {:.1f} more minutes",
      what, 1000 * then.painted->median_mm, 1000 * now.painted->median_mm,
      1000 * then.painted->p95_mm, 1000 * now.painted->p95_mm,
      total_minutes(then) - total_minutes(now));
}

std::string um(const std::optional<ErrorSpread>& spread, double ErrorSpread::*member) {
  return spread ? fmt::format("{:.1f}", 1000 * (*spread).*member) : "-";
}

std::optional<ErrorSpread> real_depth(const CalibratingRow& row) {
  return row.real ? std::optional(row.real->depth) : std::nullopt;
}

std::string line_of_row(const CalibratingRow& row) {
  std::string line = fmt::format(
      "{:>8.1f} {:>8.2f} {:>8.2f} {:>9} {:>8} {:>9} {:>8}  {}", row.technician_min, row.computing_s,
      row.time_ratio, um(row.painted, &ErrorSpread::median_mm),
      um(row.painted, &ErrorSpread::p95_mm), um(real_depth(row), &ErrorSpread::median_mm),
      um(real_depth(row), &ErrorSpread::p95_mm), words_of(row.choice));
  if (row.failed > 0) line += fmt::format("   ({} of {} gave no mapping)", row.failed, row.draws);
  return line + '\n';
}

}  // namespace

Message words_of(const CalibratingChoice& choice) {
  CalibrationSettings settings = fit_settings(choice), defaults;
  settings.presses = choice.presses;
  settings.frames_per_press = choice.images;
  defaults.frames_per_press = CalibratingChoice{}.images;
  std::vector<Message> words;
  for (const char* name : {"presses", "pictures-per-press", "method", "family", "iterations"})
    for (const auto& setting : calibration_settings())
      if (setting.name == name && setting.get(settings) != setting.get(defaults))
        words.push_back(setting.phrase(settings));
  return en::list(words);
}

double total_minutes(const CalibratingRow& row) {
  return row.technician_min + row.computing_s / 60;
}

std::vector<std::size_t> calibrating_front(const CalibratingStudy& study) {
  const auto beats = [](const CalibratingRow& a, const CalibratingRow& b) {
    const double min_a = total_minutes(a), min_b = total_minutes(b);
    const double mm_a = painted_median_mm(a), mm_b = painted_median_mm(b);
    return min_a <= min_b && mm_a <= mm_b && (min_a < min_b || mm_a < mm_b);
  };
  std::vector<std::size_t> front;
  for (std::size_t i = 0; i < study.rows.size(); ++i) {
    const CalibratingRow& row = study.rows[i];
    if (painted_median_mm(row) == std::numeric_limits<double>::infinity()) continue;
    if (std::none_of(study.rows.begin(), study.rows.end(),
                     [&](const CalibratingRow& other) { return beats(other, row); }))
      front.push_back(i);
  }
  std::sort(front.begin(), front.end(), [&](std::size_t a, std::size_t b) {
    return total_minutes(study.rows[a]) < total_minutes(study.rows[b]);
  });
  return front;
}

std::vector<Message> benefit_of_more_data(const CalibratingStudy& study,
                                          const CalibratingChoice& from) {
  std::vector<Message> sentences;
  const CalibratingRow* now = row_of_choice(study, from);
  if (now == nullptr) return sentences;
  const CalibratingRow* more_presses = nullptr;  // fewest beyond
  const CalibratingRow* more_images = nullptr;   // fewest beyond
  for (const CalibratingRow& row : study.rows) {
    if (!row.painted) continue;
    CalibratingChoice same = row.choice;
    same.presses = from.presses;
    if (same == from && row.choice.presses > from.presses &&
        (more_presses == nullptr || row.choice.presses < more_presses->choice.presses))
      more_presses = &row;
    same = row.choice;
    same.images = from.images;
    if (same == from && row.choice.images > from.images &&
        (more_images == nullptr || row.choice.images < more_images->choice.images))
      more_images = &row;
  }
  if (more_presses != nullptr)
    sentences.push_back(benefit_of(
        en::count("{} more presses", "{} more press", more_presses->choice.presses - from.presses),
        *now, *more_presses));
  if (more_images != nullptr)
    sentences.push_back(benefit_of(en::say("{} images of each press", more_images->choice.images),
                                   *now, *more_images));
  const CalibratingRow* minute = nullptr;  // the best within a minute more
  for (const CalibratingRow& row : study.rows)
    if (row.painted && total_minutes(row) <= total_minutes(*now) + 1 &&
        painted_median_mm(row) < painted_median_mm(minute != nullptr ? *minute : *now))
      minute = &row;
  if (minute != nullptr)
    sentences.push_back(benefit_of(
        en::say("The best within one more minute ({})", words_of(minute->choice)), *now, *minute));
  return sentences;
}

std::string text_of(const CalibratingStudy& study) {
  std::string text = fmt::format(
      "{:>8} {:>8} {:>8} {:>9} {:>8} {:>9} {:>8}\n{:>8} {:>8} {:>8} {:>9} {:>8} {:>9} {:>8}\n",
      "minutes", "seconds", "ratio", "painted", "95 %", "real", "95 %", "of hand", "computed", "",
      "(um)", "(um)", "(um)", "(um)");
  text += "Nothing studied takes less time and reads depth closer (painted) than these:\n";
  for (const std::size_t row : calibrating_front(study)) text += line_of_row(study.rows[row]);
  text += "All that was studied:\n";
  for (const CalibratingRow& row : study.rows) text += line_of_row(row);
  if (!study.no_real_reason.empty())
    text += fmt::format("Nothing is told of real presses: {}.\n", study.no_real_reason);
  text += fmt::format(
      "Minutes of hand are an estimate: {:.0f} s once, {:.0f} s a press, {:.2f} s a further "
      "picture.\n",
      study.technician.once_s, study.technician.press_s, study.technician.image_s);
  for (const Message& sentence : benefit_of_more_data(study, study.rows.front().choice))
    text += fmt::format("{}.\n", sentence);
  return text;
}

std::string csv_of(const CalibratingStudy& study) {
  std::string csv =
      "presses,pictures,method,family,iterations,technician_min,computing_s,time_ratio,draws,"
      "failed,"
      "painted_median_mm,painted_p95_mm,splits,splits_failed,real_median_mm,real_p95_mm,on_front\n";
  const auto number = [](const std::optional<ErrorSpread>& spread, double ErrorSpread::*member) {
    return spread ? fmt::format("{}", (*spread).*member) : "";
  };
  const auto front = calibrating_front(study);
  for (std::size_t i = 0; i < study.rows.size(); ++i) {
    const CalibratingRow& row = study.rows[i];
    csv += fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n", row.choice.presses,
                       row.choice.images, method_name(row.choice.method),
                       family_name(row.choice.family), row.choice.iterations, row.technician_min,
                       row.computing_s, row.time_ratio, row.draws, row.failed,
                       number(row.painted, &ErrorSpread::median_mm),
                       number(row.painted, &ErrorSpread::p95_mm), row.splits, row.splits_failed,
                       number(real_depth(row), &ErrorSpread::median_mm),
                       number(real_depth(row), &ErrorSpread::p95_mm),
                       std::find(front.begin(), front.end(), i) != front.end() ? 1 : 0);
  }
  return csv;
}

nlohmann::json json_of(const CalibratingStudy& study) {
  nlohmann::json json{{"about", study.about.english()},
                      {"truth", "painted, and real presses apart"},
                      {"world", fmt::format("{:016x}", study.world_checksum)},
                      {"technician",
                       {{"once_s", study.technician.once_s},
                        {"press_s", study.technician.press_s},
                        {"picture_s", study.technician.image_s},
                        {"is_estimate", true}}}};
  if (!study.no_real_reason.empty()) json["no_real"] = study.no_real_reason.english();
  const auto front = calibrating_front(study);
  const auto spread = [](const ErrorSpread& of) {
    return nlohmann::json{{"median_mm", of.median_mm}, {"p95_mm", of.p95_mm}};
  };
  nlohmann::json& rows = json["rows"] = nlohmann::json::array();
  for (std::size_t i = 0; i < study.rows.size(); ++i) {
    const CalibratingRow& row = study.rows[i];
    nlohmann::json errors{{"draws", row.draws},
                          {"failed", row.failed},
                          {"splits", row.splits},
                          {"splits_failed", row.splits_failed}};
    if (row.painted) errors["painted"] = spread(*row.painted);
    if (row.real) errors["real"] = spread(row.real->depth);
    rows.push_back({{"words", words_of(row.choice).english()},
                    {"presses", row.choice.presses},
                    {"pictures", row.choice.images},
                    {"method", method_name(row.choice.method)},
                    {"family", family_name(row.choice.family)},
                    {"iterations", row.choice.iterations},
                    {"errors", std::move(errors)},
                    {"times",
                     {{"computing_s", row.computing_s},
                      {"ratio", row.time_ratio},
                      {"technician_min", row.technician_min}}},
                    {"on_front", std::find(front.begin(), front.end(), i) != front.end()}});
  }
  nlohmann::json& more = json["one_more"] = nlohmann::json::array();
  for (const Message& sentence : benefit_of_more_data(study, study.rows.front().choice))
    more.push_back(sentence.english());
  return json;
}

}  // namespace alltact
