// What the window holds in memory with one finger open, while a person goes through all places.
// ALLTACT_SOAK_SECONDS makes it longer, ALLTACT_SOAK_FILE keeps the figures as a table, and
// ALLTACT_SOAK_DEMO names the folder of `alltact demo`, whose finger has a camera's full size.
#include "tests/studio/calibrate_rig.h"
#include "tests/support/process_figures.h"
#include "tests/support/sanitized.h"
#include "widgets/pages/accuracy_page.h"

#include <QFile>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include <gtest/gtest.h>

namespace alltact::test {
namespace {

constexpr double kAllowed_mb = 600;

struct OpenFinger {
  std::filesystem::path folder, recording, images;
};

OpenFinger open_finger_of_run() {
  const char* demo = std::getenv("ALLTACT_SOAK_DEMO");
  if (demo == nullptr)
    return {MadeFingers::get().calibrated(), MadeFingers::get().touched(),
            MadeFingers::get().touched_pictures()};
  const std::filesystem::path folder(demo);
  return {folder / "finger", folder / "finger" / "reference.mkv", folder / "objects"};
}

std::chrono::seconds duration() {
  const char* text = std::getenv("ALLTACT_SOAK_SECONDS");
  return std::chrono::seconds(text == nullptr ? 10 : std::atoi(text));
}

class Walk {
 public:
  Walk(Studio& studio, OpenFinger open) : studio_(studio), open_(std::move(open)) {}

  void once() {
    MainWindow& window = studio_.window();
    window.open_source({open_.recording});
    stay("live", 2000);
    stay("record", 500);
    window.go_to("inspect");
    auto& inspect = *window.findChild<InspectPage*>();
    inspect.open(open_.images);
    ASSERT_TRUE(wait_until([&] { return inspect.inspection().frame() != nullptr; }, 60000));
    stay("inspect", 1500);
    window.go_to("calibrate");
    for (int step = 1; step <= 6; ++step) go_to_step(step);
    stay("accuracy", 500);
  }

 private:
  void stay(const char* place, int time_ms) {
    studio_.window().go_to(place);
    QTest::qWait(time_ms);
    note(place);
  }
  void go_to_step(int step) {
    const QString number = QString::number(step);
    for (auto* button : studio_.window().findChildren<QAbstractButton*>())
      if (button->isVisible() && button->text().startsWith(number)) button->click();
    QTest::qWait(500);
    note("calibrate");
  }
  static void note(const char* place) {
    if (std::getenv("ALLTACT_SOAK_DEMO") == nullptr) return;
    std::printf("[ figures  ] %s: %.0f MB\n", place, resident_mb());
    std::fflush(stdout);
  }

  Studio& studio_;
  OpenFinger open_;
};

TEST(WindowMemory, StaysBelow600MegabytesInAllPlaces) {
  StudioOptions options;
  const OpenFinger open = open_finger_of_run();
  options.finger = open.folder;
  options.opener = &open_source;
  Studio studio(options);
  ASSERT_TRUE(wait_until([&] { return studio.session().status().finger.has_reference; }, 60000));
  Walk walk(studio, open);
  ASSERT_NO_FATAL_FAILURE(walk.once());
  std::vector<ProcessFigures> samples;
  const auto end = std::chrono::steady_clock::now() + duration();
  do {
    ASSERT_NO_FATAL_FAILURE(walk.once());
    samples.push_back(process_figures(studio.folder().path()));
  } while (std::chrono::steady_clock::now() < end || samples.size() < 2);
  keep_figures(samples);
  double most_mb = 0;
  for (const ProcessFigures& one : samples) most_mb = std::max(most_mb, one.resident_mb);
  const double growth_mb = rise_of(samples, &ProcessFigures::resident_mb);
  std::printf("[ figures  ] %zu rounds: at most %.0f MB, grew %.1f MB\n", samples.size(), most_mb,
              growth_mb);
  if (kIsSanitized) return;  // sanitizers keep what was freed
  EXPECT_LT(most_mb, kAllowed_mb);
  if (samples.size() < 20) return;  // the first rounds fill caches
  EXPECT_LT(growth_mb, 20);
}

}  // namespace
}  // namespace alltact::test
