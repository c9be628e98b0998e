#include "core/sources/gauge/serial_port.h"

#include "core/io/system_error.h"

#include <algorithm>
#include <cerrno>
#include <map>
#include <utility>

#include <fcntl.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <termios.h>
#include <unistd.h>

namespace alltact {
namespace {

constexpr int kWriteTimeout_ms = 1000;

const std::map<int, speed_t>& speed_codes() {
  static const std::map<int, speed_t> codes{
      {300, B300},         {600, B600},         {1200, B1200},       {2400, B2400},
      {4800, B4800},       {9600, B9600},       {19200, B19200},     {38400, B38400},
      {57600, B57600},     {115200, B115200},   {230400, B230400},   {460800, B460800},
      {500000, B500000},   {576000, B576000},   {921600, B921600},   {1000000, B1000000},
      {1152000, B1152000}, {1500000, B1500000}, {2000000, B2000000}, {2500000, B2500000},
      {3000000, B3000000}, {3500000, B3500000}, {4000000, B4000000}};
  return codes;
}

FailureWords words_for_line(int error_number) {
  switch (error_number) {
    case EACCES:
    case EPERM:
      return {en::say("access is not allowed"),
              en::say("make this user a member of the group dialout (sudo usermod -aG dialout "
                      "$USER) and log in again")};
    case EBUSY:
      return {en::say("another program uses it"), en::say("close that program")};
    case ENOENT:
    case ENXIO:
    case ENODEV: {
      std::vector<Message> names;
      for (const auto& port : serial_ports()) names.push_back(Message::typed(port.string()));
      return {en::say("there is no such serial line"),
              names.empty() ? en::say("plug the gauge in; none was found")
                            : en::say("plug it in, or one of {}", en::list(names))};
    }
    default:
      return {{}, en::say("unplug it and plug it in again")};
  }
}

Error line_error(const Message& doing, const std::filesystem::path& node, int error_number) {
  return errno_error(doing, node, words_for_line(error_number), error_number);
}

Error line_gone(const std::filesystem::path& node) {
  return {en::say("the serial line is gone"), node, en::say("plug the gauge in again")};
}

Status set_up(int descriptor, const std::filesystem::path& node, speed_t speed, int baud) {
  const Message doing = en::say("the serial line cannot be set up");
  termios line{};
  if (::tcgetattr(descriptor, &line) != 0)
    return Error{en::say("this is no serial line"), node, en::say("the gauge's /dev/tty...")};
  ::cfmakeraw(&line);
  line.c_cflag &= ~static_cast<tcflag_t>(CSTOPB | PARENB | CRTSCTS | HUPCL);
  line.c_cflag |= CS8 | CREAD | CLOCAL;
  line.c_iflag &= ~static_cast<tcflag_t>(IXON | IXOFF | IXANY);
  line.c_cc[VMIN] = 0;
  line.c_cc[VTIME] = 0;
  ::cfsetispeed(&line, speed);
  ::cfsetospeed(&line, speed);
  if (::tcsetattr(descriptor, TCSANOW, &line) != 0) return line_error(doing, node, errno);
  // tcsetattr() succeeds where any of the settings was accepted.
  termios now{};
  if (::tcgetattr(descriptor, &now) != 0) return line_error(doing, node, errno);
  if (::cfgetospeed(&now) != speed)
    return Error{en::say("the serial line does not take {} baud", baud),
                 node,
                 en::say("the speed that the gauge's manual tells")};
  return {};
}

}  // namespace

const std::vector<int>& serial_speeds() {
  static const std::vector<int> speeds = [] {
    std::vector<int> all;
    for (const auto& [baud, code] : speed_codes()) all.push_back(baud);
    return all;
  }();
  return speeds;
}

std::vector<std::filesystem::path> serial_ports() {
  std::vector<std::filesystem::path> ports;
  std::error_code ignored;
  for (const auto& entry : std::filesystem::directory_iterator("/dev/serial/by-id", ignored))
    ports.push_back(entry.path());
  if (ports.empty())
    for (const auto& entry : std::filesystem::directory_iterator("/dev", ignored)) {
      const std::string name = entry.path().filename().string();
      if (name.starts_with("ttyUSB") || name.starts_with("ttyACM")) ports.push_back(entry.path());
    }
  std::sort(ports.begin(), ports.end());
  return ports;
}

Result<SerialPort> SerialPort::open(const std::filesystem::path& node, int baud) {
  const auto speed = speed_codes().find(baud);
  if (speed == speed_codes().end())
    return Error{en::say("{} baud is no speed of a serial line", baud),
                 node,
                 en::say("9600, 19200, 115200 or what the gauge's manual tells")};
  SerialPort port;
  port.node_ = node;
  port.descriptor_ = ::open(node.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
  if (port.descriptor_ < 0)
    return line_error(en::say("the serial line cannot be opened"), node, errno);
  if (Status status = set_up(port.descriptor_, node, speed->second, baud); !status)
    return status.error();
  ::ioctl(port.descriptor_, TIOCEXCL);
  port.discard_input();
  return port;
}

SerialPort::SerialPort(SerialPort&& other) noexcept
    : node_(std::move(other.node_)), descriptor_(std::exchange(other.descriptor_, -1)) {}

SerialPort& SerialPort::operator=(SerialPort&& other) noexcept {
  if (this == &other) return *this;
  close();
  node_ = std::move(other.node_);
  descriptor_ = std::exchange(other.descriptor_, -1);
  return *this;
}

SerialPort::~SerialPort() {
  close();
}

void SerialPort::close() {
  if (descriptor_ < 0) return;
  ::ioctl(descriptor_, TIOCNXCL);
  ::close(descriptor_);
  descriptor_ = -1;
}

Result<std::string> SerialPort::read(int timeout_ms) {
  pollfd waiting{descriptor_, POLLIN, 0};
  const int ready = ::poll(&waiting, 1, timeout_ms);
  if (ready < 0 && errno != EINTR) return line_gone(node_);
  if (ready <= 0) return std::string();
  std::string bytes(4096, '\0');
  const ssize_t size = ::read(descriptor_, bytes.data(), bytes.size());
  if (size < 0 && (errno == EAGAIN || errno == EINTR)) return std::string();
  // A disconnected line is always ready and has no bytes.
  if (size <= 0) return line_gone(node_);
  bytes.resize(static_cast<std::size_t>(size));
  return bytes;
}

Status SerialPort::write(std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t size = ::write(descriptor_, bytes.data(), bytes.size());
    if (size > 0) {
      bytes.remove_prefix(static_cast<std::size_t>(size));
      continue;
    }
    if (size < 0 && errno != EAGAIN && errno != EINTR) return line_gone(node_);
    pollfd waiting{descriptor_, POLLOUT, 0};
    const int ready = ::poll(&waiting, 1, kWriteTimeout_ms);
    if (ready == 0)
      return Error{en::say("the serial line takes nothing"), node_, en::say("check its cable")};
    if (ready < 0 && errno != EINTR) return line_gone(node_);
    if (ready > 0 && (waiting.revents & (POLLERR | POLLHUP)) != 0) return line_gone(node_);
  }
  return {};
}

void SerialPort::discard_input() {
  ::tcflush(descriptor_, TCIFLUSH);
}

}  // namespace alltact
