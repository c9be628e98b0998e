#include "widgets/calibrating/presses_page.h"

#include "core/live/source_runner.h"
#include "widgets/calibrating/space_key.h"
#include "widgets/panels/side_panel.h"
#include "widgets/report/report_words.h"

#include <QApplication>
#include <QButtonGroup>
#include <QFileDialog>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QVBoxLayout>

namespace alltact {
namespace {

constexpr int kListWidth = 270, kPressSideWidth = 284;

}  // namespace

PressesPage::PressesPage(LiveSession& session,
                         PressDesk& desk,
                         const CalibrationRun& run,
                         QWidget* parent)
    : StepPage(parent),
      session_(session),
      desk_(desk),
      run_(run),
      model_(desk, run),
      problems_(new ProblemList),
      count_(wrapped_text()),
      list_(new QListView),
      add_(new QPushButton),
      out_(new QPushButton),
      remove_(new QPushButton),
      live_button_(new QPushButton),
      press_button_(new QPushButton),
      pictures_(new QStackedWidget),
      live_(new PicturePanel(session)),
      editor_(new OutlineEditor),
      place_(new QLabel),
      take_group_(new QGroupBox),
      press_group_(new QGroupBox),
      radius_label_(new QLabel),
      operator_label_(new QLabel),
      radius_(new QDoubleSpinBox),
      operator_(new QLineEdit),
      form_(new PressForm(desk)),
      take_(new QPushButton),
      find_(new QPushButton),
      by_itself_(new QCheckBox),
      take_reason_(wrapped_text()),
      taken_(wrapped_text()),
      press_text_(wrapped_text()),
      legend_(wrapped_text()) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(problems_);
  auto* row = new QHBoxLayout;
  row->addWidget(make_list());
  row->addWidget(make_middle(), 1);
  row->addWidget(make_side());
  column->addLayout(row, 1);
  new SpaceKey(*this, [this] {
    if (take_->isEnabled()) take();
  });
  connect(&desk_, &PressDesk::changed, this, &PressesPage::show_status);
  connect(&desk_, &PressDesk::refused, this, [this](const Problem& problem) {
    problems_->set_problems({problem});
  });
  connect(&run_, &CalibrationRun::changed, this, &PressesPage::show_shown);
  connect(&session_, &LiveSession::view_ready, this, &PressesPage::watch_contact);
  say([this] { name_parts(); });
}

QWidget* PressesPage::make_list() {
  auto* side = new QWidget;
  side->setFixedWidth(kListWidth);
  auto* column = new QVBoxLayout(side);
  column->setContentsMargins(0, 0, 6, 0);
  list_->setModel(&model_);
  list_->setWordWrap(true);
  list_->setIconSize(PressThumbnails::size());
  list_->setSpacing(2);
  list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  column->addWidget(count_);
  column->addWidget(list_, 1);
  auto* row = new QHBoxLayout;
  row->addWidget(out_);
  row->addWidget(remove_);
  column->addLayout(row);
  column->addWidget(add_);
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
  connect(out_, &QPushButton::clicked, this, &PressesPage::take_out_or_put_back);
  connect(remove_, &QPushButton::clicked, this, [this] { desk_.remove(shown_); });
  connect(add_, &QPushButton::clicked, this, &PressesPage::choose_files);
  return side;
}

QWidget* PressesPage::make_middle() {
  auto* middle = new QWidget;
  auto* column = new QVBoxLayout(middle);
  column->setContentsMargins(0, 0, 0, 0);
  auto* row = new QHBoxLayout;
  auto* which = new QButtonGroup(this);
  for (QPushButton* button : {live_button_, press_button_}) {
    button->setCheckable(true);
    which->addButton(button);
    row->addWidget(button);
  }
  row->addStretch();
  column->addLayout(row);
  auto* edited = new QWidget;
  auto* inside = new QVBoxLayout(edited);
  inside->setContentsMargins(0, 0, 0, 0);
  inside->addWidget(editor_, 1);
  place_->setMinimumWidth(1);
  place_->setWordWrap(true);
  inside->addWidget(place_);
  pictures_->addWidget(live_);
  pictures_->addWidget(edited);
  column->addWidget(pictures_, 1);
  ViewOptions options;
  options.direction = options.depth = options.markers = false;
  live_->set_options(options);
  connect(live_button_, &QPushButton::clicked, this, [this] { show_press({}); });
  connect(press_button_, &QPushButton::clicked, this, [this] {
    const int row_now = std::max(0, list_->currentIndex().row());
    show_press(model_.name_at(row_now));
  });
  connect(editor_,
          &OutlineEditor::ball_moved,
          this,
          [this](const Eigen::Vector3d&, const Eigen::Vector3d& after, int grip) {
            desk_.place_ball(shown_, after, grip);
          });
  return middle;
}

QWidget* PressesPage::make_side() {
  const SidePanel side(kPressSideWidth);
  auto* take = new QVBoxLayout(take_group_);
  radius_->setRange(0, kLargestBallMm);
  radius_->setDecimals(3);
  radius_->setSingleStep(0.1);
  radius_->setKeyboardTracking(false);
  radius_label_->setBuddy(radius_);
  operator_label_->setBuddy(operator_);
  auto* form = new QFormLayout;
  form->addRow(radius_label_, radius_);
  form->addRow(operator_label_, operator_);
  take->addLayout(form);
  take_->setMinimumHeight(40);
  take->addWidget(take_);
  take->addWidget(take_reason_);
  take->addWidget(by_itself_);
  take->addWidget(taken_);
  side.column->addWidget(take_group_);
  auto* press = new QVBoxLayout(press_group_);
  press->addWidget(press_text_);
  press->addWidget(form_);
  press->addWidget(find_);
  press->addWidget(legend_);
  side.column->addWidget(press_group_);
  side.column->addStretch();
  connect(radius_, &QDoubleSpinBox::valueChanged, this, [this](double value) {
    desk_.set_radius(value);
  });
  connect(operator_, &QLineEdit::editingFinished, this, [this] {
    desk_.set_operator(operator_->text().trimmed().toStdString());
  });
  connect(take_, &QPushButton::clicked, this, &PressesPage::take);
  connect(by_itself_, &QCheckBox::toggled, this, [this] {
    still_.begin();
    show_take();
  });
  connect(find_, &QPushButton::clicked, this, [this] { desk_.find_again(shown_); });
  return side.whole;
}

void PressesPage::name_parts() {
  list_->setAccessibleName(tr("Presses"));
  add_->setText(tr("&Add pictures…"));
  remove_->setText(tr("Re&move"));
  remove_->setToolTip(tr("Takes the press and its picture away (undo brings them back)"));
  live_button_->setText(tr("&Live picture"));
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
  by_itself_->setText(tr("By &itself when it holds still"));
  by_itself_->setToolTip(
      tr("Takes a press as soon as a contact holds still for half a second; both hands stay free"));
  find_->setText(tr("&Find the ball again"));
  find_->setToolTip(tr("Forgets where the outline was put by hand"));
  legend_->setText(
      tr("Yellow: the ball's outline, dashed as the program found it, whole where a hand put it. "
         "Blue: where the ball meets the untouched face, about the dark disc."));
  place_->setAccessibleName(tr("Place of the ball"));
  show_status();
}

StepState PressesPage::state() const {
  return missing().isEmpty() ? StepState::kDone : StepState::kToDo;
}

QString PressesPage::missing() const {
  if (run_.state() == CalibrationState::kCurrent) return {};  // they were enough
  if (!desk_.is_ready()) return tr("The presses are being read.");
  if (!(desk_.said().ball_radius_mm > 0)) return tr("The ball's radius is missing.");
  if (desk_.presses().empty()) return tr("Take a press first; six at different places are good.");
  const auto has_ball = [this](const DeskPress& press) {
    return desk_.is_usable(press) && desk_.has_ball(press);
  };
  if (std::none_of(desk_.presses().begin(), desk_.presses().end(), has_ball))
    return tr("In no press a ball was found yet.");
  return {};
}

QString PressesPage::why_not_take() const {
  if (!session_.view()) return tr("There is no live picture: choose a source.");
  if (!desk_.is_ready()) return tr("The presses are being read.");
  if (!desk_.looker()) return tr("The finger cannot be compared with its reference.");
  const FramePtr& frame = session_.view()->result.frame;
  if (!frame || session_.view()->problem) return tr("The live picture does not fit this finger.");
  return {};
}

void PressesPage::take() {
  if (!why_not_take().isEmpty()) return;
  const FramePtr& frame = session_.view()->result.frame;
  const auto alike = frame == newest_held_ ? held_.alike() : std::vector<FramePtr>{frame};
  taken_name_ = as_text(desk_.add({mean_frame(alike)}));
  taken_of_ = alike.size();
  show_take();
}

void PressesPage::hold(const FramePtr& frame) {
  if (!frame || frame == newest_held_) return;
  const bool goes_on = newest_held_ && frame->origin == newest_held_->origin &&
                       frame->sequence > newest_held_->sequence;
  if (!goes_on) held_.clear();  // another source, or the same from its beginning
  held_.add(frame);
  newest_held_ = frame;
}

void PressesPage::forget_held() {
  held_.clear();
  newest_held_.reset();
}

void PressesPage::hideEvent(QHideEvent* event) {
  forget_held();
  StepPage::hideEvent(event);
}

void PressesPage::press_pedal() {
  if (!take_->isEnabled()) return;
  take();
  QApplication::beep();
}

void PressesPage::watch_contact() {
  if (!isVisible()) return;
  hold(session_.view()->result.frame);
  show_take();
  if (!by_itself_->isChecked() || !why_not_take().isEmpty()) return;
  const FrameResult& result = session_.view()->result;
  if (!still_.add(dark_patch(result), 1e-9 * static_cast<double>(monotonic_ns()))) return;
  take();
  QApplication::beep();
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
    problems_->set_problems({});
    desk_.add_files(inputs);
  });
  dialog->show();
}

void PressesPage::take_out_or_put_back() {
  if (desk_.said().of(shown_).excluded)
    desk_.put_back(shown_);
  else
    desk_.take_out(shown_, {});
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

void PressesPage::show_take() {
  const QString reason = why_not_take();
  take_->setEnabled(reason.isEmpty());
  take_reason_->setText(reason);
  take_reason_->setVisible(!reason.isEmpty());
  taken_->setText(
      taken_of_ > 1
          ? tr("%1 is taken: the mean of %2 pictures held still.").arg(taken_name_).arg(taken_of_)
          : tr("%1 is taken from a single picture; hold ball and finger still for half "
               "a second, and its noise falls to a quarter.")
                .arg(taken_name_));
  taken_->setVisible(!taken_name_.isEmpty());
}

void PressesPage::show_status() {
  if (held_for_ != desk_.folder()) forget_held();
  held_for_ = desk_.folder();
  if (const auto problem = desk_.problem()) problems_->set_problems({Problem::of(*problem)});
  const PressSet& said = desk_.said();
  if (!radius_->hasFocus() || radius_->value() != said.ball_radius_mm) {
    const QSignalBlocker quiet(radius_);
    radius_->setValue(said.ball_radius_mm);
  }
  if (!operator_->hasFocus()) operator_->setText(as_text(said.operator_name));
  const int count = static_cast<int>(desk_.presses().size());
  const int usable = desk_.usable_count();
  count_->setText(count == 0
                      ? tr("No press yet. Press the ball in at different places and depths, "
                           "base, middle and tip.")
                      : tr("%n press(es), ", nullptr, count) + tr("%n usable", nullptr, usable));
  radius_->setEnabled(desk_.is_ready());
  operator_->setEnabled(desk_.is_ready());
  add_->setEnabled(desk_.is_ready());
  show_list();
  show_shown();
  show_take();
  Q_EMIT changed();
}

}  // namespace alltact
