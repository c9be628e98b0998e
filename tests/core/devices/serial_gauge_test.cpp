// A gauge on a serial line, played on a pseudo-terminal.
#include "core/devices/open_gauge.h"
#include "tests/rigs/serial_line.h"

#include <atomic>
#include <functional>
#include <thread>

#include <gtest/gtest.h>
#include <termios.h>

namespace alltact {
namespace {

using test::SerialLine;

SerialGaugeOptions on(const SerialLine& line, const char* ask = "") {
  SerialGaugeOptions options;
  options.node = line.node();
  options.baud = 115200;
  options.ask = ask;
  options.ask_every_s = 0.005;
  return options;
}

/// What the gauge tells until there are so many samples, or a few seconds are over.
std::vector<GaugeSample> samples_of(GaugeSource& gauge, std::size_t count,
                                    std::vector<Message>* remarks = nullptr) {
  std::vector<GaugeSample> samples;
  for (int slice = 0; slice < 60 && samples.size() < count; ++slice) {
    const auto news = gauge.read(50);
    EXPECT_TRUE(news) << news.error().sentence();
    if (!news) break;
    samples.insert(samples.end(), news->samples.begin(), news->samples.end());
    if (remarks != nullptr)
      remarks->insert(remarks->end(), news->remarks.begin(), news->remarks.end());
  }
  return samples;
}

std::vector<double> forces_of(const std::vector<GaugeSample>& samples) {
  std::vector<double> forces;
  for (const GaugeSample& sample : samples)
    forces.push_back(sample.has_force ? sample.force_N.x()
                                      : std::numeric_limits<double>::infinity());
  return forces;
}

constexpr double kNone = std::numeric_limits<double>::infinity();

TEST(SerialPort, IsSetUpAs8N1WithoutAnyTranslation) {
  const SerialLine line;
  auto port = SerialPort::open(line.node(), 19200);
  ASSERT_TRUE(port) << port.error().sentence();
  const int other = ::open(line.node().c_str(), O_RDWR | O_NOCTTY | O_CLOEXEC);
  termios settings{};
  if (other >= 0) {  // root may open it although it is taken
    ASSERT_EQ(::tcgetattr(other, &settings), 0);
    EXPECT_EQ(::cfgetospeed(&settings), static_cast<speed_t>(B19200));
    EXPECT_EQ(settings.c_cflag & CSIZE, static_cast<tcflag_t>(CS8));
    EXPECT_EQ(settings.c_cflag & (CSTOPB | PARENB | CRTSCTS), 0U);
    EXPECT_EQ(settings.c_lflag & (ICANON | ECHO | ISIG), 0U);
    EXPECT_EQ(settings.c_iflag & (IXON | IXOFF | ICRNL), 0U);
    EXPECT_EQ(settings.c_oflag & OPOST, 0U);
    ::close(other);
  }
  std::string all;
  for (int c = 0; c < 256; ++c) all += static_cast<char>(c);
  line.say(all);
  std::string heard;
  for (int i = 0; i < 50 && heard.size() < all.size(); ++i) heard += port->read(50).value();
  EXPECT_EQ(heard, all);
  ASSERT_TRUE(port->write("?\r\n"));
  EXPECT_EQ(line.hear(1000), "?\r\n");
}

TEST(SerialPort, WhatIsNoLineIsRefusedWithASentence) {
  EXPECT_NE(SerialPort::open("/dev/ttyNone", 9600).error().sentence().find("no such serial line"),
            std::string::npos);
  EXPECT_NE(SerialPort::open("/dev/null", 9600).error().sentence().find("is not a serial line"),
            std::string::npos);
  const SerialLine line;
  EXPECT_NE(SerialPort::open(line.node(), 9601).error().sentence().find("9601 baud"),
            std::string::npos);
}

TEST(SerialPort, AnUnpluggedLineIsAnError) {
  SerialLine line;
  auto port = SerialPort::open(line.node(), 9600);
  ASSERT_TRUE(port);
  line.unplug();
  const auto bytes = port->read(1000);
  ASSERT_FALSE(bytes);
  EXPECT_NE(bytes.error().sentence().find("is gone"), std::string::npos);
}

TEST(SerialGauge, LinesInPiecesAreReadingsAndTheFirstIsNot) {
  const SerialLine line;
  auto gauge = SerialGauge::open(on(line)).value();
  // The first line has lost its beginning: it was -10.123 N.
  for (const char* piece :
       {"0.123 N\r\n+0.", "2", "50 N", "\r", "\n", "+0.300 N\r\n+0.350 N\r\n-1", ".000 N\n"})
    line.say(piece);
  EXPECT_EQ(forces_of(samples_of(*gauge, 4)), (std::vector<double>{0.25, 0.3, 0.35, -1}));
}

TEST(SerialGauge, TimesAreOfTheLinesBeginningsAndNeverGoBack) {
  const SerialLine line;
  SerialGaugeOptions options = on(line);
  options.baud = 9600;
  auto gauge = SerialGauge::open(options).value();
  line.say("x\n");
  (void)gauge->read(20);
  const double before_s = gauge_clock_s();
  std::string burst;
  for (int i = 0; i < 10; ++i) burst += "1.00" + std::to_string(i) + " N\n";
  line.say(burst);
  const auto samples = samples_of(*gauge, 10);
  ASSERT_EQ(samples.size(), 10U);
  EXPECT_LE(samples.back().time_s, gauge_clock_s());
  EXPECT_GT(samples.front().time_s, before_s - 0.1);
  // 8 bytes of 10 bits at 9600 baud lie between the beginnings of two lines.
  for (std::size_t i = 1; i < samples.size(); ++i)
    EXPECT_GT(samples[i].time_s, samples[i - 1].time_s);
  EXPECT_NEAR(samples[9].time_s - samples[0].time_s, 9 * 8 * 10 / 9600.0, 0.02);
}

TEST(SerialGauge, NoiseAndOverRangeMakeNoForce) {
  const SerialLine line;
  auto gauge = SerialGauge::open(on(line)).value();
  line.say("\x01\xff\x7f\n0.500 N\n\xc3\x28.3 N\n" + std::string(5000, '7') +
           "\nOL\n0.600 N\n0.6+0.700 N\n-----\n0.700 N\n");
  EXPECT_EQ(forces_of(samples_of(*gauge, 5)), (std::vector<double>{0.5, kNone, 0.6, kNone, 0.7}));
}

TEST(SerialGauge, ALineThatLostDigitsIsPassedOver) {
  const SerialLine line;
  auto gauge = SerialGauge::open(on(line)).value();
  // 0.512 lost its last digits; from then on the gauge shows two decimals.
  line.say("\n0.000 N\n0.510 N\n0.511 N\n0.5 N\n0.513 N\n0.51 N\n0.52 N\n0.53 N\n");
  EXPECT_EQ(forces_of(samples_of(*gauge, 5)),
            (std::vector<double>{0.51, 0.511, 0.513, 0.52, 0.53}));
}

/// Answers each question until the line ends.
class Answering {
 public:
  Answering(const SerialLine& line, std::function<std::string(const std::string&)> answer)
      : thread_([&line, answer = std::move(answer), this] {
          while (!is_over_) {
            const std::string asked = line.hear(20);
            if (!asked.empty()) line.say(answer(asked));
          }
        }) {}
  ~Answering() {
    is_over_ = true;
    thread_.join();
  }

 private:
  std::atomic<bool> is_over_{false};
  std::thread thread_;
};

TEST(SerialGauge, AsksAsAMark10IsAsked) {
  const SerialLine line;
  GaugeChoice choice;
  choice.gauge = "serial:" + line.node();
  choice.model = "mark10";
  choice.ask_every_s = 0.005;
  choice.direction = "y";
  const auto opener = gauge_opener(choice);
  ASSERT_TRUE(opener) << opener.error().sentence();
  auto gauge = (*opener)().value();
  int number = 0;
  const Answering answering(line, [number](const std::string& asked) mutable {
    return asked == "?\r\n" ? fmt::format("{:.2f} lbF\r\n", 0.5 * ++number) : "*10\r\n";
  });
  const double before_s = gauge_clock_s();
  const auto samples = samples_of(*gauge, 5);
  ASSERT_EQ(samples.size(), 5U);
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_NEAR(samples[i].force_N.y(), 0.5 * (i + 1.0) * 4.4482216152605, 1e-9);
    EXPECT_EQ(samples[i].force_N.x(), 0);
    EXPECT_GE(samples[i].time_s, before_s);
    EXPECT_NEAR(samples[i].sd_N, 0.01 * 4.4482216152605 / std::sqrt(12.0), 1e-12);
  }
}

TEST(SerialGauge, SautersAnswersEndWithAPause) {
  const SerialLine line;
  GaugeChoice choice;
  choice.gauge = "serial:" + line.node();
  choice.model = "sauter";
  choice.baud = 115200;
  choice.ask_every_s = 0.005;
  auto gauge = (*gauge_opener(choice))().value();
  int number = 0;
  const Answering answering(line, [number](const std::string& asked) mutable {
    return asked == "9" ? fmt::format("{:04}.50", ++number % 2 == 0 ? 7 : 1007) : "?";
  });
  EXPECT_EQ(forces_of(samples_of(*gauge, 4)), (std::vector<double>{7.5, -7.5, 7.5, -7.5}));
}

TEST(SerialGauge, AGaugeThatDoesNotAnswerIsToldOfOnce) {
  const SerialLine line;
  auto gauge = SerialGauge::open(on(line, "D\r")).value();
  std::vector<Message> remarks;
  EXPECT_TRUE(samples_of(*gauge, 1, &remarks).empty());
  ASSERT_EQ(remarks.size(), 1U);
  EXPECT_NE(remarks[0].english().find("does not answer to 'D\\x0d'"), std::string::npos)
      << remarks[0].english();
}

TEST(OpenGauge, WhatDoesNotGoTogetherIsRefused) {
  const auto has = [](const GaugeChoice& choice, const char* words) {
    const auto opener = gauge_opener(choice);
    ASSERT_FALSE(opener) << words;
    EXPECT_NE(opener.error().sentence().find(words), std::string::npos)
        << opener.error().sentence();
  };
  const auto with = [](const std::string& gauge, auto member, const auto& value) {
    GaugeChoice choice;
    choice.gauge = gauge;
    choice.*member = value;
    return choice;
  };
  const std::string serial = "serial:/dev/ttyNone", hid = "hid:1:2";
  has(with("scale", &GaugeChoice::unit, "N"), "'scale' is not a gauge");
  has(with("typed", &GaugeChoice::model, "mark10"), "only to a serial gauge");
  has(with("typed", &GaugeChoice::baud, 9600), "only to a serial gauge");
  has(with("typed", &GaugeChoice::unit, "mm"), "is not a unit of force");
  has(with("typed", &GaugeChoice::direction, "up"), "is not a direction");
  has(with("typed", &GaugeChoice::report, "at=1"), "not a HID device");
  has(with(hid, &GaugeChoice::direction, "x"), "the position of the force");
  has(with(hid, &GaugeChoice::report, "at=x"), "does not describe a gauge's report");
  GaugeChoice choice = with(hid, &GaugeChoice::report, "at=1");
  choice.unit = "g";
  has(choice, "belongs in its report");
  choice.unit = "", choice.direction = "x/y";
  has(choice, "2 directions for 1");
  has(with(serial, &GaugeChoice::model, "balance"), "no gauge 'balance'");
  has(with(serial, &GaugeChoice::ask, "\\q"), "is not a text with");
  const auto absent = gauge_opener(with(serial, &GaugeChoice::unit, "N"));
  ASSERT_TRUE(absent);
  EXPECT_NE((*absent)().error().sentence().find("no such serial line"), std::string::npos);
}

TEST(OpenGauge, QuestionsAreTypedWithBackslashes) {
  EXPECT_EQ(unescaped("?\\r\\n").value(), "?\r\n");
  EXPECT_EQ(unescaped("\\x02D\\\\").value(),
            "\x02"
            "D\\");
  for (const char* bad : {"\\", "\\x", "\\x1", "\\xg0", "a\\t"})
    EXPECT_FALSE(unescaped(bad)) << bad;
}

}  // namespace
}  // namespace alltact
