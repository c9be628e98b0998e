// View of one press in the step Presses: its image, the ball over it, and its advice.
#include "calibration/presses/manual_ball.h"
#include "widgets/calibrating/presses_page.h"
#include "widgets/calibrating/verdict_words.h"
#include "widgets/image/overlays.h"
#include "widgets/language.h"
#include "widgets/report/report_words.h"

#include <QPainter>
#include <QPainterPath>

namespace alltact {
namespace {

constexpr int kRimPoints = 90;
const QColor kContact(86, 180, 233);  // Okabe and Ito's sky blue

/// Where the ball meets the undeformed face: nearly the visible dark disc.
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

std::optional<ShownBall> PressesPage::ball_of(const CollectedPress& press) const {
  if (auto known = known_ball(press, collection_, run_)) return known;
  const double radius = collection_.press_set().radius_of(press.name);
  if (collection_.analyser() == nullptr || !(radius > 0) ||
      collection_.press_set().of(press.name).step_mm || press.analysis.grey.empty())
    return std::nullopt;
  // No ball was found: an outline in the middle for the user to drag onto it.
  const auto middle =
      press.analysis.shape
          ? press.analysis.shape->at(0.5 * press.analysis.grey.cols, 0.5 * press.analysis.grey.rows)
          : std::nullopt;
  if (!middle) return std::nullopt;
  const double layer_mm = collection_.analyser()->finger().face.layer_mm;
  return ShownBall{
      collection_.analyser()->camera(),
      radius,
      untouched_point_mm(*middle, layer_mm, MappingAlong::kNormal) + 0.8 * radius * middle->normal,
      false,
      middle->normal};
}

std::vector<Overlay> PressesPage::overlays_of(const CollectedPress& press) const {
  std::vector<Overlay> overlays;
  if (fit_ && residual_->isChecked()) overlays = residual_overlays(*fit_);
  const auto ball = ball_of(press);
  if (!ball || !press.analysis.shape) return overlays;
  const auto contact = ball_on_face(*press.analysis.shape,
                                    collection_.analyser()->finger().face,
                                    ball->centre_mm,
                                    ball->radius_mm);
  if (contact)
    overlays.push_back(contact_overlay(contact_rim_px(ball->camera, *contact, kRimPoints)));
  return overlays;
}

QString PressesPage::advice_for(const CollectedPress& press) const {
  QStringList lines{press_state_text(press, collection_, run_)};
  if (press.is_analysed && press.analysis.problem && !collection_.has_ball(press)) {
    const Error& problem = *press.analysis.problem;
    lines << window_sentence(problem.what);
    if (!problem.advice.empty()) lines << tr("Try: %1.").arg(in_window_language(problem.advice));
  }
  const auto ball = ball_of(press);
  if (press.is_analysed && !press.analysis.found_mm &&
      !collection_.press_set().of(press.name).ball_mm && ball)
    lines << tr("Or drag the outline onto the ball.");
  if (ball && collection_.press_set().of(press.name).ball_mm && press.analysis.shape) {
    const auto contact = ball_on_face(*press.analysis.shape,
                                      collection_.analyser()->finger().face,
                                      ball->centre_mm,
                                      ball->radius_mm);
    lines << (contact && contact->depth_mm > 0 ? tr("As it lies now it is pressed in by %1 mm.")
                                                     .arg(local_mm(contact->depth_mm, 2))
                                               : tr("As it lies now it does not touch the face."));
  }
  return lines.join(QLatin1Char('\n'));
}

std::optional<PressFit> PressesPage::fit_at(const CollectedPress& press,
                                            const Eigen::Vector3d& centre_mm) const {
  const FingerCalibration* known = forecast_.baseline();
  if (known == nullptr || !press.analysis.measured || !press.analysis.measured->taken.press)
    return std::nullopt;
  Press measured = *press.analysis.measured->taken.press;  // shares its images
  measured.ball_radius_mm = collection_.press_set().radius_of(press.name);
  return fit_of_press(
      measured, collection_.analyser()->finger().face, known->calibration.mapping, centre_mm);
}

void PressesPage::show_shown() {
  const CollectedPress* press = collection_.find(shown_);
  if (press == nullptr) shown_.clear();
  live_button_->setChecked(press == nullptr);
  press_button_->setChecked(press != nullptr);
  press_button_->setText(press != nullptr ? as_text(press->name) : tr("Chosen &press"));
  press_button_->setEnabled(!collection_.presses().empty());
  views_->setCurrentIndex(press == nullptr ? 0 : 1);
  take_group_->setVisible(press == nullptr);
  press_group_->setVisible(press != nullptr);
  residual_->setVisible(press != nullptr);
  leave_out_->setEnabled(press != nullptr && collection_.is_ready());
  form_->setEnabled(collection_.is_ready());
  remove_->setEnabled(press != nullptr && press->frame);
  leave_out_->setText(
      collection_.toggle_left_out_text(press != nullptr ? press->name : std::string()));
  leave_out_->setToolTip(tr("A press that is taken out stays with the finger and is not used"));
  if (press == nullptr) {
    fit_.reset();
    editor_->set_ball(std::nullopt);
    return;
  }
  const PressNote& note = collection_.press_set().of(press->name);
  const bool is_measured = note.depth || note.step_mm || note.ball_radius_mm;
  find_->setEnabled(!note.step_mm && note.ball_mm.has_value());
  legend_->setVisible(!note.step_mm);
  more_->setArrowType(more_->isChecked() ? Qt::DownArrow : Qt::RightArrow);
  form_->setVisible(more_->isChecked() || is_measured);
  more_->setVisible(!is_measured);
  form_->show_press(press->name);
  press_text_->setText(advice_for(*press));
  show_press_image(*press);
}

void PressesPage::show_press_image(const CollectedPress& press) {
  if (press.analysis.grey.empty()) {
    fit_.reset();
    fit_pane_->show_fit(nullptr, nullptr, nullptr, {});
    editor_->set_ball(std::nullopt);
    editor_->show_message(tr("The picture is being read."));
  } else {
    editor_->set_ball(ball_of(press));
    show_fit(press);
    editor_->show_image(press.analysis.grey, overlays_of(press));
  }
  show_position();
}

std::optional<Eigen::Vector3d> PressesPage::solved_ball(const CollectedPress& press) const {
  const FingerCalibration* known = forecast_.baseline();
  if (known == nullptr) return std::nullopt;
  for (const BallFit& ball : known->calibration.balls)
    if (ball.press == press.name) return ball.centre_mm;
  return press.analysis.found_mm;
}

void PressesPage::show_fit(const CollectedPress& press) {
  // The detected ball is only a start value; the solved position is what counts.
  const bool is_by_hand = editor_->ball() && editor_->ball()->is_by_hand;
  const auto solved = collection_.has_ball(press) ? solved_ball(press) : std::nullopt;
  const auto before = solved ? fit_at(press, *solved) : std::nullopt;
  fit_ = is_by_hand ? fit_at(press, editor_->ball()->centre_mm) : before;
  const FingerCalibration* known = forecast_.baseline();
  fit_pane_->show_fit(fit_ ? &*fit_ : nullptr,
                      is_by_hand && before ? &*before : nullptr,
                      known != nullptr ? &known->calibration : nullptr,
                      forecast_text(forecast_, run_));
}

void PressesPage::show_position() {
  const auto circle = editor_->ball() ? image_outline(*editor_->ball()) : std::nullopt;
  position_->setText(circle ? tr("Centre u %1 px, v %2 px, radius %3 px, %4 mm before the camera")
                                  .arg(local_mm(circle->centre.x(), 1),
                                       local_mm(circle->centre.y(), 1),
                                       local_mm(circle->radius_px(), 1),
                                       local_mm(editor_->ball()->centre_mm.z(), 2))
                            : tr("No ball is drawn here."));
}

}  // namespace alltact
