// The presses of one finger as somebody collects them: kept in the finger's folder from the moment
// they are there, looked at beside the window, every change undoable.
#pragma once

#include "core/finger/finger_store.h"
#include "core/io/disk_queue.h"
#include "widgets/background_work.h"
#include "widgets/calibrating/press_looker.h"
#include "widgets/shell/problem_list.h"
#include "widgets/undo_step.h"

#include <QObject>
#include <QUndoStack>
#include <deque>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace alltact {

struct DeskPress {
  std::string name;  ///< presses/NAME.png
  FramePtr frame;    ///< as it was taken; null while it is being read
  LookedAt looked;
  bool is_looked_at = false;
};

class PressDesk : public QObject {
  Q_OBJECT
 public:
  explicit PressDesk(QUndoStack& undo, QObject* parent = nullptr);
  ~PressDesk() override;  ///< what waits for the disk is written first

  /// Another finger's folder, or the same one with another reference. Empty: none. Returns at once.
  void open(const std::filesystem::path& folder);
  [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }
  /// What lies in the folder is known and can be looked at. Before that, presses() and said() may
  /// tell already what lies there, and nothing can be changed.
  [[nodiscard]] bool is_ready() const { return is_ready_; }
  /// Why the finger's presses cannot be looked at, or not be kept.
  [[nodiscard]] std::optional<Error> problem() const;

  /// The camera's frame that balls are in; nullptr until is_ready(), or where there is a problem.
  [[nodiscard]] const PressLooker* looker() const { return looker_.get(); }

  /// In the order of their names.
  [[nodiscard]] const std::vector<DeskPress>& presses() const { return presses_; }
  [[nodiscard]] const PressSet& said() const { return said_; }
  /// nullptr where there is none.
  [[nodiscard]] const DeskPress* find(const std::string& name) const;
  /// Found, or put there by hand; a punch is none.
  [[nodiscard]] bool has_ball(const DeskPress& press) const;
  /// Its picture could be written to the disk, or is being written.
  [[nodiscard]] bool is_kept(const std::string& name) const;
  /// Not taken out, and with a ball or a punch.
  [[nodiscard]] bool is_usable(const DeskPress& press) const;
  [[nodiscard]] int usable_count() const;
  [[nodiscard]] bool is_looking() const { return looking_.is_running(); }

  // Undoable:
  void set_radius(double radius_mm);
  /// Of the ball of this press alone; 0: the same as of all others.
  void set_radius_of(const std::string& name, double radius_mm);
  /// As a stage or a gauge tells it; 0 mm: not measured.
  void set_depth_of(const std::string& name, const ToldDepth& depth);
  /// Of a punch that was pressed in place of a ball; 0: it was a ball. What is said of its ball
  /// stays for when it is one again.
  void set_step_of(const std::string& name, double step_mm);
  void set_operator(const std::string& name);
  /// `grip`: see OutlineEditor::ball_moved.
  void place_ball(const std::string& name, const Eigen::Vector3d& centre_mm, int grip);
  void find_again(const std::string& name);  ///< forgets where a hand put the ball
  void take_out(const std::string& name, const std::string& because);
  void put_back(const std::string& name);
  void take_out_or_put_back(const std::string& name);
  /// For the button that does it.
  [[nodiscard]] QString words_to_take_out_or_put_back(const std::string& name) const;
  /// Under the next free names press_1, press_2, ...; gives the first.
  std::string add(std::vector<FramePtr> frames);
  void remove(const std::string& name);
  /// Reads pictures, folders or a video beside the window and adds them under their own names,
  /// after those that are being read.
  void add_files(const std::vector<std::filesystem::path>& inputs);

  /// The disk, for whoever has to write or read after what is being written.
  [[nodiscard]] std::shared_ptr<DiskQueue> disk() const { return disk_; }

 Q_SIGNALS:
  /// Presses came, went, were looked at, or something was said of them.
  void changed();
  /// Why pictures could not be added.
  void refused(const alltact::Problem& problem);

 private:
  class AddOrRemove;
  struct Waiting;
  void load();
  void load_looker();
  void add_next();
  void look_at_next();
  void change(const StepWords& words, PressSet said, int merge_id = -1);
  void change_radii(const StepWords& words, PressSet said, int merge_id);
  /// What `change` makes of a press' note.
  void change_note(const StepWords& words,
                   const std::string& name,
                   const std::function<void(PressNote&)>& change,
                   int merge_id = -1);
  void set_said(const PressSet& said);
  void insert(const std::vector<FramePtr>& frames);
  void erase(const std::vector<FramePtr>& frames);

  QUndoStack& undo_;
  std::shared_ptr<DiskQueue> disk_;
  std::filesystem::path folder_;
  int opened_ = 0;  // counts, so that results for another finger are dropped
  bool is_ready_ = false;
  std::optional<Error> problem_;
  std::shared_ptr<PressLooker> looker_;
  std::vector<DeskPress> presses_;
  PressSet said_;
  std::shared_ptr<Waiting> waiting_;
  std::deque<std::vector<std::filesystem::path>> to_add_;
  BackgroundWork loading_, looking_, adding_;
};

}  // namespace alltact
