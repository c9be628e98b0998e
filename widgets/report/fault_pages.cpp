#include "widgets/report/fault_pages.h"

#include "calibration/typical_faults.h"
#include "widgets/report/calibration_figures.h"

#include <QCoreApplication>

namespace alltact {
namespace {

constexpr int kWidth = 270, kHeight = 170;  // px at 96 to the inch
constexpr std::uint64_t kSeed = 1;

QString tr(const char* text) {
  return QCoreApplication::translate("TypicalFaults", text);
}

struct Entry {
  Fault fault;
  bool correct_light;
  QString name, text;
};

std::vector<Entry> catalogue() {
  return {
      {Fault::kNone,
       true,
       tr("No fault"),
       tr("One narrow cloud from zero to the deepest press, on the line.")},
      {Fault::kOtherLight,
       false,
       tr("Other light than when the reference was taken"),
       tr("5 % more light, not corrected for: the cloud lies beside zero, the balls seem less deep "
          "than they are. The program sees it on the untouched face, corrects it, and says so.")},
      {Fault::kAutomaticExposure,
       false,
       tr("Automatic exposure"),
       tr("Another gain in every press, up to 6 %, not corrected for: as many clouds as presses. "
          "The "
          "program sees it on the untouched face, and says so: lock exposure and gain.")},
      {Fault::kMovedCamera,
       false,
       tr("Finger or camera moved after the reference"),
       tr("By 0.45 mm, not corrected for: the light's own pattern moves with it and adds to the "
          "presses, differently at each place. Of a bending finger the program says when the "
          "reference does not hold its pose; a small shift of a flat sensor it cannot tell from "
          "other light.")},
      {Fault::kLooseSkin,
       true,
       tr("Skin that leaves the ball"),
       tr("Crosses far from the line: near the rim the skin no longer follows the ball, and a "
          "bright "
          "swelling or light that shines under the edge shows beside it. Common, and no fault as "
          "long "
          "as the inner points (dots) lie on the line: only they are used.")},
      {Fault::kBallRadius,
       true,
       tr("Wrong radius of the ball"),
       tr("Given 10 % too large: looks as good as it can, with the same errors, and every depth is "
          "9 "
          "% too small. No residual shows a wrong radius. Measure the ball with callipers; a check "
          "with a ball of another size (alltact check --presses) shows it.")},
  };
}

}  // namespace

Status add_typical_faults(Document& document,
                          const QPalette& palette,
                          const QFont& font,
                          const Job& job) {
  document.new_page();
  document.heading(tr("Typical faults, and what they look like"));
  document.paragraph(
      tr("Each picture is a calibration with four presses on a small flat sensor that this program "
         "has just simulated, with this fault and nothing else. Compare the cloud with your own."));
  std::vector<Document::Row> rows;
  for (const Entry& entry : catalogue()) {
    const auto made = simulate_calibration(entry.fault, kSeed, entry.correct_light, job);
    if (!made) return made.error();
    MappingPlot plot;
    plot.setFont(font);
    plot.setPalette(palette);
    MappingPlotData data = mapping_figure(made->calibration, made->residuals);
    data.is_small = true;
    plot.set_data(std::move(data));
    rows.push_back({{QString(), plot.picture({kWidth, kHeight}, 2.0), kWidth},
                    {entry.name + ".\n" + entry.text, {}, 0}});
  }
  document.table({}, rows, {});
  return {};
}

}  // namespace alltact
