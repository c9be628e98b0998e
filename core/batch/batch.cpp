#include "core/batch/batch.h"

#include <condition_variable>
#include <deque>
#include <map>
#include <mutex>
#include <thread>

namespace alltact {
namespace {

/// Consecutive frames, and those before them.
struct FramePiece {
  std::size_t number = 0;
  std::vector<FramePtr> before;
  std::vector<BatchFrame> frames;
};

class Batch {
 public:
  Batch(Source& source,
        std::vector<Pipeline>& pipelines,
        const BatchFrames& frames,
        const BatchWork& work,
        const Job& job)
      : source_(source), pipelines_(pipelines), frames_(frames), work_(work), job_(job) {}

  Status run() {
    const bool is_sequential = pipelines_.front().has_long_memory();
    next_index_ = frames_.first;
    next_taken_ = frames_.first / kPieceFrames;
    skip_to_first();
    const std::size_t count = is_sequential ? 1 : pipelines_.size();
    window_ = count + 1;
    {
      std::vector<std::jthread> others;
      for (std::size_t i = 1; i < count; ++i)
        others.emplace_back([this, i] { work_on(pipelines_[i], false); });
      work_on(pipelines_.front(), is_sequential);
    }
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
        if (!is_sequential) begin(pipeline, *piece);
        for (BatchFrame& frame : piece->frames) {
          if (!source_.is_continuous()) pipeline.forget();
          measure(pipeline, frame, is_sequential);
          auto line = work_.write(frame, pipeline);
          if (!line) return fail(line.error());
          lines.push_back(std::move(*line));
          frame = {};  // releases its memory
        }
        if (!done(piece->number, std::move(lines))) return;
      }
    } catch (const std::exception& problem) {
      fail({en::say("unexpected: {}", std::string(problem.what())),
            "",
            en::say("reporting this as a defect")});
    }
  }

  void begin(Pipeline& pipeline, const FramePiece& piece) const {
    pipeline.forget();
    if (!source_.is_continuous()) return;
    for (const FramePtr& frame : piece.before)
      if (frame) pipeline.warm_up(frame);
  }

  static void measure(Pipeline& pipeline, BatchFrame& frame, bool is_sequential) {
    if (frame.problem || !frame.frame) return;
    auto result = is_sequential ? pipeline(frame.frame)
                                : pipeline.measure_untracked(frame.frame, frame.contacts);
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

Status measure_batch(Source& source,
                     std::vector<Pipeline>& pipelines,
                     const BatchFrames& frames,
                     const BatchWork& work,
                     const Job& job) {
  assert(!pipelines.empty() && frames.first % kPieceFrames == 0);
  return Batch(source, pipelines, frames, work, job).run();
}

}  // namespace alltact
