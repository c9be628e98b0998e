#include "widgets/calibrating/mapping_page.h"

#include "widgets/calibrating/calibration_run.h"
#include "widgets/language.h"
#include "widgets/report/calibration_figures.h"

#include <QGridLayout>
#include <QHBoxLayout>
#include <QLocale>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

namespace alltact {
namespace {

constexpr int kProgressLines = 2, kTextLines = 1;

}  // namespace

MappingPage::MappingPage(PressCollection& collection, CalibrationRun& run, PressForecast& forecast,
                         QWidget* parent)
    : StepPage(parent),
      collection_(collection),
      run_(run),
      forecast_(forecast),
      calibrate_(new QPushButton),
      compare_(new QPushButton),
      stop_(new QPushButton),
      bar_(new QProgressBar),
      progress_(new ReservedText(kProgressLines)),
      text_(new ReservedText(kTextLines)),
      convergence_(new ConvergencePlot),
      figures_(new QWidget),
      chosen_row_(new QWidget),
      chosen_(wrapped_text()),
      show_press_(new QPushButton),
      leave_out_(new QPushButton),
      drawing_(new FingerDrawing(DrawnThing::kPress)),
      mapping_(new MappingPlot),
      errors_(new PressErrorPlot),
      residual_(new FaceMapPlot),
      sd_(new FaceMapPlot) {
  auto* column = without_margins(new QVBoxLayout(this));
  auto* row = new QHBoxLayout;
  calibrate_->setMinimumWidth(160);
  for (QWidget* shown : std::initializer_list<QWidget*>{compare_, bar_, stop_})
    reserve_room(*shown);
  row->addWidget(calibrate_, 0, Qt::AlignTop);
  row->addWidget(compare_, 0, Qt::AlignTop);
  row->addWidget(bar_, 1, Qt::AlignTop);
  row->addWidget(stop_, 0, Qt::AlignTop);
  row->addWidget(progress_, 2);
  column->addLayout(row);
  column->addWidget(text_);
  auto* chosen = without_margins(new QHBoxLayout(chosen_row_));
  chosen->addWidget(chosen_, 1);
  chosen->addWidget(show_press_);
  chosen->addWidget(leave_out_);
  column->addWidget(chosen_row_);
  auto* figures = without_margins(new QGridLayout(figures_));
  figures->addWidget(mapping_, 0, 0);
  figures->addWidget(errors_, 0, 1);
  figures->addWidget(residual_, 1, 0);
  figures->addWidget(sd_, 1, 1);
  for (int i = 0; i < 2; ++i) {
    figures->setColumnStretch(i, 1);
    figures->setRowStretch(i, 1);
  }
  // Only one of them is visible at a time.
  column->addWidget(convergence_, 1);
  column->addWidget(figures_, 1);
  column->addWidget(drawing_, 1);
  connect(calibrate_, &QPushButton::clicked, &run_, &CalibrationRun::start);
  connect(compare_, &QPushButton::clicked, &run_, &CalibrationRun::compare);
  connect(stop_, &QPushButton::clicked, &run_, &CalibrationRun::stop);
  connect(&run_, &CalibrationRun::changed, this, &MappingPage::show_status);
  connect(&forecast_, &PressForecast::changed, this, [this] {
    show_progress();
    show_figures();
  });
  connect_chosen();
  say([this] {
    show_press_->setText(tr("S&how this press"));
    show_press_->setToolTip(tr("Opens the chosen press on the step Presses"));
    compare_->setText(tr("Compare with other &methods"));
    compare_->setToolTip(
        tr("Calibrates with the same presses by the source paper's method and two others, for the "
           "report"));
    stop_->setText(tr("&Stop"));
    stop_->setToolTip(tr("Retains the best solution so far"));
    bar_->setAccessibleName(tr("Progress of the calibration"));
    drawing_->setAccessibleName(tr("A ball in the layer, seen from its side"));
    drawing_->show_names({tr("Clear silicone"),
                          tr("Untouched face"),
                          {},
                          tr("Depth"),
                          tr("Layer thickness"),
                          tr("Ball"),
                          {}});
    mapping_->setAccessibleName(tr("Depth over brightness difference"));
    errors_->setAccessibleName(tr("Error of every press, worst first"));
    shown_.reset();
    show_status();
  });
}

/// Synchronises the chosen press in all four plots.
void MappingPage::connect_chosen() {
  errors_->enable_choice();
  connect(errors_, &PressErrorPlot::press_chosen, this, &MappingPage::choose);
  connect(errors_, &PressErrorPlot::press_opened, this, &MappingPage::press_requested);
  for (FaceMapPlot* map : {residual_, sd_}) {
    map->enable_choice();
    connect(map, &FaceMapPlot::contact_chosen, this, [this](std::size_t contact) {
      if (!shown_ || contact >= shown_->residuals.size()) return;
      errors_->choose(shown_->residuals[contact].press);
      choose();
    });
  }
  connect(show_press_, &QPushButton::clicked, this,
          [this] { Q_EMIT press_requested(errors_->chosen()); });
  connect(leave_out_, &QPushButton::clicked, this,
          [this] { collection_.toggle_left_out(errors_->chosen()); });
}

void MappingPage::choose() {
  show_plots();
  show_chosen();
}

void MappingPage::show_chosen() {
  chosen_row_->setVisible(figures_->isVisibleTo(this));
  const std::string& name = errors_->chosen();
  const CollectedPress* press = collection_.find(name);
  const bool is_out = collection_.press_set().of(name).excluded.has_value();
  for (QPushButton* button : {show_press_, leave_out_}) {
    button->setVisible(!name.empty());
    button->setEnabled(press != nullptr && collection_.is_ready() && !run_.is_running());
  }
  leave_out_->setText(collection_.toggle_left_out_text(name));
  leave_out_->setToolTip(
      tr("A press that is left out stays stored; the next calibration does not use it"));
  chosen_->setText(name.empty()
                       ? tr("Click a bar or circle to show this press's points and position.")
                   : is_out ? tr("%1 is left out: the next calibration does not use it.")
                                  .arg(QString::fromStdString(name))
                            : tr("%1: its points are marked +, its circle is bold.")
                                  .arg(QString::fromStdString(name)));
}

StepState MappingPage::state() const {
  switch (run_.state()) {
    case CalibrationState::kNone:
      return StepState::kToDo;
    case CalibrationState::kStale:
      return StepState::kOutdated;
    case CalibrationState::kCurrent:
      break;
  }
  return StepState::kDone;
}

QString MappingPage::missing() const {
  if (run_.is_running()) return tr("The calibration is running.");
  return run_.state() == CalibrationState::kNone ? tr("Calibrate first.") : QString();
}

void MappingPage::show_status() {
  const bool is_running = run_.is_running();
  compare_->setVisible(run_.can_compare());
  bar_->setVisible(is_running);
  stop_->setVisible(is_running);
  calibrate_->setEnabled(!is_running && collection_.usable_count() > 0);
  calibrate_->setText(run_.state() == CalibrationState::kNone ? tr("&Calibrate now")
                                                              : tr("&Calibrate again"));
  calibrate_->setToolTip(tr("Computes the mapping from all presses; undo restores the one before"));
  show_progress();
  std::vector<Problem> problems;
  if (run_.problem() && !is_running) problems.push_back(Problem::of(*run_.problem()));
  set_problems(std::move(problems));
  if (is_running) convergence_->set_rounds(run_.rounds());
  show_figures();
  Q_EMIT changed();
}

void MappingPage::show_progress() {
  bar_->setValue(static_cast<int>(100 * run_.work().fraction()));
  QString progress;
  if (run_.is_running()) {
    progress = in_window_language(run_.work().what());
    if (const auto left = run_.work().seconds_left())
      progress += QLatin1Char(' ') +
                  tr("(about %n second(s) left)", nullptr, static_cast<int>(std::ceil(*left)));
  } else if (run_.state() == CalibrationState::kStale) {
    progress = recalibration_reason(run_) + QLatin1Char(' ') + forecast_text(forecast_, run_);
  } else if (run_.state() == CalibrationState::kCurrent && !run_.result()) {
    progress = tr("This finger is calibrated. Calibrate again to show the figures.");
  } else if (run_.state() == CalibrationState::kCurrent) {
    progress = comparison();
  } else if (run_.state() == CalibrationState::kNone) {
    progress = forecast_text(forecast_, run_);
  }
  progress_->setText(progress);
}

/// The comparison with other methods, where it was made.
QString MappingPage::comparison() const {
  const auto& rows = run_.result()->methods;
  const auto paper = std::find_if(rows.begin(), rows.end(), [](const MethodRow& row) {
    return row.method == CalibrationMethod::kPaper;
  });
  if (paper == rows.end()) return {};
  if (!paper->failed.empty())
    return tr(
        "The source paper's method finds no calibration with these presses. The report has "
        "all methods.");
  return tr("Mean residual of the presses: %1 mm, by the source paper's method %2 mm. The report "
            "has all methods.")
      .arg(local_mm(run_.result()->calibration.residual_mm, 3), local_mm(paper->residual_mm, 3));
}

void MappingPage::showEvent(QShowEvent* event) {
  StepPage::showEvent(event);
  forecast_.set_watched(true);
}

void MappingPage::hideEvent(QHideEvent* event) {
  forecast_.set_watched(false);
  StepPage::hideEvent(event);
}

/// Of the calibration in use or, before the first, of the forecast.
void MappingPage::show_figures() {
  const auto& done = run_.result() ? run_.result() : forecast_.result();
  convergence_->setVisible(run_.is_running());
  figures_->setVisible(done != nullptr && !run_.is_running());
  drawing_->setVisible(done == nullptr && !run_.is_running());
  if (done != shown_ || !done) {
    shown_ = done;
    show_text();
  }
  show_chosen();
}

void MappingPage::show_text() {
  if (!shown_) {
    text_->setText(collection_.usable_count() == 0
                       ? tr("From one press on, the program learns from the ball's shape what each "
                            "pixel's darkening means in mm.")
                       : tr("From the ball's shape in all presses, the program learns what each "
                            "pixel's darkening means in mm. It leaves out each press once to test "
                            "how well the others predict it."));
    return;
  }
  const Calibration& calibration = shown_->calibration;
  errors_->set_data(press_errors(calibration));
  show_plots();
  const QString mapping = tr("Mapping: %1.").arg(in_window_language(calibration.degree_choice));
  text_->setText(shown_ == run_.result() ? mapping
                                         : tr("Result with these presses; not in use yet.") +
                                               QLatin1Char(' ') + mapping);
}

/// The plots that highlight the chosen press.
void MappingPage::show_plots() {
  if (!shown_) return;
  const Calibration& calibration = shown_->calibration;
  const FaceKind kind = shown_->finger.face.kind;
  const std::string& chosen = errors_->chosen();
  mapping_->set_data(mapping_figure(calibration, shown_->residuals, chosen));
  residual_->set_data(
      face_figure(FaceQuantity::kResidual, calibration, shown_->residuals, kind, chosen));
  sd_->set_data(face_figure(FaceQuantity::kDepthSd, calibration, shown_->residuals, kind, chosen));
}

}  // namespace alltact
