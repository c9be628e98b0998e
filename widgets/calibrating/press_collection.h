// The presses of one finger as the user collects them. Images and notes are stored in the finger's
// folder at once; analysis runs on a background thread; every change can be undone.
#pragma once

#include "calibration/finger/calibrate_presses.h"
#include "calibration/presses/press.h"
#include "core/base/job.h"
#include "core/base/slow_disk.h"
#include "core/finger/finger_store.h"
#include "widgets/background_work.h"
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

// Analysis of one press image before any calibration: the shape of the face and the position of the
// ball.

struct PressAnalysis {
  cv::Mat grey;                             ///< oriented; empty where analysis failed
  std::shared_ptr<const FaceShape> shape;   ///< null: no face was found
  std::optional<Eigen::Vector3d> found_mm;  ///< the ball's centre, camera frame
  std::optional<Error> problem;             ///< why there is no ball
  /// Input of a calibration; null where the image is not usable.
  std::shared_ptr<const MeasuredPress> measured;
};

/// Used by one thread at a time.
class PressAnalyser {
 public:
  /// Reads the finger's reference. Errors: those of open_finger and Pipeline::create.
  static Result<std::shared_ptr<PressAnalyser>> create(const std::filesystem::path& folder,
                                                       const Job& job);

  [[nodiscard]] const Camera& camera() const { return meter_.pipeline().camera(); }
  [[nodiscard]] const Finger& finger() const { return meter_.pipeline().finger(); }
  [[nodiscard]] bool is_perspective() const { return camera().is_perspective(); }

  /// radius_mm: of the ball; 0: unknown, and no ball is searched for.
  [[nodiscard]] PressAnalysis operator()(const FramePtr& frame, double radius_mm);

 private:
  explicit PressAnalyser(PressMeter meter) : meter_(std::move(meter)) {}
  PressMeter meter_;
};

struct CollectedPress {
  std::string name;  ///< file presses/NAME.png
  FramePtr frame;    ///< captured frame; null while it is being read
  PressAnalysis analysis;
  bool is_analysed = false;
};

class PressCollection : public QObject {
  Q_OBJECT
 public:
  explicit PressCollection(QUndoStack& undo, QObject* parent = nullptr);
  ~PressCollection() override;  ///< pending writes are finished first

  /// Opens another finger's folder, or the same one after its reference changed. Empty: none.
  /// Returns at once.
  void open(const std::filesystem::path& folder);
  [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }
  /// The folder was read and can be changed. presses() and press_set() may be filled earlier,
  /// when nothing can be changed yet.
  [[nodiscard]] bool is_ready() const { return is_ready_; }
  /// Why the presses cannot be analysed or stored.
  [[nodiscard]] std::optional<Error> problem() const;

  /// Analyses presses; its camera is the frame of all ball positions. nullptr until is_ready(), or
  /// where there is a problem.
  [[nodiscard]] const PressAnalyser* analyser() const { return analyser_.get(); }

  /// In the order of their names.
  [[nodiscard]] const std::vector<CollectedPress>& presses() const { return presses_; }
  [[nodiscard]] const PressSet& press_set() const { return press_set_; }
  /// nullptr where there is none.
  [[nodiscard]] const CollectedPress* find(const std::string& name) const;
  /// A ball was found or set by hand; a punch or another body has none.
  [[nodiscard]] bool has_ball(const CollectedPress& press) const;
  /// Its image was written to the disk, or is being written.
  [[nodiscard]] bool is_saved(const std::string& name) const;
  /// Not left out, and made with a ball, a punch or another body.
  [[nodiscard]] bool is_usable(const CollectedPress& press) const;
  [[nodiscard]] int usable_count() const;
  [[nodiscard]] bool is_analysing() const { return analysing_.is_running(); }

  // Undoable changes:
  void set_radius(double radius_mm);
  /// Radius of this press' ball; 0: the radius of all other presses.
  void set_radius_of(const std::string& name, double radius_mm);
  /// Depth measured by a stage or a gauge, with its standard deviation; 0 mm: not measured.
  void set_depth_of(const std::string& name, const GivenDepth& depth);
  /// Step height of a punch used instead of a ball; 0: a ball. Notes about the ball are retained.
  void set_step_of(const std::string& name, double step_mm);
  /// Mesh of another body used instead of a ball, likewise; empty: a ball.
  void set_body_of(const std::string& name, const std::filesystem::path& mesh);
  void set_operator(const std::string& name);
  /// `grip`: see OutlineEditor::ball_moved.
  void set_ball(const std::string& name, const Eigen::Vector3d& centre_mm, int grip);
  void find_ball_again(const std::string& name);  ///< drops the ball position set by hand
  void leave_out(const std::string& name, const std::string& because);
  void use_again(const std::string& name);
  void toggle_left_out(const std::string& name);
  /// All of them, in one step: left out unless each is so already.
  void toggle_left_out(const std::vector<std::string>& names);
  /// Label of the button that toggles it.
  [[nodiscard]] QString toggle_left_out_text(const std::string& name) const;
  /// Adds frames under the next free names press_01, press_02, ...; returns the first name.
  std::string add(std::vector<FramePtr> frames);
  /// One step for all of them.
  void remove(const std::vector<std::string>& names);
  /// Reads images, folders or a video on a background thread and adds them under their own names.
  /// Runs after earlier calls.
  void add_files(const std::vector<std::filesystem::path>& inputs);

  /// Disk queue, for reads and writes that must follow pending ones.
  [[nodiscard]] std::shared_ptr<DiskQueue> disk() const { return disk_; }

 Q_SIGNALS:
  /// Presses were added, removed or analysed, or their notes changed.
  void changed();
  /// Why images could not be added.
  void refused(const alltact::Problem& problem);

 private:
  class AddOrRemove;
  struct Waiting;
  void load();
  void load_analyser();
  void add_next();
  void analyse_next();
  void change(const StepWords& words, PressSet press_set, int merge_id = -1);
  void change_radii(const StepWords& words, PressSet press_set, int merge_id);
  /// Changes one press' note through `change`.
  void change_note(const StepWords& words, const std::string& name,
                   const std::function<void(PressNote&)>& change, int merge_id = -1);
  void set_press_set(const PressSet& press_set);
  void insert(const std::vector<FramePtr>& frames);
  void erase(const std::vector<FramePtr>& frames);

  QUndoStack& undo_;
  std::shared_ptr<DiskQueue> disk_;
  std::filesystem::path folder_;
  int opened_ = 0;  // count of open() calls; drops results of a former finger
  bool is_ready_ = false;
  std::optional<Error> problem_;
  std::shared_ptr<PressAnalyser> analyser_;
  std::vector<CollectedPress> presses_;
  PressSet press_set_;
  std::shared_ptr<Waiting> waiting_;
  std::deque<std::vector<std::filesystem::path>> to_add_;
  BackgroundWork loading_, analysing_, adding_;
};

}  // namespace alltact
