// What the step Presses shows of one press: its picture, the ball over it, and what to do with it.
#include "calibration/presses/placed_ball.h"
#include "widgets/calibrating/presses_page.h"
#include "widgets/calibrating/verdict_words.h"
#include "widgets/language.h"
#include "widgets/picture/overlays.h"
#include "widgets/report/report_words.h"

#include <QPainter>
#include <QPainterPath>

namespace alltact {
namespace {

constexpr int kRimPoints = 90;
const QColor kContact(86, 180, 233);  // Okabe and Ito's sky blue

/// Where the ball meets the untouched face: nearly the dark disc that one sees.
Overlay contact_overlay(const std::vector<Eigen::Vector2d>& rim) {
  return [rim](QPainter& painter, const ImageTransform& transform) {
    QPolygonF polygon;
    for (const auto& p : rim) polygon << transform.to_widget({p.x(), p.y()});
    QPainterPath path;
    path.addPolygon(polygon);
    path.closeSubpath();
    stroke_over(painter, path, kContact, 1.4, Qt::DotLine);
  };
}

}  // namespace

std::optional<ShownBall> PressesPage::ball_of(const DeskPress& press) const {
  if (auto known = known_ball(press, desk_, run_)) return known;
  const double radius = desk_.said().radius_of(press.name);
  if (desk_.looker() == nullptr || !(radius > 0) || desk_.said().of(press.name).step_mm ||
      press.looked.grey.empty())
    return std::nullopt;
  // Nothing was found: something to drag onto the ball, where balls mostly are.
  const auto middle = press.looked.shape ? press.looked.shape->at(0.5 * press.looked.grey.cols,
                                                                  0.5 * press.looked.grey.rows)
                                         : std::nullopt;
  if (!middle) return std::nullopt;
  const double layer_mm = desk_.looker()->finger().face.layer_mm;
  return ShownBall{
      desk_.looker()->camera(),
      radius,
      untouched_point_mm(*middle, layer_mm, MappingAlong::kNormal) + 0.8 * radius * middle->normal,
      false,
      middle->normal};
}

std::vector<Overlay> PressesPage::overlays_of(const DeskPress& press) const {
  std::vector<Overlay> overlays;
  if (fit_ && residual_->isChecked()) overlays = residual_overlays(*fit_);
  const auto ball = ball_of(press);
  if (!ball || !press.looked.shape) return overlays;
  const auto contact = ball_on_face(
      *press.looked.shape, desk_.looker()->finger().face, ball->centre_mm, ball->radius_mm);
  if (contact)
    overlays.push_back(contact_overlay(contact_rim_px(ball->camera, *contact, kRimPoints)));
  return overlays;
}

QString PressesPage::advice_for(const DeskPress& press) const {
  QStringList lines{press_state_text(press, desk_, run_)};
  if (press.is_looked_at && press.looked.problem && !desk_.has_ball(press)) {
    const Error& problem = *press.looked.problem;
    lines << window_sentence(problem.what);
    if (!problem.advice.empty()) lines << tr("Try: %1.").arg(in_window_language(problem.advice));
  }
  const auto ball = ball_of(press);
  if (press.is_looked_at && !press.looked.found_mm && !desk_.said().of(press.name).ball_mm && ball)
    lines << tr("Or drag the outline onto the ball.");
  if (ball && desk_.said().of(press.name).ball_mm && press.looked.shape) {
    const auto contact = ball_on_face(
        *press.looked.shape, desk_.looker()->finger().face, ball->centre_mm, ball->radius_mm);
    lines << (contact && contact->depth_mm > 0 ? tr("As it lies now it is pressed in by %1 mm.")
                                                     .arg(local_mm(contact->depth_mm, 2))
                                               : tr("As it lies now it does not touch the face."));
  }
  return lines.join(QLatin1Char('\n'));
}

std::optional<PressFit> PressesPage::fit_at(const DeskPress& press,
                                            const Eigen::Vector3d& centre_mm) const {
  const FingerCalibration* known = forecast_.to_compare_with();
  if (known == nullptr || !press.looked.measured || !press.looked.measured->taken.press)
    return std::nullopt;
  Press measured = *press.looked.measured->taken.press;  // shares its pictures
  measured.ball_radius_mm = desk_.said().radius_of(press.name);
  return fit_of_press(
      measured, desk_.looker()->finger().face, known->calibration.mapping, centre_mm);
}

void PressesPage::show_shown() {
  const DeskPress* press = desk_.find(shown_);
  if (press == nullptr) shown_.clear();
  live_button_->setChecked(press == nullptr);
  press_button_->setChecked(press != nullptr);
  press_button_->setText(press != nullptr ? as_text(press->name) : tr("Chosen &press"));
  press_button_->setEnabled(!desk_.presses().empty());
  pictures_->setCurrentIndex(press == nullptr ? 0 : 1);
  take_group_->setVisible(press == nullptr);
  press_group_->setVisible(press != nullptr);
  residual_->setVisible(press != nullptr);
  out_->setEnabled(press != nullptr && desk_.is_ready());
  form_->setEnabled(desk_.is_ready());
  remove_->setEnabled(press != nullptr && press->frame);
  out_->setText(
      desk_.words_to_take_out_or_put_back(press != nullptr ? press->name : std::string()));
  out_->setToolTip(tr("A press that is taken out stays with the finger and is not used"));
  if (press == nullptr) {
    fit_.reset();
    editor_->set_ball(std::nullopt);
    return;
  }
  const PressNote& note = desk_.said().of(press->name);
  const bool is_measured = note.depth || note.step_mm || note.ball_radius_mm;
  find_->setEnabled(!note.step_mm && note.ball_mm.has_value());
  legend_->setVisible(!note.step_mm);
  more_->setArrowType(more_->isChecked() ? Qt::DownArrow : Qt::RightArrow);
  form_->setVisible(more_->isChecked() || is_measured);
  more_->setVisible(!is_measured);
  form_->show_press(press->name);
  press_text_->setText(advice_for(*press));
  show_picture(*press);
}

void PressesPage::show_picture(const DeskPress& press) {
  if (press.looked.grey.empty()) {
    fit_.reset();
    fit_pane_->show_fit(nullptr, nullptr, nullptr, {});
    editor_->set_ball(std::nullopt);
    editor_->show_message(tr("The picture is being read."));
  } else {
    editor_->set_ball(ball_of(press));
    show_fit(press);
    editor_->show_picture(press.looked.grey, overlays_of(press));
  }
  show_place();
}

std::optional<Eigen::Vector3d> PressesPage::solved_ball(const DeskPress& press) const {
  const FingerCalibration* known = forecast_.to_compare_with();
  if (known == nullptr) return std::nullopt;
  for (const BallFit& ball : known->calibration.balls)
    if (ball.press == press.name) return ball.centre_mm;
  return press.looked.found_mm;
}

void PressesPage::show_fit(const DeskPress& press) {
  // What the program found is where a solution begins; the solution itself is what counts.
  const bool is_by_hand = editor_->ball() && editor_->ball()->is_by_hand;
  const auto solved = desk_.has_ball(press) ? solved_ball(press) : std::nullopt;
  const auto before = solved ? fit_at(press, *solved) : std::nullopt;
  fit_ = is_by_hand ? fit_at(press, editor_->ball()->centre_mm) : before;
  const FingerCalibration* known = forecast_.to_compare_with();
  fit_pane_->show_fit(fit_ ? &*fit_ : nullptr,
                      is_by_hand && before ? &*before : nullptr,
                      known != nullptr ? &known->calibration : nullptr,
                      forecast_text(forecast_, run_));
}

void PressesPage::show_place() {
  const auto place = editor_->ball() ? outline_place(*editor_->ball()) : std::nullopt;
  place_->setText(place ? tr("Centre u %1 px, v %2 px, radius %3 px, %4 mm before the camera")
                              .arg(local_mm(place->centre.x(), 1),
                                   local_mm(place->centre.y(), 1),
                                   local_mm(place->radius_px(), 1),
                                   local_mm(editor_->ball()->centre_mm.z(), 2))
                        : tr("No ball is drawn here."));
}

}  // namespace alltact
