#include "core/stream/stream_server.h"

#include "core/base/atomic_file.h"
#include "core/base/guarded.h"
#include "core/base/message.h"
#include "core/base/result.h"
#include "core/base/worker.h"
#include "core/stream/stream_format.h"

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <deque>
#include <list>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <poll.h>
#include <sys/eventfd.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/uio.h>
#include <sys/un.h>
#include <unistd.h>

namespace alltact {
namespace {

using StreamMessagePtr = std::shared_ptr<const StreamMessage>;

/// One thread. No call blocks. Besides the message being sent, it holds the newest frame and,
/// before it, the newest message of every other kind.
class StreamClient {
 public:
  using Clock = std::chrono::steady_clock;
  static constexpr std::chrono::seconds kRequestTimeout{5};  ///< for its request line
  static constexpr std::chrono::seconds kLeaveTimeout{1};    ///< for its last message

  StreamClient(Descriptor connection, Clock::time_point now)
      : connection_(std::move(connection)), leave_by_(now + kRequestTimeout) {}

  [[nodiscard]] int descriptor() const { return connection_.number(); }
  /// The client has sent its request and takes messages.
  [[nodiscard]] bool has_request() const { return requested_.has_value() && !is_leaving_; }
  [[nodiscard]] StreamPartSet requested() const { return requested_.value_or(StreamPartSet()); }
  [[nodiscard]] bool wants_to_read() const { return !has_closed_input_; }
  [[nodiscard]] bool wants_to_write() const { return sending_ || !due_.empty() || newest_; }
  /// The client has left, or there is nothing more to send.
  [[nodiscard]] bool is_over(Clock::time_point now) const;
  /// When is_over() may change by itself; empty: never.
  [[nodiscard]] std::optional<Clock::time_point> deadline() const;
  [[nodiscard]] std::uint64_t lost() const { return lost_; }
  [[nodiscard]] bool is_refused() const { return is_refused_; }

  /// Call when there is something to read. An invalid request ends the connection, with the reason.
  void read(Clock::time_point now);
  /// Call when the client accepts more bytes.
  void write();
  /// Call when the client's end is gone.
  void hang_up() { is_gone_ = true; }

  void offer(const StreamMessagePtr& message, Clock::time_point now);
  /// Sends the reason and ends the connection.
  void refuse(const Error& why, Clock::time_point now);

 private:
  void leave(Clock::time_point now);
  void take_line(Clock::time_point now);
  bool begin_next();

  Descriptor connection_;
  Clock::time_point leave_by_;
  std::string line_;
  std::optional<StreamPartSet> requested_;
  std::optional<StreamBytes> sending_;
  std::size_t sent_bytes_ = 0, sending_bytes_ = 0;  // of sending_: so far, and in total
  std::deque<StreamMessagePtr> due_;
  StreamMessagePtr newest_;  // newest_ holds a frame
  std::uint64_t lost_ = 0;
  bool has_closed_input_ = false, is_leaving_ = false, is_refused_ = false, is_gone_ = false;
};

constexpr std::array<char, kStreamAlignment> kZeros{};

std::size_t size_of(const cv::Mat& part) { return part.total() * part.elemSize(); }
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
      refuse({en::say("the connection's line was incomplete"), "",
              en::say("ending it with a line break")},
             now);
    return;
  }
  if (requested_)
    return refuse({en::say("more data followed the line"), "", en::say("connecting again")}, now);
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
    return refuse({en::say("more data followed the line"), "", en::say("connecting again")}, now);
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
  sending_ = stream_bytes(*next, requested(), lost_);
  sent_bytes_ = 0;
  sending_bytes_ = sending_->head.size();
  for (const cv::Mat& part : sending_->parts) sending_bytes_ += size_of(part) + padding_of(part);
  return true;
}

void StreamClient::write() {
  while (!is_gone_ && (sending_ || begin_next())) {
    std::vector<iovec> rest = rest_of(*sending_, sent_bytes_);
    msghdr message{};
    message.msg_iov = rest.data();
    message.msg_iovlen = rest.size();
    const ssize_t sent = sendmsg(connection_.number(), &message, MSG_DONTWAIT | MSG_NOSIGNAL);
    if (sent < 0) {
      if (errno == EINTR) continue;
      if (errno != EAGAIN && errno != ENOBUFS) is_gone_ = true;
      return;
    }
    sent_bytes_ += static_cast<std::size_t>(sent);
    if (sent_bytes_ == sending_bytes_) sending_.reset();
  }
}

using Clock = StreamClient::Clock;
constexpr std::chrono::milliseconds kAcceptPause{100};  // pause when no descriptor was free

int milliseconds_until(Clock::time_point then, Clock::time_point now) {
  const auto left = std::chrono::ceil<std::chrono::milliseconds>(then - now).count();
  return static_cast<int>(std::max<decltype(left)>(left, 0));
}

}  // namespace

struct StreamServer::State {
  State(ListeningSocket socket, Descriptor wake_event)
      : listening(std::move(socket)), woken(std::move(wake_event)) {}

  ListeningSocket listening;
  Descriptor woken;  // an eventfd
  std::atomic<unsigned long> requested{0};

  mutable std::mutex mutex;  // protects:
  std::vector<StreamMessagePtr> inbox;
  StreamCounts counts;
  bool is_ending = false;

  // Of the thread:
  std::list<StreamClient> clients;
  StreamMessagePtr finger;
  std::uint64_t lost_by_dropped = 0;
  std::optional<Clock::time_point> accept_after;  // pause after a failed accept()

  Worker worker;  // last: it ends first

  void wake() const {
    const std::uint64_t one = 1;
    (void)!::write(woken.number(), &one, sizeof one);
  }

  void run() {
    bool is_over = false;
    while (!is_over) {
      const Status ran = guarded([&] {
        wait();
        const auto now = Clock::now();
        const bool is_last = deliver(now);
        drop_gone_clients(now);
        is_over = is_last && clients.empty();
      });
      if (ran) continue;
      clients.clear();  // they connect again
      const std::lock_guard lock(mutex);
      is_over = is_ending;
    }
  }

  /// Waits until there is something to do, and serves the ready descriptors.
  void wait() {
    auto now = Clock::now();
    if (accept_after && now >= *accept_after) accept_after.reset();
    std::vector<pollfd> all = {{woken.number(), POLLIN, 0},
                               {accept_after ? -1 : listening.descriptor(), POLLIN, 0}};
    std::optional<Clock::time_point> next = accept_after;
    for (const StreamClient& client : clients) {
      const int events =
          (client.wants_to_read() ? POLLIN : 0) | (client.wants_to_write() ? POLLOUT : 0);
      all.push_back({client.descriptor(), static_cast<short>(events), 0});
      if (const auto end = client.deadline(); end && (!next || *end < *next)) next = end;
    }
    if (poll(all.data(), all.size(), next ? milliseconds_until(*next, now) : -1) < 0) return;
    now = Clock::now();
    std::uint64_t ignored = 0;
    if (all[0].revents != 0) (void)!::read(woken.number(), &ignored, sizeof ignored);
    std::size_t at = 2;
    for (StreamClient& client : clients) serve(client, all[at++].revents, now);
    if (all[1].revents != 0) accept_clients(now);
  }

  void serve(StreamClient& client, int events, Clock::time_point now) {
    const bool had_request = client.has_request();
    if ((events & POLLIN) != 0) client.read(now);
    if ((events & POLLOUT) != 0) client.write();
    if ((events & (POLLHUP | POLLERR | POLLNVAL)) != 0 && (events & POLLIN) == 0) client.hang_up();
    if (!had_request && client.has_request()) {
      const std::lock_guard lock(mutex);
      ++counts.served;
      if (finger) client.offer(finger, now);
    }
  }

  void accept_clients(Clock::time_point now) {
    while (true) {
      Descriptor connection = listening.accept();
      if (!connection.is_open()) {
        if (errno != EAGAIN && errno != EINTR && errno != ECONNABORTED)
          accept_after = now + kAcceptPause;
        return;
      }
      StreamClient& client = clients.emplace_back(std::move(connection), now);
      if (!is_own_peer(client.descriptor()))
        client.refuse({en::say("programs of other users are not accepted"), "", ""}, now);
      else if (clients.size() > kMaxClients)
        client.refuse({en::say("{} programs are already served", kMaxClients), "",
                       en::say("ending one of them")},
                      now);
    }
  }

  /// True once the last message was sent.
  bool deliver(Clock::time_point now) {
    std::vector<StreamMessagePtr> messages;
    bool is_last = false;
    {
      const std::lock_guard lock(mutex);
      messages.swap(inbox);
      is_last = is_ending;
    }
    for (const StreamMessagePtr& message : messages) {
      if (message->type == StreamType::kFinger) finger = message;
      for (StreamClient& client : clients)
        if (finger || message->type == StreamType::kEnd) client.offer(message, now);
    }
    if (is_last)
      for (StreamClient& client : clients)
        if (client.deadline() && !client.wants_to_write()) client.hang_up();  // no request came
    return is_last;
  }

  void drop_gone_clients(Clock::time_point now) {
    for (StreamClient& client : clients)
      if (const auto end = client.deadline(); end && now >= *end && !client.is_over(now))
        client.refuse(
            {en::say("no line came within {} seconds", StreamClient::kRequestTimeout.count()), "",
             en::say("one line such as alltact-stream/1 picture depth16")},
            now);
    std::uint64_t refused = 0;
    std::erase_if(clients, [&](const StreamClient& client) {
      if (!client.is_over(now)) return false;
      lost_by_dropped += client.lost();
      refused += client.is_refused() ? 1 : 0;
      return true;
    });
    count(refused);
  }

  void count(std::uint64_t refused) {
    StreamPartSet all;
    std::size_t served = 0;
    std::uint64_t lost = lost_by_dropped;
    for (const StreamClient& client : clients) {
      lost += client.lost();
      if (!client.has_request()) continue;
      ++served;
      all |= client.requested();
    }
    requested = all.to_ulong();
    const std::lock_guard lock(mutex);
    counts.refused += refused;
    counts.clients = served;
    counts.lost = lost;
  }
};

Result<std::unique_ptr<StreamServer>> StreamServer::start(const std::filesystem::path& socket,
                                                          const std::string& doing) {
  auto listening = ListeningSocket::listen(socket, doing);
  if (!listening) return listening.error();
  Descriptor woken(eventfd(0, EFD_NONBLOCK | EFD_CLOEXEC));
  if (!woken.is_open())
    return system_error(en::say("programs could not connect here"), socket, errno);
  auto state = std::make_unique<State>(std::move(*listening), std::move(woken));
  state->worker = Worker([s = state.get()] { s->run(); });
  return std::unique_ptr<StreamServer>(new StreamServer(std::move(state)));
}

StreamServer::StreamServer(std::unique_ptr<State> state) : state_(std::move(state)) {}

StreamServer::~StreamServer() { end("{}"); }

const std::filesystem::path& StreamServer::path() const { return state_->listening.path(); }

void StreamServer::publish(StreamMessage message) {
  {
    const std::lock_guard lock(state_->mutex);
    if (state_->is_ending) return;
    state_->inbox.push_back(std::make_shared<const StreamMessage>(std::move(message)));
  }
  state_->wake();
}

StreamPartSet StreamServer::requested() const { return StreamPartSet(state_->requested.load()); }

StreamCounts StreamServer::counts() const {
  const std::lock_guard lock(state_->mutex);
  return state_->counts;
}

void StreamServer::end(std::string json) {
  StreamMessage message;
  message.type = StreamType::kEnd;
  message.json = std::move(json);
  publish(std::move(message));
  {
    const std::lock_guard lock(state_->mutex);
    state_->is_ending = true;
  }
  state_->wake();
  state_->worker.join();
}

namespace {

namespace fs = std::filesystem;

constexpr int kBacklog = 16;  // length of the queue of new connections

fs::path lock_of(const fs::path& socket) { return socket.string() + ".lock"; }

Error cannot_listen(const fs::path& path, int error_number) {
  return system_error(en::say("programs could not connect here"), path, error_number);
}

Result<sockaddr_un> address_of(const fs::path& path) {
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  const std::string& name = path.native();
  if (name.size() >= sizeof address.sun_path)
    return Error{en::say("the path is longer than the {} bytes a socket's path may have",
                         sizeof address.sun_path - 1),
                 path, en::say("a shorter one with --socket")};
  name.copy(address.sun_path, name.size());
  return address;
}

Descriptor new_socket() {
  return Descriptor(socket(AF_UNIX, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0));
}

/// Only this user may replace files in the folder.
Status make_private_folder(const fs::path& folder) {
  std::error_code failed;
  if (folder.has_parent_path()) fs::create_directories(folder.parent_path(), failed);
  if (mkdir(folder.c_str(), S_IRWXU) != 0 && errno != EEXIST) return cannot_listen(folder, errno);
  struct stat of {};
  if (stat(folder.c_str(), &of) != 0) return cannot_listen(folder, errno);
  if (!S_ISDIR(of.st_mode)) return cannot_listen(folder, ENOTDIR);
  if (of.st_uid != geteuid())
    return Error{en::say("this folder belongs to another user, who could read the data"), folder,
                 en::say("a folder of your own with --socket")};
  if ((of.st_mode & (S_IWGRP | S_IWOTH)) != 0)
    return Error{en::say("others may write in this folder, and could put their own socket there"),
                 folder, en::say("chmod 700, or another folder with --socket")};
  return {};
}

Status check_free(const fs::path& path, const sockaddr_un& address) {
  struct stat of {};
  if (lstat(path.c_str(), &of) != 0) return errno == ENOENT ? Status() : cannot_listen(path, errno);
  if (!S_ISSOCK(of.st_mode))
    return Error{en::say("something here is not a socket, and it remains unchanged"), path,
                 en::say("another path with --socket")};
  const Descriptor probe = new_socket();
  if (connect(probe.number(), reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0 &&
      errno != EAGAIN)
    return {};
  const auto who = read_file(lock_of(path));
  return Error{
      en::say("another program already serves here ({})", who ? printable(*who) : std::string("?")),
      path, en::say("connecting to that one, ending it, or another path with --socket")};
}

}  // namespace

fs::path default_socket(const std::string& finger_name) {
  std::string name = finger_name + ".sock";
  std::replace(name.begin(), name.end(), '/', '_');
  std::error_code failed;
  const char* own = std::getenv("XDG_RUNTIME_DIR");
  if (own != nullptr && fs::path(own).is_absolute() && fs::is_directory(own, failed))
    return fs::path(own) / "alltact" / name;
  return fs::temp_directory_path(failed) / fmt::format("alltact-{}", geteuid()) / name;
}

Result<ListeningSocket> ListeningSocket::listen(const fs::path& given, const std::string& doing) {
  std::error_code failed;
  const fs::path path = fs::absolute(given, failed);
  const auto address = address_of(path);
  if (!address) return address.error();
  if (Status made = make_private_folder(path.parent_path()); !made) return made.error();
  if (Status free = check_free(path, *address); !free) return free.error();
  auto held = LockFile::hold(lock_of(path), this_process(doing), std::chrono::milliseconds(0));
  if (!held) return held.error();
  // The lock excludes other servers: an existing file is a rest.
  if (Status free = check_free(path, *address); !free) return free.error();
  unlink(path.c_str());
  ListeningSocket made(path, std::move(*held), new_socket());
  if (bind(made.descriptor(), reinterpret_cast<const sockaddr*>(&*address), sizeof *address) != 0)
    return cannot_listen(path, errno);
  struct stat of {};
  if (stat(path.c_str(), &of) == 0) made.inode_ = of.st_ino;
  // Before anybody can connect.
  if (chmod(path.c_str(), S_IRUSR | S_IWUSR) != 0 || ::listen(made.descriptor(), kBacklog) != 0)
    return cannot_listen(path, errno);
  return made;
}

ListeningSocket::~ListeningSocket() {
  struct stat of {};
  if (socket_.is_open() && stat(path_.c_str(), &of) == 0 && of.st_ino == inode_)
    unlink(path_.c_str());
}

Descriptor ListeningSocket::accept() const {
  return Descriptor(accept4(socket_.number(), nullptr, nullptr, SOCK_NONBLOCK | SOCK_CLOEXEC));
}

bool is_own_peer(int connection) {
  ucred peer{};
  socklen_t size = sizeof peer;
  return getsockopt(connection, SOL_SOCKET, SO_PEERCRED, &peer, &size) == 0 &&
         size == sizeof peer && peer.uid == geteuid();
}

}  // namespace alltact
