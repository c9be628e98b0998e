// Programs that connect: quick ones, slow ones, and those that do what they should not.
#include "core/stream/stream_server.h"

#include "tests/support/stream_peer.h"
#include "tests/support/temporary_folder.h"

#include <chrono>
#include <fstream>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

namespace alltact {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using testing::HasSubstr;

template <class Condition>
bool wait_until(const Condition& condition) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(20);
  while (!condition()) {
    if (std::chrono::steady_clock::now() > end) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return true;
}

using Peer = test::StreamPeer;

StreamMessage frame(std::uint64_t number, int side = 8) {
  StreamMessage message;
  message.sequence = number;
  message.json = json{{"index", number}}.dump();
  message.parts[kImage] =
      cv::Mat(side, side, CV_8UC1, cv::Scalar(static_cast<double>(number % 251)));
  message.parts[kDepth16] = cv::Mat(side, side, CV_16UC1, cv::Scalar(static_cast<double>(number)));
  return message;
}

StreamMessage finger(int revision) {
  StreamMessage message;
  message.type = StreamType::kFinger;
  message.json = json{{"finger_revision", revision}}.dump();
  return message;
}

class StreamServerTest : public testing::Test {
 protected:
  void SetUp() override {
    auto started = StreamServer::start(path_, "serving a test");
    ASSERT_TRUE(started.ok()) << started.error().sentence();
    server_ = std::move(*started);
    server_->publish(finger(1));
  }
  /// Has asked, and heard what the finger is.
  [[nodiscard]] std::unique_ptr<Peer> listener(const std::string& parts) const {
    auto peer = std::make_unique<Peer>(path_);
    EXPECT_TRUE(peer->is_in());
    peer->say("alltact-stream/1" + parts + "\n");
    const auto first = peer->hear();
    EXPECT_TRUE(first && first->type() == StreamType::kFinger);
    return peer;
  }
  /// What a peer is told when it is refused, before its connection ends.
  static std::string refusal(const Peer& peer) {
    const auto heard = peer.hear();
    if (!heard) return "ended without a word";
    EXPECT_EQ(heard->type(), StreamType::kRefused);
    EXPECT_FALSE(peer.hear());
    return heard->told.at("error");
  }
  [[nodiscard]] bool still_serves() const {
    const auto peer = listener(" picture");
    server_->publish(frame(99));
    const auto heard = peer->hear();
    return heard && heard->header.sequence == 99 && heard->table.size() == 1;
  }

  test::TemporaryFolder folder_;
  fs::path path_ = folder_ / "own/f.sock";
  std::unique_ptr<StreamServer> server_;
};

TEST_F(StreamServerTest, EachGetsWhatItAskedFor) {
  const auto both = listener(" depth16 picture"), none = listener("");
  ASSERT_TRUE(wait_until([&] { return server_->counts().clients == 2; }));
  EXPECT_EQ(server_->requested(), StreamPartSet(0b11));
  for (std::uint64_t number = 0; number < 5; ++number) {
    server_->publish(frame(number, 33));
    const auto a = both->hear(), b = none->hear();
    ASSERT_TRUE(a && b);
    EXPECT_EQ(a->told.at("index"), number);
    EXPECT_EQ(a->header.sequence, number);
    ASSERT_EQ(a->table.size(), 2U);
    EXPECT_EQ(a->part(0), std::string(33 * 33, static_cast<char>(number)));
    EXPECT_EQ(a->table[1].bytes, 2U * 33 * 33);
    EXPECT_EQ(a->table[1].offset % 16, 0U);
    EXPECT_TRUE(b->table.empty());
    EXPECT_EQ(b->told.at("index"), number);
  }
  EXPECT_EQ(server_->counts().lost, 0U);
}

TEST_F(StreamServerTest, AFrameThatWasUnderWayWithoutWhatIsAskedForIsNotSent) {
  const auto wanting = listener(" depth16"), content = listener("");
  StreamMessage before = frame(1);
  before.requested_parts = StreamPartSet();
  before.parts = {};
  server_->publish(before);
  server_->publish(frame(2));
  const auto heard = wanting->hear();
  ASSERT_TRUE(heard);
  EXPECT_EQ(heard->header.sequence, 2U);
  EXPECT_EQ(heard->header.lost, 0U);
  EXPECT_EQ(heard->table.size(), 1U);
  const auto other = content->hear();
  ASSERT_TRUE(other);
  EXPECT_TRUE(other->header.sequence == 1 || other->header.lost == 1);
}

TEST_F(StreamServerTest, WhoeverComesLateHearsTheFingerAsItIsNow) {
  server_->publish(finger(2));
  const auto peer = listener("");
  server_->publish(finger(3));
  const auto heard = peer->hear();
  ASSERT_TRUE(heard);
  EXPECT_EQ(heard->type(), StreamType::kFinger);
  EXPECT_EQ(heard->told.at("finger_revision"), 3);
}

TEST_F(StreamServerTest, ASlowOneLosesFramesThatAreCountedAndGetsTheNewest) {
  const auto slow = listener(" picture"), quick = listener("");
  constexpr std::uint64_t kFrames = 40;
  constexpr int kSide = 1000;  // more than a socket takes at once
  for (std::uint64_t number = 0; number < kFrames; ++number) {
    server_->publish(frame(number, kSide));
    const auto heard = quick->hear();  // never waits for the other
    ASSERT_TRUE(heard);
    ASSERT_EQ(heard->header.sequence, number);
    ASSERT_EQ(heard->header.lost, 0U);
  }
  std::uint64_t last = 0, heard_frames = 0;
  while (last != kFrames - 1) {
    const auto heard = slow->hear();
    ASSERT_TRUE(heard);
    ++heard_frames;
    last = heard->header.sequence;
    EXPECT_EQ(heard->part(0), std::string(kSide * kSide, static_cast<char>(last % 251)));
    // Whatever it did not get up to here was counted.
    EXPECT_EQ(heard->header.lost + heard_frames, last + 1);
  }
  EXPECT_LT(heard_frames, 4U);
  EXPECT_EQ(server_->counts().lost, kFrames - heard_frames);
}

TEST_F(StreamServerTest, OneThatNeverReadsHoldsNobodyUp) {
  const auto stuck = listener(" picture depth16");
  for (std::uint64_t number = 0; number < 20; ++number) server_->publish(frame(number, 1000));
  EXPECT_TRUE(still_serves());
  const auto begin = std::chrono::steady_clock::now();
  server_->end(R"({"reason":"over."})");
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(5));
}

TEST_F(StreamServerTest, OneThatDiesIsForgotten) {
  {
    const auto dying = listener(" picture");
    server_->publish(frame(1, 1000));
  }
  EXPECT_TRUE(wait_until([&] { return server_->counts().clients == 0; }));
  EXPECT_EQ(server_->requested(), StreamPartSet());
  EXPECT_TRUE(still_serves());
}

TEST_F(StreamServerTest, GarbageIsRefusedWithTheReason) {
  const auto answer_to = [&](const std::string& line) {
    const Peer peer(path_);
    peer.say(line);
    return refusal(peer);
  };
  EXPECT_THAT(answer_to("GET / HTTP/1.1\r\n"), HasSubstr("'GET / HTTP/1.1' does not request"));
  EXPECT_THAT(answer_to("alltact-stream/1 colour\n"), HasSubstr("no part 'colour'"));
  EXPECT_THAT(answer_to(std::string(400, 'a')), HasSubstr("longer than 256 bytes"));
  EXPECT_THAT(answer_to(std::string(300, '\0') + "\n"), HasSubstr("longer than 256 bytes"));
  EXPECT_THAT(answer_to("alltact-stream/1\nand more"), HasSubstr("data followed the line"));
  EXPECT_TRUE(wait_until([&] { return server_->counts().refused == 5; }));
  EXPECT_TRUE(still_serves());
}

TEST_F(StreamServerTest, MoreAfterTheLineEndsTheConnection) {
  const auto peer = listener("");
  peer->say("alltact-stream/1 picture\n");
  EXPECT_THAT(refusal(*peer), HasSubstr("data followed the line"));
}

TEST_F(StreamServerTest, HalfARequestIsNotWaitedForForEver) {
  const Peer closed(path_), silent(path_), begun(path_);
  closed.say("alltact-str");
  closed.say_no_more();
  EXPECT_THAT(refusal(closed), HasSubstr("incomplete"));
  begun.say("alltact-stream/1 pict");
  EXPECT_TRUE(still_serves());
  EXPECT_THAT(refusal(silent), HasSubstr("no line came within 5 seconds"));
  EXPECT_THAT(refusal(begun), HasSubstr("no line came within 5 seconds"));
}

// As `echo alltact-stream/1 | nc -N -U PATH` does.
TEST_F(StreamServerTest, OneThatWillSayNothingMoreIsServed) {
  const auto peer = listener("");
  peer->say_no_more();
  for (std::uint64_t number : {4, 5}) {
    server_->publish(frame(number));
    const auto heard = peer->hear();
    ASSERT_TRUE(heard);
    EXPECT_EQ(heard->header.sequence, number);
  }
}

TEST_F(StreamServerTest, TooManyAreTold) {
  std::vector<std::unique_ptr<Peer>> all;
  for (std::size_t i = 0; i < StreamServer::kMaxClients; ++i) all.push_back(listener(""));
  EXPECT_THAT(refusal(Peer(path_)), HasSubstr("16 programs are already served"));
  all.pop_back();
  ASSERT_TRUE(wait_until([&] { return server_->counts().clients == all.size(); }));
  EXPECT_TRUE(still_serves());
}

TEST_F(StreamServerTest, TheEndIsToldAndNothingIsLeft) {
  const auto peer = listener("");
  server_->end(R"({"reason":"the source ended."})");
  const auto heard = peer->hear();
  ASSERT_TRUE(heard);
  EXPECT_EQ(heard->type(), StreamType::kEnd);
  EXPECT_EQ(heard->told.at("reason"), "the source ended.");
  EXPECT_FALSE(peer->hear());
  server_.reset();
  EXPECT_TRUE(fs::is_empty(path_.parent_path()));
}

TEST_F(StreamServerTest, OnlyTheUserMayComeNear) {
  struct stat of {};
  ASSERT_EQ(stat(path_.c_str(), &of), 0);
  EXPECT_EQ(of.st_mode & 07777U, 0600U);
  ASSERT_EQ(stat(path_.parent_path().c_str(), &of), 0);
  EXPECT_EQ(of.st_mode & 07777U, 0700U);
}

// Even where the file itself would let it in.
TEST_F(StreamServerTest, AnotherUserIsRefused) {
  if (geteuid() != 0) GTEST_SKIP() << "only root can try it as somebody else";
  ASSERT_EQ(chmod(folder_.path().c_str(), 0755), 0);
  ASSERT_EQ(chmod(path_.parent_path().c_str(), 0755), 0);
  ASSERT_EQ(chmod(path_.c_str(), 0666), 0);
  const pid_t child = fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    constexpr uid_t kNobody = 65534;
    if (setuid(kNobody) != 0) _exit(2);
    const Peer peer(path_);
    if (!peer.is_in()) _exit(3);
    const auto heard = peer.hear();
    if (!heard || heard->type() != StreamType::kRefused) _exit(4);
    _exit(heard->told.at("error").get<std::string>().find("other users") != std::string::npos ? 0
                                                                                              : 5);
  }
  int status = 0;
  ASSERT_EQ(waitpid(child, &status, 0), child);
  EXPECT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 0);
  EXPECT_TRUE(wait_until([&] { return server_->counts().refused == 1; }));
}

TEST_F(StreamServerTest, TwoOnOnePathAreToldApart) {
  const auto second = StreamServer::start(path_, "serving another");
  ASSERT_FALSE(second);
  EXPECT_THAT(second.error().sentence(), HasSubstr("another program already serves here"));
  EXPECT_THAT(second.error().sentence(), HasSubstr("serving a test, process"));
  EXPECT_TRUE(still_serves());
}

TEST(StreamSocket, WhatAKilledServerLeftBehindIsReplaced) {
  const test::TemporaryFolder folder;
  const fs::path path = folder / "f.sock";
  const pid_t child = fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    const auto left = ListeningSocket::listen(path, "serving");
    kill(getpid(), left ? SIGKILL : SIGABRT);
  }
  int status = 0;
  ASSERT_EQ(waitpid(child, &status, 0), child);
  ASSERT_EQ(WTERMSIG(status), SIGKILL);
  ASSERT_TRUE(fs::exists(path));
  const auto again = ListeningSocket::listen(path, "serving again");
  ASSERT_TRUE(again.ok()) << again.error().sentence();
  EXPECT_TRUE(Peer(path).is_in());
}

TEST(StreamSocket, WhatIsNoSocketIsLeftAlone) {
  const test::TemporaryFolder folder;
  std::ofstream(folder / "notes") << "dear diary";
  const auto refused = ListeningSocket::listen(folder / "notes", "serving");
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().sentence(), HasSubstr("not a socket"));
  EXPECT_EQ(fs::file_size(folder / "notes"), 10U);
}

TEST(StreamSocket, FoldersOfOthersAreRefused) {
  const test::TemporaryFolder folder;
  ASSERT_EQ(chmod(folder.path().c_str(), 0777), 0);
  const auto open = ListeningSocket::listen(folder / "f.sock", "serving");
  ASSERT_FALSE(open);
  EXPECT_THAT(open.error().sentence(), HasSubstr("others may write in this folder"));
  ASSERT_EQ(chmod(folder.path().c_str(), 0700), 0);
  if (geteuid() != 0) return;
  ASSERT_EQ(chown(folder.path().c_str(), 65534, 65534), 0);
  const auto theirs = ListeningSocket::listen(folder / "f.sock", "serving");
  ASSERT_FALSE(theirs);
  EXPECT_THAT(theirs.error().sentence(), HasSubstr("belongs to another user"));
}

TEST(StreamSocket, APathThatIsTooLongIsSaidToBe) {
  const test::TemporaryFolder folder;
  const auto refused = ListeningSocket::listen(folder / std::string(120, 'n'), "serving");
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().sentence(), HasSubstr("longer than the 107 bytes"));
}

TEST(StreamSocket, TheUsualPlaceIsTheUsersOwn) {
  const test::TemporaryFolder folder;
  setenv("XDG_RUNTIME_DIR", folder.path().c_str(), 1);
  EXPECT_EQ(default_socket("left-07"), folder / "alltact/left-07.sock");
  EXPECT_EQ(default_socket("a/b"), folder / "alltact/a_b.sock");
  setenv("XDG_RUNTIME_DIR", "relative", 1);
  EXPECT_EQ(default_socket("left-07").parent_path().filename(),
            "alltact-" + std::to_string(geteuid()));
  unsetenv("XDG_RUNTIME_DIR");
}

}  // namespace
}  // namespace alltact
