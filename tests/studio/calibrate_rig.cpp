#include "tests/studio/calibrate_rig.h"

#include "core/io/atomic_file.h"
#include "core/io/picture.h"
#include "core/simulation/plan.h"

namespace alltact::test {
namespace {

void must(const Status& status) {
  if (!status) throw std::runtime_error(status.error().sentence());
}

std::string repeated(const std::vector<double>& values, int times) {
  std::string list;
  for (const double value : values)
    for (int i = 0; i < times; ++i) list += fmt::format("{}{}", list.empty() ? "" : ", ", value);
  return "[" + list + "]";
}

}  // namespace

std::string pressing_scene() {
  std::string scene = small_scene(true);
  const std::string still = "{use: ball, radius_mm: 4.0, s_mm: 46.0, y_mm: 0.0, depth_mm: 0.8}";
  const std::string moving =
      fmt::format("{{use: ball, radius_mm: 4.0, s_mm: {}, y_mm: {}, depth_mm: {}}}",
                  repeated({24, 36, 48, 58, 70, 82}, 15),
                  repeated({-4, 3, 0, -2, 4, 1}, 15),
                  repeated({0.8, 0.5, 1.1, 0.6, 1.0, 0.9}, 15));
  scene.replace(scene.find(still), still.size(), moving);
  const std::string frames = "frames: 60";
  scene.replace(scene.find(frames), frames.size(), "frames: 90");
  return scene;
}

CalibrateStudio::CalibrateStudio(int presses) {
  std::filesystem::copy(
      MadeFingers::get().calibrated(), finger(), std::filesystem::copy_options::recursive);
  auto own = Finger::load(finger()).value();
  own.mapping.reset();
  must(own.save(finger()));
  must(write_file_atomically(folder_ / "pressing.yaml", pressing_scene()));
  if (presses == 0) return;
  const Plan plan = Plan::compile(Scene::load(folder_ / "pressing.yaml").value(), 1).value();
  std::filesystem::create_directories(finger() / "presses");
  for (int i = 0; i < presses; ++i)
    must(write_picture(finger() / "presses" / fmt::format("press_{:02}.png", i + 1),
                       plan.render((15 * i + 7) % 90)));
}

CalibratePlace& CalibrateStudio::place() {
  auto* place = studio_->window().findChild<CalibratePlace*>();
  if (place == nullptr) throw std::runtime_error("no place Calibrate");
  return *place;
}

void CalibrateStudio::open(const std::filesystem::path& command_line) {
  StudioOptions options;
  options.finger = finger();
  options.source = {folder_ / "pressing.yaml"};
  options.session_folder = folder_ / "session";
  options.command_line = command_line;
  studio_ = std::make_unique<Studio>(options);
  ASSERT_TRUE(studio_->wait_for_picture());
  ASSERT_TRUE(wait_until([&] { return studio_->session().status().finger.has_reference; }, 30000));
  QTest::keyClick(&studio_->window(), Qt::Key_2, Qt::ControlModifier);
  ASSERT_TRUE(wait_until([&] { return desk().is_ready(); }, 30000));
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
        const auto& presses = desk().presses();
        return static_cast<int>(presses.size()) == count &&
               std::all_of(presses.begin(), presses.end(), [](const DeskPress& press) {
                 return press.is_looked_at;
               });
      },
      30000);
}

bool CalibrateStudio::wait_for_report() {
  return wait_until([&] { return !run().report().empty(); }, 60000);
}

bool CalibrateStudio::wait_for_press() {
  return wait_until([&] {
    const auto& view = studio_->session().view();
    if (!view) return false;
    const auto patch = dark_patch(view->watched.result);
    if (!patch || patch->darkness < 0.05) return false;
    if (last_along_mm_ && std::abs(patch->place_mm.x() - *last_along_mm_) < 5) return false;
    last_along_mm_ = patch->place_mm.x();
    return true;
  });
}

}  // namespace alltact::test
