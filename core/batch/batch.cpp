#include "core/batch/batch.h"

#include "core/base/guarded.h"
#include "core/numerics/parallel.h"
#include "core/sensing/result_json.h"

#include <cassert>
#include <condition_variable>
#include <deque>
#include <map>
#include <mutex>
#include <utility>

#include <nlohmann/json.hpp>

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
          measure(pipeline, frame, is_sequential);
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

Status measure_batch(Source& source, std::vector<Pipeline>& pipelines, const BatchFrames& frames,
                     const BatchWork& work, const Job& job) {
  assert(!pipelines.empty() && frames.first % kPieceFrames == 0);
  return Batch(source, pipelines, frames, work, job).run();
}

namespace {

using Json = nlohmann::ordered_json;

Json seen_json(const ContactState::Observation& seen) {
  Json entry = Json::object();
  if (seen.time_s) entry["time_s"] = *seen.time_s;
  entry["strength"] = seen.strength;
  if (seen.position_mm) {
    entry["place_mm"] = {seen.position_mm->x(), seen.position_mm->y()};
    const Eigen::Matrix2d& c = seen.position_covariance_mm2;
    entry["covariance_mm2"] = {c(0, 0), c(0, 1), c(1, 0), c(1, 1)};
  }
  entry["skin_along_mm"] = seen.skin_along_mm;
  return entry;
}

ContactState::Observation seen_of(const Json& entry) {
  ContactState::Observation seen;
  if (entry.contains("time_s")) seen.time_s = entry.at("time_s").get<double>();
  seen.strength = entry.at("strength");
  if (entry.contains("place_mm")) {
    const Json &position = entry.at("place_mm"), &c = entry.at("covariance_mm2");
    seen.position_mm = Eigen::Vector2d(position.at(0), position.at(1));
    seen.position_covariance_mm2 << c.at(0), c.at(1), c.at(2), c.at(3);
  }
  seen.skin_along_mm = entry.at("skin_along_mm");
  return seen;
}

}  // namespace

FrameLine::Contacts contacts_of(const FrameContacts& frame) {
  FrameLine::Contacts contacts;
  contacts.seen = frame.seen;
  for (std::size_t i = 0; i < contacts.texts.size(); ++i) {
    contacts.texts[i] = contact_text(frame.by_face[i]);
    contacts.faces[i] = frame.by_face[i].face;
  }
  return contacts;
}

std::string FrameLine::to_json() const {
  Json json;
  json["frame"] = frame;
  json["line"] = line;
  json["measured"] = is_measured;
  json["total_ms"] = total_ms;
  if (contacts) {
    json["seen"] = seen_json(contacts->seen);
    // All five are mostly equal; each text is stored once.
    Json texts = Json::array(), which = Json::array(), faces = Json::array();
    for (std::size_t i = 0; i < contacts->texts.size(); ++i) {
      std::size_t same = 0;
      while (contacts->texts[same] != contacts->texts[i]) ++same;
      if (same == i) texts.push_back(contacts->texts[i]);
      which.push_back(same == i ? texts.size() - 1 : which.at(same).get<std::size_t>());
      faces.push_back(static_cast<int>(contacts->faces[i]));
    }
    json["contacts"] = std::move(texts);
    json["which"] = std::move(which);
    json["faces"] = std::move(faces);
  }
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

Result<FrameLine> FrameLine::from_json(std::string_view text) {
  try {
    const Json json = Json::parse(text);
    FrameLine frame;
    frame.frame = json.at("frame");
    frame.line = json.at("line");
    frame.is_measured = json.at("measured");
    frame.total_ms = json.at("total_ms");
    if (!json.contains("seen")) return frame;
    Contacts contacts;
    contacts.seen = seen_of(json.at("seen"));
    for (std::size_t i = 0; i < contacts.texts.size(); ++i) {
      const Json& part = json.at("contacts").at(json.at("which").at(i).get<std::size_t>());
      contacts.texts[i] = part.get<std::string>();
      const int face = json.at("faces").at(i);
      if (face < 1 || face > 4 || !Json::accept(contacts.texts[i])) throw std::out_of_range("face");
      contacts.faces[i] = static_cast<PushedFace>(face);
    }
    frame.contacts = std::move(contacts);
    return frame;
  } catch (const std::exception&) {
    return Error{en::say("one of its lines is damaged"), "",
                 en::say("reconstruct this part again")};
  }
}

std::optional<LastingContacts::Lasting> LastingContacts::operator()(
    const ContactState::Observation* seen, const std::array<PushedFace, 5>& faces) {
  if (!is_continuous_) {
    state_.forget();
    face_.reset();
  }
  if (seen == nullptr) return std::nullopt;
  const ContactState::Estimate estimate = state_.add(*seen);
  if (!estimate.has_contact) {
    face_.reset();
    return std::nullopt;
  }
  const std::size_t before = face_ ? static_cast<std::size_t>(*face_) : 0;
  face_ = faces[before];
  return Lasting{before, estimate};
}

std::string LastingContacts::complete_line(const FrameLine& frame) {
  const auto& contacts = frame.contacts;
  const auto lasting = contacts ? (*this)(&contacts->seen, contacts->faces) : (*this)(nullptr, {});
  return lasting ? with_contact(frame.line, contacts->texts[lasting->which], lasting->estimate)
                 : frame.line;
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
  static_cast<void>(contacts_(nullptr, {}));
}

Result<FrameResult> SequentialBatch::operator()(const FramePtr& frame) {
  begin_piece();
  if (!is_continuous_) pipeline_.forget();
  remember(frame);
  if (is_sequential_) return pipeline_(frame);
  std::optional<FrameContacts> contacts;
  auto result = pipeline_.measure_untracked(frame, contacts);
  std::array<PushedFace, 5> faces{};
  if (contacts)
    for (std::size_t i = 0; i < faces.size(); ++i) faces[i] = contacts->by_face[i].face;
  const auto lasting = contacts_(contacts ? &contacts->seen : nullptr, faces);
  if (!result || !lasting) return result;
  FingerContact& contact = result->contact.emplace(contacts->by_face[lasting->which]);
  contact.is_new = lasting->estimate.is_new;
  contact.held_s = lasting->estimate.held_s;
  contact.is_slipping = lasting->estimate.is_slipping;
  return result;
}

}  // namespace alltact
