// Live, over the stream, in pieces on several threads, in parts and single frames of any order: the
// same contacts, to the bit, and those that were drawn.
#include "core/batch/batch.h"

#include "core/sensing/result_json.h"
#include "core/sources/file_source.h"
#include "core/stream/stream_server.h"
#include "tests/support/flat_sensor.h"
#include "tests/support/slow_run.h"
#include "tests/support/stream_peer.h"
#include "tests/support/temporary_folder.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <random>

#include <gtest/gtest.h>

namespace alltact::test {
namespace {

struct DrawnFrame {
  FramePtr frame;
  double depth_mm = 0;  ///< of the ball that presses; 0: nothing does
  cv::Point2d at_px;
  [[nodiscard]] double time_s() const { return alltact::time_s(*frame).value(); }
};

/// A sensor on which balls press for random times, at random places and depths; some frames show
/// nothing, and time jumps now and then.
std::vector<DrawnFrame> drawn_frames(std::size_t count, std::uint64_t seed) {
  std::mt19937_64 draw(seed);
  const auto between = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(draw);
  };
  struct Picture {
    cv::Mat grey;
    double depth_mm;
    cv::Point2d at_px;
  };
  std::vector<Picture> shown;  // drawn once and shown often
  for (std::uint64_t i = 0; i < 40; ++i) {
    const double depth_mm = i < 10 ? 0.0 : between(0.05, 1.0);
    const double u = between(80, 240), v = between(70, 170);
    shown.push_back({pressed_picture(ball_depth_mm(u, v, depth_mm), seed + i), depth_mm, {u, v}});
  }
  std::vector<DrawnFrame> frames;
  std::int64_t time_ns = 1'000'000'000;
  while (frames.size() < count) {
    const Picture& picture = shown[static_cast<std::size_t>(between(0, 39.999))];
    const auto held = static_cast<std::size_t>(between(1, 60));
    time_ns += static_cast<std::int64_t>(between(0, 2e9)) * (between(0, 1) < 0.1 ? 1 : 0);
    for (std::size_t i = 0; i < held && frames.size() < count; ++i) {
      auto frame = std::make_shared<Frame>();
      frame->grey = picture.grey.clone();
      // No two pictures in a row are equal, or the camera would be taken for frozen.
      frame->grey.at<std::uint8_t>(0, static_cast<int>(frames.size() % 300)) ^= 1;
      frame->name = "frame_" + std::to_string(100000 + frames.size());
      frame->origin = "drawn";
      frame->sequence = frames.size();
      frame->time_ns = time_ns += 33'000'000;
      frames.push_back({std::move(frame), picture.depth_mm, picture.at_px});
    }
  }
  return frames;
}

class Batches : public testing::Test {
 protected:
  Batches() : drawn_(drawn_frames(static_cast<std::size_t>(as_many_as(640, 10'000)), 7)) {
    for (const DrawnFrame& one : drawn_) frames_.push_back(one.frame);
    auto finger = FingerSnapshot::of({}, flat_sensor_finger(true));
    EXPECT_TRUE(finger.ok());
    finger_.emplace(std::move(*finger));
  }
  Pipeline pipeline() const {
    return Pipeline::with_library(*ReferenceLibrary::single(untouched_picture(1)), *finger_, {});
  }
  static std::string line_of(const FrameResult& result, std::size_t index) {
    FrameResult untimed = result;
    untimed.times_ms = {};
    return result_line(untimed, index, ReferenceMethod::kLocal);
  }
  /// As a program hears them that is connected to the server.
  std::vector<std::string> live() const {
    const TemporaryFolder folder;
    auto server = StreamServer::start(folder / "f.sock", "serving a test");
    EXPECT_TRUE(server.ok());
    StreamMessage about;
    about.type = StreamType::kFinger;
    about.json = "{}";
    (*server)->publish(about);
    const StreamPeer peer(folder / "f.sock");
    peer.say("alltact-stream/1\n");
    EXPECT_TRUE(peer.hear());
    Pipeline measuring = pipeline();
    std::vector<std::string> lines;
    for (const FramePtr& frame : frames_) {
      StreamMessage message;
      message.sequence = frame->sequence;
      message.json = line_of(*measuring(frame), lines.size());
      (*server)->publish(message);
      const auto heard = peer.hear();
      EXPECT_TRUE(heard && heard->header.lost == 0);
      lines.push_back(heard ? heard->body.substr(0, heard->body.find_last_of('}') + 1) : "");
    }
    return lines;
  }
  std::vector<std::string> on_request() const {
    SequentialBatch measuring(pipeline(), true);
    std::vector<std::string> lines;
    for (const FramePtr& frame : frames_) lines.push_back(line_of(*measuring(frame), lines.size()));
    return lines;
  }
  /// Lines without their contacts, in order, through JSON as parts are.
  std::vector<FrameLine> measured(std::size_t threads, const BatchFrames& which) const {
    FrameSource source(frames_);
    std::vector<Pipeline> pipelines;
    for (std::size_t i = 0; i < threads; ++i) pipelines.push_back(pipeline());
    std::vector<FrameLine> lines;
    BatchWork work;
    work.write = [](BatchFrame& frame, const Pipeline&) -> Result<FrameLine> {
      FrameLine line;
      line.frame = frame.frame->name;
      line.line = line_of(*frame.result, frame.index);
      line.evidence = frame.result->evidence;
      return line;
    };
    work.take = [&](std::size_t index, FrameLine&& line) -> Status {
      EXPECT_EQ(index, which.first + lines.size()) << "in the order of their frames";
      lines.push_back(*FrameLine::from_json(line.to_json()));
      return {};
    };
    EXPECT_TRUE(measure_batch(source, pipelines, which, work, Job()).ok());
    return lines;
  }
  /// Each frame by a pipeline that has just seen another one.
  std::vector<FrameLine> in_any_order() const {
    std::vector<std::size_t> order(frames_.size());
    std::iota(order.begin(), order.end(), 0);
    std::shuffle(order.begin(), order.end(), std::mt19937_64(9));
    Pipeline measuring = pipeline();
    std::vector<FrameLine> lines(frames_.size());
    for (const std::size_t i : order) {
      measuring.forget();
      const auto result = measuring.measure_untracked(frames_[i]);
      lines[i].line = line_of(*result, i);
      lines[i].evidence = result->evidence;
    }
    return lines;
  }
  /// Parts of whole pieces, the last of them measured first.
  std::vector<FrameLine> in_parts(const std::vector<std::size_t>& cuts) const {
    std::vector<FrameLine> lines;
    for (std::size_t part = cuts.size() - 1; part > 0; --part) {
      auto some = measured(1 + part % 2, {cuts[part - 1], cuts[part]});
      lines.insert(lines.begin(), std::make_move_iterator(some.begin()),
                   std::make_move_iterator(some.end()));
    }
    return lines;
  }
  static std::vector<std::string> completed(const std::vector<FrameLine>& lines) {
    FingerContactTracker contacts;
    std::vector<std::string> complete;
    for (const FrameLine& line : lines) complete.push_back(complete_line(line, contacts));
    return complete;
  }

  std::optional<FingerSnapshot> finger_;
  std::vector<DrawnFrame> drawn_;
  std::vector<FramePtr> frames_;
};

void expect_same(const std::vector<std::string>& lines, const std::vector<std::string>& expected) {
  ASSERT_EQ(lines.size(), expected.size());
  for (std::size_t i = 0; i < lines.size(); ++i) ASSERT_EQ(lines[i], expected[i]) << i;
}

TEST_F(Batches, GiveTheSameContactsHoweverTheyAreCut) {
  const std::vector<std::string> expected = completed(measured(1, {}));
  std::size_t touched = 0, begun = 0;
  for (const std::string& line : expected) {
    touched += line.find("\"finger_contact\"") != std::string::npos;
    begun += line.find("\"new\":true") != std::string::npos;
  }
  EXPECT_GT(touched, frames_.size() / 4);
  EXPECT_GE(begun, frames_.size() / 200);
  expect_same(live(), expected);
  expect_same(on_request(), expected);
  for (const std::size_t threads : {2U, 3U})
    expect_same(completed(measured(threads, {})), expected);
  expect_same(completed(in_parts(
                  {0, 5 * kPieceFrames, 6 * kPieceFrames, 17 * kPieceFrames, frames_.size()})),
              expected);
  expect_same(completed(in_any_order()), expected);
}

// What presses for two frames is a contact in the second; what is gone for three is none.
TEST_F(Batches, ContactsAreThoseThatWereDrawn) {
  constexpr double kPressed_mm = 0.25;  // surely deeper than kContactDepth_mm
  Pipeline measuring = pipeline();
  const auto is_pressed = [&](std::size_t i) { return drawn_[i].depth_mm > kPressed_mm; };
  const auto is_free = [&](std::size_t i) { return drawn_[i].depth_mm == 0; };
  std::size_t touched = 0, untouched = 0, held = 0;
  // Time of the first of frames that press without a pause, after free ones; NaN: none
  double first_s = std::nan("");
  for (std::size_t i = 0; i < drawn_.size(); ++i) {
    const bool begins =
        i == 0 || drawn_[i].time_s() - drawn_[i - 1].time_s() > FingerContactTracker::kMaxGap_s;
    if (!is_pressed(i)) first_s = std::nan("");
    if (is_pressed(i) && (begins || (i > 2 && is_free(i - 1) && is_free(i - 2) && is_free(i - 3))))
      first_s = drawn_[i].time_s();
    const FrameResult result = *measuring(frames_[i]);
    const auto& contact = result.contact;
    if (is_free(i) && (begins || (i > 1 && is_free(i - 1) && is_free(i - 2)))) {
      ++untouched;
      ASSERT_FALSE(contact) << i;
    }
    if (!is_pressed(i) || !(begins || is_pressed(i - 1))) continue;
    ++touched;
    ASSERT_TRUE(contact && contact->position) << i;
    EXPECT_EQ(contact->face, PushedFace::kContact);
    const auto place_mm = result.shape->position_mm(drawn_[i].at_px.x, drawn_[i].at_px.y);
    ASSERT_NEAR(contact->position->along_mm, place_mm.x(), 0.1) << i;
    ASSERT_NEAR(contact->position->across_mm.value(), place_mm.y(), 0.1) << i;
    // The deepest of noisy pixels, so rather too deep.
    ASSERT_NEAR(contact->position->depth_mm.value(), drawn_[i].depth_mm, 0.1) << i;
    if (std::isnan(first_s)) continue;
    ++held;
    ASSERT_NEAR(contact->held_s.value(), drawn_[i].time_s() - first_s, 1e-6) << i;
  }
  EXPECT_GT(touched, drawn_.size() / 4);
  EXPECT_GT(untouched, drawn_.size() / 10);
  EXPECT_GT(held, drawn_.size() / 20);
}

// Of every kind, in random orders, as fingers with markers show it.
TEST(ContactsOfParts, AreThoseOfTheEvidenceBeforeItWasWritten) {
  std::mt19937_64 draw(3);
  const auto between = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(draw);
  };
  const auto chance = [&](double part) { return between(0, 1) < part; };
  const auto position = [&] {
    PositionOnFinger one;
    one.along_mm = between(0, 90);
    one.across_mm = between(-9, 9);
    one.depth_mm = between(0, 1);
    if (chance(0.7)) one.along_sd_mm = between(0, 1), one.depth_sd_mm = between(0, 0.1);
    one.limits = chance(0.2) ? kLayerLimit : kNoLimit;
    return one;
  };
  FingerContactTracker before, after;
  FrameLine frame;
  frame.line = R"({"frame":"a","times_ms":{}})";
  std::map<std::string, int> seen{{"contact\",\"direction", 0},
                                  {"\"back\"", 0},
                                  {"\"upper\"", 0},
                                  {"\"lower\"", 0},
                                  {"along_sd_mm", 0},
                                  {"no_place", 0},
                                  {"new\":true", 0},
                                  {"slipping\":true", 0},
                                  {"limits", 0}};
  double time_s = 0, force = 0;
  for (int i = 0; i < 10'000; ++i) {
    time_s += chance(0.01) ? between(0, 3) : between(0, 0.05);
    if (chance(0.1)) force = between(0, 2.5);
    frame.evidence.reset();
    if (chance(0.97)) {
      ContactEvidence& evidence = frame.evidence.emplace();
      if (i < 9000) evidence.time_s = time_s;
      if (chance(0.9)) evidence.depth = chance(0.5) ? force * between(0.8, 1.2) : 0;
      if (evidence.depth > 0.5) {
        auto& part = evidence.indentation.emplace();
        part.position = position();
        if (chance(0.9)) part.direction = Eigen::Vector3d(between(-1, 1), 0.1, 1).normalized();
        if (chance(0.9)) part.on_skin_mm = Eigen::Vector2d(between(0, 0.5), between(0, 0.5));
        part.on_skin_covariance_mm2 << 1e-3, 1e-5, 1e-5, 2e-3;
      }
      evidence.push = force * between(0.5, 1.5);
      if (evidence.push > FingerContactTracker::kRelease)
        evidence.deflection = {static_cast<PushedFace>(1 + draw() % 4),
                               Eigen::Vector3d(between(-1, 1), between(-1, 1), 0.1).normalized(),
                               between(0, 5), std::nullopt};
      if (evidence.deflection && chance(0.5)) evidence.deflection->position = position();
    }
    const auto read = FrameLine::from_json(frame.to_json());
    ASSERT_TRUE(read.ok());
    ASSERT_EQ(read->to_json(), frame.to_json()) << i;
    const std::string line = complete_line(frame, before);
    ASSERT_EQ(complete_line(*read, after), line) << i;
    for (auto& [word, count] : seen) count += line.find(word) != std::string::npos;
  }
  for (const auto& [word, count] : seen) EXPECT_GT(count, 100) << word;
}

TEST_F(Batches, WhatIsThrownEndsTheBatchWithAnError) {
  FrameSource source(frames_);
  std::vector<Pipeline> pipelines;
  for (int i = 0; i < 2; ++i) pipelines.push_back(pipeline());
  std::size_t taken = 0;
  BatchWork work;
  work.write = [](BatchFrame& frame, const Pipeline&) -> Result<FrameLine> {
    if (frame.index == 100) throw 7;
    return FrameLine{};
  };
  work.take = [&](std::size_t, FrameLine&&) -> Status {
    ++taken;
    return {};
  };
  const Status status = measure_batch(source, pipelines, {}, work, Job());
  ASSERT_FALSE(status.ok());
  EXPECT_EQ(status.error().what.english(), "unexpected: exception");
  EXPECT_LE(taken, 96U) << "lines of whole pieces before it";
}

}  // namespace
}  // namespace alltact::test
