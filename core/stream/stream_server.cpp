#include "core/stream/stream_server.h"

#include "core/io/system_error.h"
#include "core/stream/stream_client.h"
#include "core/stream/stream_socket.h"

#include <atomic>
#include <cerrno>
#include <chrono>
#include <list>
#include <mutex>
#include <thread>

#include <poll.h>
#include <sys/eventfd.h>
#include <unistd.h>

namespace alltact {
namespace {

using Clock = StreamClient::Clock;
constexpr std::chrono::milliseconds kAcceptPause{100};  // pause when no descriptor was free

int milliseconds_until(Clock::time_point then, Clock::time_point now) {
  const auto left = std::chrono::ceil<std::chrono::milliseconds>(then - now).count();
  return static_cast<int>(std::max<decltype(left)>(left, 0));
}

}  // namespace

struct StreamServer::State {
  State(ListeningSocket listening, Descriptor woken)
      : listening(std::move(listening)), woken(std::move(woken)) {}

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

  std::jthread thread;  // last: it ends first

  void wake() const {
    const std::uint64_t one = 1;
    (void)!::write(woken.number(), &one, sizeof one);
  }

  void run() {
    while (true) {
      wait();
      const auto now = Clock::now();
      const bool is_last = deliver(now);
      drop_gone_clients(now);
      if (is_last && clients.empty()) return;
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
        client.refuse({en::say("another user's programs are not let in"), "", ""}, now);
      else if (clients.size() > kMaxClients)
        client.refuse({en::say("{} programs are served already", kMaxClients),
                       "",
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
        if (client.deadline() && !client.wants_to_write())
          client.hang_up();  // never requested
                             // anything
    return is_last;
  }

  void drop_gone_clients(Clock::time_point now) {
    for (StreamClient& client : clients)
      if (const auto end = client.deadline(); end && now >= *end && !client.is_over(now))
        client.refuse(
            {en::say("no line came within {} seconds", StreamClient::kRequestTimeout.count()),
             "",
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
    return system_error(en::say("programs could not be let in here"), socket, errno);
  auto state = std::make_unique<State>(std::move(*listening), std::move(woken));
  state->thread = std::jthread([s = state.get()] { s->run(); });
  return std::unique_ptr<StreamServer>(new StreamServer(std::move(state)));
}

StreamServer::StreamServer(std::unique_ptr<State> state) : state_(std::move(state)) {}

StreamServer::~StreamServer() {
  end("{}");
}

const std::filesystem::path& StreamServer::path() const {
  return state_->listening.path();
}

void StreamServer::publish(StreamMessage message) {
  {
    const std::lock_guard lock(state_->mutex);
    if (state_->is_ending) return;
    state_->inbox.push_back(std::make_shared<const StreamMessage>(std::move(message)));
  }
  state_->wake();
}

StreamPartSet StreamServer::requested() const {
  return StreamPartSet(state_->requested.load());
}

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
  if (state_->thread.joinable()) state_->thread.join();
}

}  // namespace alltact
