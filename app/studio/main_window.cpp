#include "app/studio/main_window.h"

#include "app/studio/command_search.h"
#include "app/studio/header_bar.h"
#include "app/studio/help.h"
#include "app/studio/menus.h"
#include "app/studio/onboarding.h"
#include "app/studio/window_bars.h"
#include "core/base/program.h"
#include "widgets/background_work.h"
#include "widgets/controls/wheel_rule.h"
#include "widgets/pages/accuracy_page.h"
#include "widgets/pages/calibrate_page.h"
#include "widgets/pages/inspect_page.h"
#include "widgets/pages/live_page.h"
#include "widgets/pages/record_page.h"
#include "widgets/theme.h"

#include <QApplication>
#include <QCloseEvent>
#include <QDragEnterEvent>
#include <QHBoxLayout>
#include <QLibraryInfo>
#include <QLocale>
#include <QMenuBar>
#include <QMessageBox>
#include <QMimeData>
#include <QSettings>
#include <QUrl>
#include <QVBoxLayout>
#include <QWidget>

namespace alltact {
namespace {

constexpr int kBarHeight_px = 32;

}  // namespace

void ProgramAppearance::apply(const Appearance& appearance) {
  appearance_ = appearance;
  QApplication::setPalette(theme_palette(appearance.theme));
  set_language(appearance.language.isEmpty() ? QLocale::system().name() : appearance.language);
}

void ProgramAppearance::set_language(const QString& language) {
  if (language == language_) return;
  language_ = language;
  QCoreApplication::removeTranslator(&app_translator_);
  QCoreApplication::removeTranslator(&qt_translator_);
  const QLocale locale(language);
  QLocale::setDefault(locale);
  // Open windows took the locale from before: their fields would go on writing its numbers.
  for (QWidget* window : QApplication::topLevelWidgets()) window->setLocale(locale);
  if (qt_translator_.load(locale, QStringLiteral("qtbase"), QStringLiteral("_"),
                          QLibraryInfo::path(QLibraryInfo::TranslationsPath)))
    QCoreApplication::installTranslator(&qt_translator_);
  // Plural forms need a translation, in English too: "1 frame", "2 frames".
  if (app_translator_.load(locale, QStringLiteral("alltact"), QStringLiteral("_"),
                           QStringLiteral(":/i18n")) ||
      app_translator_.load(QStringLiteral(":/i18n/alltact_en")))
    QCoreApplication::installTranslator(&app_translator_);
}

MainWindow::MainWindow(const StudioOptions& options, ProgramAppearance& program_appearance)
    : program_appearance_(program_appearance),
      session_store_(options.session_folder),
      session_(options.opener),
      work_(session_, undo_, session_store_.last()),
      finder_(options.lister),
      pedal_(options.pedal),
      live_(new LivePage(session_, undo_)),
      inspect_(new InspectPage(session_, undo_)),
      finger_menu_(new FingerMenu(work_, this)),
      source_menu_(new SourceMenu(work_, finder_, this)),
      stack_(new QStackedWidget) {
  let_wheel_scroll(*qApp);
  setWindowIcon(QIcon(symbol(QStringLiteral("alltact"), Qt::black, 64, 1)));
  make_pages(options);
  navigation_ = new NavigationBar(pages_);
  problems_ =
      new NotificationBar(session_, session_store_, pedal_, work_, pages_, options.slow_files);
  make_menus();
  put_together();
  for (Page* page : pages_) connect_page(*page);
  connect_live();
  connect_start();
  connect_pedal();
  connect(navigation_, &NavigationBar::chosen, this, &MainWindow::go_to);
  connect(problems_, &NotificationBar::continue_requested, this, &MainWindow::go_on_with_last);
  connect(&work_, &Workspace::changed, this, &MainWindow::keep);
  connect(source_menu_, &SourceMenu::failed, problems_, &NotificationBar::show_error);
  connect(&UnexpectedErrors::instance(), &UnexpectedErrors::reported, problems_,
          &NotificationBar::show_error);
  connect(&desktop_files_, &DesktopFiles::failed, problems_, &NotificationBar::show_error);
  if (session_store_.last()) live_->set_options(session_store_.last()->view);
  say([this] {
    setWindowTitle(tr("AllTact Studio"));
    name_last();
  });
  setAcceptDrops(true);
  resize(1280, 800);
  restoreGeometry(QSettings().value(QStringLiteral("window/geometry")).toByteArray());
  shown_page().focus_next();
  work_.begin_with(options.finger, options.source);
}

MainWindow::~MainWindow() {
  // A field that loses the focus emits its value: now, while its listeners live.
  if (QWidget* focused = focusWidget()) focused->clearFocus();
  problems_->set_problems({});
}

/// The table of pages: all code that shows or lists them loops over it.
void MainWindow::make_pages(const StudioOptions& options) {
  auto* calibrate = new CalibratePage(session_, undo_, options.work_folder, program_version());
  auto* accuracy = new AccuracyPage(session_, undo_, program_version());
  pages_ = {live_, calibrate, new RecordPage(session_, undo_), inspect_, accuracy};
  guide_ = new Tutorial(session_, work_, *calibrate, options.work_folder);
  hint_ = new PageHint(*guide_);
}

void MainWindow::put_together() {
  for (Page* page : pages_) stack_->addWidget(page);
  auto* content = new QWidget;
  auto* column = new QVBoxLayout(content);
  column->setContentsMargins(10, 8, 10, 4);
  make_bars(*column);
  column->addWidget(stack_, 1);
  auto* centre = new QWidget;
  auto* row = without_margins(new QHBoxLayout(centre));
  row->setSpacing(0);
  row->addWidget(navigation_);
  row->addWidget(content, 1);
  setCentralWidget(centre);
  setStatusBar(new StatusLine(session_));
}

void MainWindow::make_bars(QVBoxLayout& column) {
  header_ = new HeaderBar(session_, work_, *finger_menu_, *source_menu_);
  connect(&header_->summary(), &FingerSummary::due_requested, this, &MainWindow::lead_to);
  auto *top = new QWidget, *strip = new QWidget;
  top->setFixedHeight(kBarHeight_px);
  strip->setFixedHeight(kBarHeight_px);
  header_row_ = without_margins(new QHBoxLayout(top));
  strip_row_ = without_margins(new QHBoxLayout(strip));
  header_row_->addWidget(header_, 1);
  add_widgets(*strip_row_, {hint_, guide_});
  add_widgets(column, {top, strip});
  connect(guide_, &Tutorial::turned, this, &MainWindow::share_bars);
  connect(problems_, &ProblemList::filled, this, &MainWindow::share_bars);
  connect(&session_, &LiveSession::status_ready, this, &MainWindow::show_leads);
  share_bars();
}

void MainWindow::share_bars() {
  const bool is_any = !problems_->problems().empty();
  QHBoxLayout& row = guide_->is_on() ? *header_row_ : *strip_row_;
  if (row.indexOf(problems_) < 0) row.addWidget(problems_, 1);
  problems_->setVisible(guide_->is_on() || is_any);
  hint_->make_room(is_any);
  show_leads();
}

void MainWindow::show_leads() {
  const Page& page = shown_page();
  const std::string leads_to = page.leads_to();
  header_->summary().set_led(guide_->is_on(), page.name(), leads_to);
  guide_->set_page(page.name(), leads_to);
}

bool MainWindow::focusNextPrevChild(bool next) {
  const QWidget* focused = focusWidget();
  const bool is_lost =
      focused != nullptr && focused != this && (!focused->isEnabled() || !focused->isVisible());
  if (!is_lost) return Translated::focusNextPrevChild(next);
  shown_page().focus_next();
  return true;
}

namespace {

std::vector<std::filesystem::path> files_of(const QMimeData& data) {
  std::vector<std::filesystem::path> files;
  for (const QUrl& url : data.urls())
    if (url.isLocalFile()) files.emplace_back(url.toLocalFile().toStdString());
  return files;
}

}  // namespace

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
  if (!files_of(*event->mimeData()).empty()) event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) {
  const auto files = files_of(*event->mimeData());
  if (files.empty()) return;
  event->acceptProposedAction();
  dropping_.restart([this, files](const Job&) {
    return std::function<void()>([this, dropped = dropped_files(files)] { open_files(dropped); });
  });
}

void MainWindow::open_files(const DroppedFiles& dropped) {
  if (dropped.kind == FileKind::kFinger) return open_finger(dropped.files.front());
  if (!shown_page().take_files(dropped)) open_source(dropped.files);
}

void MainWindow::connect_page(Page& page) {
  connect(&page, &Page::changed, this, &MainWindow::keep);
  connect(&page, &Page::problems_changed, problems_, &NotificationBar::follow);
  connect(&page, &Page::page_requested, this, &MainWindow::go_to);
  connect(&page, &Page::lead_requested, this, &MainWindow::lead_to);
  connect(&page, &Page::open_finger_requested, finger_menu_, &FingerMenu::choose);
  connect(&page, &Page::inspect_requested, this, [this](const std::filesystem::path& recording) {
    inspect_->open(recording);
    go_to(inspect_->name());
  });
  connect(&page, &Page::new_finger_requested, finger_menu_, &FingerMenu::make);
  connect(&work_, &Workspace::finger_rewritten, &page, &Page::reload);
}

void MainWindow::connect_live() {
  connect(live_, &LivePage::control_set, &work_, &Workspace::store_control);
  connect(live_, &LivePage::lock_set, &work_, &Workspace::store_lock);
  connect(&work_, &Workspace::source_changed, live_, [this] {
    live_->show_start(work_.state().source.empty());
    show_hint();
  });
}

void MainWindow::connect_start() {
  StartPanel* start = &live_->start();
  connect(&finder_, &CameraFinder::cameras_changed, live_,
          [this] { live_->set_cameras(finder_.cameras()); });
  connect(start, &StartPanel::last_requested, this, &MainWindow::go_on_with_last);
  connect(start, &StartPanel::camera_requested, this,
          [this](const QString& name) { open_source({name.toStdString()}); });
  connect(start, &StartPanel::simulation_requested, source_menu_, &SourceMenu::open_simulated);
  connect(start, &StartPanel::all_fingers_requested, finger_menu_, &FingerMenu::list_all);
  connect(start, &StartPanel::tutorial_requested, this, [this] {
    if (!work_.state().finger.empty()) work_.open_finger({});
    source_menu_->open_simulated_day();
    guide_->begin();
  });
  connect(start, &StartPanel::video_requested, source_menu_, &SourceMenu::choose_video);
  connect(start, &StartPanel::folder_requested, source_menu_, &SourceMenu::choose_folder);
  connect(guide_, &Tutorial::page_requested, this, &MainWindow::lead_to);
  connect(guide_, &Tutorial::failed, problems_, &NotificationBar::show_error);
  FingerCards* cards = &start->cards();
  connect(cards, &FingerCards::found, finger_menu_, &FingerMenu::offer);
  connect(cards, &FingerCards::finger_chosen, this, [this](const QString& folder) {
    const auto& last = session_store_.last();
    if (last && last->finger == folder.toStdString() && !last->source.empty())
      go_on_with_last();  // its source is known too
    else
      open_finger(folder.toStdString());
  });
  const auto show_recent = [this, cards] { cards->set_fingers(work_.state().recent_fingers); };
  connect(&work_, &Workspace::recent_fingers_changed, cards, show_recent);
  connect(cards, &FingerCards::removal_requested, &work_, &Workspace::forget_finger);
  connect(&work_, &Workspace::finger_changed, this, [this] {
    QCoreApplication::instance()->setProperty(
        "alltact_finger_folder", QString::fromStdString(work_.state().finger.string()));
  });
  show_recent();
}

void MainWindow::connect_pedal() {
  static const QString key = QStringLiteral("pedal/button");
  connect(&pedal_, &Pedal::pressed, this, [this] { shown_page().press_pedal(); });
  if (const auto stored = LearntButton::parse(QSettings().value(key).toString().toStdString()))
    pedal_.listen(*stored);
  connect(&pedal_, &Pedal::changed, this, [this] {
    const auto& button = pedal_.button();
    if (!pedal_.is_learning())
      QSettings().setValue(key, button ? QString::fromStdString(button->text()) : QString());
  });
}

void MainWindow::make_menus() {
  make_file_menu();
  menuBar()->addMenu(new EditMenu(undo_, session_, this));
  make_view_menu();
  auto* help = new HelpMenu([this] { return shown_page().name(); }, pages_, this);
  connect(hint_, &PageHint::help_requested, help, &HelpMenu::show_help);
  connect(help, &HelpMenu::failed, problems_, &NotificationBar::show_error);
  menuBar()->addMenu(help);
  new MenuKeys(*menuBar(), *this);
}

void MainWindow::make_file_menu() {
  auto* menu = new TranslatedMenu(this);
  menu->set_title([] { return tr("&File"); });
  finger_menu_->add_to(*menu);
  menu->addSeparator();
  menu->addMenu(source_menu_);
  menu->addSeparator();
  menu->add(
      {Qt::CTRL | Qt::Key_Comma}, [] { return tr("S&ettings…"); }, [this] { show_settings(); });
  menu->add(
      {Qt::CTRL | Qt::Key_Q}, [] { return tr("&Quit"); }, [this] { close(); });
  menuBar()->addMenu(menu);
}

void MainWindow::make_view_menu() {
  auto* menu = new TranslatedMenu(this);
  menu->set_title([] { return tr("&View"); });
  for (std::size_t i = 0; i < pages_.size(); ++i) {
    const Page* page = pages_[i];
    const auto key = static_cast<Qt::Key>(Qt::Key_1 + static_cast<int>(i));
    menu->add(
        {Qt::CTRL | key}, [page] { return page->menu_text(); },
        [this, page] { go_to(page->name()); });
  }
  menu->addSeparator();
  menu->add(
      {Qt::CTRL | Qt::Key_K}, [] { return tr("Fi&nd a command…"); },
      [this] { show_dialog(*new CommandSearch(*this)); });
  menu->add(
      {Qt::Key_F11}, [] { return tr("&Full screen"); },
      [this] { setWindowState(windowState() ^ Qt::WindowFullScreen); });
  menuBar()->addMenu(menu);
}

void MainWindow::show_settings() {
  auto* dialog = new SettingsDialog(program_appearance_.appearance(), &pedal_, this);
  connect(dialog, &SettingsDialog::appearance_chosen, this, [this](const Appearance& chosen) {
    program_appearance_.apply(chosen);
    QSettings settings;
    settings.setValue(QStringLiteral("appearance/theme"), static_cast<int>(chosen.theme));
    settings.setValue(QStringLiteral("appearance/language"), chosen.language);
  });
  show_dialog(*dialog);
}

Page& MainWindow::shown_page() const {
  return *pages_[static_cast<std::size_t>(stack_->currentIndex())];
}

void MainWindow::go_to(const std::string& name) {
  const auto found = std::find_if(pages_.begin(), pages_.end(),
                                  [&](const Page* page) { return page->name() == name; });
  const auto index = found == pages_.end() ? 0 : found - pages_.begin();
  stack_->setCurrentIndex(static_cast<int>(index));
  navigation_->mark(static_cast<std::size_t>(index));
  show_leads();
  show_hint();
  // Who walks along the navigation bar by keys stays there.
  if (focusWidget() == nullptr || !navigation_->isAncestorOf(focusWidget()))
    shown_page().focus_next();
  problems_->follow();
  keep();
}

void MainWindow::lead_to(const std::string& page) {
  go_to(page);
  shown_page().begin_next_step();
}

void MainWindow::show_hint() {
  const bool is_first_page = &shown_page() == live_ && work_.state().source.empty();
  hint_->show_for(is_first_page ? std::string() : shown_page().name());
}

void MainWindow::keep() {
  SessionState state = work_.state();
  state.page = shown_page().name();
  state.view = live_->options();
  state.inspect = {inspect_->options(), inspect_->frame_number()};
  session_store_.keep(state);
}

void MainWindow::restore(const SessionState& state) {
  live_->set_options(state.view);
  const bool was_inspecting = !state.inspect.options.recording.empty();
  if (!state.finger.empty()) open_finger(state.finger);
  if (!state.source.empty() || was_inspecting) {
    undo_.beginMacro(tr("continue the last session"));
    if (!state.source.empty()) open_source(state.source);
    inspect_->restore(state.inspect.options, state.inspect.frame);
    undo_.endMacro();
  }
  go_to(state.page);
}

void MainWindow::go_on_with_last() {
  problems_->forget_crash();
  if (session_store_.last()) restore(*session_store_.last());
}

void MainWindow::name_last() {
  const auto& last = session_store_.last();
  QStringList what;
  if (last && !last->finger.empty()) what << tr("finger %1").arg(short_name(last->finger));
  if (last && !last->source.empty()) what << tr("source %1").arg(short_name(last->source.front()));
  if (last && !last->inspect.options.recording.empty())
    what << tr("recording %1").arg(short_name(last->inspect.options.recording));
  live_->start().set_last(what.join(QStringLiteral(", ")));
}

void MainWindow::ask_before_closing() {
  auto* box = new QMessageBox(
      QMessageBox::Question, tr("A recording is running"),
      tr("A recording is running. Quitting ends it; the recording up to then is saved."),
      QMessageBox::NoButton, this);
  box->setAttribute(Qt::WA_DeleteOnClose);
  auto* end = box->addButton(tr("&End it and quit"), QMessageBox::AcceptRole);
  auto* go_on = box->addButton(tr("&Go on recording"), QMessageBox::RejectRole);
  box->setDefaultButton(go_on);
  box->setEscapeButton(go_on);
  connect(end, &QPushButton::clicked, this, [this] {
    may_close_ = true;
    close();
  });
  box->open();
}

void MainWindow::end() {
  may_close_ = true;
  close();
  QApplication::quit();
}

void MainWindow::closeEvent(QCloseEvent* event) {
  if (session_.status().recording.state == RecordingState::kRunning && !may_close_) {
    event->ignore();
    return ask_before_closing();
  }
  QSettings().setValue(QStringLiteral("window/geometry"), saveGeometry());
  session_.close_source();
  event->accept();
}

}  // namespace alltact
