#include "widgets/calibrating/presses_page.h"

#include "widgets/calibrating/space_key.h"
#include "widgets/calibrating/verdict_words.h"
#include "widgets/panels/side_panel.h"
#include "widgets/report/report_words.h"

#include <QButtonGroup>
#include <QFileDialog>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QVBoxLayout>

namespace alltact {
namespace {

constexpr int kPressSideWidth = 268;
constexpr int kMinListHeight = 150;

}  // namespace

PressesPage::PressesPage(LiveSession& session,
                         PressCollection& collection,
                         const CalibrationRun& run,
                         PressForecast& forecast,
                         QWidget* parent)
    : StepPage(parent),
      session_(session),
      collection_(collection),
      run_(run),
      forecast_(forecast),
      model_(collection, run),
      problems_(new ProblemList),
      count_(wrapped_text()),
      forecast_words_(wrapped_text()),
      list_(new PressListView),
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
      position_(new QLabel),
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
      take_reason_(wrapped_text()),
      guide_(wrapped_text()),
      waiting_reason_(wrapped_text()),
      taken_(wrapped_text()),
      press_text_(wrapped_text()),
      legend_(wrapped_text()) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(problems_);
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
  auto* column = new QVBoxLayout(views);
  column->setContentsMargins(0, 0, 0, 0);
  auto* edited = new QWidget;
  auto* inside = new QVBoxLayout(edited);
  inside->setContentsMargins(0, 0, 0, 0);
  inside->addWidget(editor_, 3);
  position_->setMinimumWidth(1);
  position_->setWordWrap(true);
  inside->addWidget(position_);
  inside->addWidget(fit_pane_, 2);
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
  make_press(*side.column);
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
  column.addWidget(take_);
  column.addWidget(take_reason_);
  column.addWidget(taken_);
  auto* inside = new QVBoxLayout(take_group_);
  inside->addWidget(guide_);
  inside->addWidget(automatic_);
  inside->addWidget(waiting_reason_);
  auto* form = new QFormLayout;
  form->addRow(radius_label_, radius_);
  form->addRow(operator_label_, operator_);
  inside->addLayout(form);
  column.addWidget(take_group_);
}

void PressesPage::make_press(QVBoxLayout& column) {
  auto* inside = new QVBoxLayout(press_group_);
  inside->addWidget(press_text_);
  inside->addWidget(fit_pane_->words());
  residual_->setChecked(true);
  inside->addWidget(residual_);
  inside->addWidget(find_);
  inside->addWidget(more_);
  more_->setCheckable(true);
  more_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  inside->addWidget(form_);
  inside->addWidget(legend_);
  column.addWidget(press_group_);
}

void PressesPage::make_list(QVBoxLayout& column) {
  list_->setModel(&model_);
  list_->setMinimumHeight(kMinListHeight);
  column.addWidget(count_);
  column.addWidget(forecast_words_);
  column.addWidget(list_, 1);
  auto* row = new QHBoxLayout;
  row->addWidget(leave_out_);
  row->addWidget(remove_);
  column.addLayout(row);
  column.addWidget(add_);
}

void PressesPage::connect_parts() {
  connect(&collection_, &PressCollection::changed, this, &PressesPage::show_status);
  connect(&collection_, &PressCollection::refused, this, [this](const Problem& problem) {
    refused_ = problem;
    show_problems();
    show_taken();
  });
  connect(&run_, &CalibrationRun::changed, this, &PressesPage::show_shown);
  connect(&forecast_, &PressForecast::changed, this, [this] {
    show_shown();
    show_forecast();
  });
  connect(&session_, &LiveSession::view_ready, this, &PressesPage::watch_contact);
  connect(&session_, &LiveSession::status_ready, this, &PressesPage::follow_source);
  connect(live_button_, &QPushButton::clicked, this, [this] { show_press({}); });
  connect(press_button_, &QPushButton::clicked, this, [this] {
    show_press(model_.name_at(std::max(0, list_->currentIndex().row())));
  });
  connect(residual_, &QCheckBox::toggled, this, &PressesPage::show_shown);
  connect(editor_,
          &OutlineEditor::ball_moved,
          this,
          [this](const Eigen::Vector3d&, const Eigen::Vector3d& after, int grip) {
            collection_.set_ball(shown_, after, grip);
          });
  connect(list_->selectionModel(),
          &QItemSelectionModel::currentChanged,
          this,
          [this](const QModelIndex& now) {
            if (now.isValid()) show_press(model_.name_at(now.row()));
          });
  connect(list_, &QListView::clicked, this, [this](const QModelIndex& at) {
    show_press(model_.name_at(at.row()));
  });
  connect(&model_, &QAbstractItemModel::modelReset, this, &PressesPage::show_list);
  connect(leave_out_, &QPushButton::clicked, this, [this] { collection_.toggle_left_out(shown_); });
  connect(remove_, &QPushButton::clicked, this, [this] { collection_.remove(shown_); });
  connect(add_, &QPushButton::clicked, this, &PressesPage::choose_files);
  connect(radius_, &NumberField::valueChanged, this, [this](double value) {
    collection_.set_radius(value);
  });
  connect(operator_, &QLineEdit::editingFinished, this, [this] {
    collection_.set_operator(operator_->text().trimmed().toStdString());
  });
  // The next key must not be typed into the field.
  connect(operator_, &QLineEdit::returnPressed, this, [this] { take_->setFocus(); });
  connect(take_, &QPushButton::clicked, this, &PressesPage::take);
  connect(automatic_, &QCheckBox::toggled, this, [this] {
    still_.begin();
    show_take();
    show_guide();
  });
  connect(more_, &QToolButton::toggled, this, &PressesPage::show_shown);
  connect(find_, &QPushButton::clicked, this, [this] { collection_.find_ball_again(shown_); });
}

void PressesPage::name_parts() {
  list_->setAccessibleName(tr("Presses"));
  add_->setText(tr("&Add pictures…"));
  remove_->setText(tr("Re&move"));
  remove_->setToolTip(tr("Takes the press and its picture away (undo brings them back)"));
  live_button_->setText(tr("&Live picture"));
  residual_->setText(tr("&Error under the ball"));
  residual_->setToolTip(
      tr("In colours, where the mapping reads deeper (red) or less deep (blue) than the ball is"));
  take_group_->setTitle(tr("Taking presses"));
  press_group_->setTitle(tr("This press"));
  radius_label_->setText(tr("Ball's &radius"));
  radius_->setAccessibleName(tr("Ball's radius"));
  radius_->setSuffix(tr(" mm"));
  radius_->setSpecialValueText(tr("unknown"));
  operator_label_->setText(tr("&Operator"));
  operator_->setAccessibleName(tr("Operator"));
  operator_->setPlaceholderText(tr("for the record"));
  take_->setText(tr("&Take a press (Space)"));
  guide_->setAccessibleName(tr("Where to press next"));
  automatic_->setText(tr("By &itself when it holds still"));
  automatic_->setToolTip(
      tr("Takes a press as soon as a contact holds still for half a second; both hands stay free"));
  find_->setText(tr("&Find the ball again"));
  find_->setToolTip(tr("Forgets where the outline was put by hand"));
  more_->setText(tr("Measured, or another ball"));
  legend_->setText(
      tr("Yellow: the ball's outline, dashed as the program found it, whole where a hand put it. "
         "Blue: where the ball meets the untouched face, about the dark disc."));
  position_->setAccessibleName(tr("Place of the ball"));
  show_status();
}

StepState PressesPage::state() const {
  return missing().isEmpty() ? StepState::kDone : StepState::kToDo;
}

QString PressesPage::missing() const {
  if (run_.state() == CalibrationState::kCurrent) return {};  // there were enough
  if (!collection_.is_ready()) return tr("The presses are being read.");
  if (!(collection_.press_set().ball_radius_mm > 0)) return tr("The ball's radius is missing.");
  if (collection_.presses().empty())
    return tr("Take a press first; six at different places are good.");
  const auto has_ball = [this](const CollectedPress& press) {
    return collection_.is_usable(press) && collection_.has_ball(press);
  };
  if (std::none_of(collection_.presses().begin(), collection_.presses().end(), has_ball))
    return tr("In no press a ball was found yet.");
  return {};
}

void PressesPage::choose_files() {
  auto* dialog = new QFileDialog(this,
                                 tr("Pictures of presses"),
                                 QString(),
                                 tr("Pictures (*.png *.jpg *.jpeg *.bmp *.tif *.tiff *.pgm)"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setFileMode(QFileDialog::ExistingFiles);
  connect(dialog, &QFileDialog::filesSelected, this, [this](const QStringList& files) {
    std::vector<std::filesystem::path> inputs;
    for (const QString& file : files) inputs.emplace_back(file.toStdString());
    refused_.reset();
    show_problems();
    collection_.add_files(inputs);
  });
  dialog->show();
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
  problems_->set_problems(std::move(problems));
}

void PressesPage::show_forecast() {
  const QString text = forecast_text(forecast_, run_);
  forecast_words_->setText(text);
  forecast_words_->setVisible(!text.isEmpty());
}

void PressesPage::show_status() {
  if (taker_folder_ != collection_.folder()) {
    taker_.forget();
    refused_.reset();
    taken_name_.clear();
    const QSignalBlocker quiet(radius_);
    radius_->setValue(0);  // resets also a number typed for another finger
  }
  taker_folder_ = collection_.folder();
  show_problems();
  const PressSet& press_set = collection_.press_set();
  {
    const QSignalBlocker quiet(radius_);
    radius_->setValue(press_set.ball_radius_mm);
  }
  if (!operator_->hasFocus()) operator_->setText(as_text(press_set.operator_name));
  const int count = static_cast<int>(collection_.presses().size());
  const int usable = collection_.usable_count();
  count_->setText(count == 0
                      ? tr("No press yet. Press the ball in at different places and depths, "
                           "base, middle and tip.")
                      : tr("%n press(es), ", nullptr, count) + tr("%n usable", nullptr, usable));
  radius_->setEnabled(collection_.is_ready());
  operator_->setEnabled(collection_.is_ready());
  add_->setEnabled(collection_.is_ready());
  show_list();
  show_shown();
  show_take();
  show_forecast();
  Q_EMIT changed();
}

}  // namespace alltact
