#include "widgets/calibrating/presses_page.h"

#include "calibration/presses/press.h"
#include "core/live/source_runner.h"
#include "widgets/calibrating/calibration_run.h"
#include "widgets/calibrating/press_list.h"
#include "widgets/calibrating/step_page.h"
#include "widgets/image/overlays.h"
#include "widgets/language.h"
#include "widgets/report/calibration_figures.h"
#include "widgets/report/document.h"
#include "widgets/shell/page.h"
#include "widgets/widget_base.h"

#include <QApplication>
#include <QButtonGroup>
#include <QFileDialog>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QMenu>
#include <QPainter>
#include <QPainterPath>
#include <QSettings>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <filesystem>

namespace alltact {
namespace {

constexpr int kPressSideWidth = 268;
constexpr int kForecastLines = 3, kGuideLines = 2, kPressLines = 2;
constexpr int kDetailsWidth_px = 260;
constexpr int kSeries = 6;  // presses

}  // namespace

PressesPage::PressesPage(LiveSession& session, PressCollection& collection,
                         const CalibrationRun& run, PressForecast& forecast, QWidget* parent)
    : StepPage(parent),
      session_(session),
      collection_(collection),
      run_(run),
      forecast_(forecast),
      model_(collection, run),
      count_(new ReservedText),
      forecast_words_(new ReservedText(kForecastLines)),
      list_(new PressListView),
      list_leave_out_(new QAction(list_)),
      list_remove_(new QAction(list_)),
      add_(new QPushButton),
      leave_out_(new QPushButton),
      remove_(new QPushButton),
      live_button_(new QPushButton),
      press_button_(new QPushButton),
      residual_(new QCheckBox),
      views_(new QStackedWidget),
      live_(new ImagePanel(session)),
      editor_(new OutlineEditor),
      fit_pane_(new PressFitPane),
      position_(wrapped_label()),
      take_group_(new QGroupBox),
      press_group_(new QGroupBox),
      radius_label_(new QLabel),
      operator_label_(new QLabel),
      radius_(new NumberField),
      operator_(new QLineEdit),
      form_(new PressForm(collection)),
      more_(new QToolButton),
      take_(new QPushButton),
      find_(new QPushButton),
      automatic_(new QCheckBox),
      guide_(new ReservedText(kGuideLines)),
      take_state_(new ReservedText),
      press_text_(new ReservedText(kPressLines)),
      legend_(wrapped_text()) {
  auto* column = without_margins(new QVBoxLayout(this));
  auto* row = new QHBoxLayout;
  row->addWidget(make_views(), 1);
  row->addWidget(make_side());
  column->addLayout(row, 1);
  new SpaceKey(*this, [this] {
    if (take_->isEnabled()) take();
  });
  connect_parts();
  say([this] { name_parts(); });
}

QWidget* PressesPage::make_views() {
  auto* views = new QWidget;
  auto* column = without_margins(new QVBoxLayout(views));
  auto* edited = new QWidget;
  auto* inside = without_margins(new QVBoxLayout(edited));
  inside->addWidget(editor_, 3);
  position_->setMinimumWidth(1);
  inside->addWidget(position_);
  auto* below = new QHBoxLayout;
  below->addWidget(make_press());
  below->addWidget(fit_pane_, 1);
  inside->addLayout(below, 2);
  views_->addWidget(live_);
  views_->addWidget(edited);
  column->addWidget(views_, 1);
  ViewOptions options;
  options.direction = options.depth = options.markers = false;
  live_->set_options(options);
  live_->set_extra_overlays([this](const LiveView&) { return guide_overlays(guided_); });
  return views;
}

QWidget* PressesPage::make_side() {
  const SidePanel side(kPressSideWidth);
  auto* shown = new QHBoxLayout;
  auto* which = new QButtonGroup(this);
  for (QPushButton* button : {live_button_, press_button_}) {
    button->setCheckable(true);
    which->addButton(button);
    shown->addWidget(button);
  }
  side.column->addLayout(shown);
  make_taking(*side.column);
  make_list(*side.column);
  foot_ = side.foot;
  return side.root;
}

void PressesPage::make_taking(QVBoxLayout& column) {
  radius_->set_quantity(kBallRadius);
  radius_->setMinimum(0);  // 0: unknown
  radius_->set_shown_decimals(3);
  radius_->setSingleStep(0.1);
  radius_label_->setBuddy(radius_);
  operator_label_->setBuddy(operator_);
  add_widgets(column, {take_, take_state_});
  auto* inside = new QVBoxLayout(take_group_);
  add_widgets(*inside, {guide_, automatic_});
  auto* form = new QFormLayout;
  form->addRow(radius_label_, radius_);
  form->addRow(operator_label_, operator_);
  inside->addLayout(form);
  column.addWidget(take_group_);
}

/// Below the press's image, not among the controls that take presses: those stay where they are.
QWidget* PressesPage::make_press() {
  const SidePanel side(kDetailsWidth_px);
  auto* inside = new QVBoxLayout(press_group_);
  inside->addWidget(press_text_);
  inside->addWidget(fit_pane_->words());
  residual_->setChecked(true);
  auto* row = new QHBoxLayout;
  row->addWidget(leave_out_);
  row->addWidget(remove_);
  inside->addLayout(row);
  add_widgets(*inside, {residual_, find_, more_});
  more_->setCheckable(true);
  more_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  inside->addWidget(form_);
  inside->addWidget(legend_);
  side.column->addWidget(press_group_);
  side.column->addStretch();
  return side.root;
}

void PressesPage::make_list(QVBoxLayout& column) {
  list_->setModel(&model_);
  list_->setMinimumHeight(PressListView::kMinHeight_px);
  column.addWidget(count_);
  column.addWidget(forecast_words_);
  column.addWidget(list_, 1);
  column.addWidget(add_);
}

void PressesPage::connect_parts() {
  connect(&collection_, &PressCollection::changed, this, &PressesPage::show_status);
  connect(&collection_, &PressCollection::refused, this, [this](const Problem& problem) {
    refused_ = problem;
    show_problems();
    show_take();
  });
  connect(&run_, &CalibrationRun::changed, this, &PressesPage::show_shown);
  connect(&forecast_, &PressForecast::changed, this, [this] {
    show_shown();
    show_forecast();
  });
  connect(&session_, &LiveSession::view_ready, this, &PressesPage::watch_contact);
  connect(&session_, &LiveSession::status_ready, this, &PressesPage::follow_source);
  connect(live_button_, &QPushButton::clicked, this, [this] { show_press({}); });
  connect(press_button_, &QPushButton::clicked, this,
          [this] { show_press(model_.name_at(std::max(0, list_->currentIndex().row()))); });
  connect(residual_, &QCheckBox::toggled, this, &PressesPage::show_shown);
  connect(editor_, &OutlineEditor::ball_moved, this,
          [this](const Eigen::Vector3d&, const Eigen::Vector3d& after, int grip) {
            collection_.set_ball(shown_, after, grip);
          });
  connect(list_->selectionModel(), &QItemSelectionModel::currentChanged, this,
          [this](const QModelIndex& now) {
            if (now.isValid()) show_press(model_.name_at(now.row()));
          });
  connect(list_, &QListView::clicked, this,
          [this](const QModelIndex& at) { show_press(model_.name_at(at.row())); });
  connect(&model_, &QAbstractItemModel::modelReset, this, &PressesPage::show_list);
  connect(leave_out_, &QPushButton::clicked, this,
          [this] { collection_.toggle_left_out(selected()); });
  connect(remove_, &QPushButton::clicked, this, [this] { collection_.remove(selected()); });
  make_list_actions();
  connect(add_, &QPushButton::clicked, this, &PressesPage::choose_files);
  connect(radius_, &NumberField::valueChanged, this,
          [this](double value) { collection_.set_radius(value); });
  connect(operator_, &QLineEdit::editingFinished, this,
          [this] { collection_.set_operator(operator_->text().trimmed().toStdString()); });
  // The next key must not be typed into the field.
  connect(operator_, &QLineEdit::returnPressed, this, [this] { take_->setFocus(); });
  connect(take_, &QPushButton::clicked, this, &PressesPage::take);
  connect(automatic_, &QCheckBox::toggled, this, [this](bool is_on) {
    QSettings().setValue(kAutomaticKey, is_on);
    begin_series();
    Q_EMIT changed();
  });
  connect(more_, &QToolButton::toggled, this, &PressesPage::show_shown);
  connect(find_, &QPushButton::clicked, this, [this] { collection_.find_ball_again(shown_); });
}

void PressesPage::make_list_actions() {
  list_->setSelectionMode(QAbstractItemView::ExtendedSelection);
  list_->setContextMenuPolicy(Qt::ActionsContextMenu);
  list_remove_->setShortcut(Qt::Key_Delete);
  for (QAction* action : {list_leave_out_, list_remove_}) {
    action->setShortcutContext(Qt::WidgetShortcut);
    list_->addAction(action);
  }
  connect(list_leave_out_, &QAction::triggered, leave_out_, &QPushButton::click);
  connect(list_remove_, &QAction::triggered, remove_, &QPushButton::click);
}

std::vector<std::string> PressesPage::selected() const {
  std::vector<std::string> names;
  for (const QModelIndex& index : list_->selectionModel()->selectedIndexes())
    names.push_back(model_.name_at(index.row()));
  if (names.empty() && !shown_.empty()) names.push_back(shown_);
  return names;
}

void PressesPage::name_parts() {
  list_->setAccessibleName(tr("Presses"));
  add_->setText(tr("&Add images…"));
  add_->setToolTip(tr("Adds stored images of presses; they can be dropped here, too"));
  remove_->setText(tr("Re&move"));
  remove_->setToolTip(tr("Removes the press and its image (undo restores them)"));
  list_remove_->setText(tr("Remove"));
  live_button_->setText(tr("&Live image"));
  live_button_->setToolTip(tr("Shows the camera, for the next press"));
  residual_->setText(tr("&Error under the ball"));
  residual_->setToolTip(
      tr("Shows in colour where the mapping is deeper (red) or shallower (blue) than the ball"));
  take_group_->setTitle(tr("Taking presses"));
  press_group_->setTitle(tr("This press"));
  radius_label_->setText(tr("Ball's &radius"));
  radius_->setAccessibleName(tr("Ball's radius"));
  radius_->setToolTip(tr("Half of the diameter that a caliper or the data sheet gives"));
  radius_->setSuffix(tr(" mm"));
  radius_->setSpecialValueText(tr("unknown"));
  operator_label_->setText(tr("&Operator"));
  operator_->setAccessibleName(tr("Operator"));
  operator_->setToolTip(tr("Your name or initials, stored with the presses"));
  operator_->setPlaceholderText(tr("for the record"));
  take_->setText(tr("&Take a press (Space)"));
  take_->setToolTip(tr("Stores the present image as a press of the ball"));
  guide_->setAccessibleName(tr("Next press position"));
  automatic_->setText(tr("Automat&ically when still"));
  automatic_->setToolTip(
      tr("Takes a press as soon as a contact holds still for half a second; both hands stay free"));
  find_->setText(tr("&Find the ball again"));
  find_->setToolTip(tr("Discards the outline position set by hand"));
  more_->setText(tr("Depth, ball or punch"));
  more_->setToolTip(tr("For a press with another ball, a known depth, or a punch"));
  legend_->setText(
      tr("Yellow: the ball's outline, dashed if found by the program, solid if set by hand. Blue: "
         "where the ball meets the untouched face, roughly the dark disc."));
  position_->setAccessibleName(tr("Position of the ball"));
  take_state_->reserve_for({taken_words(QStringLiteral("press_00"), 1),
                            waiting_words(PressTaker::State::kWaits),
                            waiting_words(PressTaker::State::kRefused)});
  list_->set_empty_text(no_press_text());
  show_status();
}

StepState PressesPage::state() const {
  return missing().isEmpty() ? StepState::kDone : StepState::kToDo;
}

/// None while presses are taken without a click, and until the last of them is there.
const QPushButton* PressesPage::action_button() const {
  const bool is_last_pending = is_series_over_ && taker_.state() != PressTaker::State::kIdle;
  return is_last_pending || (automatic_->isChecked() && has_radius()) ? nullptr : take_;
}

QString PressesPage::missing() const {
  if (run_.state() == CalibrationState::kCurrent) return {};  // there were enough
  if (!collection_.is_ready()) return tr("The presses are being read.");
  if (!(collection_.press_set().ball_radius_mm > 0)) return tr("The ball's radius is missing.");
  if (collection_.presses().empty())
    return tr("Take a press first, best six at different positions.");
  const auto has_ball = [this](const CollectedPress& press) {
    return collection_.is_usable(press) && collection_.has_ball(press);
  };
  if (std::none_of(collection_.presses().begin(), collection_.presses().end(), has_ball))
    return tr("No ball was found in any press yet.");
  return {};
}

void PressesPage::choose_files() {
  auto* dialog = new QFileDialog(this, tr("Images of presses"), QString(), image_filter());
  dialog->setFileMode(QFileDialog::ExistingFiles);
  begin_in_last_folder(*dialog, FilesOf::kImages,
                       QString::fromStdString(collection_.folder().string()));
  connect(dialog, &QFileDialog::filesSelected, this, [this](const QStringList& files) {
    std::vector<std::filesystem::path> inputs;
    for (const QString& file : files) inputs.emplace_back(file.toStdString());
    add_files(inputs);
  });
  show_dialog(*dialog);
}

void PressesPage::add_files(const std::vector<std::filesystem::path>& files) {
  refused_.reset();
  show_problems();
  collection_.add_files(files);
}

bool PressesPage::take_files(const DroppedFiles& dropped) {
  if (!collection_.is_ready() || dropped.kind != FileKind::kImages) return false;
  add_files(dropped.files);
  return true;
}

void PressesPage::show_press(const std::string& name) {
  const bool is_other = name != shown_;
  shown_ = name;
  if (is_other && !name.empty()) editor_->fit();
  show_list();
  show_shown();
}

void PressesPage::show_list() {
  const QSignalBlocker quiet(list_->selectionModel());
  const int row = model_.row_of(shown_);
  const QModelIndex now = row < 0 ? QModelIndex() : model_.index(row);
  if (now != list_->currentIndex()) list_->setCurrentIndex(now);
  if (row < 0) list_->clearSelection();
  list_->viewport()->update();
}

void PressesPage::show_problems() {
  std::vector<Problem> problems;
  if (const auto problem = collection_.problem()) problems.push_back(Problem::of(*problem));
  if (refused_) problems.push_back(*refused_);
  set_problems(std::move(problems));
}

void PressesPage::show_forecast() {
  const QString text = forecast_text(forecast_, run_);
  forecast_words_->setText(text);
}

QString PressesPage::no_press_text() {
  return tr(
      "No press yet. Press the ball in at different positions and depths: base, middle and tip.");
}

void PressesPage::show_status() {
  if (taker_folder_ != collection_.folder()) {
    taker_.forget();
    refused_.reset();
    taken_name_.clear();
    awaits_first_series_ = true;
    const QSignalBlocker quiet(radius_);
    radius_->setValue(0);  // resets also a number typed for another finger
  }
  taker_folder_ = collection_.folder();
  if (awaits_first_series_ && collection_.is_ready()) begin_first_series();
  show_problems();
  const PressSet& press_set = collection_.press_set();
  {
    const QSignalBlocker quiet(radius_);
    radius_->setValue(press_set.ball_radius_mm);
  }
  if (!operator_->hasFocus()) operator_->setText(as_text(press_set.operator_name));
  const int count = static_cast<int>(collection_.presses().size());
  const int usable = collection_.usable_count();
  count_->setText(tr("%n press(es), ", nullptr, count) + tr("%n usable", nullptr, usable));
  radius_->setEnabled(collection_.is_ready());
  operator_->setEnabled(collection_.is_ready());
  add_->setEnabled(collection_.is_ready());
  show_list();
  show_shown();
  show_take();
  show_forecast();
  Q_EMIT changed();
}

namespace {

constexpr double kMinSdMm = 0.001;  // smallest value that the field shows

/// Sets the value without a change signal.
void show_value(NumberField* field, double value) {
  const QSignalBlocker quiet(field);
  field->setValue(value);
}

}  // namespace

PressForm::PressForm(PressCollection& collection, QWidget* parent)
    : Translated(parent),
      collection_(collection),
      radius_label_(new QLabel),
      depth_label_(new QLabel),
      depth_sd_label_(new QLabel),
      step_label_(new QLabel),
      body_label_(new QLabel),
      radius_(new NumberField),
      depth_(new NumberField),
      depth_sd_(new NumberField),
      step_(new NumberField),
      body_(new QPushButton) {
  auto* form = without_margins(new QFormLayout(this));
  const auto add = [form](QLabel* label, NumberField* field, const Quantity& is, double step) {
    field->set_quantity(is);
    field->setMinimum(0);  // 0: unknown
    field->set_shown_decimals(3);
    field->setSingleStep(step);
    label->setBuddy(field);
    form->addRow(label, field);
  };
  add(radius_label_, radius_, kBallRadius, 0.1);
  add(depth_label_, depth_, kPressDepth, 0.1);
  add(depth_sd_label_, depth_sd_, kDepthSd, 0.005);
  depth_sd_->setMinimum(kMinSdMm);
  add(step_label_, step_, kStepHeight, 0.1);
  body_label_->setBuddy(body_);
  form->addRow(body_label_, body_);
  auto* menu = new QMenu(body_);
  choose_mesh_ = menu->addAction(QString(), this, &PressForm::choose_mesh);
  no_mesh_ = menu->addAction(QString(), this, [this] { collection_.set_body_of(shown_, {}); });
  body_->setMenu(menu);
  connect(radius_, &NumberField::valueChanged, this,
          [this](double value) { collection_.set_radius_of(shown_, value); });
  connect(depth_, &NumberField::valueChanged, this, [this](double value) {
    const auto before = collection_.press_set().of(shown_).depth;
    collection_.set_depth_of(shown_, {value, before ? before->sd_mm : kTypicalDepthSdMm});
  });
  connect(depth_sd_, &NumberField::valueChanged, this, [this](double value) {
    if (const auto before = collection_.press_set().of(shown_).depth)
      collection_.set_depth_of(shown_, {before->mm, value});
  });
  connect(step_, &NumberField::valueChanged, this,
          [this](double value) { collection_.set_step_of(shown_, value); });
  say([this] { name_parts(); });
}

void PressForm::name_parts() {
  for (NumberField* field : {radius_, depth_, depth_sd_, step_}) field->setSuffix(tr(" mm"));
  radius_label_->setText(tr("&Its ball"));
  radius_->setAccessibleName(tr("Radius of this press's ball"));
  radius_->setToolTip(tr("If this press was made with a ball of another radius"));
  depth_label_->setText(tr("Measured &depth"));
  depth_->setAccessibleName(tr("Measured depth of this press"));
  depth_->setSpecialValueText(tr("not measured"));
  depth_->setToolTip(
      tr("Indentation depth of the ball from first contact, normal to the face, measured with a "
         "stage or a feeler gauge"));
  depth_sd_label_->setText(tr("&Give or take"));
  depth_sd_->setAccessibleName(tr("Standard deviation of the measured depth"));
  depth_sd_->setToolTip(tr("Uncertainty of the depth: the standard deviation of its measurement"));
  step_label_->setText(tr("&Step of a punch"));
  step_->setAccessibleName(tr("Step of a punch"));
  step_->setSpecialValueText(tr("a ball"));
  step_->setToolTip(
      tr("Step height of a flat punch pressed in instead of a ball; the program then searches for "
         "no ball"));
  body_label_->setText(tr("Another &body"));
  body_->setAccessibleName(tr("Mesh of another body"));
  body_->setToolTip(
      tr("A body of known shape pressed in instead of a ball, such as a rod or a printed part: its "
         "closed mesh, STL or OBJ in mm. The program finds its pose."));
  choose_mesh_->setText(tr("&Choose a mesh…"));
  no_mesh_->setText(tr("A &ball"));
  if (!shown_.empty()) show_press(shown_);
}

void PressForm::choose_mesh() {
  auto* dialog = new QFileDialog(this, tr("Mesh of the body"), QString(),
                                 tr("Meshes (*.stl *.obj *.STL *.OBJ)"));
  dialog->setFileMode(QFileDialog::ExistingFile);
  begin_in_last_folder(*dialog, FilesOf::kMeshes,
                       QString::fromStdString(collection_.folder().string()));
  connect(dialog, &QFileDialog::fileSelected, this, [this, press = shown_](const QString& file) {
    collection_.set_body_of(press, file.toStdString());
  });
  show_dialog(*dialog);
}

void PressForm::show_press(const std::string& name) {
  shown_ = name;
  const PressNote& note = collection_.press_set().of(name);
  const bool is_ball = note.is_ball();
  show_value(radius_, collection_.press_set().radius_of(name));
  show_value(depth_, note.depth ? note.depth->mm : 0.0);
  show_value(depth_sd_, note.depth ? note.depth->sd_mm : kTypicalDepthSdMm);
  show_value(step_, note.step_mm.value_or(0.0));
  const auto enable = [](QLabel* label, NumberField* field, bool is_enabled) {
    label->setEnabled(is_enabled);
    field->setEnabled(is_enabled);
  };
  enable(radius_label_, radius_, is_ball);
  enable(depth_label_, depth_, is_ball);
  enable(depth_sd_label_, depth_sd_, is_ball && note.depth);
  enable(step_label_, step_, note.step_mm || (is_ball && !note.depth));
  body_label_->setEnabled(note.body || (is_ball && !note.depth));
  body_->setEnabled(body_label_->isEnabled());
  body_->setText(note.body ? as_text(std::filesystem::path(*note.body).filename().string())
                           : tr("none"));
  no_mesh_->setEnabled(note.body.has_value());
}

namespace {

constexpr int kOpaque = 170;  // of 255
constexpr int kFitLines = 3;

Overlay squares_overlay(const PressFit& fit) {
  return [fit](QPainter& painter, const ImageTransform& transform) {
    painter.setRenderHint(QPainter::Antialiasing, false);
    const double half = 0.5 * fit.side_px;
    const ColourScale scale = difference_scale(kGoodErrorMm);
    for (const ResidualSample& sample : fit.residuals.samples) {
      if (!(sample.rim <= kInnerRim) || !std::isfinite(sample.residual_mm)) continue;
      const MapColour colour = scale.colour_at(sample.residual_mm);
      const QPointF at(sample.pixel.x(), sample.pixel.y());
      painter.fillRect(QRectF(transform.to_widget(at - QPointF(half, half)),
                              transform.to_widget(at + QPointF(half, half))),
                       QColor(colour.red, colour.green, colour.blue, kOpaque));
    }
  };
}

/// The press took part in the mapping, so this is not its error; see press_error_mm().
QString difference_text(const PressFit& fit) {
  return PressFitPane::tr("%1 mm").arg(local_mm(fit.error_mm, 3));
}

}  // namespace

std::vector<Overlay> residual_overlays(const PressFit& fit) {
  return {squares_overlay(fit), colour_bar_overlay(difference_scale(kGoodErrorMm),
                                                   PressFitPane::tr("Mapping − ball, mm"))};
}

PressFitPane::PressFitPane(QWidget* parent)
    : Translated(parent), plot_(new MappingPlot), words_(new ReservedText(kFitLines)) {
  auto* row = without_margins(new QHBoxLayout(this));
  row->addWidget(plot_, 1);
  words_->setTextFormat(Qt::RichText);
  say([this] { words_->setAccessibleName(tr("Mapping minus ball in this press")); });
}

void PressFitPane::show_fit(const PressFit* fit, const PressFit* before,
                            const Calibration* calibration, const QString& forecast) {
  if (fit == nullptr || calibration == nullptr) {
    plot_->set_data({});
    return words_->clear();
  }
  MappingPlotData data = mapping_figure(*calibration, {fit->residuals});
  data.is_small = true;
  plot_->set_data(std::move(data));
  QStringList lines{tr("<b>Mapping − ball here:</b> %1").arg(difference_text(*fit))};
  if (before != nullptr)
    lines << tr("at the calibrated position: %1").arg(difference_text(*before));
  if (!forecast.isEmpty()) lines << forecast.toHtmlEscaped();
  words_->setText(lines.join(QStringLiteral("<br>")));
}

// View of one press in the step Presses: its image, the ball over it, and its advice.

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
      !collection_.press_set().of(press.name).is_ball() || press.analysis.grey.empty())
    return std::nullopt;
  // No ball was found: an outline in the middle for the user to drag onto it.
  const auto middle =
      press.analysis.shape
          ? press.analysis.shape->at(0.5 * press.analysis.grey.cols, 0.5 * press.analysis.grey.rows)
          : std::nullopt;
  if (!middle) return std::nullopt;
  const double layer_mm = collection_.analyser()->finger().face.layer_mm;
  return ShownBall{
      collection_.analyser()->camera(), radius,
      untouched_point_mm(*middle, layer_mm, MappingAlong::kNormal) + 0.8 * radius * middle->normal,
      false, middle->normal};
}

std::vector<Overlay> PressesPage::overlays_of(const CollectedPress& press) const {
  std::vector<Overlay> overlays;
  if (fit_ && residual_->isChecked()) overlays = residual_overlays(*fit_);
  const auto ball = ball_of(press);
  if (!ball || !press.analysis.shape) return overlays;
  const auto contact = ball_on_face(*press.analysis.shape, collection_.analyser()->finger().face,
                                    ball->centre_mm, ball->radius_mm);
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
    const auto contact = ball_on_face(*press.analysis.shape, collection_.analyser()->finger().face,
                                      ball->centre_mm, ball->radius_mm);
    lines << (contact && contact->depth_mm > 0
                  ? tr("At this position, it is pressed in by %1 mm.")
                        .arg(local_mm(contact->depth_mm, 2))
                  : tr("At this position, it does not touch the face."));
  }
  return lines.join(QLatin1Char('\n'));
}

std::optional<PressFit> PressesPage::fit_at(const CollectedPress& press,
                                            const Eigen::Vector3d& centre_mm) const {
  const FingerCalibration* known = forecast_.baseline();
  if (known == nullptr || !press.analysis.measured || !press.analysis.measured->press)
    return std::nullopt;
  Press measured = *press.analysis.measured->press;  // shares its images
  measured.ball_radius_mm = collection_.press_set().radius_of(press.name);
  return fit_of_press(measured, collection_.analyser()->finger().face, known->calibration.mapping,
                      centre_mm);
}

void PressesPage::show_shown() {
  const CollectedPress* press = collection_.find(shown_);
  if (press == nullptr) shown_.clear();
  live_button_->setChecked(press == nullptr);
  press_button_->setChecked(press != nullptr);
  press_button_->setText(press != nullptr ? as_text(press->name) : tr("Chosen &press"));
  press_button_->setEnabled(!collection_.presses().empty());
  press_button_->setToolTip(tr("Shows the press that is chosen in the list"));
  const bool is_focus_lost =
      press == nullptr && press_group_->isAncestorOf(QApplication::focusWidget());
  views_->setCurrentIndex(press == nullptr ? 0 : 1);
  if (is_focus_lost) Q_EMIT focus_released();
  leave_out_->setEnabled(press != nullptr && collection_.is_ready());
  form_->setEnabled(collection_.is_ready());
  remove_->setEnabled(press != nullptr && press->frame);
  leave_out_->setText(
      collection_.toggle_left_out_text(press != nullptr ? press->name : std::string()));
  list_leave_out_->setText(leave_out_->text());
  list_leave_out_->setEnabled(leave_out_->isEnabled());
  list_remove_->setEnabled(remove_->isEnabled());
  leave_out_->setToolTip(tr("A press that is left out stays with the finger and is not used"));
  if (press == nullptr) {
    fit_.reset();
    editor_->set_ball(std::nullopt);
    return;
  }
  const PressNote& note = collection_.press_set().of(press->name);
  const bool is_measured = note.depth || !note.is_ball() || note.ball_radius_mm;
  find_->setEnabled(note.is_ball() && note.ball_mm.has_value());
  legend_->setVisible(note.is_ball());
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
    editor_->show_message(tr("The image is being read."));
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
  fit_pane_->show_fit(fit_ ? &*fit_ : nullptr, is_by_hand && before ? &*before : nullptr,
                      known != nullptr ? &known->calibration : nullptr,
                      forecast_text(forecast_, run_));
}

void PressesPage::show_position() {
  const auto circle = editor_->ball() ? image_outline(*editor_->ball()) : std::nullopt;
  position_->setText(
      circle
          ? tr("Centre u %1 px, v %2 px, radius %3 px, %4 mm from the camera")
                .arg(local_mm(circle->centre.x(), 1), local_mm(circle->centre.y(), 1),
                     local_mm(circle->radius_px(), 1), local_mm(editor_->ball()->centre_mm.z(), 2))
          : tr("No ball is drawn here."));
}

// Taking presses in the step Presses: by a click, a key, a pedal, or automatically.

QString PressesPage::take_obstacle() const {
  if (!session_.view()) return tr("There is no live image: choose a source.");
  if (!collection_.is_ready()) return tr("The presses are being read.");
  if (!collection_.analyser()) return tr("The finger cannot be compared with its reference.");
  const FramePtr& frame = session_.view()->result.frame;
  if (!frame || session_.view()->problem) return tr("The live image does not match this finger.");
  return {};
}

void PressesPage::take() {
  if (!take_obstacle().isEmpty()) return;
  refused_.reset();
  live_->freeze(false);
  show_press({});
  const auto taken = taker_.request(monotonic_s());
  if (taken) add_taken(*taken);
  follow_source();
  show_problems();
  show_take();
}

void PressesPage::add_taken(const PressTaker::Taken& taken) {
  taken_name_ = collection_.add({taken.frame});
  taken_frames_ = taken.of;
  live_->flash(tr("Press %1").arg(collection_.presses().size()));
  QApplication::beep();
  show_problems();
  show_take();
}

void PressesPage::follow_source() {
  if (session_.status().source.state != SourceState::kEnded) return;
  if (const auto last = taker_.end()) add_taken(*last);
}

double PressesPage::held_part() const {
  return automatic_->isChecked() ? still_.hold().hold_fraction : taker_.held_part();
}

void PressesPage::hideEvent(QHideEvent* event) {
  taker_.forget();
  forecast_.set_watched(false);
  StepPage::hideEvent(event);
}

void PressesPage::showEvent(QShowEvent* event) {
  StepPage::showEvent(event);
  forecast_.set_watched(true);
}

void PressesPage::press_pedal() {
  if (take_->isEnabled()) take();
}

/// Of a finger that is opened. One that is calibrated, or has its presses, is only looked at.
void PressesPage::begin_first_series() {
  awaits_first_series_ = false;
  const bool needs_presses =
      run_.state() == CalibrationState::kNone && collection_.usable_count() < kSeries;
  const QSignalBlocker quiet(automatic_);
  automatic_->setChecked(needs_presses && QSettings().value(kAutomaticKey, true).toBool());
  begin_series();
}

/// A series fills up to six presses; when there are as many, it takes six more.
void PressesPage::begin_series() {
  const int usable = collection_.usable_count();
  series_left_ = usable < kSeries ? kSeries - usable : kSeries;
  is_series_over_ = false;
  still_.begin();
  show_guide();
}

void PressesPage::watch_contact() {
  if (!isVisible()) return;
  const FrameResult& result = session_.view()->result;
  const bool can_take = take_obstacle().isEmpty();
  guided_ = can_take ? guidance_of(result, collection_, forecast_, 0) : PressGuidance();
  // Whoever looks at a press, or drags its outline, is left alone.
  const bool may_take = can_take && automatic_->isChecked() && shown_.empty() && has_radius();
  const bool is_still = may_take && still_.add(guided_.contact, monotonic_s());
  const bool was_pending = taker_.state() != PressTaker::State::kIdle;
  const auto taken =
      taker_.see(can_take ? result.frame : FramePtr(), guided_.contact, monotonic_s());
  guided_.hold_fraction = held_part();
  if (taken)
    add_taken(*taken);
  else if (is_still)
    take_automatically();
  else if (was_pending && taker_.state() == PressTaker::State::kIdle)
    Q_EMIT changed();  // it came to nothing
  show_guide();
}

void PressesPage::take_automatically() {
  take();
  if (--series_left_ > 0) return;
  const QSignalBlocker quiet(automatic_);
  automatic_->setChecked(false);
  is_series_over_ = true;
  Q_EMIT changed();
}

bool PressesPage::has_radius() const { return collection_.press_set().ball_radius_mm > 0; }

QString PressesPage::auto_take_obstacle() const {
  if (is_series_over_) return tr("Six presses are taken. Tick it again to take six more.");
  if (!automatic_->isChecked() || !take_obstacle().isEmpty()) return {};
  if (!has_radius()) return tr("Waiting for the ball's radius.");
  if (!shown_.empty()) return tr("Paused while a press is shown.");
  switch (still_.hold().state) {
    case HoldState::kNothing:
      return is_face_pressed(session_.view()->result)
                 ? tr("Waiting: no contact yet.")
                 : tr("Waiting: it is unknown whether something touches the face.");
    case HoldState::kMoves:
      return tr("Waiting: the contact still moves or gets deeper.");
    case HoldState::kTaken:
      return tr("Taken. For the next one, lift the ball or move it by 2 mm.");
    case HoldState::kHolds:
      break;
  }
  return tr("Holds still.");
}

void PressesPage::show_guide() {
  const bool is_face_seen = guided_.layer_mm > 0;
  guide_->setText(is_face_seen ? guide_words(guided_) : QString());
  show_take();
}

void PressesPage::show_take() {
  const QString obstacle = take_obstacle();
  take_->setEnabled(obstacle.isEmpty());
  const QString waiting = taker_.state() != PressTaker::State::kIdle ? waiting_words(taker_.state())
                                                                     : auto_take_obstacle();
  take_state_->setText(!obstacle.isEmpty()  ? obstacle
                       : !waiting.isEmpty() ? waiting
                                            : taken_words());
}

QString PressesPage::taken_words() const {
  if (collection_.find(taken_name_) == nullptr || !collection_.is_saved(taken_name_)) return {};
  return taken_words(as_text(taken_name_), taken_frames_);
}

QString PressesPage::taken_words(const QString& name, int frames) {
  return frames > 1 ? tr("%1 is taken: the mean of %2 still images.").arg(name).arg(frames)
                    : tr("%1 is a single image: half a second held still would quarter its noise.")
                          .arg(name);
}

}  // namespace alltact
