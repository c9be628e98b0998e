// The bytes that other programs get, read back by offsets that are written down here once more.
#include "core/stream/stream_format.h"

#include <cstring>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace alltact {
namespace {

using testing::HasSubstr;

template <class T>
T at(const std::string& bytes, std::size_t offset) {
  T value{};
  std::memcpy(&value, bytes.data() + offset, sizeof value);
  return value;
}

StreamMessage message() {
  StreamMessage message;
  message.sequence = 7;
  message.time_ns = -12345678901;
  message.json = R"({"frame":"x"})";  // 13 bytes
  message.parts[kImage] = (cv::Mat_<std::uint8_t>(2, 3) << 1, 2, 3, 4, 5, 6);
  message.parts[kDepth16] = (cv::Mat_<std::uint16_t>(1, 2) << 10000, 65535);
  message.parts[kPoints] = cv::Mat(1, 1, CV_32FC3, cv::Scalar(1.5, -2, 3));
  return message;
}

TEST(StreamFormat, AMessageLiesAsItIsSaid) {
  StreamPartSet requested;
  requested.set(kImage).set(kPoints).set(kDepth);  // of depth there is none
  const StreamBytes bytes = stream_bytes(message(), requested, 5);
  const std::string& head = bytes.head;
  ASSERT_EQ(head.size(), 48U + 2 * 48 + 16);
  EXPECT_EQ(head.substr(0, 4), "ATCT");
  EXPECT_EQ(at<std::uint16_t>(head, 4), 1);
  EXPECT_EQ(at<std::uint16_t>(head, 6), 2);
  EXPECT_EQ(at<std::uint32_t>(head, 8), 2U);
  EXPECT_EQ(at<std::uint32_t>(head, 12), 16U);
  EXPECT_EQ(at<std::uint64_t>(head, 16), 2U * 48 + 16 + 16 + 16);
  EXPECT_EQ(at<std::uint64_t>(head, 24), 7U);
  EXPECT_EQ(at<std::int64_t>(head, 32), -12345678901);
  EXPECT_EQ(at<std::uint64_t>(head, 40), 5U);
  EXPECT_EQ(head.substr(48, 16), std::string("picture") + std::string(9, '\0'));
  EXPECT_EQ(head.substr(64, 4), std::string("|u1") + '\0');
  EXPECT_EQ(at<std::uint32_t>(head, 68), 2U);
  EXPECT_EQ(at<std::uint32_t>(head, 72), 3U);
  EXPECT_EQ(at<std::uint32_t>(head, 76), 1U);
  EXPECT_EQ(at<std::uint64_t>(head, 80), 112U);
  EXPECT_EQ(at<std::uint64_t>(head, 88), 6U);
  EXPECT_STREQ(head.substr(96, 16).c_str(), "points");
  EXPECT_EQ(at<std::uint32_t>(head, 96 + 28), 3U);
  EXPECT_EQ(at<std::uint64_t>(head, 96 + 32), 128U);
  EXPECT_EQ(at<std::uint64_t>(head, 96 + 40), 12U);
  EXPECT_EQ(head.substr(144), R"({"frame":"x"}   )");
  ASSERT_EQ(bytes.parts.size(), 2U);
  EXPECT_EQ(bytes.parts[1].at<cv::Vec3f>(0, 0), cv::Vec3f(1.5F, -2, 3));
}

TEST(StreamFormat, PicturesAreNotCopiedUnlessTheirRowsLieApart) {
  StreamMessage whole;
  whole.json = "{}";
  whole.parts[kImage] = cv::Mat(4, 8, CV_8UC1, cv::Scalar(9));
  EXPECT_EQ(stream_bytes(whole, StreamPartSet(1), 0).parts[0].data, whole.parts[kImage].data);
  StreamMessage cut = whole;
  cut.parts[kImage] = whole.parts[kImage].colRange(2, 5);
  const cv::Mat sent = stream_bytes(cut, StreamPartSet(1), 0).parts[0];
  EXPECT_TRUE(sent.isContinuous());
  EXPECT_EQ(cv::norm(sent, cut.parts[kImage], cv::NORM_INF), 0);
}

TEST(StreamFormat, ARequestNamesParts) {
  EXPECT_EQ(stream_request("alltact-stream/1").value(), StreamPartSet());
  EXPECT_EQ(stream_request("alltact-stream/1  points picture\r").value(), StreamPartSet(0b10001));
  for (const char* wrong :
       {"", "GET / HTTP/1.1", "alltact-stream/10", "alltact-stream/1depth", "\x80\xff"})
    EXPECT_FALSE(stream_request(wrong)) << wrong;
  const auto slip = stream_request("alltact-stream/1 dept16");
  ASSERT_FALSE(slip);
  EXPECT_THAT(slip.error().sentence(), HasSubstr("'dept16', only 'depth16'"));
  EXPECT_THAT(stream_request("alltact-stream/1 \x1b[2J").error().sentence(), HasSubstr("\\x1b[2J"));
}

TEST(StreamFormat, TheSchemaTellsEveryPartFieldAndKey) {
  const std::string text = stream_schema_text();
  const auto json = nlohmann::json::parse(stream_schema_json());
  EXPECT_EQ(json.at("header").at("bytes"), 48);
  EXPECT_EQ(json.at("header").at("fields").size(), 9U);
  EXPECT_EQ(json.at("table").at("fields").back().at("offset"), 40);
  for (const StreamPartKind& kind : kStreamParts) {
    EXPECT_THAT(text, HasSubstr(std::string(kind.name) + " "));
    EXPECT_EQ(json.at("parts").at(std::string(kind.name)).at("dtype"), kind.dtype);
  }
  for (const StreamKey& key : stream_keys())
    EXPECT_TRUE(json.at("json").at(std::string(key.message)).contains(std::string(key.path)));
  EXPECT_THAT(text, HasSubstr("\n   0  magic "));
  EXPECT_THAT(text, HasSubstr("\n  40  lost "));
}

}  // namespace
}  // namespace alltact
