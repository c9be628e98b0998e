#include "widgets/accuracy/more_data_box.h"

#include "widgets/language.h"

#include <QHBoxLayout>
#include <QVBoxLayout>
#include <algorithm>

namespace alltact {
namespace {

std::vector<PressesPoint> points_of(const CalibratingStudy& study) {
  const CalibratingChoice& now = study.rows.front().choice;
  std::vector<PressesPoint> points;
  for (const CalibratingRow& row : study.rows) {
    CalibratingChoice same = row.choice;
    same.presses = now.presses;
    if (!row.painted || !(same == now)) continue;
    PressesPoint point;
    point.presses = row.choice.presses;
    point.median_mm = row.painted->median_mm;
    point.p95_mm = row.painted->p95_mm;
    if (row.real) point.real_median_mm = row.real->depth.median_mm;
    point.is_current = row.choice == now;
    points.push_back(point);
  }
  std::sort(points.begin(), points.end(), [](const PressesPoint& a, const PressesPoint& b) {
    return a.presses < b.presses;
  });
  return points;
}

/// The painted presses depend on the calibration.
bool is_same_calibration(const FingerPtr& a, const FingerPtr& b) {
  if (!a || !b) return a == b;
  const MappingParameters &m = a->mapping->parameters(), &n = b->mapping->parameters();
  return a->folder == b->folder && m.x_max == n.x_max && m.chebyshev == n.chebyshev &&
         m.a_mm == n.a_mm && m.b == n.b;
}

}  // namespace

MoreDataBox::MoreDataBox(QWidget* parent)
    : Translated(parent),
      words_(new QLabel),
      plot_(new PressesPlot),
      start_(new QPushButton),
      bar_(new QProgressBar) {
  words_->setWordWrap(true);
  words_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  plot_->setMinimumHeight(150);
  auto* column = new QVBoxLayout(this);
  column->addWidget(words_);
  column->addWidget(plot_, 1);
  auto* line = new QHBoxLayout;
  line->addWidget(start_);
  line->addWidget(bar_, 1);
  line->addStretch();
  column->addLayout(line);
  connect(start_, &QPushButton::clicked, this, [this] {
    if (work_.is_running())
      work_.stop();
    else
      start();
  });
  connect(&work_, &BackgroundWork::progressed, this, &MoreDataBox::show_state);
  connect(&work_, &BackgroundWork::finished, this, &MoreDataBox::show_state);
  say([this] {
    setTitle(tr("What more would bring"));
    bar_->setAccessibleName(tr("Progress of working it out"));
    show_state();
  });
}

void MoreDataBox::set_finger(const FingerPtr& finger) {
  const FingerPtr calibrated = finger && finger->mapping ? finger : nullptr;
  if (!is_same_calibration(calibrated, finger_)) {
    work_.stop();
    study_.reset();
    problem_.reset();
    plot_->set_points({});
  }
  finger_ = calibrated;
  show_state();
}

void MoreDataBox::start() {
  if (!finger_) return;
  problem_.reset();
  work_.start([this, finger = finger_](const Job& job) -> std::function<void()> {
    CalibratingOptions how;
    how.quick = true;
    auto made = study_calibrating(finger, how, job);
    std::shared_ptr<const CalibratingStudy> study;
    std::optional<Error> problem;
    if (made)
      study = std::make_shared<const CalibratingStudy>(std::move(made).value());
    else if (!job.stop_requested())
      problem = made.error();
    return [this, finger, study, problem] {
      if (!is_same_calibration(finger, finger_)) return;
      study_ = study;
      problem_ = problem;
      plot_->set_points(study ? points_of(*study) : std::vector<PressesPoint>());
      show_state();
    };
  });
  show_state();
}

void MoreDataBox::show_state() {
  const bool is_running = work_.is_running();
  start_->setText(is_running ? tr("Sto&p") : tr("&Work it out"));
  start_->setVisible(!study_);
  bar_->setVisible(is_running);
  bar_->setValue(static_cast<int>(100 * work_.fraction()));
  plot_->setVisible(study_ != nullptr);
  if (problem_) {
    words_->setText(window_sentence(problem_->message()));
    return;
  }
  if (!study_) {
    words_->setText(
        tr("One more press, more pictures of each, one more minute: told by balls "
           "painted into this finger's own pictures, which calibrate it anew."));
    return;
  }
  QStringList lines;
  for (const Message& sentence : benefit_of_more_data(*study_, study_->rows.front().choice))
    lines << window_sentence(sentence);
  if (lines.isEmpty()) lines << tr("Nothing that was tried brings more.");
  words_->setText(lines.join(QLatin1Char('\n')));
}

}  // namespace alltact
