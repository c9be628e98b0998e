#include "app/studio/main_window.h"

#include "calibration/lens/measure_lens.h"
#include "calibration/reference/new_reference.h"
#include "calibration/reference/settings_record.h"
#include "core/program.h"
#include "core/sources/open/open_source.h"
#include "widgets/accessible.h"
#include "widgets/shell/icons.h"

#include <QCloseEvent>
#include <QHBoxLayout>
#include <QMenuBar>
#include <QSettings>
#include <QStatusBar>
#include <QVBoxLayout>
#include <array>

namespace alltact {
namespace {

constexpr int kRailIcon = 28;

Result<ReferenceReport> install(const std::filesystem::path& folder,
                                const std::filesystem::path& video,
                                const ReferenceChoices& choices,
                                const Job& job) {
  return give_reference(folder, {video}, job, choices);
}

Result<Message> measure(const LensWanted& wanted, const Job& job) {
  const auto done = measure_lens({wanted.pictures}, wanted.board, wanted.settings, job);
  if (!done) return done.error();
  const Status saved = save_camera(wanted.camera, done->fit.lens, lens_record(wanted.board, *done));
  if (!saved) return saved.error();
  return done->verdict.sentence;
}

}  // namespace

MainWindow::MainWindow(const StudioOptions& options, Dresser& dresser)
    : dresser_(dresser),
      keeper_(options.session_folder),
      session_(options.opener),
      finder_(options.lister),
      pedal_(options.pedal),
      rail_(new QButtonGroup(this)),
      live_button_(new QToolButton),
      calibrate_button_(new QToolButton),
      record_button_(new QToolButton),
      inspect_button_(new QToolButton),
      finger_button_(new QToolButton),
      source_button_(new QToolButton),
      finger_label_(new QLabel),
      source_label_(new QLabel),
      problems_(new ProblemList),
      places_(new QStackedWidget),
      live_or_start_(new QStackedWidget),
      start_(new StartPanel),
      live_(new LivePlace(session_, undo_)),
      calibrate_(new CalibratePlace(
          session_, undo_, {measure, options.session_folder, program_version()})),
      record_(new RecordPlace(session_, install)),
      inspect_(new InspectPlace(session_, undo_)),
      delivered_(new QLabel),
      lost_(new QLabel),
      age_(new QLabel),
      time_(new QLabel) {
  setWindowIcon(QIcon(symbol(QStringLiteral("alltact"), Qt::black, 64, 1)));
  make_menus();
  live_or_start_->addWidget(start_);
  live_or_start_->addWidget(live_);
  places_->addWidget(live_or_start_);
  places_->addWidget(calibrate_);
  places_->addWidget(record_);
  places_->addWidget(inspect_);
  auto* content = new QWidget;
  auto* column = new QVBoxLayout(content);
  column->setContentsMargins(10, 8, 10, 4);
  column->addWidget(make_header());
  column->addWidget(problems_);
  column->addWidget(places_, 1);
  auto* whole = new QWidget;
  auto* row = new QHBoxLayout(whole);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(0);
  row->addWidget(make_rail());
  row->addWidget(content, 1);
  setCentralWidget(whole);
  make_status_line();
  connect(&session_, &LiveSession::status_ready, this, &MainWindow::follow);
  connect(&session_, &LiveSession::view_ready, this, [this] {
    live_or_start_->setCurrentWidget(live_);
  });
  connect(&finder_, &CameraFinder::cameras_changed, this, [this] {
    start_->set_cameras(finder_.cameras());
    fill_source_menu();
  });
  connect(live_, &LivePlace::options_changed, this, &MainWindow::keep);
  connect(inspect_, &InspectPlace::changed, this, &MainWindow::keep);
  connect(live_, &LivePlace::control_set, this, [this](const ControlValue& control) {
    auto& kept = state_.controls[source_name().toStdString()];
    std::erase_if(kept, [&](const ControlValue& old) { return old.id == control.id; });
    kept.push_back(control);
    keep();
  });
  connect(live_, &LivePlace::lock_set, this, [this](bool is_locked) {
    state_.is_locked = is_locked;
    keep();
  });
  connect(record_, &RecordPlace::installed, this, [this] {
    session_.open_finger(state_.finger);
    calibrate_->reload();
  });
  connect_calibrating();
  connect_pedal();
  connect(start_, &StartPanel::last_wanted, this, &MainWindow::go_on_with_last);
  connect(start_, &StartPanel::camera_wanted, this, [this](const QString& name) {
    open_source({name.toStdString()});
  });
  connect(start_, &StartPanel::simulated_wanted, this, &MainWindow::open_simulated);
  connect(start_, &StartPanel::video_wanted, this, &MainWindow::choose_video);
  connect(start_, &StartPanel::folder_wanted, this, &MainWindow::choose_folder);
  connect(start_, &StartPanel::finger_wanted, this, &MainWindow::choose_finger);
  connect(start_, &StartPanel::new_finger_wanted, this, [this] { new_finger(); });
  if (keeper_.last()) {
    state_.recent_fingers = keeper_.last()->recent_fingers;
    state_.controls = keeper_.last()->controls;
    state_.view = keeper_.last()->view;
    live_->set_options(state_.view);
  }
  say([this] { name_parts(); });
  set_icons();
  resize(1280, 800);
  QSettings settings;
  restoreGeometry(settings.value(QStringLiteral("window/geometry")).toByteArray());
  if (!options.finger.empty()) set_finger(options.finger);
  if (!options.source.empty()) set_source(options.source);
  follow();
}

void MainWindow::connect_calibrating() {
  connect(calibrate_, &CalibratePlace::new_finger_wanted, this, &MainWindow::new_finger);
  connect(calibrate_, &CalibratePlace::open_finger_wanted, this, &MainWindow::choose_finger);
  connect(calibrate_, &CalibratePlace::record_wanted, this, [this] { go_to("record"); });
  connect(calibrate_, &CalibratePlace::finger_changed, this, [this] {
    session_.open_finger(state_.finger);
  });
}

void MainWindow::connect_pedal() {
  static const QString key = QStringLiteral("pedal/button");
  connect(&pedal_, &Pedal::pressed, this, [this] {
    if (state_.place == "calibrate") calibrate_->press_pedal();
    if (state_.place == "record") record_->press_pedal();
  });
  if (const auto kept = LearntButton::parse(QSettings().value(key).toString().toStdString()))
    pedal_.listen(*kept);
  connect(&pedal_, &Pedal::changed, this, [this] {
    const auto& button = pedal_.button();
    if (!pedal_.is_learning())
      QSettings().setValue(key, button ? QString::fromStdString(button->text()) : QString());
    follow();
  });
}

MainWindow::~MainWindow() {
  problems_->set_problems({});
}

QAction* MainWindow::add(QMenu& menu, std::function<QString()> text, const QKeySequence& key) {
  QAction* action = menu.addAction(QString());
  action->setShortcut(key);
  words_.push_back({action, std::move(text)});
  return action;
}

void MainWindow::make_menus() {
  file_menu_ = menuBar()->addMenu(QString());
  edit_menu_ = menuBar()->addMenu(QString());
  view_menu_ = menuBar()->addMenu(QString());
  help_menu_ = menuBar()->addMenu(QString());
  const auto on = [this](QAction* action, auto slot) {
    connect(action, &QAction::triggered, this, slot);
  };
  on(add(
         *file_menu_, [] { return tr("&Open finger…"); }, QKeySequence::Open),
     &MainWindow::choose_finger);
  on(add(
         *file_menu_, [] { return tr("&New finger…"); }, QKeySequence::New),
     [this] { new_finger(); });
  recent_menu_ = file_menu_->addMenu(QString());
  export_action_ = add(
      *file_menu_, [] { return tr("E&xport finger…"); }, QKeySequence(Qt::CTRL | Qt::Key_E));
  export_action_->setEnabled(false);
  on(export_action_, &MainWindow::export_open_finger);
  on(add(*file_menu_, [] { return tr("&Close finger"); }), [this] { open_finger({}); });
  file_menu_->addSeparator();
  source_menu_ = file_menu_->addMenu(QString());
  file_menu_->addSeparator();
  on(add(
         *file_menu_, [] { return tr("S&ettings…"); }, QKeySequence(Qt::CTRL | Qt::Key_Comma)),
     &MainWindow::show_settings);
  on(add(
         *file_menu_, [] { return tr("&Quit"); }, QKeySequence(Qt::CTRL | Qt::Key_Q)),
     &MainWindow::close);
  make_undo_entries();
  make_view_menu();
  make_help_menu();
}

void MainWindow::make_view_menu() {
  const auto place = [this](const char* name, std::function<QString()> text, Qt::Key key) {
    QAction* action = add(*view_menu_, std::move(text), QKeySequence(Qt::CTRL | key));
    connect(action, &QAction::triggered, this, [this, name] { go_to(name); });
  };
  place(
      "live", [] { return tr("&Live"); }, Qt::Key_1);
  place(
      "calibrate", [] { return tr("&Calibrate"); }, Qt::Key_2);
  place(
      "record", [] { return tr("&Record"); }, Qt::Key_3);
  place(
      "inspect", [] { return tr("&Inspect"); }, Qt::Key_4);
  view_menu_->addSeparator();
  QAction* full = add(
      *view_menu_, [] { return tr("&Full screen"); }, QKeySequence(Qt::Key_F11));
  connect(full, &QAction::triggered, this, [this] {
    setWindowState(windowState() ^ Qt::WindowFullScreen);
  });
}

void MainWindow::make_help_menu() {
  QAction* help = add(
      *help_menu_, [] { return tr("&Help on this place"); }, QKeySequence::HelpContents);
  connect(help, &QAction::triggered, this, &MainWindow::show_help);
  QAction* about = add(*help_menu_, [] { return tr("&About AllTact Studio"); });
  connect(about, &QAction::triggered, this, &MainWindow::show_about);
}

QWidget* MainWindow::make_rail() {
  auto* rail = new QFrame;
  rail->setObjectName(QStringLiteral("rail"));
  rail->setAutoFillBackground(true);
  rail->setBackgroundRole(QPalette::AlternateBase);
  auto* column = new QVBoxLayout(rail);
  column->setContentsMargins(6, 8, 6, 8);
  for (QToolButton* button : {live_button_, calibrate_button_, record_button_, inspect_button_}) {
    button->setCheckable(true);
    button->setToolButtonStyle(Qt::ToolButtonTextUnderIcon);
    button->setIconSize({kRailIcon, kRailIcon});
    button->setMinimumSize(76, 64);
    button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    button->setFocusPolicy(Qt::TabFocus);
    button->setAutoRaise(true);
    rail_->addButton(button);
    column->addWidget(button);
  }
  column->addStretch();
  live_button_->setChecked(true);
  connect(live_button_, &QToolButton::clicked, this, [this] { go_to("live"); });
  connect(calibrate_button_, &QToolButton::clicked, this, [this] { go_to("calibrate"); });
  connect(record_button_, &QToolButton::clicked, this, [this] { go_to("record"); });
  connect(inspect_button_, &QToolButton::clicked, this, [this] { go_to("inspect"); });
  return rail;
}

QWidget* MainWindow::make_header() {
  auto* header = new QWidget;
  auto* row = new QHBoxLayout(header);
  row->setContentsMargins(0, 0, 0, 0);
  source_button_->setMenu(source_menu_);
  finger_button_->setMenu(new QMenu(finger_button_));
  for (const auto& [label, button] :
       {std::pair{finger_label_, finger_button_}, {source_label_, source_button_}}) {
    button->setPopupMode(QToolButton::InstantPopup);
    button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    button->setFocusPolicy(Qt::TabFocus);
    label->setBuddy(button);
    row->addWidget(label);
    row->addWidget(button);
    row->addSpacing(18);
  }
  row->addStretch();
  return header;
}

void MainWindow::make_status_line() {
  for (QLabel* label : {delivered_, lost_, age_, time_}) {
    label->setContentsMargins(6, 0, 12, 0);
    statusBar()->addWidget(label);
  }
}

void MainWindow::name_parts() {
  setWindowTitle(tr("AllTact Studio"));
  for (const Words& words : words_) words.action->setText(words.text());
  show_undo();
  file_menu_->setTitle(tr("&File"));
  edit_menu_->setTitle(tr("&Edit"));
  view_menu_->setTitle(tr("&View"));
  help_menu_->setTitle(tr("&Help"));
  recent_menu_->setTitle(tr("&Recent fingers"));
  source_menu_->setTitle(tr("&Source"));
  live_button_->setText(tr("Live"));
  calibrate_button_->setText(tr("Calibrate"));
  record_button_->setText(tr("Record"));
  inspect_button_->setText(tr("Inspect"));
  live_button_->setToolTip(tr("Live (Ctrl+1)"));
  calibrate_button_->setToolTip(tr("Calibrate (Ctrl+2)"));
  record_button_->setToolTip(tr("Record (Ctrl+3)"));
  inspect_button_->setToolTip(tr("Inspect (Ctrl+4)"));
  finger_label_->setText(tr("Finger:"));
  source_label_->setText(tr("Source:"));
  delivered_->setAccessibleName(tr("Frames delivered"));
  lost_->setAccessibleName(tr("Frames lost"));
  age_->setAccessibleName(tr("Age of the picture"));
  time_->setAccessibleName(tr("Time of a frame"));
  name_last();
  fill_source_menu();
  fill_recent_menu();
  follow();
}

void MainWindow::set_icons() {
  live_button_->setIcon(icon(QStringLiteral("live"), palette()));
  calibrate_button_->setIcon(icon(QStringLiteral("calibrate"), palette()));
  record_button_->setIcon(icon(QStringLiteral("record"), palette()));
  inspect_button_->setIcon(icon(QStringLiteral("inspect"), palette()));
  finger_button_->setIcon(icon(QStringLiteral("finger"), palette()));
  source_button_->setIcon(icon(QStringLiteral("source"), palette()));
}

void MainWindow::changeEvent(QEvent* event) {
  Translated::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) set_icons();
}

void MainWindow::go_to(const std::string& place) {
  struct Room {
    const char* name;
    QToolButton* button;
  };
  const std::array rooms{Room{"live", live_button_},
                         Room{"calibrate", calibrate_button_},
                         Room{"record", record_button_},
                         Room{"inspect", inspect_button_}};
  const auto room =
      std::find_if(rooms.begin(), rooms.end(), [&](const Room& one) { return one.name == place; });
  const auto index = room == rooms.end() ? 0 : room - rooms.begin();
  places_->setCurrentIndex(static_cast<int>(index));
  rooms[static_cast<std::size_t>(index)].button->setChecked(true);
  state_.place = place;
  follow();
  keep();
}

void MainWindow::closeEvent(QCloseEvent* event) {
  QSettings settings;
  settings.setValue(QStringLiteral("window/geometry"), saveGeometry());
  session_.close_source();
  event->accept();
}

}  // namespace alltact
