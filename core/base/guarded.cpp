#include "core/base/guarded.h"

#include <algorithm>
#include <mutex>
#include <new>
#include <system_error>

#include <fmt/core.h>
#include <opencv2/core.hpp>

namespace alltact {
namespace {

Error not_enough_memory() {
  return {en::say("there is not enough memory"), "", en::say("close other programs")};
}

/// A mistake of this program.
Error unexpected(std::string reason) {
  std::replace(reason.begin(), reason.end(), '\n', ' ');  // OpenCV's have several lines
  return {en::say("unexpected: {}", reason), "", en::say("reporting this as a defect")};
}

std::function<void(const Error&)>& unexpected_receiver() {
  // Never destroyed: threads may report until the program's end.
  static auto* const receiver = new std::function<void(const Error&)>;
  return *receiver;
}

std::mutex receiver_mutex;

}  // namespace

void report_unexpected(const Error& error) {
  const std::lock_guard lock(receiver_mutex);
  if (unexpected_receiver()) return unexpected_receiver()(error);
  fmt::print(stderr, "{}\n", error.sentence());
}

void set_unexpected_receiver(std::function<void(const Error&)> receiver) {
  const std::lock_guard lock(receiver_mutex);
  unexpected_receiver() = std::move(receiver);
}

Error caught_error() {
  try {
    throw;
  } catch (const std::bad_alloc&) {
    return not_enough_memory();
  } catch (const cv::Exception& thrown) {
    return thrown.code == cv::Error::StsNoMem ? not_enough_memory() : unexpected(thrown.what());
  } catch (const std::system_error& thrown) {
    const bool is_memory = thrown.code() == std::errc::resource_unavailable_try_again ||
                           thrown.code() == std::errc::not_enough_memory;
    return is_memory ? not_enough_memory() : unexpected(thrown.what());
  } catch (const std::exception& thrown) {
    return unexpected(thrown.what());
  } catch (...) {
    return unexpected("exception");
  }
}

}  // namespace alltact
