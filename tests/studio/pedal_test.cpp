// A foot pedal that is made up, as the window hears it. Needs umockdev's preload library.
#include "core/open/open_source.h"
#include "tests/rigs/hid_device.h"
#include "tests/studio/calibrate_rig.h"
#include "widgets/shell/settings_dialog.h"

#include <QSettings>
#include <condition_variable>
#include <deque>
#include <thread>

#include <fmt/format.h>
#include <gmock/gmock.h>

namespace alltact::test {
namespace {

using testing::HasSubstr;

constexpr const char* kButton = "0c45:7403/0 4 2:05=05";

class PedalInWindow : public testing::Test {
 protected:
  void SetUp() override {
    if (!qgetenv("LD_PRELOAD").contains("umockdev"))
      GTEST_SKIP() << "needs LD_PRELOAD=libumockdev-preload.so.0";
    plug_in(0);
    set_chosen(kButton);
  }
  void TearDown() override { set_chosen({}); }
  void set_chosen(const QString& button) {
    QSettings().setValue(QStringLiteral("pedal/button"), button);
  }
  void plug_in(int number) {
    if (!bed_) bed_ = std::make_unique<TestBed>();
    number_ = number;
    bed_->add(TestBed::hid(number, "0C45", "7403", "FootSwitch"));
    pedal_ = std::make_unique<HidDevice>(*bed_, number);
  }
  void unplug() {
    pedal_->hang_up();
    pedal_.reset();
    bed_->remove_hid(number_, "0C45", "7403");
  }
  void press() {
    pedal_->say({1, 0, 5, 0});
    pedal_->say({1, 0, 0, 0});
  }
  std::unique_ptr<TestBed> bed_;
  std::unique_ptr<HidDevice> pedal_;
  int number_ = 0;
};

TEST_F(PedalInWindow, StartsAndStopsARecording) {
  Studio studio(simulated());
  ASSERT_TRUE(studio.wait_for_picture());
  studio.window().go_to("record");
  auto* place = studio.window().findChild<RecordPage*>();
  const auto& recording = studio.session().status().recording;
  QTest::qWait(500);  // the device is being opened
  place->set_file(QString::fromStdString((studio.folder() / "a.mkv").string()));
  press();
  ASSERT_TRUE(wait_until([&] { return recording.state == RecordingState::kRunning; }));
  EXPECT_TRUE(wait_until([&] { return recording.counts.recorded > 3; }));
  press();
  ASSERT_TRUE(wait_until([&] { return recording.state == RecordingState::kDone; }));
  EXPECT_TRUE(std::filesystem::exists(studio.folder() / "a.mkv"));
  studio.window().go_to("live");
  press();
  QTest::qWait(300);
  EXPECT_EQ(recording.state, RecordingState::kDone) << "elsewhere it does nothing";
}

TEST_F(PedalInWindow, TakesAPress) {
  CalibrateStudio rig(0);
  rig.open();
  rig.go_to_step("Presses");
  rig.type_radius("4");
  rig.studio().window().open_source({MadeFingers::get().touched()});
  ASSERT_TRUE(rig.studio().wait_for_picture());
  auto* take = rig.studio().find<QPushButton>("Take a press (Space)");
  ASSERT_TRUE(wait_until([&] { return take->isEnabled(); }));
  const std::size_t before = rig.collection().presses().size();
  QTest::qWait(300);
  press();
  ASSERT_TRUE(wait_until([&] { return rig.collection().presses().size() == before + 1; }));
  QTest::qWait(200);
  EXPECT_EQ(rig.collection().presses().size(), before + 1) << "one press, one picture";
}

TEST_F(PedalInWindow, UnpluggedIsSaidAndComingBackIsHeard) {
  Studio studio(simulated());
  ASSERT_TRUE(studio.wait_for_picture());
  studio.window().go_to("record");
  QTest::qWait(500);
  EXPECT_THAT(studio.problems(), testing::Not(HasSubstr("foot pedal")));
  unplug();
  ASSERT_TRUE(wait_until([&] {
    return studio.problems().find("The foot pedal sends no signal now") != std::string::npos;
  }));
  EXPECT_THAT(studio.problems(), HasSubstr("plug it in"));
  plug_in(1);  // another node, the same device
  ASSERT_TRUE(
      wait_until([&] { return studio.problems().find("foot pedal") == std::string::npos; }));
  auto* place = studio.window().findChild<RecordPage*>();
  place->set_file(QString::fromStdString((studio.folder() / "b.mkv").string()));
  press();
  EXPECT_TRUE(wait_until(
      [&] { return studio.session().status().recording.state == RecordingState::kRunning; }));
}

TEST_F(PedalInWindow, IsLearntInTheSettings) {
  set_chosen({});
  Studio studio;
  EXPECT_FALSE(studio.window().pedal().button());
  QTest::keyClick(&studio.window(), Qt::Key_Comma, Qt::ControlModifier);
  auto* dialog = studio.window().findChild<SettingsDialog*>();
  ASSERT_NE(dialog, nullptr);
  const auto button = [&](const char* text) {
    for (QPushButton* one : dialog->findChildren<QPushButton*>())
      if (one->text().remove(QLatin1Char('&')).startsWith(QLatin1String(text))) return one;
    return static_cast<QPushButton*>(nullptr);
  };
  QTest::mouseClick(button("Learn"), Qt::LeftButton);
  EXPECT_NE(button("Stop"), nullptr);
  const auto& pedal = studio.window().pedal();
  ASSERT_TRUE(wait_until(
      [&] { return pedal.learning_text() == QStringLiteral("Press the pedal twice now."); }));
  press();
  press();
  ASSERT_TRUE(wait_until([&] { return pedal.button().has_value(); }));
  EXPECT_EQ(pedal.button()->text(), kButton);
  EXPECT_EQ(QSettings().value(QStringLiteral("pedal/button")).toString(), QLatin1String(kButton));
  int presses = 0;
  QObject::connect(&pedal, &Pedal::pressed, [&] { ++presses; });
  QTest::qWait(500);
  press();
  EXPECT_TRUE(wait_until([&] { return presses == 1; }));
  QTest::mouseClick(button("None"), Qt::LeftButton);
  EXPECT_FALSE(pedal.button());
  press();
  QTest::qWait(300);
  EXPECT_EQ(presses, 1);
  EXPECT_EQ(QSettings().value(QStringLiteral("pedal/button")).toString(), QString());
}

TEST_F(PedalInWindow, ClosingWhileItListensOrLearnsIsQuick) {
  for (const bool learns : {false, true}) {
    auto studio = std::make_unique<Studio>();
    QTest::qWait(300);
    if (learns) studio->window().pedal().learn();
    QTest::qWait(100);
    QElapsedTimer timer;
    timer.start();
    studio.reset();
    EXPECT_LT(timer.elapsed(), 1000);
  }
}

/// A pedal in memory: the made-up node merges presses that follow each other so quickly.
class QuickPedal : public HidPort {
 public:
  struct Said {
    std::mutex mutex;
    std::condition_variable changed;
    std::deque<std::vector<std::uint8_t>> reports;

    void press() {
      const std::lock_guard lock(mutex);
      reports.insert(reports.end(), {{1, 0, 5, 0}, {1, 0, 0, 0}});
      changed.notify_all();
    }
  };
  explicit QuickPedal(Said& said) : said_(said) {}
  Result<std::vector<std::uint8_t>> read(int timeout_ms) override {
    std::unique_lock lock(said_.mutex);
    said_.changed.wait_for(lock, std::chrono::milliseconds(timeout_ms),
                           [&] { return !said_.reports.empty(); });
    if (said_.reports.empty()) return std::vector<std::uint8_t>();
    auto report = std::move(said_.reports.front());
    said_.reports.pop_front();
    return report;
  }
  Status write(std::span<const std::uint8_t>) override { return {}; }
  Status send_feature(std::span<const std::uint8_t>) override { return {}; }

 private:
  Said& said_;
};

/// From the pedal's report through the window to the file: the first press starts a recording, the
/// second ends it, 0 to 10 ms later.
TEST(TwoQuickPresses, AreAStartAndAStop) {
  struct Forgotten {  // the next test has no pedal
    ~Forgotten() { QSettings().remove(QStringLiteral("pedal/button")); }
  } forgotten;
  QuickPedal::Said pedal;
  StudioOptions options = simulated();
  options.pedal.list = [] { return std::vector<FoundHid>(); };
  options.pedal.open = [&](const std::string&) -> Result<std::unique_ptr<HidPort>> {
    return std::unique_ptr<HidPort>(std::make_unique<QuickPedal>(pedal));
  };
  Studio studio(options);
  ASSERT_TRUE(studio.wait_for_picture());
  studio.window().go_to("record");
  studio.window().pedal().listen(LearntButton::parse(kButton).value());
  auto* place = studio.window().findChild<RecordPage*>();
  auto* record = studio.find<QPushButton>("Start recording");
  const auto& recording = studio.session().status().recording;
  int presses = 0;
  QObject::connect(&studio.window().pedal(), &Pedal::pressed, [&] { ++presses; });
  const int orders = is_thorough() ? 1000 : 100;  // a fifth of a second each
  for (int order = 0; order < orders; ++order) {
    const auto file = studio.folder() / fmt::format("p{}.mkv", order);
    place->set_file(QString::fromStdString(file.string()));
    const std::chrono::microseconds between(10000 * order / orders);
    ASSERT_TRUE(wait_until([&] { return record->isEnabled(); }));
    std::jthread foot([&] {
      pedal.press();
      std::this_thread::sleep_for(between);
      pedal.press();
    });
    ASSERT_TRUE(wait_until([&] {
      return presses == 2 * (order + 1) && recording.state == RecordingState::kDone &&
             recording.file == file;
    })) << presses
        << " presses, the second after " << between.count() << " us; state "
        << static_cast<int>(recording.state);
    std::error_code ignored;
    std::filesystem::remove(file, ignored);
  }
}

}  // namespace
}  // namespace alltact::test
