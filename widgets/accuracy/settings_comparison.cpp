#include "widgets/accuracy/settings_comparison.h"

#include "calibration/live/live_finger.h"
#include "calibration/study/accuracy_study.h"
#include "core/numerics/readable_numbers.h"
#include "widgets/image/overlays.h"
#include "widgets/inspect/inspect_pane.h"
#include "widgets/language.h"

#include <QGridLayout>
#include <QLocale>

namespace alltact {
namespace {

constexpr double kDepthTop_mm = 1.0;

QString millimetres(double mm) { return QLocale().toString(mm, 'f', 4); }

}  // namespace

struct SettingsComparison::Held {
  FingerPtr finger;
  PipelineSettings now, other;
  std::optional<ComparedSettings> pipelines;
};

SettingsComparison::SettingsComparison(LiveSession& session, QWidget* parent)
    : Translated(parent), session_(session), figures_(new QLabel) {
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(0, 4, 0, 0);
  grid->setVerticalSpacing(2);
  const std::array<std::pair<int, int>, kViews> cells{{{0, 0}, {0, 1}, {2, 0}}};
  for (std::size_t i = 0; i < kViews; ++i) {
    captions_[i] = new QLabel;
    captions_[i]->setWordWrap(false);
    captions_[i]->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    views_[i] = new ImageView;
    grid->addWidget(captions_[i], cells[i].first, cells[i].second);
    grid->addWidget(views_[i], cells[i].first + 1, cells[i].second);
  }
  figures_->setWordWrap(true);
  figures_->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
  figures_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  figures_->setMargin(8);
  grid->addWidget(figures_, 3, 1);
  for (const int column : {0, 1}) grid->setColumnStretch(column, 1);
  for (const int row : {1, 3}) grid->setRowStretch(row, 1);
  connect(&session_, &LiveSession::view_ready, this, &SettingsComparison::take_frame);
  connect(&work_, &BackgroundWork::finished, this, &SettingsComparison::take_frame);
  say([this] { name_parts(); });
}

void SettingsComparison::name_parts() {
  views_[kNow]->setAccessibleName(tr("Depth with the setting in use now"));
  views_[kOther]->setAccessibleName(tr("Depth with the chosen setting"));
  views_[kDifference]->setAccessibleName(tr("Difference of the two depths"));
  figures_->setAccessibleName(tr("Both settings in figures"));
  show_views();
}

void SettingsComparison::showEvent(QShowEvent* event) {
  Translated::showEvent(event);
  take_frame();
}

bool SettingsComparison::is_same() const {
  return key_of(now_.settings) == key_of(other_.settings);
}

void SettingsComparison::compare(const FingerPtr& finger, const Settings& now,
                                 const Settings& other) {
  const bool is_new = finger != finger_ || key_of(now.settings) != key_of(now_.settings) ||
                      key_of(other.settings) != key_of(other_.settings);
  finger_ = finger;
  now_ = now;
  other_ = other;
  if (is_new) {
    held_.reset();
    compared_.reset();
    difference_top_mm_ = kMinDifferenceTop_mm;
    problem_.reset();
    last_.reset();
  }
  show_views();
  take_frame();
}

// The newest frame, as soon as the one before is done; none twice.
void SettingsComparison::take_frame() {
  const auto& view = session_.view();
  if (!isVisible() || work_.is_running() || !finger_ || is_same() || problem_) return;
  if (!view || !view->result.frame || view->result.frame == last_) return;
  if (!held_) {
    held_ = std::make_shared<Held>();
    held_->finger = finger_;
    held_->now = now_.settings;
    held_->other = other_.settings;
  }
  last_ = view->result.frame;
  work_.start([this, held = held_, frame = last_](const Job& job) -> std::function<void()> {
    std::optional<Error> problem;
    auto compared = std::make_shared<ComparedFrame>();
    if (!held->pipelines) {
      auto made = ComparedSettings::create(*held->finger, held->now, held->other, job);
      if (made)
        held->pipelines = std::move(*made);
      else
        problem = made.error();
    }
    if (held->pipelines) {
      auto both = (*held->pipelines)(frame);
      if (both)
        *compared = std::move(*both);
      else
        problem = both.error();
    }
    return [this, held, compared, problem] {
      if (held != held_) return;  // the settings have changed in the meantime
      problem_ = problem;
      take(problem ? nullptr : compared);
    };
  });
}

void SettingsComparison::take(const std::shared_ptr<const ComparedFrame>& compared) {
  compared_ = compared;
  // A scale that shrank with every lighter contact could not be compared with the one before.
  if (compared_ && compared_->p95_mm.value_or(0) > 0)
    difference_top_mm_ = std::max(difference_top_mm_, round_step(*compared_->p95_mm));
  show_views();
  Q_EMIT shown();
}

void SettingsComparison::show_message(const QString& message) {
  for (ImageView* view : views_) view->show_message(message);
}

void SettingsComparison::show_view(View view, const FrameResult& result) {
  ImageView& image = *views_[static_cast<std::size_t>(view)];
  std::vector<Overlay> overlays;
  if (result.depth) {
    const PartLayer layer = depth_layer(*result.depth, kDepthTop_mm);
    overlays.push_back(layer_overlay(layer.pixels, layer.at));
    overlays.push_back(colour_bar_overlay(depth_scale(kDepthTop_mm), tr("Depth (mm)")));
  }
  image.show_image(result.grey, std::move(overlays));
}

void SettingsComparison::show_views() {
  captions_[kNow]->setText(tr("In use now: %1").arg(now_.words));
  captions_[kOther]->setText(tr("Chosen: %1").arg(other_.words));
  captions_[kDifference]->setText(tr("Chosen minus in use"));
  for (QLabel* caption : captions_) caption->setToolTip(caption->text());
  figures_->setText(figures());
  if (!finger_ || is_same()) {
    show_message(tr("Choose a setting other than the one in use."));
    return;
  }
  if (problem_) {
    show_message(window_sentence(problem_->message()));
    return;
  }
  if (!compared_) {
    show_message(session_.view() ? tr("Measuring…") : tr("Open a camera or a recording first."));
    return;
  }
  show_view(kNow, compared_->now);
  show_view(kOther, compared_->other);
  if (compared_->difference_mm.empty()) {
    views_[kDifference]->show_message(tr("One setting gives no depth in this image."));
    return;
  }
  const ColourScale scale = difference_scale(difference_top_mm_);
  const FrameResult& full =
      compared_->now.reduced_by <= compared_->other.reduced_by ? compared_->now : compared_->other;
  const cv::Mat layer = height_layer(compared_->difference_mm, scale);
  if (layer.size() == full.grey.size())
    views_[kDifference]->show_image(
        full.grey, {layer_overlay(layer), colour_bar_overlay(scale, tr("Difference (mm)"))});
  else  // both are reduced
    views_[kDifference]->show_image(
        cv::Mat(layer.size(), CV_8UC1, cv::Scalar(0)),
        {layer_overlay(layer), colour_bar_overlay(scale, tr("Difference (mm)"))});
}

QString SettingsComparison::figures() const {
  if (!compared_ || is_same()) return {};
  const auto milliseconds = [](double ms) { return QLocale().toString(ms, 'f', 2); };
  QStringList lines{tr("This image: %1 ms with the setting in use, %2 ms with the chosen one.")
                        .arg(milliseconds(compared_->now_ms), milliseconds(compared_->other_ms))};
  if (compared_->median_mm)
    lines << tr("Where something presses, half of all points differ by less than %1 mm, 95 % by "
                "less than %2 mm.")
                 .arg(millimetres(*compared_->median_mm), millimetres(*compared_->p95_mm));
  else
    lines << tr("No contact: touch the finger to compare depths.");
  return lines.join(QStringLiteral("\n\n"));
}

}  // namespace alltact
