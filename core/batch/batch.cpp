#include "core/batch/batch.h"

#include "core/base/guarded.h"
#include "core/base/json_fields.h"
#include "core/numerics/parallel.h"
#include "core/sensing/result_json.h"

#include <algorithm>
#include <cassert>
#include <condition_variable>
#include <deque>
#include <map>
#include <mutex>
#include <utility>

#include <opencv2/core/utility.hpp>

namespace alltact {
namespace {

/// Brings a pipeline to the state after the frames `before` a piece (null: could not be read).
template <class Frames>
void begin_piece(Pipeline& pipeline, const Frames& before, bool is_continuous) {
  pipeline.forget();
  if (!is_continuous) return;
  for (const FramePtr& frame : before)
    if (frame) pipeline.warm_up(frame);
}

/// Consecutive frames, and those before them.
struct FramePiece {
  std::size_t number = 0;
  std::vector<FramePtr> before;
  std::vector<BatchFrame> frames;
};

class Batch {
 public:
  Batch(Source& source, std::vector<Pipeline>& pipelines, const BatchFrames& frames,
        const BatchWork& work, const Job& job)
      : source_(source), pipelines_(pipelines), frames_(frames), work_(work), job_(job) {}

  Status run() {
    const bool is_sequential = pipelines_.front().has_long_memory();
    next_index_ = frames_.first;
    next_taken_ = frames_.first / kPieceFrames;
    skip_to_first();
    const std::size_t count = is_sequential ? 1 : pipelines_.size();
    window_ = count + 1;
    const int threads = static_cast<int>(count);
    parallel_for(threads, threads, [&](int begin, int end) {
      for (int i = begin; i < end; ++i)
        work_on(pipelines_[static_cast<std::size_t>(i)], is_sequential);
    });
    return failed_ ? Status(*failed_) : Status();
  }

 private:
  /// Skips to the first frame, and reads the warm-up frames before it.
  void skip_to_first() {
    const std::size_t warm_up_count =
        std::min(frames_.first, source_.is_continuous() ? kWarmUpFrames : 0);
    source_.skip(frames_.first - warm_up_count);
    for (std::size_t i = 0; i < warm_up_count; ++i) {
      const auto frame = source_.next();
      tail_.push_back(frame ? *frame : nullptr);
    }
  }

  /// The next piece; nullopt: there is none, or the batch has ended.
  std::optional<FramePiece> read() {
    const std::lock_guard reading(reader_);
    {
      std::unique_lock lock(order_);
      changed_.wait(lock,
                    [&] { return failed_ || next_index_ / kPieceFrames < next_taken_ + window_; });
      if (failed_) return std::nullopt;
    }
    if (is_over_ || job_.stop_requested()) return std::nullopt;
    FramePiece piece{next_index_ / kPieceFrames, {tail_.begin(), tail_.end()}, {}};
    while (piece.frames.size() < kPieceFrames && next_index_ < frames_.end) {
      auto frame = source_.next();
      if (frame && !*frame) break;
      BatchFrame next;
      next.index = next_index_++;
      if (frame)
        next.frame = *frame;
      else
        next.problem = frame.error();
      tail_.push_back(next.frame);
      if (tail_.size() > kWarmUpFrames) tail_.pop_front();
      if (work_.inspect) work_.inspect(next);
      piece.frames.push_back(std::move(next));
    }
    is_over_ = piece.frames.size() < kPieceFrames || next_index_ >= frames_.end;
    if (piece.frames.empty()) return std::nullopt;
    return piece;
  }

  void work_on(Pipeline& pipeline, bool is_sequential) {
    try {
      while (auto piece = read()) {
        std::vector<FrameLine> lines;
        if (!is_sequential) begin_piece(pipeline, piece->before, source_.is_continuous());
        for (BatchFrame& frame : piece->frames) {
          if (!source_.is_continuous()) pipeline.forget();
          measure(pipeline, frame);
          auto line = work_.write(frame, pipeline);
          if (!line) return fail(line.error());
          lines.push_back(std::move(*line));
          frame = {};  // releases its memory
        }
        if (!done(piece->number, std::move(lines))) return;
      }
    } catch (...) {
      fail(caught_error());
    }
  }

  static void measure(Pipeline& pipeline, BatchFrame& frame) {
    if (frame.problem || !frame.frame) return;
    auto result = pipeline.measure_untracked(frame.frame);
    if (result)
      frame.result = std::move(*result);
    else
      frame.problem = result.error();
  }

  void fail(Error error) {
    const std::lock_guard lock(order_);
    if (!failed_) failed_ = std::move(error);
    changed_.notify_all();
  }

  /// Delivers finished pieces in order. False: the batch has ended.
  bool done(std::size_t number, std::vector<FrameLine>&& lines) {
    const std::lock_guard lock(order_);
    done_.emplace(number, std::move(lines));
    while (!failed_ && !done_.empty() && done_.begin()->first == next_taken_) {
      auto& ready = done_.begin()->second;
      for (std::size_t i = 0; i < ready.size() && !failed_; ++i)
        if (Status status = work_.take(next_taken_ * kPieceFrames + i, std::move(ready[i]));
            !status)
          failed_ = status.error();
      done_.erase(done_.begin());
      ++next_taken_;
    }
    changed_.notify_all();
    return !failed_;
  }

  Source& source_;
  std::vector<Pipeline>& pipelines_;
  const BatchFrames frames_;
  const BatchWork& work_;
  const Job& job_;

  std::mutex reader_;  // guards:
  std::size_t next_index_ = 0;
  std::deque<FramePtr> tail_;  // the last frames read; null: could not be read
  bool is_over_ = false;

  std::mutex order_;  // guards:
  std::condition_variable changed_;
  std::map<std::size_t, std::vector<FrameLine>> done_;  // pieces that wait for an earlier one
  std::size_t next_taken_ = 0;                          // piece
  std::optional<Error> failed_;
  std::size_t window_ = 2;  // pieces that may be in progress
};

}  // namespace

int batch_threads(int requested) {
  constexpr int kMost = 64;
  return requested > 0 ? requested : std::clamp(cv::getNumberOfCPUs(), 1, kMost);
}

Result<std::vector<Pipeline>> batch_pipelines(int threads,
                                              const std::function<Result<Pipeline>()>& make) {
  std::vector<Pipeline> pipelines;
  while (pipelines.size() < static_cast<std::size_t>(threads)) {
    auto pipeline = make();
    if (!pipeline) return pipeline.error();
    pipelines.push_back(std::move(*pipeline));
    if (pipelines.front().has_long_memory()) break;
  }
  return pipelines;
}

Status measure_batch(Source& source, std::vector<Pipeline>& pipelines, const BatchFrames& frames,
                     const BatchWork& work, const Job& job) {
  assert(!pipelines.empty() && frames.first % kPieceFrames == 0);
  return Batch(source, pipelines, frames, work, job).run();
}

static void describe(JsonFields& fields, PositionOnFinger& position) {
  fields.field("along_mm", position.along_mm);
  fields.field("limits", position.limits);
  fields.field("across_mm", position.across_mm);
  fields.field("depth_mm", position.depth_mm);
  fields.field("along_sd_mm", position.along_sd_mm);
  fields.field("across_sd_mm", position.across_sd_mm);
  fields.field("depth_sd_mm", position.depth_sd_mm);
}

static void describe(JsonFields& fields, ContactIndentation& indentation) {
  fields.field("position", indentation.position);
  fields.field("direction", indentation.direction);
  fields.field("on_skin_mm", indentation.on_skin_mm);
  fields.field("on_skin_covariance_mm2", indentation.on_skin_covariance_mm2);
}

static void describe(JsonFields& fields, ContactDeflection& deflection) {
  int face = static_cast<int>(deflection.face);
  fields.field("face", face);
  if (face < 1 || face > 4) throw std::out_of_range("face");
  deflection.face = static_cast<PushedFace>(face);
  fields.field("direction", deflection.direction);
  fields.field("direction_sd_deg", deflection.direction_sd_deg);
  fields.field("position", deflection.position);
}

static void describe(JsonFields& fields, ContactEvidence& evidence) {
  fields.field("push", evidence.push);
  fields.field("time_s", evidence.time_s);
  fields.field("depth", evidence.depth);
  fields.field("is_face_pressed", evidence.is_face_pressed);
  fields.field("indentation", evidence.indentation);
  fields.field("deflection", evidence.deflection);
}

static void describe(JsonFields& fields, FrameLine& frame) {
  fields.field("frame", frame.frame);
  fields.field("line", frame.line);
  fields.field("measured", frame.is_measured);
  fields.field("total_ms", frame.total_ms);
  fields.field("evidence", frame.evidence);
}

std::string FrameLine::to_json() const {
  using Json = JsonFields::Json;
  return written_json(*this).dump(-1, ' ', false, Json::error_handler_t::replace);
}

Result<FrameLine> FrameLine::from_json(std::string_view text) {
  try {
    const auto json = JsonFields::Json::parse(text);
    FrameLine frame;
    JsonFields fields(json, {.null_is_nan = true});
    describe(fields, frame);
    if (std::isnan(frame.total_ms)) throw std::out_of_range("total_ms");
    return frame;
  } catch (const std::exception&) {
    return Error{en::say("one of its lines is damaged"), "",
                 en::say("reconstruct this part again")};
  }
}

std::string complete_line(const FrameLine& frame, FingerContactTracker& contacts) {
  const auto contact = contacts(frame.evidence);
  return contact ? with_contact(frame.line, *contact) : frame.line;
}

SequentialBatch::SequentialBatch(Pipeline pipeline, bool is_continuous)
    : pipeline_(std::move(pipeline)),
      is_continuous_(is_continuous),
      is_sequential_(pipeline_.has_long_memory()),
      contacts_(is_continuous) {}

void SequentialBatch::begin_piece() {
  if (!is_sequential_ && index_ % kPieceFrames == 0)
    alltact::begin_piece(pipeline_, before_, is_continuous_);
}

void SequentialBatch::remember(const FramePtr& frame) {
  before_.push_back(frame);
  if (before_.size() > kWarmUpFrames) before_.pop_front();
  ++index_;
}

void SequentialBatch::skip() {
  begin_piece();
  remember(nullptr);
  static_cast<void>(contacts_(std::nullopt));
}

Result<FrameResult> SequentialBatch::operator()(const FramePtr& frame) {
  begin_piece();
  if (!is_continuous_) pipeline_.forget();
  remember(frame);
  auto result = pipeline_.measure_untracked(frame);
  if (result) result->contact = contacts_(result->evidence);
  return result;
}

}  // namespace alltact
