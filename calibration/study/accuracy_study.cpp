#include "calibration/study/accuracy_study.h"

#include "calibration/study/evaluate.h"
#include "calibration/study/real_presses.h"
#include "calibration/study/study_machine.h"
#include "core/numerics/median.h"
#include "core/sensing/pipeline.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <vector>

#include <opencv2/imgproc.hpp>

namespace alltact {
namespace {

constexpr std::size_t kBatch = 5;  // choices that take turns with the base

std::optional<ErrorSpread> spread_of(std::vector<float>& errors) {
  if (errors.empty()) return std::nullopt;
  ErrorSpread spread;
  spread.median_mm = upper_median(errors);
  const std::size_t rank = std::min(errors.size() - 1, errors.size() * 95 / 100);
  const auto at = errors.begin() + static_cast<std::ptrdiff_t>(rank);
  std::nth_element(errors.begin(), at, errors.end());
  spread.p95_mm = *at;
  return spread;
}

double quantile_of(std::vector<double> values, double part) {
  if (values.empty()) return 0;
  // Of an even number the upper middle one, as upper_median(): no part is less than a smaller one.
  const auto rank = static_cast<std::ptrdiff_t>(
      std::min(part * static_cast<double>(values.size()), static_cast<double>(values.size() - 1)));
  std::nth_element(values.begin(), values.begin() + rank, values.end());
  return values[static_cast<std::size_t>(rank)];
}

/// The settings that a library depends on (finger_as_measured()).
using LibraryKey = std::pair<Resolution, bool>;
LibraryKey library_key_of(const PipelineSettings& settings) {
  return {settings.resolution, settings.undistort};
}

/// What is known of a frame in addition to its image.
struct FrameMasks {
  cv::Mat away;  // CV_8UC1: further than kAwayMm from any contact
};

std::optional<Eigen::Vector2d> position_of(const std::vector<ContactRegion>& regions) {
  if (regions.empty()) return std::nullopt;
  return regions.front().deepest_on_face_mm;  // of the region in the first position
}

class Measured {
 public:
  void add_errors(const StudyFrame& frame, const FrameMasks& masks, const FrameResult& result) {
    ++row_.frames;
    if (!result.depth) {
      ++row_.frames_missing;
      return;
    }
    const auto zone = static_cast<std::size_t>(frame.zone);
    const cv::Mat depth =
        at_full_size(result.depth->depth_mm, result.reduced_by, frame.depth_mm.size());
    for (int v = 0; v < depth.rows; ++v) {
      const auto* truth = frame.depth_mm.ptr<float>(v);
      const auto* read = depth.ptr<float>(v);
      const auto* away = masks.away.ptr<std::uint8_t>(v);
      for (int u = 0; u < depth.cols; ++u) {
        const bool is_read = std::isfinite(read[u]);
        if (truth[u] > kPressedMm) {
          ++pressed_;
          if (!is_read) continue;
          ++covered_;
          errors_[zone].push_back(std::abs(read[u] - truth[u]));
        } else if (away[u] != 0 && is_read) {
          false_sum_ += std::abs(read[u]);
          ++false_count_;
        }
      }
    }
    const auto position_mm = position_of(result.regions);
    if (frame.position_mm && position_mm)
      position_errors_mm_.push_back((*position_mm - *frame.position_mm).norm());
  }
  void add_angle(const StudyFrame& frame, const FrameResult& result) {
    ++row_.bars;
    if (result.regions.empty() || !result.regions.front().angle_deg) {
      ++row_.bars_missing;
      return;
    }
    const double off_deg = *result.regions.front().angle_deg - frame.angle_deg.value();
    angles_deg_.push_back(std::abs(std::remainder(off_deg, 180.0)));  // a bar has no front
  }
  void add_time(double milliseconds, double base_milliseconds) {
    times_ms_.push_back(milliseconds);
    ratios_.push_back(milliseconds / base_milliseconds);
  }
  void set_memory(std::size_t bytes) { row_.memory_bytes = bytes; }
  [[nodiscard]] StudyRow row(const PipelineSettings& settings) {
    row_.settings = settings;
    std::vector<float> all;
    for (std::size_t zone = 0; zone < kFaceZones; ++zone) {
      all.insert(all.end(), errors_[zone].begin(), errors_[zone].end());
      row_.depth_by_zone[zone] = spread_of(errors_[zone]);
    }
    row_.depth = spread_of(all);
    if (pressed_ > 0) row_.coverage = static_cast<double>(covered_) / static_cast<double>(pressed_);
    if (false_count_ > 0) row_.false_depth_mm = false_sum_ / static_cast<double>(false_count_);
    if (!position_errors_mm_.empty()) row_.position_mm = upper_median(position_errors_mm_);
    if (!position_errors_mm_.empty()) row_.position_p95_mm = quantile_of(position_errors_mm_, 0.95);
    if (!angles_deg_.empty()) row_.angle_deg = upper_median(angles_deg_);
    if (!angles_deg_.empty()) row_.angle_p95_deg = quantile_of(angles_deg_, 0.95);
    row_.time_ms = quantile_of(times_ms_, 0.5);
    row_.time_p95_ms = quantile_of(times_ms_, 0.95);
    row_.time_ratio = quantile_of(ratios_, 0.5);
    return row_;
  }

 private:
  StudyRow row_;
  std::array<std::vector<float>, kFaceZones> errors_;
  std::vector<double> position_errors_mm_, angles_deg_, times_ms_, ratios_;
  std::size_t pressed_ = 0, covered_ = 0, false_count_ = 0;
  double false_sum_ = 0;
};

class AccuracyStudyRun {
 public:
  AccuracyStudyRun(const StudyWorld& world, const StudyOptions& options, const Job& job)
      : world_(world), options_(options), job_(job) {}

  /// Reads the libraries of all images that are requested. Images in which the recording shows no
  /// face (too small ones) are skipped, except those of the first choice.
  [[nodiscard]] Status read_libraries(const std::vector<PipelineSettings>& choices) {
    for (const PipelineSettings& choice : choices) {
      if (library_key_of(choice) == library_key_of({}) || others_.contains(library_key_of(choice)))
        continue;
      auto library = world_.library_for(choice, job_);
      if (library)
        others_.emplace(library_key_of(choice), std::move(library).value());
      else if (job_.stop_requested() || library_key_of(choice) == library_key_of(choices.front()))
        return library.error();
    }
    return {};
  }

  [[nodiscard]] bool has_library(const PipelineSettings& choice) const {
    return library_key_of(choice) == library_key_of({}) || others_.contains(library_key_of(choice));
  }
  /// The row of a choice that no image can be measured with.
  [[nodiscard]] StudyRow without_depth(const PipelineSettings& choice) const {
    StudyRow row;
    row.settings = choice;
    row.frames = row.frames_missing = static_cast<int>(world_.frames.size());
    return row;
  }

  [[nodiscard]] Status find_answers() {
    Pipeline pipeline = pipeline_of(options_.base);
    for (const StudyFrame& frame : world_.frames) {
      pipeline.forget();
      const auto seen = pipeline(frame.image);
      if (!seen) return seen.error();
      masks_.push_back(answer_of(frame, *seen));
    }
    return {};
  }

  /// The base is the first choice. Its row is returned along with each batch.
  [[nodiscard]] Result<std::vector<StudyRow>> measure(const std::vector<PipelineSettings>& choices,
                                                      double from, double to) {
    std::vector<Pipeline> pipelines;
    std::vector<Measured> measured(choices.size());
    for (std::size_t i = 0; i < choices.size(); ++i) {
      const std::size_t before = heap_bytes();
      pipelines.push_back(pipeline_of(choices[i]));
      const auto held = pipelines[i](world_.frames.front().image);
      if (!held) return held.error();
      const std::size_t now = heap_bytes();
      measured[i].set_memory(library_of(choices[i]).memory_bytes() +
                             (now > before ? now - before : 0));
      for (const StudyFrame& bar : world_.bars) {
        pipelines[i].forget();
        const auto seen = pipelines[i](bar.image);
        if (!seen) return seen.error();
        measured[i].add_angle(bar, *seen);
      }
    }
    const std::size_t frames = world_.frames.size();
    for (std::size_t number = 0; number < frames; ++number) {
      if (job_.stop_requested()) return Error{en::say("stopped before the study was over"), "", ""};
      clock_.report(job_,
                    from + (to - from) * static_cast<double>(number) / static_cast<double>(frames),
                    en::say("measuring what settings cost"));
      const StudyFrame& frame = world_.frames[number];
      for (std::size_t i = 0; i < choices.size(); ++i) {
        pipelines[i].forget();
        const auto single = pipelines[i](frame.image);
        if (!single) return single.error();
        measured[i].add_errors(frame, masks_[number], *single);
      }
      if (const Status timed = time_following(frame, pipelines, measured); !timed)
        return timed.error();
    }
    std::vector<StudyRow> rows;
    for (std::size_t i = 0; i < choices.size(); ++i) rows.push_back(measured[i].row(choices[i]));
    return rows;
  }

 private:
  /// For pipelines that have seen this frame, the base's first, turn by turn.
  [[nodiscard]] Status time_following(const StudyFrame& frame, std::vector<Pipeline>& pipelines,
                                      std::vector<Measured>& measured) const {
    constexpr double kSlow = 10;  // times the base: from there on one turn a frame is enough
    std::vector<char> is_slow(pipelines.size(), 0);
    for (int repeat = 0; repeat < options_.repeats; ++repeat) {
      double base_ms = 1;
      for (std::size_t i = 0; i < pipelines.size(); ++i) {
        if (is_slow[i] != 0) continue;
        const double begin_s = thread_cpu_s();
        const auto following = pipelines[i](frame.image);
        const double processor_ms = 1000 * (thread_cpu_s() - begin_s);
        if (!following) return following.error();
        // Processor time excludes the load of other programs and of other threads.
        const double milliseconds =
            cv::getNumThreads() <= 1 ? processor_ms : following->times_ms.total;
        if (i == 0) base_ms = milliseconds;
        measured[i].add_time(milliseconds, base_ms);
        is_slow[i] = milliseconds > kSlow * base_ms ? 1 : 0;
      }
    }
    return {};
  }

  [[nodiscard]] const ReferenceLibrary& library_of(const PipelineSettings& settings) const {
    const auto other = others_.find(library_key_of(settings));
    return other == others_.end() ? world_.library : other->second;
  }
  [[nodiscard]] Pipeline pipeline_of(const PipelineSettings& settings) const {
    return Pipeline::with_library(library_of(settings), *world_.finger, settings);
  }

  [[nodiscard]] FrameMasks answer_of(const StudyFrame& frame, const FrameResult& seen) const {
    FrameMasks masks;
    cv::Mat contact;
    cv::inRange(cv::abs(frame.depth_mm), kUntouchedMm, 1e6, contact);  // or bulges
    cv::Mat distance_px(contact.size(), CV_32FC1, cv::Scalar(1e6));
    if (cv::countNonZero(contact) > 0)
      cv::distanceTransform(255 - contact, distance_px, cv::DIST_L2, 3);
    double away_px = 0;
    if (seen.shape) {
      std::vector<double> z;
      for (const FaceColumn& column : seen.shape->columns())
        if (column.valid) z.push_back(column.z_mm);
      if (!z.empty()) away_px = kAwayMm / world_.finger->camera.mm_per_px_at(upper_median(z));
    }
    masks.away = distance_px > away_px;
    return masks;
  }

  const StudyWorld& world_;
  const StudyOptions& options_;
  const Job& job_;
  const StudyClock clock_;
  std::vector<FrameMasks> masks_;
  std::map<LibraryKey, ReferenceLibrary> others_;
};

}  // namespace

Result<AccuracyStudy> study_accuracy(const StudyWorld& world, const StudyOptions& options,
                                     const std::vector<StudyRow>& known, const SaveRows& save,
                                     const Job& job) {
  AccuracyStudyRun run(world, options, job);
  if (const Status status = run.find_answers(); !status) return status.error();
  const std::vector<PipelineSettings> choices =
      study_choices(options.base, options.extent, world.finger->finger);
  if (const Status status = run.read_libraries(choices); !status) return status.error();
  std::vector<StudyRow> rows = known;
  const auto row_of = [&](const PipelineSettings& choice) {
    return std::find_if(rows.begin(), rows.end(), [&](const StudyRow& row) {
      return key_of(row.settings) == key_of(choice);
    });
  };
  std::vector<PipelineSettings> left;
  std::vector<StudyRow> without;
  for (const PipelineSettings& choice : choices) {
    if (row_of(choice) != rows.end()) continue;
    if (run.has_library(choice))
      left.push_back(choice);
    else
      without.push_back(run.without_depth(choice));
  }
  if (save && !without.empty())
    if (const Status saved = save(without); !saved) return saved.error();
  rows.insert(rows.end(), without.begin(), without.end());
  for (std::size_t at = 0; at < left.size();) {
    std::vector<PipelineSettings> batch{options.base};
    const std::size_t begin = at;
    for (; at < left.size() && batch.size() <= kBatch; ++at)
      if (key_of(left[at]) != key_of(options.base)) batch.push_back(left[at]);
    const auto part = [&](std::size_t i) {
      return static_cast<double>(i) / static_cast<double>(left.size());
    };
    auto measured = run.measure(batch, part(begin), part(at));
    if (!measured) return measured.error();
    if (row_of(options.base) != rows.end()) measured->erase(measured->begin());
    if (save)
      if (const Status saved = save(*measured); !saved) return saved.error();
    rows.insert(rows.end(), measured->begin(), measured->end());
  }
  AccuracyStudy study{world.about, world.simulated, world.checksum, {}, world.mapping_p95_mm};
  for (const PipelineSettings& choice : choices) study.rows.push_back(*row_of(choice));
  return study;
}

namespace {

/// A study's images have the light of the recording that they come from.
const std::pair<std::string, std::string> kUnproven{"light-change", "ignored"};

/// One value of one setting.
struct TriedValue {
  const Setting<PipelineSettings>* setting;
  std::string value;

  [[nodiscard]] bool is_alone() const {
    const auto& alone = setting->trade->alone;
    return std::find(alone.begin(), alone.end(), value) != alone.end();
  }
};

std::vector<TriedValue> tried_values(const PipelineSettings& base, const Finger& finger) {
  std::vector<TriedValue> values;
  for (const auto& setting : pipeline_settings()) {
    if (!has_trade_off(setting, finger)) continue;
    for (const std::string& value : setting.trade->tried)
      if (value != setting.get(base)) values.push_back({&setting, value});
  }
  return values;
}

void put(const TriedValue& tried, PipelineSettings& settings) {
  [[maybe_unused]] const Status status = tried.setting->set(settings, tried.value);
  assert(status.ok());  // the table's own value
}

PipelineSettings cheapest(PipelineSettings settings, const Finger& finger) {
  for (const auto& setting : pipeline_settings())
    if (has_trade_off(setting, finger) && !setting.trade->tried.empty())
      put({&setting, setting.trade->tried.front()}, settings);
  return settings;
}

}  // namespace

std::vector<PipelineSettings> study_choices(const PipelineSettings& base, StudyExtent extent,
                                            const Finger& finger) {
  std::vector<PipelineSettings> choices;
  std::set<std::string> known;
  const auto add = [&](const PipelineSettings& choice) {
    if (known.insert(key_of(choice)).second) choices.push_back(choice);
  };
  add(base);
  const std::vector<TriedValue> values = tried_values(base, finger);
  for (const TriedValue& value : values) {
    PipelineSettings choice = base;
    put(value, choice);
    add(choice);
  }
  if (extent == StudyExtent::kQuick) return choices;
  for (std::size_t i = 0; i < values.size(); ++i)
    for (std::size_t k = i + 1; k < values.size(); ++k) {
      if (values[i].setting == values[k].setting) continue;
      if (values[i].is_alone() || values[k].is_alone()) continue;
      PipelineSettings choice = base;
      put(values[i], choice);
      put(values[k], choice);
      add(choice);
    }
  add(cheapest(base, finger));
  return choices;
}

Message words_of(const PipelineSettings& choice, const PipelineSettings& base) {
  std::string words;
  for (const auto& setting : pipeline_settings())
    if (setting.get(choice) != setting.get(base))
      words += (words.empty() ? "" : ", ") + setting.name + ' ' + setting.get(choice);
  return words.empty() ? en::say("as it is") : Message::typed(words);
}

std::string flags_of(const PipelineSettings& choice, const PipelineSettings& base) {
  std::string flags;
  for (const auto& setting : pipeline_settings())
    if (setting.get(choice) != setting.get(base))
      flags += (flags.empty() ? "--" : " --") + setting.name + ' ' + setting.get(choice);
  return flags;
}

bool is_proven(const PipelineSettings& choice, const PipelineSettings& base) {
  const auto& all = pipeline_settings();
  return std::none_of(all.begin(), all.end(), [&](const Setting<PipelineSettings>& setting) {
    return setting.name == kUnproven.first && setting.get(choice) == kUnproven.second &&
           setting.get(base) != kUnproven.second;
  });
}

std::string key_of(const PipelineSettings& choice) {
  std::string key;
  for (const auto& setting : pipeline_settings())
    key += (key.empty() ? "" : " ") + setting.name + '=' + setting.get(choice);
  return key;
}

namespace {

/// A frame's result and its processor time in a pipeline that has already seen the frame.
Result<FrameResult> timed(Pipeline& pipeline, const FramePtr& frame, double& milliseconds) {
  auto first = pipeline(frame);
  if (!first) return first;
  const double begin_s = thread_cpu_s();
  auto next = pipeline(frame);
  milliseconds = 1000 * (thread_cpu_s() - begin_s);
  return next ? std::move(first) : std::move(next);
}

}  // namespace

cv::Mat at_full_size(const cv::Mat& values, int reduced_by, cv::Size size) {
  if (reduced_by == 1) return values;
  cv::Mat full(size, CV_32FC1, cv::Scalar(std::numeric_limits<float>::quiet_NaN()));
  const cv::Size covered(values.cols * reduced_by, values.rows * reduced_by);
  cv::Mat part = full({0, 0, covered.width, covered.height});
  cv::resize(values, part, covered, 0, 0, cv::INTER_NEAREST);
  return full;
}

Result<ComparedSettings> ComparedSettings::create(const FingerSnapshot& finger,
                                                  const PipelineSettings& now,
                                                  const PipelineSettings& other, const Job& job) {
  auto first = Pipeline::create(finger, now, job);
  if (!first) return first.error();
  auto second = Pipeline::create(finger, other, job);
  if (!second) return second.error();
  return ComparedSettings(std::move(first).value(), std::move(second).value());
}

Result<ComparedFrame> ComparedSettings::operator()(const FramePtr& frame) {
  ComparedFrame compared;
  auto now = timed(now_, frame, compared.now_ms);
  if (!now) return now.error();
  auto other = timed(other_, frame, compared.other_ms);
  if (!other) return other.error();
  compared.now = std::move(now).value();
  compared.other = std::move(other).value();
  if (!compared.now.depth || !compared.other.depth) return compared;
  const int by = compared.now.reduced_by;
  const cv::Mat& first = compared.now.depth->depth_mm;
  const cv::Size full = by == 1 ? first.size()
                        : compared.other.reduced_by == 1
                            ? compared.other.depth->depth_mm.size()
                            : cv::Size(first.cols * by, first.rows * by);
  const cv::Mat a = at_full_size(first, by, full),
                b = at_full_size(compared.other.depth->depth_mm, compared.other.reduced_by, full);
  compared.difference_mm = b - a;
  std::vector<float> pressed_mm;
  for (int v = 0; v < full.height; ++v)
    for (int u = 0; u < full.width; ++u) {
      const float off = compared.difference_mm.at<float>(v, u);
      const bool is_pressed = a.at<float>(v, u) > kPressedMm || b.at<float>(v, u) > kPressedMm;
      if (std::isfinite(off) && is_pressed) pressed_mm.push_back(std::abs(off));
    }
  if (const auto spread = spread_of_errors(pressed_mm)) {
    compared.median_mm = spread->median_mm;
    compared.p95_mm = spread->p95_mm;
  }
  return compared;
}

}  // namespace alltact
