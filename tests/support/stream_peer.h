// A program that connects to a StreamServer, by POSIX alone.
#pragma once

#include "core/stream/stream_format.h"

#include <cstring>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <sys/socket.h>
#include <sys/time.h>
#include <sys/un.h>
#include <unistd.h>

namespace alltact::test {

class StreamPeer {
 public:
  explicit StreamPeer(const std::filesystem::path& path)
      : socket_(socket(AF_UNIX, SOCK_STREAM, 0)) {
    sockaddr_un address{AF_UNIX, {}};
    std::strncpy(address.sun_path, path.c_str(), sizeof address.sun_path - 1);
    is_in_ = connect(socket_, reinterpret_cast<sockaddr*>(&address), sizeof address) == 0;
    const timeval patience{20, 0};
    setsockopt(socket_, SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof patience);
  }
  StreamPeer(const StreamPeer&) = delete;
  StreamPeer& operator=(const StreamPeer&) = delete;
  ~StreamPeer() { leave(); }

  [[nodiscard]] bool is_in() const { return is_in_; }
  void say(std::string_view text) const {
    ASSERT_EQ(send(socket_, text.data(), text.size(), MSG_NOSIGNAL),
              static_cast<ssize_t>(text.size()));
  }
  void say_no_more() const { shutdown(socket_, SHUT_WR); }
  void leave() {
    if (socket_ >= 0) close(socket_);
    socket_ = -1;
  }

  struct Heard {
    StreamHeader header;
    nlohmann::json told;
    std::vector<StreamPartEntry> table;
    std::string body;
    [[nodiscard]] StreamType type() const { return static_cast<StreamType>(header.type); }
    [[nodiscard]] std::string part(std::size_t k) const {
      return body.substr(table.at(k).offset, table.at(k).bytes);
    }
  };
  /// Nothing: the connection has ended.
  [[nodiscard]] std::optional<Heard> hear() const {
    Heard heard;
    if (!take(&heard.header, sizeof heard.header)) return std::nullopt;
    heard.body.resize(heard.header.bytes);
    if (!take(heard.body.data(), heard.body.size())) return std::nullopt;
    heard.table.resize(heard.header.parts);
    const std::size_t table = heard.table.size() * sizeof(StreamPartEntry);
    if (table > 0) std::memcpy(heard.table.data(), heard.body.data(), table);
    heard.told = nlohmann::json::parse(heard.body.substr(table, heard.header.json_bytes));
    return heard;
  }

 private:
  bool take(void* into, std::size_t size) const {
    return size == 0 || recv(socket_, into, size, MSG_WAITALL) == static_cast<ssize_t>(size);
  }
  int socket_;
  bool is_in_ = false;
};

}  // namespace alltact::test
