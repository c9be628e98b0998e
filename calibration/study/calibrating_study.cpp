#include "calibration/study/calibrating_study.h"

#include "calibration/finger/measuring_settings.h"
#include "calibration/joint/calibrate.h"
#include "calibration/study/calibrating_bench.h"
#include "calibration/study/study_clock.h"
#include "core/numerics/philox.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numeric>

namespace alltact {
namespace {

constexpr int kQuickDraws = 1, kDraws = 3;

Result<Calibration> calibrate_with(const std::vector<Press>& presses,
                                   const FingerSnapshot& finger,
                                   const CalibratingChoice& choice,
                                   const Job& job) {
  CalibrationSettings settings;
  settings.method = choice.method;
  settings.family = choice.family;
  settings.iterations = choice.iterations;
  return calibrate(presses, finger.camera, finger.finger.face, settings, job);
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

Error stopped_calibrating() {
  return {en::say("stopped before the study was over"), "", ""};
}

/// Errors of one choice, summed over draws.
struct PaintedSum {
  int draws = 0, failed = 0;
  std::vector<float> errors_mm;
  std::vector<double> seconds;  // by draw; 0 where it failed
};

Result<PaintedSum> paint_and_calibrate(CalibratingBench& bench,
                                       const CalibratingChoice& choice,
                                       int draws,
                                       const Job& job) {
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
      return Error{en::say("the finger keeps too few presses to leave one out: {}",
                           splits.own_presses_.size()),
                   finger->folder.string(),
                   en::say("calibrating it with three presses or more")};
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
      const double drawn = philox_uniform(
          seed_, "press split", static_cast<std::uint32_t>(split), static_cast<std::uint32_t>(i));
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
                                           const CalibratingOptions& options,
                                           const Job& job) {
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

}  // namespace alltact
