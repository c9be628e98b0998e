// The column of buttons at the window's left edge, one for each page.
#pragma once

#include "app/studio/session.h"
#include "app/studio/workspace.h"
#include "widgets/controls/devices.h"
#include "widgets/live/live_session.h"
#include "widgets/shell/page.h"
#include "widgets/widget_base.h"

#include <QButtonGroup>
#include <QFrame>
#include <QLabel>
#include <QStatusBar>
#include <array>

namespace alltact {

class NavigationBar : public Translated<QFrame> {
  Q_OBJECT
 public:
  /// Marks the first page at first; there is at least one.
  explicit NavigationBar(const std::vector<Page*>& pages, QWidget* parent = nullptr);

  /// Its button is down from now on, and is the one that Tab goes to.
  void mark(std::size_t page);

 Q_SIGNALS:
  void chosen(const std::string& page);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  [[nodiscard]] QAbstractButton* make_button();
  void name_buttons();
  void set_icons();

  std::vector<Page*> pages_;
  QButtonGroup* buttons_;  // by the pages' order
};

// Problems of everything that runs, above every page; hidden without problems.

class NotificationBar : public ProblemList {
  Q_OBJECT
 public:
  NotificationBar(const LiveSession& session, const SessionStore& store, const Pedal& pedal,
                  Workspace& work, const std::vector<Page*>& pages,
                  std::function<std::vector<std::filesystem::path>()> slow_files);

  void follow();
  /// Shows what could not be opened, until something else is.
  void show_error(const Error& why);
  /// The user continues the session from before the crash.
  void forget_crash();

 Q_SIGNALS:
  void continue_requested();

 private:
  using Problems = std::vector<Problem>;
  void add_session_problems(Problems& problems);
  void add_disk_problems(Problems& problems) const;
  void add_pedal_problems(Problems& problems) const;
  void add_source_problems(Problems& problems);
  void add_finger_problems(Problems& problems) const;

  const LiveSession& session_;
  const SessionStore& session_store_;
  const Pedal& pedal_;
  Workspace& work_;
  std::vector<Page*> pages_;
  std::function<std::vector<std::filesystem::path>()> slow_files_;
  bool is_crash_reported_ = false;
  std::optional<Error> open_error_;
};

// The line below every page: delivered, lost and delayed frames of the open source.

class StatusLine : public Translated<QStatusBar> {
  Q_OBJECT
 public:
  explicit StatusLine(const LiveSession& session);

 private:
  [[nodiscard]] std::array<QLabel*, 4> labels() const;
  void follow();
  void show_source(const SourceStatus& source, double shown_per_s);

  const LiveSession& session_;
  QLabel *delivered_, *lost_, *time_;
  AgeLabel* age_;
};

}  // namespace alltact
