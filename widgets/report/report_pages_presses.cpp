// Report pages: image and figures of each press, and its light.
#include "widgets/number_text.h"
#include "widgets/plots/press_light_plot.h"
#include "widgets/report/press_image.h"
#include "widgets/report/report_pages.h"
#include "widgets/verdict_text.h"

#include <algorithm>
#include <map>

namespace alltact {
namespace {

constexpr int kImageWidth = 132;  // of a press

}  // namespace

QString ReportPages::press_words(const BallFit& ball) const {
  QString words = as_text(ball.press);
  if (calibration_.inputs.press_set.has_other_balls())
    words += "\n" + text("ball %1 mm").arg(ball.radius_mm);
  if (ball.cut_by_edge) words += "\n" + text("cut by the edge");
  if (ball.given_depth)
    words += "\n" + text("measured %1 ± %2 mm deep, the solution has %3 mm")
                        .arg(mm(ball.given_depth->mm),
                             sd_number(ball.given_depth->sd_mm, 3),
                             mm(ball.indentation_mm));
  return words;
}

QString ReportPages::punch_words(const StepFit& step) {
  return as_text(step.press) + "\n" +
         text("a punch with a step of %1 mm, which reads %2 ± %3 mm")
             .arg(mm(step.step_mm), mm(step.estimated_mm), sd_number(step.sd_mm, 3));
}

void ReportPages::add_presses() {
  document_.new_page();
  document_.heading(text("The presses, worst first"));
  std::map<std::string, const TakenPress*> taken;
  for (const TakenPress& press : calibration_.presses) taken[press.name] = &press;
  std::vector<const BallFit*> balls;
  for (const BallFit& ball : calibration_.calibration.balls) balls.push_back(&ball);
  const auto worst = [](const BallFit* ball) { return press_error_mm(*ball).value_or(0.0); };
  std::stable_sort(balls.begin(), balls.end(), [&](const BallFit* a, const BallFit* b) {
    return worst(a) > worst(b);
  });
  const auto camera = Camera::create(calibration_.finger.camera);
  const QSize size = QSize(kImageWidth, kImageWidth * 3 / 4) * kSharpness;
  std::vector<Document::Row> rows;
  for (const BallFit* ball : balls) {
    const auto press = taken.find(ball->press);
    const auto error = press_error_mm(*ball);
    QImage image;
    if (camera && press != taken.end())
      image = press_image(press->second->grey, *camera, *ball, contact_pixels_of(*ball), size);
    rows.push_back(
        {{QString(), image, kImageWidth},
         {press_words(*ball), {}, 0},
         {mm(ball->depth_mm), {}, 0},
         {mm(ball->residual_mm), {}, 0},
         {error ? mm(*error) : text("unknown"), {}, 0},
         {mm(ball->centre_sd_mm.z()), {}, 0},
         {press == taken.end() ? QString() : percent(press->second->sign.light_change), {}, 0}});
  }
  for (const StepFit& step : calibration_.calibration.steps) {
    const auto press = taken.find(step.press);
    if (press == taken.end()) continue;
    rows.push_back({{QString(), full_image(press->second->grey, size), kImageWidth},
                    {punch_words(step), {}, 0},
                    {text("none"), {}, 0},
                    {text("none"), {}, 0},
                    {text("none"), {}, 0},
                    {text("none"), {}, 0},
                    {percent(press->second->sign.light_change), {}, 0}});
  }
  document_.image_table({text("Picture"),
                         text("Press"),
                         text("Depth (mm)"),
                         text("With this press (mm)"),
                         text("Error (mm)"),
                         text("Ball's distance, sd (mm)"),
                         text("Light (%)")},
                        rows,
                        {false, false, true, true, true, true, true});
  document_.paragraph(text(
      "Orange: the outline of the ball as it was found, with its middle. Dashed: what the ball "
      "touches; the dark contact must lie in there, or something else was taken for the ball. "
      "Depth: the deepest point. Error: mapping minus ball inside the contact, on average, with a "
      "mapping made without this press; this is the figure that counts. With this press: the same "
      "with the final mapping, which this press helped to make. Ball's distance, sd: how well the "
      "ball's distance from the camera is known. Light: "
      "how much brighter the untouched face is than in the reference; it should be 0 within 1 %."));
  add_left_out();
}

void ReportPages::add_left_out() {
  std::vector<Document::Row> rows;
  for (const TakenPress& press : calibration_.presses) {
    if (press.left_out.empty()) continue;
    rows.push_back({{QString(),
                     full_image(press.grey, QSize(kImageWidth, kImageWidth * 9 / 16) * kSharpness),
                     kImageWidth},
                    {as_text(press.name), {}, 0},
                    {sentence(press.left_out), {}, 0}});
  }
  QStringList reasons;
  for (const Message& reason : calibration_.calibration.left_out) {
    const bool shown =
        std::any_of(calibration_.presses.begin(), calibration_.presses.end(), [&](const auto& one) {
          return !one.left_out.empty() && reason.english().rfind(one.name + ": ", 0) == 0;
        });
    if (!shown) reasons << sentence(reason);
  }
  if (rows.empty() && reasons.isEmpty()) return;
  document_.new_page();
  document_.heading(text("Presses that were left out"));
  if (!rows.empty()) document_.image_table({text("Picture"), text("Press"), text("Why")}, rows, {});
  if (!reasons.isEmpty()) document_.list(reasons);
}

void ReportPages::add_light() {
  std::vector<PressLight> light;
  for (const TakenPress& press : calibration_.presses)
    if (press.left_out.empty()) light.push_back({press.name, 100 * press.sign.light_change});
  document_.heading(text("Light"));
  PressLightPlot plot;
  apply_style(plot);
  plot.set_data(std::move(light), 100 * kOtherLight);
  add_plot(
      plot,
      190,
      text("How much brighter the untouched face is than in its reference, in the order in which "
           "the presses were given. Good: all near zero. All alike beyond a dashed line: other "
           "light than when the reference was taken. Up and down: automatic exposure, or light "
           "that gets in."));
}

}  // namespace alltact
