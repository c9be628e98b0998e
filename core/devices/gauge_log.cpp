#include "core/devices/gauge_log.h"

#include "core/base/guarded.h"
#include "core/base/result.h"

#include <cerrno>
#include <chrono>
#include <cmath>
#include <utility>

#include <fcntl.h>
#include <unistd.h>

namespace alltact {
namespace {

constexpr int kGaugeSlice_ms = 50;
constexpr double kRecent_s = 1.0;
constexpr auto kGaugeRetry = std::chrono::milliseconds(300);
/// Maximum delay of a camera's frames, s; a larger difference means another clock.
constexpr double kOldestFrame_s = 5;

std::string gauge_log_line(const GaugeSample& sample, double clock_offset_s) {
  std::string line = fmt::format("{:.6f}", sample.time_s - clock_offset_s);
  for (Eigen::Index axis = 0; axis < 3; ++axis)
    line += sample.has_force ? fmt::format(",{:.7g}", sample.force_N[axis]) : std::string(",");
  line += std::isfinite(sample.sd_N) ? fmt::format(",{:.3g}", sample.sd_N) : std::string(",");
  return line + fmt::format(",{},{},{}\n", sample.holds ? 1 : 0, sample.block, sample.indenter);
}

}  // namespace

std::filesystem::path gauge_log_of(const std::filesystem::path& video) {
  std::filesystem::path file = video;
  return file.replace_extension(".gauge.csv");
}

Result<std::unique_ptr<GaugeLog>> GaugeLog::start(GaugeOpener open, std::string name) {
  auto source = open();
  if (!source) return source.error();
  return std::unique_ptr<GaugeLog>(
      new GaugeLog(std::move(*source), std::move(open), std::move(name)));
}

GaugeLog::GaugeLog(std::unique_ptr<GaugeSource> source, GaugeOpener open, std::string name)
    : open_(std::move(open)),
      name_(std::move(name)),
      source_(std::move(source)),
      worker_([this](const std::stop_token& stop) { run(stop); }) {}

Status GaugeLog::begin(const std::filesystem::path& file) {
  const std::lock_guard lock(mutex_);
  Descriptor opened(
      ::open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_APPEND | O_CLOEXEC, 0666));
  if (!opened.is_open())
    return system_error(en::say("could not write the gauge's readings"), file, errno);
  descriptor_ = std::move(opened);
  file_ = file;
  status_ = {};
  counts_ = {};
  is_clock_synced_ = false;
  waiting_ = recent_;
  std::string name = name_;
  for (char& c : name)
    if (c == '\n' || c == '\r') c = ' ';
  write_text(fmt::format("{}\n# gauge: {}\nt_s,fx_n,fy_n,fz_n,sd_n,holds,block,indenter\n",
                         kGaugeLogFormat, name));
  return status_;
}

void GaugeLog::sync_clock(const Frame& frame) {
  const std::lock_guard lock(mutex_);
  if (is_clock_synced_ || !descriptor_.is_open() || !frame.time_ns) return;
  const double offset_s = gauge_clock_s() - *time_s(frame);
  clock_offset_s_ = offset_s >= -1 && offset_s < kOldestFrame_s ? 0 : offset_s;
  is_clock_synced_ = true;
  for (const GaugeSample& sample : waiting_) write(sample);
  waiting_.clear();
}

Result<GaugeLog::Counts> GaugeLog::end() {
  const std::lock_guard lock(mutex_);
  if (!descriptor_.is_open()) return counts_;
  if (::fsync(descriptor_.number()) != 0 && errno != EINVAL && status_.ok())
    status_ = system_error(en::say("could not write the gauge's readings"), file_, errno);
  descriptor_ = Descriptor();
  if (!status_) return status_.error();
  return counts_;
}

std::vector<Message> GaugeLog::take_remarks() {
  const std::lock_guard lock(mutex_);
  return std::exchange(remarks_, {});
}

void GaugeLog::run(const std::stop_token& stop) {
  bool is_reported = false;
  while (!stop.stop_requested()) {
    if (!source_) {
      auto again = guarded(open_);
      if (!again) {
        static_cast<void>(is_stopped_within(stop, kGaugeRetry));
        continue;
      }
      source_ = std::move(*again);
      is_reported = false;
      const std::lock_guard lock(mutex_);
      remarks_.push_back(en::say("The gauge is back."));
    }
    const auto update = guarded([this] { return source_->read(kGaugeSlice_ms); });
    if (update) {
      take(*update);
      continue;
    }
    source_.reset();
    GaugeUpdate gone;
    gone.samples.emplace_back();
    gone.samples.back().time_s = gauge_clock_s();
    if (!is_reported) gone.remarks.push_back(update.error().message());
    is_reported = true;
    take(gone);
  }
}

void GaugeLog::take(const GaugeUpdate& update) {
  const std::lock_guard lock(mutex_);
  remarks_.insert(remarks_.end(), update.remarks.begin(), update.remarks.end());
  for (const GaugeSample& sample : update.samples) {
    store_recent(sample);
    if (!descriptor_.is_open()) continue;
    if (is_clock_synced_)
      write(sample);
    else
      waiting_.push_back(sample);
  }
}

void GaugeLog::store_recent(const GaugeSample& sample) {
  recent_.push_back(sample);
  while (recent_.size() > 1 && recent_.front().time_s < sample.time_s - kRecent_s)
    recent_.pop_front();
}

void GaugeLog::write(const GaugeSample& sample) {
  ++(sample.has_force ? counts_.readings : counts_.without_force);
  write_text(gauge_log_line(sample, clock_offset_s_));
}

void GaugeLog::write_text(const std::string& text) {
  std::string_view rest = text;
  while (status_.ok() && !rest.empty()) {
    const ssize_t size = ::write(descriptor_.number(), rest.data(), rest.size());
    if (size > 0) {
      rest.remove_prefix(static_cast<std::size_t>(size));
    } else if (errno != EINTR) {
      status_ = system_error(en::say("could not write the gauge's readings"), file_, errno);
      remarks_.push_back(status_.error().message());
    }
  }
}

}  // namespace alltact
