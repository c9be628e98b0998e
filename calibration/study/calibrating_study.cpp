#include "calibration/study/calibrating_study.h"

#include "calibration/finger/measuring_settings.h"
#include "calibration/joint/calibrate.h"
#include "calibration/study/calibrating_bench.h"
#include "calibration/study/study_clock.h"
#include "core/numerics/philox.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace alltact {
namespace {

constexpr int kQuickDraws = 1, kDraws = 3;

/// Stops a calculation after so many rounds of its last stretch; the rest of it goes with `job`.
Result<Calibration> calibrate_with(const std::vector<Press>& presses,
                                   const FingerSnapshot& finger,
                                   const CalibratingChoice& choice,
                                   const Job& job) {
  CalibrationSettings settings;
  settings.method = choice.method;
  settings.family = choice.family;
  Job part(job, 0, 1);
  RoundListener count;
  if (choice.rounds > 0)
    count = [&](const Round& round) {
      if (round.number >= choice.rounds) part.request_stop();
    };
  return calibrate(presses, finger.camera, finger.finger.face, settings, part, count);
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
    const auto read = bench.presses(draw, choice.pictures);
    if (!read) return read.error();
    const auto read_s = first_of((*read)->read_s, choice.presses);
    const auto frames = first_of((*read)->frames, choice.presses);
    const auto taken =
        is_paper ? bench.as_paper(frames, job) : Result(first_of((*read)->presses, choice.presses));
    ++sum.draws;
    sum.seconds.push_back(0);
    const double begin_s = computed_s();
    const auto made = taken ? calibrate_with(*taken, bench.finger(), choice, job)
                            : Result<Calibration>(taken.error());
    if (job.stop_requested()) return stopped_calibrating();
    const auto mapping = made ? Mapping::create(made->mapping) : Result<Mapping>(made.error());
    if (!mapping) {
      ++sum.failed;
      continue;
    }
    sum.seconds.back() =
        computed_s() - begin_s + std::accumulate(read_s.begin(), read_s.end(), 0.0);
    const auto errors = bench.errors_mm(*mapping, is_paper, draw, job);
    if (!errors) return errors.error();
    sum.errors_mm.insert(sum.errors_mm.end(), errors->begin(), errors->end());
  }
  return sum;
}

/// The finger's own presses, as ours and as the paper's steps read them.
class RealSplits {
 public:
  static Result<RealSplits> open(const FingerPtr& finger, std::uint64_t seed, const Job& job) {
    auto presses = RealPresses::open(finger, job);
    if (!presses) return presses.error();
    RealSplits splits(std::move(presses).value(), seed);
    auto ours = splits.presses_.measured(measuring_settings(finger->folder), job);
    if (!ours) return ours.error();
    splits.ours_ = std::move(ours).value();
    if (splits.ours_.size() < RealPresses::kLeast)
      return Error{
          en::say("the finger keeps too few presses to leave one out: {}", splits.ours_.size()),
          finger->folder.string(),
          en::say("calibrating it with three presses or more")};
    return splits;
  }

  void measure(const CalibratingChoice& choice, int splits, const Job& job, CalibratingRow& row) {
    if (choice.pictures != 1 || choice.presses >= std::ssize(ours_)) return;
    const bool is_paper = choice.method == CalibrationMethod::kPaper;
    if (is_paper) read_as_paper(job);
    const std::vector<Press>& all = is_paper ? papers_ : ours_;
    if (choice.presses >= std::ssize(all)) return;
    RealErrorSum sum;
    for (int split = 0; split < splits; ++split) {
      std::vector<Press> kept, left;
      for (const std::size_t i : shuffled(all.size(), split))
        (std::ssize(kept) < choice.presses ? kept : left).push_back(all[i]);
      ++row.splits;
      const auto made = calibrate_with(kept, presses_.finger(), choice, job);
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
    auto read = paper_presses(*method, presses_.frames(), presses_.inputs().said, job);
    if (read) papers_ = std::move(read).value();
  }

  /// Fisher and Yates.
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
  std::vector<Press> ours_, papers_;
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

}  // namespace

std::vector<CalibratingChoice> calibrating_choices(bool quick) {
  const CalibratingChoice base;
  std::vector<CalibratingChoice> choices;
  const auto add = [&](const CalibratingChoice& choice) {
    if (std::find(choices.begin(), choices.end(), choice) == choices.end())
      choices.push_back(choice);
  };
  using M = CalibrationMethod;
  using F = FamilyChoice;
  add(base);
  for (const int presses :
       quick ? std::vector<int>{1, 2, 3, 4, 7} : std::vector<int>{1, 2, 3, 4, 5, 7, 8, 10, 12})
    add({presses});
  for (const int pictures : quick ? std::vector<int>{4} : std::vector<int>{4, 16})
    for (const int presses :
         quick ? std::vector<int>{base.presses} : std::vector<int>{3, base.presses})
      add({presses, pictures});
  for (const M method : {M::kPaper, M::kCircle, M::kCone})
    for (const int presses :
         quick ? std::vector<int>{base.presses} : std::vector<int>{3, base.presses, 12})
      add({presses, 1, method});
  if (quick) return choices;
  for (const F family : {F::kPolynomial, F::kMoebius, F::kLayer})
    add({base.presses, 1, M::kJoint, family});
  for (const int rounds : {1, 2, 4}) add({base.presses, 1, M::kJoint, F::kAuto, rounds});
  return choices;
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
  if (!splits) study.no_real = splits.error().what;
  const auto choices = calibrating_choices(options.quick);
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
    row.technician_min = options.technician.minutes(row.choice.presses, row.choice.pictures);
    if (splits) splits->measure(choices[i], draws, quiet, row);
    study.rows.push_back(std::move(row));
  }
  return study;
}

}  // namespace alltact
