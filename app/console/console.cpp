#include "app/console/console.h"

#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdio>

#include <fmt/format.h>
#include <unistd.h>

namespace alltact {
namespace {

// The job that Ctrl-C stops; a program has one console.
std::atomic<Job*> running_job{nullptr};

void on_interrupt(int) {
  if (Job* job = running_job.load(std::memory_order_relaxed)) job->request_stop();
}

std::int64_t now_ms() {
  return std::chrono::duration_cast<std::chrono::milliseconds>(
             std::chrono::steady_clock::now().time_since_epoch())
      .count();
}

}  // namespace

Console::Console(bool json)
    : json_(json),
      watched_(isatty(STDERR_FILENO) == 1),
      job_([this](double fraction, const Message& what) { draw(fraction, what); }) {
  running_job = &job_;
  struct sigaction action {};
  action.sa_handler = on_interrupt;
  action.sa_flags = static_cast<int>(SA_RESETHAND);
  for (const int signal : {SIGINT, SIGTERM}) sigaction(signal, &action, nullptr);
  std::signal(SIGXFSZ, SIG_IGN);  // a file that may not grow is an error of its writing
}

Console::~Console() { running_job = nullptr; }

void Console::say(std::string_view line) {
  if (json_) return;
  clear_progress();
  fmt::print("{}\n", line);
  std::fflush(stdout);
}

Status Console::put(std::string_view line) {
  clear_progress();
  const std::string text = fmt::format("{}\n", line);
  if (std::fwrite(text.data(), 1, text.size(), stdout) == text.size() && std::fflush(stdout) == 0)
    return {};
  return Error{en::say("standard output could not be written"), "",
               en::say("looking at what reads it")};
}

void Console::warn(std::string_view line) {
  clear_progress();
  fmt::print(stderr, "{}\n", line);
}

void Console::draw(double fraction, const Message& what) {
  if (!watched_) return;
  const std::int64_t now = now_ms();
  if (drawn_ && now - last_drawn_ms_ < 100) return;
  const std::string line = fmt::format("{:3.0f} %  {:.70}", 100 * fraction, what);
  // Overwrites the last one and pads with blanks: works on every terminal.
  fmt::print(stderr, "\r{:<{}}", line, drawn_width_);
  std::fflush(stderr);
  drawn_width_ = line.size();
  last_drawn_ms_ = now;
  drawn_ = true;
}

void Console::clear_progress() {
  if (!drawn_) return;
  fmt::print(stderr, "\r{:<{}}\r", "", drawn_width_);
  drawn_ = false;
}

int Console::finish(const Status& status) {
  clear_progress();
  if (!status) {
    fmt::print(stderr, "{}\n", status.error().sentence());
    answer_["error"] = status.error().sentence();
  }
  bool written = true;
  if (json_) {
    const std::string text = answer_.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
    written = std::fwrite(text.data(), 1, text.size(), stdout) == text.size();
  }
  written = std::fflush(stdout) == 0 && written;
  if (!written) fmt::print(stderr, "Standard output could not be written.\n");
  return status.ok() && written ? 0 : 1;
}

Console::Json in_english(const std::vector<Message>& messages) {
  Console::Json all = Console::Json::array();
  for (const Message& message : messages) all.push_back(message.english());
  return all;
}

}  // namespace alltact
