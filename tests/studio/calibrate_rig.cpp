#include "tests/studio/calibrate_rig.h"

#include "core/base/atomic_file.h"
#include "core/image/image_file.h"
#include "core/simulation/plan.h"

#include <QClipboard>
#include <fstream>
#include <sstream>

namespace alltact::test {
namespace {

constexpr const char* kStillBall =
    "{use: ball, radius_mm: 4.0, s_mm: 46.0, y_mm: 0.0, depth_mm: 0.8}";

void replace_all(std::string& text, const std::string& old, const std::string& now) {
  for (std::size_t at = text.find(old); at != std::string::npos; at = text.find(old, at))
    text.replace(at, old.size(), now);
}

std::string held(std::string scene) {
  replace_all(scene, "-0.3, to: 0.3", "-0.0001, to: 0.0001");
  return scene;
}

std::string repeated(const std::vector<double>& values, int times) {
  std::string list;
  for (const double value : values)
    for (int i = 0; i < times; ++i) list += fmt::format("{}{}", list.empty() ? "" : ", ", value);
  return "[" + list + "]";
}

}  // namespace

std::string pressing_scene(int frames_each) {
  std::string scene = small_scene(true);
  const std::string moving = fmt::format(
      "{{use: ball, radius_mm: 4.0, s_mm: {}, y_mm: {}, depth_mm: {}}}",
      repeated({24, 36, 48, 58, 70, 82}, frames_each), repeated({-4, 3, 0, -2, 4, 1}, frames_each),
      repeated({0.8, 0.5, 1.1, 0.6, 1.0, 0.9}, frames_each));
  replace_all(scene, kStillBall, moving);
  replace_all(scene, "frames: 60", fmt::format("frames: {}", 6 * frames_each));
  return scene;
}

std::string held_pressing_scene(int frames_each) { return held(pressing_scene(frames_each)); }

std::string still_scene() { return held(small_scene(true)); }

bool says(Studio& studio, const char* words) {
  for (const QLabel* label : studio.window().findChildren<QLabel*>())
    if (label->isVisible() && label->text().contains(QString::fromUtf8(words))) return true;
  return false;
}

std::map<std::string, std::string> contents(const std::filesystem::path& folder) {
  std::map<std::string, std::string> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    if (!entry.is_regular_file()) continue;
    std::ifstream stream(entry.path(), std::ios::binary);
    std::ostringstream text;
    text << stream.rdbuf();
    files[std::filesystem::relative(entry.path(), folder).string()] = text.str();
  }
  return files;
}

CalibrateStudio::CalibrateStudio(int presses) {
  std::filesystem::copy(MadeFingers::get().calibrated(), finger(),
                        std::filesystem::copy_options::recursive);
  auto own = Finger::load(finger()).value();
  own.mapping.reset();
  own.mapping_record.reset();
  must(own.save(finger()));
  must(write_file_atomically(folder_ / "pressing.yaml", pressing_scene()));
  if (presses == 0) return;
  std::filesystem::create_directories(finger() / "presses");
  for (int i = 0; i < presses; ++i)
    must(write_image(finger() / "presses" / fmt::format("press_{:02}.png", i + 1),
                     remembered_frame(folder_ / "pressing.yaml", (15 * i + 7) % 90)));
}

CalibratePage& CalibrateStudio::place() {
  auto* place = studio_->window().findChild<CalibratePage*>();
  if (place == nullptr) throw std::runtime_error("no place Calibrate");
  return *place;
}

PressesWhenStill::PressesWhenStill() { QSettings().setValue(PressesPage::kAutomaticKey, true); }

PressesWhenStill::~PressesWhenStill() { QSettings().remove(PressesPage::kAutomaticKey); }

void CalibrateStudio::hold_still() const {
  constexpr int kFramesEach = 40;
  must(write_file_atomically(folder_ / "pressing.yaml", held_pressing_scene(kFramesEach)));
}

bool CalibrateStudio::wait_for_depth() {
  return wait_until([this] {
    const auto& view = studio_->session().view();
    return view && view->result.depth.has_value();
  });
}

void CalibrateStudio::open() {
  StudioOptions options;
  options.finger = finger();
  options.source = {folder_ / "pressing.yaml"};
  options.session_folder = folder_ / "session";
  studio_ = std::make_unique<Studio>(options);
  ASSERT_TRUE(studio_->wait_for_picture());
  ASSERT_TRUE(wait_until([&] { return studio_->session().status().finger.has_reference; }, 30000));
  QTest::keyClick(&studio_->window(), Qt::Key_2, Qt::ControlModifier);
  ASSERT_TRUE(wait_until([&] { return collection().is_ready(); }, 30000));
}

void CalibrateStudio::go_to_step(const QString& title) {
  for (auto* button : place().findChildren<QToolButton*>())
    if (button->isVisible() && (button->text().contains(title + QLatin1Char(':')) ||
                                button->text().startsWith(title + QLatin1Char(' ')))) {
      EXPECT_TRUE(wait_until([&] { return button->isEnabled(); })) << title.toStdString();
      return QTest::mouseClick(button, Qt::LeftButton);
    }
  ADD_FAILURE() << "no step is called " << title.toStdString();
}

void CalibrateStudio::type_radius(const QString& text) {
  auto* radius = studio_->find<QDoubleSpinBox>("Ball's radius");
  ASSERT_NE(radius, nullptr);
  radius->setFocus();
  radius->selectAll();
  QTest::keyClicks(radius, text);
  QTest::keyClick(radius, Qt::Key_Return);
}

bool CalibrateStudio::wait_until_looked_at(int count) {
  return wait_until(
      [&] {
        const auto& presses = collection().presses();
        return static_cast<int>(presses.size()) == count &&
               std::all_of(presses.begin(), presses.end(),
                           [](const CollectedPress& press) { return press.is_analysed; });
      },
      30000);
}

bool CalibrateStudio::wait_for_report() {
  return wait_until([&] { return !run().report().empty(); }, 60000);
}

void CalibrateStudio::add_punch(const std::string& name) {
  cv::Mat relief(180, 240, CV_8UC1, cv::Scalar(0));  // 0.06 mm each
  relief.colRange(0, 120) = 255;
  must(write_image(folder_ / "punch.png", relief));
  std::string scene = still_scene();
  replace_all(scene, kStillBall,
              "{use: relief, shape: picture, file: punch.png, mm_per_px: 0.06, height_mm: 0.5, "
              "s_mm: 26.0, y_mm: 0.0, depth_mm: 1.0}");
  replace_all(scene, "  - {use: rolloff, kind: hertz, length_mm: 0.8}\n", "");
  must(write_file_atomically(folder_ / "punch.yaml", scene));
  const Plan plan = Plan::compile(Scene::load(folder_ / "punch.yaml").value(), 1).value();
  std::filesystem::create_directories(finger() / "presses");
  must(write_image(finger() / "presses" / (name + ".png"), plan.render(0)));
}

std::string CalibrateStudio::calibrate_and_compare_with_the_command() {
  namespace fs = std::filesystem;
  collection().disk()->wait();
  fs::copy(finger(), folder_ / "before", fs::copy_options::recursive);
  studio_->click("Next: Mapping");  // calibrates
  EXPECT_TRUE(wait_until([&] { return run().result() != nullptr; }, 60000)) << studio_->problems();
  EXPECT_TRUE(wait_for_report()) << run().report_problem()->sentence();
  studio_->click("Next: Verdict");
  studio_->click("Copy as command line");
  std::string command = QGuiApplication::clipboard()->text().toStdString();
  const auto by_window = contents(finger());
  close();
  fs::rename(finger(), folder_ / "by_window");
  fs::rename(folder_ / "before", finger());
  EXPECT_EQ(command.rfind("alltact ", 0), 0U);
  const ProgramRun run = run_shell(std::string(ALLTACT_PROGRAM) + command.substr(7));
  EXPECT_EQ(run.status, 0) << run.errors;
  const auto by_command = contents(finger());
  EXPECT_EQ(by_window.size(), by_command.size());
  for (const auto& [name, bytes] : by_window)
    EXPECT_TRUE(by_command.count(name) && by_command.at(name) == bytes) << name;
  return command;
}

bool CalibrateStudio::wait_for_press(double from_mm, double to_mm) {
  return wait_until([&] {
    const auto& view = studio_->session().view();
    if (!view) return false;
    const auto patch = dark_patch(view->result);
    if (!patch || patch->darkness < 0.05) return false;
    const double along_mm = patch->position_mm.x();
    if (along_mm < from_mm || along_mm > to_mm) return false;
    if (last_along_mm_ && std::abs(along_mm - *last_along_mm_) < 5) return false;
    last_along_mm_ = along_mm;
    return true;
  });
}

}  // namespace alltact::test
