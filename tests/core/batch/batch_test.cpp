// Live, in pieces on several threads, in parts that are merged, and frame by frame on request: the
// same contacts, to the bit.
#include "core/batch/batch.h"

#include "core/sensing/result_json.h"
#include "core/sources/file_source.h"
#include "tests/support/flat_sensor.h"
#include "tests/support/slow_run.h"

#include <random>

#include <gtest/gtest.h>

namespace alltact::test {
namespace {

/// A sensor on which balls press for random times, at random places and depths; some frames show
/// nothing, and time jumps now and then.
std::vector<FramePtr> drawn_frames(std::size_t count, std::uint64_t seed) {
  std::mt19937_64 draw(seed);
  const auto between = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(draw);
  };
  std::vector<cv::Mat> shown;  // pictures that are drawn once and shown often
  for (std::uint64_t i = 0; i < 40; ++i) {
    const double depth_mm = i < 10 ? 0.0 : between(0.05, 1.0);
    shown.push_back(
        pressed_picture(ball_depth_mm(between(80, 240), between(70, 170), depth_mm), seed + i));
  }
  std::vector<FramePtr> frames;
  std::int64_t time_ns = 1'000'000'000;
  while (frames.size() < count) {
    const cv::Mat& touched = shown[static_cast<std::size_t>(between(0, 39.999))];
    const auto held = static_cast<std::size_t>(between(1, 60));
    time_ns += static_cast<std::int64_t>(between(0, 2e9)) * (between(0, 1) < 0.1 ? 1 : 0);
    for (std::size_t i = 0; i < held && frames.size() < count; ++i) {
      auto frame = std::make_shared<Frame>();
      frame->grey = touched.clone();
      // No two pictures in a row are equal, or the camera would be taken for frozen.
      frame->grey.at<std::uint8_t>(0, static_cast<int>(frames.size() % 300)) ^= 1;
      frame->name = "frame_" + std::to_string(100000 + frames.size());
      frame->origin = "drawn";
      frame->sequence = frames.size();
      frame->time_ns = time_ns += 33'000'000;
      frames.push_back(std::move(frame));
    }
  }
  return frames;
}

class Batches : public testing::Test {
 protected:
  Batches() : frames_(drawn_frames(static_cast<std::size_t>(as_many_as(640, 10'000)), 7)) {
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
  std::vector<std::string> live() const {
    Pipeline measuring = pipeline();
    std::vector<std::string> lines;
    for (const FramePtr& frame : frames_) lines.push_back(line_of(*measuring(frame), lines.size()));
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
      if (frame.contacts) line.contacts = contacts_of(*frame.contacts);
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
  static std::vector<std::string> completed(const std::vector<FrameLine>& lines) {
    LastingContacts contacts(true);
    std::vector<std::string> complete;
    for (const FrameLine& line : lines) complete.push_back(contacts.complete_line(line));
    return complete;
  }

  std::optional<FingerSnapshot> finger_;
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
  std::vector<FrameLine> merged;
  const std::size_t cuts[] = {0, 5 * kPieceFrames, 6 * kPieceFrames, 17 * kPieceFrames,
                              frames_.size()};
  for (std::size_t part = 0; part + 1 < std::size(cuts); ++part)
    for (FrameLine& line : measured(1 + part % 2, {cuts[part], cuts[part + 1]}))
      merged.push_back(std::move(line));
  expect_same(completed(merged), expected);
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
