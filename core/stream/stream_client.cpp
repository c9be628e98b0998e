#include "core/stream/stream_client.h"

#include <algorithm>
#include <cerrno>

#include <nlohmann/json.hpp>
#include <sys/socket.h>
#include <sys/uio.h>

namespace alltact {
namespace {

constexpr std::array<char, kStreamAlignment> kZeros{};

std::size_t size_of(const cv::Mat& part) {
  return part.total() * part.elemSize();
}
std::size_t padding_of(const cv::Mat& part) {
  return (kStreamAlignment - size_of(part) % kStreamAlignment) % kStreamAlignment;
}

/// The unsent rest of a message.
std::vector<iovec> rest_of(const StreamBytes& bytes, std::size_t sent) {
  std::vector<iovec> rest;
  const auto add = [&](const void* data, std::size_t size) {
    const std::size_t passed = std::min(sent, size);
    sent -= passed;
    if (passed == size) return;
    // sendmsg() reads only.
    rest.push_back({const_cast<char*>(static_cast<const char*>(data)) + passed, size - passed});
  };
  add(bytes.head.data(), bytes.head.size());
  for (const cv::Mat& part : bytes.parts) {
    add(part.data, size_of(part));
    add(kZeros.data(), padding_of(part));
  }
  return rest;
}

}  // namespace

bool StreamClient::is_over(Clock::time_point now) const {
  if (is_gone_) return true;
  if (is_leaving_) return !wants_to_write() || now >= leave_by_;
  return false;
}

std::optional<StreamClient::Clock::time_point> StreamClient::deadline() const {
  return requested_ && !is_leaving_ ? std::nullopt : std::optional(leave_by_);
}

void StreamClient::leave(Clock::time_point now) {
  is_leaving_ = true;
  leave_by_ = now + kLeaveTimeout;
}

void StreamClient::refuse(const Error& why, Clock::time_point now) {
  if (is_leaving_) return;
  StreamMessage message;
  message.type = StreamType::kRefused;
  message.json = nlohmann::json{{"error", why.sentence()}}.dump();
  due_ = {std::make_shared<const StreamMessage>(std::move(message))};
  newest_.reset();
  is_refused_ = true;
  leave(now);
  write();
}

void StreamClient::read(Clock::time_point now) {
  std::array<char, 512> bytes{};
  const ssize_t count = recv(connection_.number(), bytes.data(), bytes.size(), MSG_DONTWAIT);
  if (count < 0) {
    if (errno != EAGAIN && errno != EINTR) is_gone_ = true;
    return;
  }
  has_closed_input_ = count == 0;
  if (is_leaving_) return;  // reads on, so that the client receives the reason
  if (count == 0) {
    if (!requested_)
      refuse({en::say("the connection's line was not whole"),
              "",
              en::say("ending it with a line break")},
             now);
    return;
  }
  if (requested_)
    return refuse({en::say("something came after the line"), "", en::say("connecting again")}, now);
  line_.append(bytes.data(), static_cast<std::size_t>(count));
  take_line(now);
}

void StreamClient::take_line(Clock::time_point now) {
  const std::size_t end = line_.find('\n');
  if (end == std::string::npos && line_.size() <= kLongestStreamRequest) return;
  if (end == std::string::npos || end > kLongestStreamRequest)
    return refuse({en::say("the line is longer than {} bytes", kLongestStreamRequest), "", ""},
                  now);
  if (end + 1 != line_.size())
    return refuse({en::say("something came after the line"), "", en::say("connecting again")}, now);
  const auto requested = stream_request(std::string_view(line_).substr(0, end));
  if (!requested) return refuse(requested.error(), now);
  requested_ = *requested;
}

void StreamClient::offer(const StreamMessagePtr& message, Clock::time_point now) {
  if (!has_request()) return;
  // A frame made before this client came lacks the parts it requested: the next one has them.
  if (message->type == StreamType::kFrame && (requested() & ~message->requested_parts).any())
    return;
  const bool replaces_frame =
      message->type == StreamType::kFrame || message->type == StreamType::kFinger;
  if (replaces_frame && newest_) {
    ++lost_;
    newest_.reset();
  }
  if (message->type == StreamType::kFrame) {
    newest_ = message;
  } else {
    std::erase_if(due_, [&](const StreamMessagePtr& old) { return old->type == message->type; });
    due_.push_back(message);
  }
  if (message->type == StreamType::kEnd) leave(now);
  write();
}

bool StreamClient::begin_next() {
  StreamMessagePtr next;
  if (!due_.empty()) {
    next = due_.front();
    due_.pop_front();
  } else {
    next = std::exchange(newest_, nullptr);
  }
  if (!next) return false;
  sending_ = Sending();
  sending_->bytes = stream_bytes(*next, requested(), lost_);
  sending_->size = sending_->bytes.head.size();
  for (const cv::Mat& part : sending_->bytes.parts)
    sending_->size += size_of(part) + padding_of(part);
  return true;
}

void StreamClient::write() {
  while (!is_gone_ && (sending_ || begin_next())) {
    std::vector<iovec> rest = rest_of(sending_->bytes, sending_->sent);
    msghdr message{};
    message.msg_iov = rest.data();
    message.msg_iovlen = rest.size();
    const ssize_t sent = sendmsg(connection_.number(), &message, MSG_DONTWAIT | MSG_NOSIGNAL);
    if (sent < 0) {
      if (errno == EINTR) continue;
      if (errno != EAGAIN && errno != ENOBUFS) is_gone_ = true;
      return;
    }
    sending_->sent += static_cast<std::size_t>(sent);
    if (sending_->sent == sending_->size) sending_.reset();
  }
}

}  // namespace alltact
