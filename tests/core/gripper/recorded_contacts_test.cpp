#include "core/gripper/gripper_recording.h"
#include "core/sensing/result_json.h"
#include "tests/support/written_region.h"

#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <opencv2/core.hpp>

namespace alltact {
namespace {

using test::written_region;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Pair;

/// A line as the program writes it.
std::string written_line(std::int64_t time_ns) {
  FrameResult result;
  auto frame = std::make_shared<Frame>();
  frame->name = "frame_00003";
  frame->time_ns = time_ns;
  result.frame = frame;
  result.depth.emplace();
  result.regions = {written_region()};
  return result_line(result, 3, ReferenceMethod::kLocal) + "\n";
}

TEST(RecordedContacts, ReadsWhatTheProgramWrites) {
  const std::string line = written_line(123456789012345678);
  const auto read = parse_recorded_contacts(line + line, "results.jsonl");
  ASSERT_TRUE(read) << read.error().sentence();
  ASSERT_EQ(read->size(), 2U);
  const RecordedContacts& one = read->front();
  EXPECT_EQ(one.frame, "frame_00003");
  EXPECT_EQ(one.time_ns, 123456789012345678);
  ASSERT_TRUE(one.contact && one.contact->axis && one.contact->face_normal);
  EXPECT_EQ(one.contact->position_mm, Eigen::Vector3d(3.1, -0.2, 48.0));
  EXPECT_NEAR((*one.contact->axis - Eigen::Vector3d(0.6, 0, 0.8)).norm(), 0, 1e-6);
  EXPECT_EQ(one.contact->axis_sd_deg, 0.25);
  EXPECT_NEAR((*one.contact->position_covariance_mm2)(1, 1), 0.02, 1e-9);
  EXPECT_FALSE(one.z_sd_mm(100)) << "nothing was said of the face";
  EXPECT_NE(line.find("polygon_mm"), std::string::npos);
}

TEST(RecordedContacts, AreWhatTheFrameItselfTells) {
  const auto read = parse_recorded_contacts(written_line(5), "results.jsonl");
  ASSERT_TRUE(read);
  const ObservedContact told = observed_contact(written_region()), &kept = *read->front().contact;
  EXPECT_NEAR((told.position_mm - kept.position_mm).norm(), 0, 1e-4);
  EXPECT_NEAR((*told.position_covariance_mm2 - *kept.position_covariance_mm2).norm(), 0, 1e-8);
  EXPECT_NEAR((*told.axis - *kept.axis).norm(), 0, 1e-5);
  EXPECT_NEAR((*told.face_normal - *kept.face_normal).norm(), 0, 1e-5);
  EXPECT_EQ(told.axis_sd_deg, kept.axis_sd_deg);
  ContactRegion round = written_region();
  round.axis.reset();
  EXPECT_FALSE(observed_contact(round).axis_sd_deg) << "a round contact has no axis to be sure of";
}

TEST(RecordedContacts, OlderLinesAreReadAsFarAsTheyGo) {
  const auto read = parse_recorded_contacts(
      "{\"frame\": \"a\", \"index\": 0, \"regions\": [{\"place_mm\": [1, 2, 3], \"angle_deg\": 4, "
      "\"angle_sd_deg\": 1}]}\n{\"frame\": \"b\", \"problems\": [\"x\"]}\n"
      "{\"frame\": \"c\", \"regions\": [], \"face\": {\"u\": [10, 20], \"z_sd_mm\": [0.1, 0.3]}}",
      "results.jsonl");
  ASSERT_TRUE(read) << read.error().sentence();
  ASSERT_EQ(read->size(), 3U);
  EXPECT_FALSE((*read)[0].time_ns);
  EXPECT_FALSE((*read)[0].contact->axis) << "an angle alone is no direction in space";
  EXPECT_FALSE((*read)[1].contact || (*read)[2].contact);
  EXPECT_NEAR(*(*read)[2].z_sd_mm(15), 0.2, 1e-12);
  EXPECT_EQ(*(*read)[2].z_sd_mm(0), 0.1);
  EXPECT_EQ(*(*read)[2].z_sd_mm(99), 0.3);
}

TEST(RecordedContacts, WhatCannotBeIsRefusedByFileAndLine) {
  const auto refusal = [](const std::string& text) {
    const auto read = parse_recorded_contacts("{\"frame\": \"a\"}\n" + text, "results.jsonl");
    return read ? std::string("accepted") : read.error().sentence();
  };
  EXPECT_THAT(refusal("{\"frame\": \"b\""), HasSubstr("results.jsonl:2: is not JSON"));
  EXPECT_THAT(refusal("[1]"), HasSubstr("results.jsonl:2: is not a JSON object"));
  EXPECT_THAT(refusal("{\"frame\": 3}"), HasSubstr("'frame' must be text"));
  EXPECT_THAT(refusal("{\"frame\": \"b\", \"time_ns\": 0.5}"), HasSubstr("'time_ns'"));
  EXPECT_THAT(refusal("{\"frame\": \"b\", \"regions\": 3}"), HasSubstr("'regions'"));
  EXPECT_THAT(refusal("{\"frame\": \"b\", \"regions\": [3]}"), HasSubstr("a region"));
  const auto region = [&](const std::string& keys) {
    return refusal("{\"frame\": \"b\", \"regions\": [{\"place_mm\": [1, 2, 3]" + keys + "}]}");
  };
  EXPECT_EQ(region(""), "accepted");
  EXPECT_THAT(region(", \"axis\": [1, 0], \"angle_sd_deg\": 1"), HasSubstr("'axis' must be 3"));
  EXPECT_THAT(region(", \"axis\": [1, 1, 0], \"angle_sd_deg\": 1"), HasSubstr("of length 1"));
  EXPECT_THAT(region(", \"axis\": [1, 0, 0], \"angle_sd_deg\": -1"), HasSubstr("0 or above"));
  EXPECT_THAT(region(", \"normal\": [0, 0, \"x\"]"), HasSubstr("'normal' must be a number"));
  EXPECT_THAT(region(", \"place_covariance_mm2\": [1, 0, 0, -1, 0, 1]"),
              HasSubstr("is not a covariance"));
  EXPECT_THAT(region(", \"place_covariance_mm2\": [1e999, 0, 0, 1, 0, 1]"), HasSubstr("not JSON"));
}

TEST(RecordedContacts, EveryTruncationAndDamageIsReadOrRefused) {
  const std::string line = written_line(5);
  for (std::size_t size = 0; size < line.size(); ++size) {
    const auto read = parse_recorded_contacts(line.substr(0, size), "results.jsonl");
    EXPECT_EQ(read.ok(), size == 0 || size == line.size() - 1) << size;
  }
  std::mt19937 random(2);
  for (int i = 0; i < 3000; ++i) {
    std::string text = line;
    for (int k = 0; k < 3; ++k) text[random() % text.size()] = "[]{}:,-\"0e.x\\ n"[random() % 15];
    const auto read = parse_recorded_contacts(text, "results.jsonl");
    if (!read) continue;
    for (const RecordedContacts& one : *read)
      if (one.contact) {
        EXPECT_TRUE(one.contact->position_mm.allFinite());
      }
  }
}

std::vector<RecordedContacts> frames_at(const std::vector<std::int64_t>& times_ms) {
  std::vector<RecordedContacts> frames(times_ms.size());
  for (std::size_t i = 0; i < frames.size(); ++i) frames[i].time_ns = times_ms[i] * 1000000;
  return frames;
}

TEST(PairedFrames, AreTheNearestOfEachOtherWithinTheTolerance) {
  const auto paired =
      paired_frames(frames_at({0, 33, 66, 100, 400}), frames_at({5, 36, 61, 70, 250}), 10000000);
  EXPECT_TRUE(paired.by_time);
  EXPECT_THAT(paired.pairs, ElementsAre(Pair(0, 0), Pair(1, 1), Pair(2, 3)));
  EXPECT_THAT(paired.unpaired_first, ElementsAre(3, 4));
  EXPECT_THAT(paired.unpaired_second, ElementsAre(2, 4));
}

TEST(PairedFrames, AreEachUsedOnceAndMeetWhatTryingAllFinds) {
  std::mt19937 random(6);
  for (int run = 0; run < 200; ++run) {
    std::vector<std::int64_t> a, b;
    for (int i = 0; i < 30; ++i) a.push_back(random() % 1000), b.push_back(random() % 1000);
    std::sort(a.begin(), a.end()), std::sort(b.begin(), b.end());
    a.erase(std::unique(a.begin(), a.end()), a.end());
    b.erase(std::unique(b.begin(), b.end()), b.end());
    const auto paired = paired_frames(frames_at(a), frames_at(b), 15000000);
    std::vector<int> used_a(a.size(), 0), used_b(b.size(), 0);
    for (const auto& [i, j] : paired.pairs) {
      ++used_a[i], ++used_b[j];
      for (const auto other : b) EXPECT_GE(std::abs(other - a[i]), std::abs(b[j] - a[i]));
      for (const auto other : a) EXPECT_GE(std::abs(b[j] - other), std::abs(b[j] - a[i]));
    }
    for (const std::size_t i : paired.unpaired_first) ++used_a[i];
    for (const std::size_t j : paired.unpaired_second) ++used_b[j];
    EXPECT_THAT(used_a, testing::Each(1));
    EXPECT_THAT(used_b, testing::Each(1));
  }
}

TEST(PairedFrames, WithoutTimesGoByTheirOrderAndSaySo) {
  auto first = frames_at({1, 2, 3});
  first[1].time_ns.reset();
  const auto paired = paired_frames(first, frames_at({7, 8}), 1);
  EXPECT_FALSE(paired.by_time);
  EXPECT_THAT(paired.pairs, ElementsAre(Pair(0, 0), Pair(1, 1)));
  EXPECT_THAT(paired.unpaired_first, ElementsAre(2));
  EXPECT_TRUE(paired_frames({}, frames_at({1}), 1).pairs.empty());
}

}  // namespace
}  // namespace alltact
