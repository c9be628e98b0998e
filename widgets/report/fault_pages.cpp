#include "widgets/report/fault_pages.h"

#include "widgets/plots/press_light_plot.h"
#include "widgets/report/calibration_figures.h"
#include "widgets/report/report_words.h"

#include <cassert>

namespace alltact {
namespace {

constexpr int kWidth = 260, kHeight = 126;  // px at 96 to the inch
constexpr std::uint64_t kSeed = 1;

enum class Shown { kCloud = 1, kLight };

struct Entry {
  Fault fault;
  Shown shown;
  QString name, text;
};

std::vector<Entry> catalogue() {
  return {
      {Fault::kNone,
       Shown::kCloud,
       text("No fault"),
       text("One narrow cloud from zero to the deepest press, on the line.")},
      {Fault::kOtherLight,
       Shown::kLight,
       text("Other light than when the reference was taken"),
       text(
           "Here 5 % more: all bars alike and beyond the dashed lines. The program corrects it and "
           "says so. Left uncorrected, every press would seem less deep.")},
      {Fault::kAutomaticExposure,
       Shown::kLight,
       text("Automatic exposure"),
       text("Here another gain in every press, within 6 %: bars up and down. The program says so: "
            "lock "
            "exposure and gain, shade the finger, press again.")},
      {Fault::kMovedCamera,
       Shown::kCloud,
       text("Finger or camera moved after the reference"),
       text("Here by 0.45 mm. On a flat sensor in even light it does not show. Of a bending finger "
            "the "
            "program says when the reference does not hold the pose of most presses.")},
      {Fault::kLooseSkin,
       Shown::kCloud,
       text("Skin that leaves the ball, light at its edge"),
       text("Crosses away from the line near zero: towards the rim the skin no longer follows the "
            "ball, "
            "and swells brightly beside it. Common, and no fault as long as the dots lie on the "
            "line: "
            "only the inner part is used.")},
      {Fault::kBallRadius,
       Shown::kCloud,
       text("Wrong radius of the ball"),
       text(
           "Here given 10 % too large: it looks as good as no fault, and every depth is 9 % too "
           "small. "
           "No residual shows a wrong radius. Measure the ball with callipers; a check with a ball "
           "of "
           "another size shows it (alltact check --presses --ball-radius-mm).")},
  };
}

QImage image_of(const Entry& entry,
                const SimulatedCalibration& made,
                const QPalette& palette,
                const QFont& font) {
  const auto dressed = [&](Plot& plot) {
    plot.setFont(font);
    plot.setPalette(palette);
    return plot.image({kWidth, kHeight}, 2.0);
  };
  if (entry.shown == Shown::kLight) {
    std::vector<PressLight> light;
    for (const PressSign& sign : made.signs) light.push_back({"", 100 * sign.light_change});
    PressLightPlot plot;
    plot.set_data(std::move(light), 100 * kOtherLight);
    return dressed(plot);
  }
  MappingPlotData data = mapping_figure(made.calibration, made.residuals);
  data.is_small = true;
  MappingPlot plot;
  plot.set_data(std::move(data));
  return dressed(plot);
}

}  // namespace

Result<std::vector<SimulatedCalibration>> simulate_typical_faults(const Job& job) {
  std::vector<SimulatedCalibration> all;
  for (const Entry& entry : catalogue()) {
    auto made = simulate_calibration(entry.fault, kSeed, true, job);
    if (!made) return made.error();
    all.push_back(std::move(*made));
  }
  return all;
}

void add_typical_faults(Document& document,
                        const std::vector<SimulatedCalibration>& faults,
                        const QPalette& palette,
                        const QFont& font) {
  document.new_page();
  document.heading(text("Typical faults, and what they look like"));
  document.paragraph(text(
      "Each picture is a calibration with four presses on a small flat sensor that this program "
      "has just simulated, with this fault and nothing else. Compare them with your own."));
  std::vector<Document::Row> rows;
  const std::vector<Entry> entries = catalogue();
  assert(entries.size() == faults.size());
  for (std::size_t i = 0; i < entries.size(); ++i)
    rows.push_back({{QString(), image_of(entries[i], faults[i], palette, font), kWidth},
                    {entries[i].name + ".\n" + entries[i].text, {}, 0}});
  document.table({}, rows, {});
}

}  // namespace alltact
