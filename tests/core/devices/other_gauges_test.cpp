// Readings that are typed, readings in HID reports, and the file that keeps readings.
#include "core/base/atomic_file.h"
#include "core/devices/gauge_log.h"
#include "core/devices/gauge_source.h"
#include "core/devices/open_gauge.h"
#include "tests/support/temporary_folder.h"

#include <condition_variable>
#include <deque>
#include <mutex>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

namespace alltact {
namespace {

using testing::HasSubstr;
using HidBytes = std::vector<std::uint8_t>;

/// What a person types, through a pipe.
class Typing {
 public:
  Typing() {
    if (::pipe(ends_) != 0) throw std::runtime_error("no pipe");
  }
  ~Typing() {
    end();
    ::close(ends_[0]);
  }
  Typing(const Typing&) = delete;
  Typing& operator=(const Typing&) = delete;
  [[nodiscard]] int descriptor() const { return ends_[0]; }
  void type(const std::string& text) {
    if (::write(ends_[1], text.data(), text.size()) < 0) throw std::runtime_error("pipe");
  }
  void end() {
    if (ends_[1] >= 0) ::close(ends_[1]);
    ends_[1] = -1;
  }

 private:
  int ends_[2]{-1, -1};
};

GaugeUpdate typed(Typing& typing, TypedGauge& gauge, const std::string& text) {
  typing.type(text);
  return gauge.read(1000).value();
}

TEST(TypedGauge, NumbersHoldFromTheirEnterOn) {
  Typing typing;
  TypedGauge gauge(typing.descriptor(), {}, {});
  const double before_s = gauge_clock_s();
  const GaugeUpdate news = typed(typing, gauge, "1.25\n 0,5 kgf \r\n");
  ASSERT_EQ(news.samples.size(), 2U);
  EXPECT_EQ(news.samples[0].force_N, Eigen::Vector3d(1.25, 0, 0));
  EXPECT_NEAR(news.samples[1].force_N.x(), 4.903325, 1e-12);
  EXPECT_GE(news.samples[0].time_s, before_s);
  EXPECT_GT(news.samples[1].time_s, news.samples[0].time_s);
  EXPECT_LE(news.samples[1].time_s, gauge_clock_s() + 1e-5);
  EXPECT_TRUE(news.samples[0].holds);
  EXPECT_EQ(news.samples[0].block, "typed 1");
  EXPECT_EQ(news.samples[1].block, "typed 2");
  EXPECT_THAT(news.remarks[0].english(), HasSubstr("1.250 0.000 0.000 N"));
}

TEST(TypedGauge, ANumberIsReadOnlyOnceItsLineIsWhole) {
  Typing typing;
  TypedGauge gauge(typing.descriptor(), {}, {});
  EXPECT_TRUE(typed(typing, gauge, "1.").samples.empty());
  const GaugeUpdate news = typed(typing, gauge, "5\n2.5");
  ASSERT_EQ(news.samples.size(), 1U);
  EXPECT_EQ(news.samples[0].force_N.x(), 1.5);
  typing.end();
  const GaugeUpdate last = gauge.read(1000).value();
  EXPECT_TRUE(last.is_over);
  ASSERT_EQ(last.samples.size(), 1U) << "without an Enter at the end of the input";
  EXPECT_EQ(last.samples[0].force_N.x(), 2.5);
}

TEST(TypedGauge, DirectionsBlocksAndReleasesAreTyped) {
  Typing typing;
  TypedGauge gauge(typing.descriptor(), {}, {});
  const GaugeUpdate news =
      typed(typing, gauge, "block first, \"one\"\nindenter ball 6\ny 0.75\n1\n\n-x 2 N\n");
  ASSERT_EQ(news.samples.size(), 4U);
  EXPECT_EQ(news.samples[0].force_N, Eigen::Vector3d(0, 0.75, 0));
  EXPECT_EQ(news.samples[0].block, "first   one") << "fit for a cell";
  EXPECT_EQ(news.samples[0].indenter, "ball 6");
  EXPECT_EQ(news.samples[1].force_N, Eigen::Vector3d(0, 1, 0)) << "the direction lasts";
  EXPECT_FALSE(news.samples[2].has_force);
  EXPECT_EQ(news.samples[3].force_N, Eigen::Vector3d(-2, 0, 0));
  TypedGauge both(typing.descriptor(), {}, {});
  EXPECT_EQ(typed(typing, both, "0.5 -1\n").samples.at(0).force_N, Eigen::Vector3d(0.5, -1, 0));
}

TEST(TypedGauge, WhatIsNoReadingIsSaidAndCostsNothing) {
  Typing typing;
  TypedGauge gauge(typing.descriptor(), {}, {});
  for (const char* bad : {"abc\n", "1.2.3\n", "y\n", "y 1 2\n", "1 2 3 4\n", "\x80\n", "OL\n"}) {
    const GaugeUpdate news = typed(typing, gauge, bad);
    EXPECT_TRUE(news.samples.empty()) << bad;
    ASSERT_EQ(news.remarks.size(), 1U) << bad;
    EXPECT_THAT(news.remarks[0].english(), HasSubstr("is not a reading")) << bad;
  }
  for (const char* doubtful : {"1,200\n", "y 1,200 N\n", "1.200,5\n", "1'200\n"}) {
    const GaugeUpdate news = typed(typing, gauge, doubtful);
    EXPECT_TRUE(news.samples.empty()) << doubtful;
    EXPECT_THAT(news.remarks.at(0).english(), HasSubstr("write 1")) << doubtful;
  }
  EXPECT_EQ(typed(typing, gauge, "3\n").samples.at(0).force_N, Eigen::Vector3d(3, 0, 0))
      << "a direction without a number does not last";
}

GaugeLine read_of(const char* report, const HidBytes& bytes) {
  const auto described = GaugeReport::parse(report);
  EXPECT_TRUE(described) << described.error().sentence();
  return described->read(bytes);
}

TEST(GaugeReport, ValuesStandWhereTheyAreDescribed) {
  EXPECT_NEAR(read_of("id=3 at=1 type=s16 scale=0.01", {3, 0xEE, 0x2E, 0xFB}).force_N[0],
              -12.34,  // 0xFB2E = -1234
              1e-12);
  EXPECT_NEAR(read_of("at=0 type=u24be scale=0.001 unit=kgf", {0x01, 0x00, 0x00}).force_N[0],
              65.536 * 9.80665, 1e-9);
  EXPECT_NEAR(read_of("at=1 type=f32", {9, 0x00, 0x00, 0x20, 0xC0}).force_N[0], -2.5, 1e-12);
  EXPECT_NEAR(read_of("at=0 type=u8 zero=128 scale=0.5", {100}).force_N[0], -14, 1e-12);
  EXPECT_NEAR(read_of("at=0 type=s32 scale=1e-4", {0x18, 0xFC, 0xFF, 0xFF}).force_N[0], -0.1,
              1e-12);
  EXPECT_NEAR(read_of("at=0 type=s24 scale=1", {0xFE, 0xFF, 0xFF}).force_N[0], -2, 1e-12);
  const GaugeLine three =
      read_of("type=s16be scale=0.1 unit=N at=0 at=2 at=4 scale=0.2", {0, 1, 0, 2, 0, 3});
  ASSERT_EQ(three.count, 3);
  EXPECT_NEAR(three.force_N[1], 0.2, 1e-12);
  EXPECT_NEAR(three.force_N[2], 0.6, 1e-12);
  EXPECT_NEAR(three.digit_N[2], 0.2, 1e-12);
}

TEST(GaugeReport, OtherReportsAndTheEndsOfTheRangeAreNoForce) {
  const char* report = "id=3 at=0 type=s16";
  EXPECT_EQ(read_of(report, {4, 1, 0}).kind, GaugeLine::Kind::kNoise);
  EXPECT_EQ(read_of(report, {3, 1}).kind, GaugeLine::Kind::kNoise);
  EXPECT_EQ(read_of(report, {}).kind, GaugeLine::Kind::kNoise);
  EXPECT_EQ(read_of(report, {3, 0xFF, 0x7F}).kind, GaugeLine::Kind::kOverRange);
  EXPECT_EQ(read_of(report, {3, 0x00, 0x80}).kind, GaugeLine::Kind::kOverRange);
  EXPECT_EQ(read_of("at=0 type=u8", {0}).kind, GaugeLine::Kind::kValues) << "no load";
  EXPECT_EQ(read_of("at=0 type=u8", {255}).kind, GaugeLine::Kind::kOverRange);
  EXPECT_EQ(read_of("at=0 type=f32", {0, 0, 0xC0, 0x7F}).kind, GaugeLine::Kind::kOverRange);
  EXPECT_EQ(read_of("at=0 type=u32 scale=1", {1, 0, 0, 0x10}).kind, GaugeLine::Kind::kOverRange)
      << "more than any force";
}

TEST(GaugeReport, NonsenseIsRefused) {
  for (const char* bad :
       {"", "id=3", "at", "at=x", "at=-1", "at=1 type=s17", "at=1 scale=0", "at=1 scale=inf",
        "at=1 unit=mm", "id=256 at=1", "at=4095 type=s16", "at=1 at=2 at=3 at=4", "at=1 speed=3"})
    EXPECT_FALSE(GaugeReport::parse(bad)) << bad;
}

TEST(GaugeReport, ATableDescribesItToo) {
  const test::TemporaryFolder folder;
  const std::string file = (folder / "gauge.csv").string();
  ASSERT_TRUE(write_file_atomically(
      folder / "gauge.csv",
      "# my gauge\nid,at,type,scale,zero,unit\n2,1,s16be,0.01,5,N\n2,3,,0.02,,\n"));
  const auto report = GaugeReport::from(file);
  ASSERT_TRUE(report) << report.error().sentence();
  const GaugeLine line = report->read(HidBytes{2, 0, 0x01, 0x05, 0x00, 0x69});
  ASSERT_EQ(line.count, 2);
  EXPECT_NEAR(line.force_N[0], 2.56, 1e-12);  // (261 - 5) 0.01
  EXPECT_NEAR(line.force_N[1], 2.0, 1e-12);   // (105 - 5) 0.02: zero and type as above
  const auto german = GaugeReport::parse_table("at;type;scale\n1;s16;0,01\n", "gauge.csv");
  ASSERT_TRUE(german) << german.error().sentence();
  EXPECT_EQ(german->values.at(0).scale, 0.01);
  const auto refusal = [](const char* csv) {
    const auto bad = GaugeReport::parse_table(csv, "gauge.csv");
    EXPECT_FALSE(bad) << csv;
    return bad ? std::string() : bad.error().sentence();
  };
  EXPECT_THAT(refusal("at,type\n1,s17\n"), HasSubstr("gauge.csv, line 2"));
  EXPECT_THAT(refusal("at,type\n1\n"), HasSubstr("has 1 cells, not 2"));
  EXPECT_THAT(refusal("type\ns16\n"), HasSubstr("'at' is missing"));
  EXPECT_THAT(refusal("at,colour\n1,red\n"), HasSubstr("'red' is not a valid colour"));
  EXPECT_THAT(refusal("at,type\n"), HasSubstr("does not describe a gauge's report"));
}

/// Reports in their order; then the device is gone.
class ScriptedHid : public HidPort {
 public:
  explicit ScriptedHid(std::deque<HidBytes> reports) : reports_(std::move(reports)) {}
  Result<HidBytes> read(int) override {
    if (reports_.empty())
      return Error{en::say("the device was unplugged"), std::string("scripted"), ""};
    HidBytes report = reports_.front();
    reports_.pop_front();
    return report;
  }
  Status write(std::span<const std::uint8_t>) override { return {}; }
  Status send_feature(std::span<const std::uint8_t>) override { return {}; }

 private:
  std::deque<HidBytes> reports_;
};

TEST(HidGauge, TellsEachReportInItsDirection) {
  const auto report = GaugeReport::parse("id=1 at=0 type=s16 scale=0.1").value();
  HidGauge gauge(std::make_unique<ScriptedHid>(
                     std::deque<HidBytes>{{1, 10, 0}, {2, 99, 0}, {1, 0xFF, 0x7F}, {1, 20, 0}, {}}),
                 report, GaugeDirections::parse("-z").value());
  const GaugeUpdate news = gauge.read(10).value();
  ASSERT_EQ(news.samples.size(), 3U) << "the other report is none";
  EXPECT_TRUE(news.samples[0].force_N.isApprox(Eigen::Vector3d(0, 0, -1), 1e-12));
  EXPECT_NEAR(news.samples[0].sd_N, 0.1 / std::sqrt(12.0), 1e-12);
  EXPECT_FALSE(news.samples[1].has_force);
  EXPECT_TRUE(news.samples[2].force_N.isApprox(Eigen::Vector3d(0, 0, -2), 1e-12));
  EXPECT_GT(news.samples[2].time_s, news.samples[1].time_s);
  EXPECT_FALSE(gauge.read(10)) << "unplugged";
}

/// A gauge that says what a test tells it to.
class SpokenGauge {
 public:
  void say(GaugeSample sample) {
    const std::lock_guard lock(mutex_);
    said_.push_back(std::move(sample));
    changed_.notify_all();
  }
  void say(double time_s, double force_N) {
    GaugeSample sample;
    sample.time_s = time_s, sample.has_force = true, sample.force_N.x() = force_N;
    sample.sd_N = 0.01;
    say(sample);
  }
  void unplug(bool is_gone) {
    const std::lock_guard lock(mutex_);
    is_gone_ = is_gone;
    changed_.notify_all();
  }
  Result<std::unique_ptr<GaugeSource>> open() {
    const std::lock_guard lock(mutex_);
    if (is_gone_) return Error{en::say("there is no such serial line"), std::string("spoken"), ""};
    return std::unique_ptr<GaugeSource>(std::make_unique<Source>(*this));
  }

 private:
  class Source : public GaugeSource {
   public:
    explicit Source(SpokenGauge& gauge) : gauge_(gauge) {}
    Result<GaugeUpdate> read(int timeout_ms) override {
      std::unique_lock lock(gauge_.mutex_);
      gauge_.changed_.wait_for(lock, std::chrono::milliseconds(timeout_ms),
                               [&] { return gauge_.is_gone_ || !gauge_.said_.empty(); });
      if (gauge_.is_gone_)
        return Error{en::say("the serial line is gone"), std::string("spoken"), ""};
      GaugeUpdate news;
      news.samples.assign(gauge_.said_.begin(), gauge_.said_.end());
      gauge_.said_.clear();
      return news;
    }
    [[nodiscard]] int axes() const override { return 1; }

   private:
    SpokenGauge& gauge_;
  };

  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<GaugeSample> said_;
  bool is_gone_ = false;
};

template <class Condition>
bool becomes(const Condition& condition) {
  for (int i = 0; i < 1000 && !condition(); ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  return condition();
}

Frame frame_at(double time_s) {
  Frame frame;
  frame.time_ns = std::llround(1e9 * time_s);
  return frame;
}

TEST(GaugeLog, KeepsReadingsOnTheFramesClock) {
  const test::TemporaryFolder folder;
  SpokenGauge gauge;
  auto log = GaugeLog::start([&] { return gauge.open(); }, "serial:/dev/ttyUSB0").value();
  const double now_s = gauge_clock_s();
  ASSERT_TRUE(log->begin(folder / "press.gauge.csv"));
  gauge.say(now_s, 1.25);
  log->sync_clock(frame_at(now_s - 0.04));  // a camera's frame: this computer's clock
  GaugeSample none;
  none.time_s = now_s + 0.1;
  gauge.say(none);
  GaugeSample held;
  held.time_s = now_s + 0.2, held.has_force = held.holds = true, held.force_N.y() = -2;
  held.block = "typed 1", held.indenter = "ball";
  gauge.say(held);
  const auto text = [&] { return read_file(folder / "press.gauge.csv").value(); };
  const auto lines = [&] {
    const std::string all = text();
    return std::count(all.begin(), all.end(), '\n');
  };
  ASSERT_TRUE(becomes([&] { return lines() == 6; })) << text();
  const auto counts = log->end();
  ASSERT_TRUE(counts);
  EXPECT_EQ(counts->readings, 2U);
  EXPECT_EQ(counts->without_force, 1U);
  EXPECT_EQ(text(), fmt::format("# alltact-gauge/1\n# gauge: serial:/dev/ttyUSB0\n"
                                "t_s,fx_n,fy_n,fz_n,sd_n,holds,block,indenter\n"
                                "{:.6f},1.25,0,0,0.01,0,,\n{:.6f},,,,,0,,\n"
                                "{:.6f},0,-2,0,,1,typed 1,ball\n",
                                now_s, now_s + 0.1, now_s + 0.2));
}

TEST(GaugeLog, OfOtherClocksItFollowsTheFrames) {
  const test::TemporaryFolder folder;
  SpokenGauge gauge;
  auto log = GaugeLog::start([&] { return gauge.open(); }, "typed").value();
  gauge.say(gauge_clock_s(), 1);
  ASSERT_TRUE(log->begin(folder / "a.gauge.csv"));
  const double now_s = gauge_clock_s();
  log->sync_clock(frame_at(-1e6));  // of a simulation
  gauge.say(now_s + 2, 3);
  const auto told = [&] { return read_file(folder / "a.gauge.csv").value(); };
  ASSERT_TRUE(becomes([&] { return told().find(",3,0,0,") != std::string::npos; })) << told();
  ASSERT_TRUE(log->end());
  const std::string text = told();
  const std::size_t at = text.rfind('\n', text.find(",3,0,0,")) + 1;
  EXPECT_NEAR(std::stod(text.substr(at)), -1e6 + 2, 0.2);
}

TEST(GaugeLog, AnUnpluggedGaugeLeavesAGapAndComesBack) {
  const test::TemporaryFolder folder;
  SpokenGauge gauge;
  auto log = GaugeLog::start([&] { return gauge.open(); }, "serial:x").value();
  ASSERT_TRUE(log->begin(folder / "a.gauge.csv"));
  log->sync_clock(frame_at(gauge_clock_s()));
  gauge.say(gauge_clock_s(), 1);
  const auto told = [&] { return read_file(folder / "a.gauge.csv").value(); };
  ASSERT_TRUE(becomes([&] { return told().find(",1,0,0,") != std::string::npos; }));
  gauge.unplug(true);
  ASSERT_TRUE(becomes([&] { return told().find(",,,,,0,,") != std::string::npos; })) << told();
  gauge.unplug(false);
  std::vector<std::string> remarks;
  ASSERT_TRUE(becomes([&] {
    for (const Message& remark : log->take_remarks()) remarks.push_back(remark.english());
    return remarks.size() == 2;
  }));
  EXPECT_THAT(remarks[0], HasSubstr("is gone"));
  EXPECT_THAT(remarks[1], HasSubstr("is back"));
  gauge.say(gauge_clock_s(), 2);
  ASSERT_TRUE(becomes([&] { return told().find(",2,0,0,") != std::string::npos; }));
  EXPECT_TRUE(log->end());
}

TEST(GaugeLog, WhatCannotBeOpenedOrWrittenIsAnError) {
  SpokenGauge gauge;
  gauge.unplug(true);
  EXPECT_FALSE(GaugeLog::start([&] { return gauge.open(); }, "x"));
  gauge.unplug(false);
  auto log = GaugeLog::start([&] { return gauge.open(); }, "x").value();
  EXPECT_FALSE(log->begin("/no/such/folder/a.gauge.csv"));
  EXPECT_EQ(gauge_log_of("a/press-001.mkv"), std::filesystem::path("a/press-001.gauge.csv"));
}

}  // namespace
}  // namespace alltact
