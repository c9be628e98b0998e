#include "widgets/calibrating/press_collection.h"

#include "calibration/finger/calibrate_presses.h"
#include "calibration/finger/calibration_inputs.h"
#include "core/base/atomic_file.h"
#include "core/base/guarded.h"
#include "core/image/image_file.h"
#include "core/open/open_source.h"
#include "widgets/language.h"
#include "widgets/report/document.h"
#include "widgets/undo_step.h"

#include <algorithm>
#include <set>

#include <fmt/format.h>

namespace alltact {
namespace {

namespace fs = std::filesystem;

Result<FramePtr> read_press(const fs::path& file) {
  auto source = open_source({file});
  if (!source) return source.error();
  return (*source)->next();
}

FramePtr named(const FramePtr& frame, const std::string& name) {
  auto copy = std::make_shared<Frame>(*frame);
  copy->name = name;
  copy->jpeg.reset();
  return copy;
}

bool before(const CollectedPress& a, const CollectedPress& b) { return a.name < b.name; }

/// Radius of the ball to search for; 0: unknown, or no ball.
double sought_radius_mm(const PressSet& press_set, const std::string& press) {
  return press_set.of(press).is_ball() ? press_set.radius_of(press) : 0.0;
}

/// Content of the folder, read on a background thread and shown at once.
struct Found {
  std::vector<fs::path> files;
  PressSet press_set;
  std::optional<Error> problem;
};

Found find_presses(const fs::path& folder) {
  Found found;
  auto files = stored_presses(folder);
  if (files)
    found.files = std::move(*files);
  else
    found.problem = files.error();
  const auto finger = open_finger(folder);
  if (finger) {
    found.press_set = (*finger)->presses;
    if ((*finger)->presses_problem) found.problem = (*finger)->presses_problem;
  }
  return found;
}

}  // namespace

struct PressCollection::Waiting {
  std::mutex mutex;
  std::optional<PressSet> press_set;  // latest notes to write; intermediate ones are skipped
  std::set<std::string> unsaved;      // presses whose images could not be written
};

class PressCollection::AddOrRemove : public UndoStep {
 public:
  AddOrRemove(PressCollection& collection, StepWords words, std::vector<FramePtr> frames, bool adds)
      : UndoStep(std::move(words)),
        collection_(collection),
        frames_(std::move(frames)),
        adds_(adds),
        folder_(collection.folder_) {}
  void redo() override { go(adds_); }
  void undo() override { go(!adds_); }

 private:
  void go(bool adds) {
    if (collection_.folder_ != folder_) return;  // another finger is open
    adds ? collection_.insert(frames_) : collection_.erase(frames_);
  }
  PressCollection& collection_;
  std::vector<FramePtr> frames_;
  bool adds_;
  fs::path folder_;
};

PressCollection::PressCollection(QUndoStack& undo, QObject* parent)
    : QObject(parent), undo_(undo), disk_(std::make_shared<DiskQueue>()) {
  connect(&adding_, &BackgroundWork::finished, this, &PressCollection::add_next);
  connect(&analysing_, &BackgroundWork::finished, this, &PressCollection::analyse_next);
}

PressCollection::~PressCollection() = default;

std::optional<Error> PressCollection::problem() const {
  if (const auto disk = disk_->problem()) return disk;
  return problem_;
}

void PressCollection::open(const fs::path& folder) {
  ++opened_;
  if (folder != folder_) disk_->clear_problem();
  folder_ = folder;
  is_ready_ = false;
  problem_.reset();
  analyser_.reset();
  presses_.clear();
  press_set_ = {};
  waiting_ = std::make_shared<Waiting>();
  to_add_.clear();
  load();
  Q_EMIT changed();
}

void PressCollection::load() {
  if (folder_.empty()) return loading_.stop();
  loading_.restart([this, folder = folder_, opened = opened_, disk = disk_](const Job&) {
    disk->wait();
    auto found = std::make_shared<Found>(find_presses(folder));
    return std::function<void()>([this, found, opened] {
      if (opened != opened_) return;
      problem_ = found->problem;
      press_set_ = found->press_set;
      for (const fs::path& file : found->files)
        presses_.push_back({file.stem().string(), nullptr, {}, false});
      std::sort(presses_.begin(), presses_.end(), before);
      load_analyser();
      Q_EMIT changed();
    });
  });
}

/// Reads the reference, which takes seconds where it is long.
void PressCollection::load_analyser() {
  loading_.start([this, folder = folder_, opened = opened_](const Job& job) {
    auto made = std::make_shared<Result<std::shared_ptr<PressAnalyser>>>(
        PressAnalyser::create(folder, job));
    return std::function<void()>([this, made, opened] {
      if (opened != opened_) return;
      is_ready_ = true;
      if (*made)
        analyser_ = **made;
      else
        problem_ = made->error();
      analyse_next();
    });
  });
}

void PressCollection::analyse_next() {
  Q_EMIT changed();
  if (analysing_.is_running() || !analyser_) return;
  const auto next = std::find_if(presses_.begin(), presses_.end(),
                                 [](const CollectedPress& press) { return !press.is_analysed; });
  if (next == presses_.end()) return;
  analysing_.start([this, opened = opened_, name = next->name, given = next->frame,
                    file = stored_press_file(folder_, next->name), analyser = analyser_,
                    radius = sought_radius_mm(press_set_, next->name)](const Job&) {
    FramePtr frame = given;
    PressAnalysis analysis;
    if (!frame) {
      auto read = read_press(file);
      if (read && *read)
        frame = *read;
      else if (!read)
        analysis.problem = read.error();
    }
    if (frame) analysis = (*analyser)(frame, radius);
    return std::function<void()>([this, opened, name, frame, analysis, radius] {
      if (opened != opened_) return;
      const auto press = std::find_if(presses_.begin(), presses_.end(),
                                      [&](const CollectedPress& one) { return one.name == name; });
      if (press == presses_.end()) return;
      press->frame = frame;
      press->analysis = analysis;
      press->is_analysed = radius == sought_radius_mm(press_set_, name);
    });
  });
}

const CollectedPress* PressCollection::find(const std::string& name) const {
  for (const CollectedPress& press : presses_)
    if (press.name == name) return &press;
  return nullptr;
}

bool PressCollection::has_ball(const CollectedPress& press) const {
  const PressNote& note = press_set_.of(press.name);
  return note.is_ball() && (press.analysis.found_mm || note.ball_mm);
}

bool PressCollection::is_saved(const std::string& name) const {
  if (!waiting_) return true;
  const std::lock_guard lock(waiting_->mutex);
  return !waiting_->unsaved.contains(name);
}

void PressCollection::toggle_left_out(const std::string& name) {
  if (press_set_.of(name).excluded)
    use_again(name);
  else
    leave_out(name, {});
}

void PressCollection::toggle_left_out(const std::vector<std::string>& names) {
  if (names.size() == 1) return toggle_left_out(names.front());
  const bool are_all_out = std::all_of(names.begin(), names.end(), [this](const std::string& name) {
    return press_set_.of(name).excluded;
  });
  PressSet changed = press_set_;
  for (const std::string& name : names) {
    PressNote note = changed.of(name);
    if (are_all_out)
      note.excluded.reset();
    else if (!note.excluded)
      note.excluded.emplace();
    changed.say(name, std::move(note));
  }
  const int count = static_cast<int>(names.size());
  change(
      [are_all_out, count] {
        return are_all_out ? tr("put %n press(es) back", nullptr, count)
                           : tr("leave %n press(es) out", nullptr, count);
      },
      std::move(changed));
}

QString PressCollection::toggle_left_out_text(const std::string& name) const {
  return press_set_.of(name).excluded ? tr("&Put back") : tr("Leave o&ut");
}

bool PressCollection::is_usable(const CollectedPress& press) const {
  const PressNote& note = press_set_.of(press.name);
  if (note.excluded) return false;
  const bool has_face = !press.is_analysed || !press.analysis.problem;
  return has_ball(press) || (!note.is_ball() && has_face);
}

int PressCollection::usable_count() const {
  return static_cast<int>(
      std::count_if(presses_.begin(), presses_.end(),
                    [&](const CollectedPress& press) { return is_usable(press); }));
}

void PressCollection::set_press_set(const PressSet& press_set) {
  for (CollectedPress& press : presses_)
    if (sought_radius_mm(press_set, press.name) != sought_radius_mm(press_set_, press.name))
      press.is_analysed = false;
  press_set_ = press_set;
  bool is_waiting = false;
  {
    const std::lock_guard lock(waiting_->mutex);
    is_waiting = waiting_->press_set.has_value();
    waiting_->press_set = press_set_;
  }
  if (!is_waiting)
    disk_->add(folder_ / PressSet::kFileName, [waiting = waiting_, folder = folder_] {
      std::optional<PressSet> latest;
      {
        const std::lock_guard lock(waiting->mutex);
        latest.swap(waiting->press_set);
      }
      return latest ? FingerStore::of(folder)->save_presses(*latest) : Status();
    });
  analyse_next();
}

std::string PressCollection::add(std::vector<FramePtr> frames) {
  if (!is_ready_ || frames.empty()) return {};
  std::set<std::string> taken;
  for (const CollectedPress& press : presses_) taken.insert(press.name);
  for (FramePtr& frame : frames) {
    int i = 1;
    std::string name;
    do name = fmt::format("press_{:02}", i++);
    while (!taken.insert(name).second);
    frame = named(frame, name);
  }
  const std::string first = frames.front()->name;
  undo_.push(new AddOrRemove(
      *this, [first] { return tr("take %1").arg(as_text(first)); }, std::move(frames), true));
  return first;
}

void PressCollection::remove(const std::vector<std::string>& names) {
  std::vector<FramePtr> frames;
  for (const std::string& name : names)
    if (const CollectedPress* press = find(name); press != nullptr && press->frame)
      frames.push_back(press->frame);
  if (frames.empty()) return;
  const int count = static_cast<int>(frames.size());
  const StepWords words = [count, name = frames.front()->name] {
    return count > 1 ? tr("remove %n press(es)", nullptr, count)
                     : tr("remove %1").arg(as_text(name));
  };
  undo_.push(new AddOrRemove(*this, words, std::move(frames), false));
}

void PressCollection::insert(const std::vector<FramePtr>& frames) {
  for (const FramePtr& frame : frames) {
    presses_.push_back({frame->name, frame, {}, false});
    disk_->add(stored_press_file(folder_, frame->name),
               [folder = folder_, frame, waiting = waiting_] {
                 const Status written = guarded([&] { return store_press(folder, *frame); });
                 const std::lock_guard lock(waiting->mutex);
                 if (written)
                   waiting->unsaved.erase(frame->name);
                 else
                   waiting->unsaved.insert(frame->name);
                 return written;
               });
  }
  std::sort(presses_.begin(), presses_.end(), before);
  analyse_next();
}

void PressCollection::erase(const std::vector<FramePtr>& frames) {
  for (const FramePtr& frame : frames) {
    std::erase_if(presses_, [&](const CollectedPress& press) { return press.name == frame->name; });
    const fs::path file = stored_press_file(folder_, frame->name);
    disk_->add(file, [file]() -> Status {
      std::error_code failed;
      fs::remove(file, failed);
      if (!failed) return {};
      return Error{en::say("the press could not be removed: {}", failed.message()), file.string(),
                   ""};
    });
  }
  Q_EMIT changed();
}

void PressCollection::add_files(const std::vector<fs::path>& inputs) {
  to_add_.push_back(inputs);
  add_next();
}

void PressCollection::add_next() {
  if (adding_.is_running() || to_add_.empty()) return;
  const auto inputs = to_add_.front();
  to_add_.pop_front();
  adding_.start([this, inputs, opened = opened_](const Job& job) {
    auto frames = std::make_shared<std::vector<FramePtr>>();
    std::optional<Error> problem;
    auto source = open_source(inputs);
    if (!source) problem = source.error();
    while (source && !problem && !job.stop_requested()) {
      auto next = (*source)->next();
      if (!next)
        problem = next.error();
      else if (!*next)
        break;
      else
        frames->push_back(*next);
    }
    return std::function<void()>([this, frames, problem, opened] {
      if (opened != opened_) return;
      if (problem) return void(Q_EMIT refused(Problem::of(*problem, Meaning::kDoubtful)));
      QStringList twice;
      std::erase_if(*frames, [&](const FramePtr& frame) {
        if (find(frame->name) == nullptr) return false;
        twice << as_text(frame->name);
        return true;
      });
      if (!frames->empty())
        undo_.push(new AddOrRemove(
            *this,
            [count = static_cast<int>(frames->size())] {
              return tr("add %n image(s)", nullptr, count);
            },
            std::move(*frames), true));
      if (!twice.isEmpty())
        Q_EMIT refused({Meaning::kDoubtful,
                        tr("Presses with these names exist already: %1.").arg(listed(twice))});
    });
  });
}

Result<std::shared_ptr<PressAnalyser>> PressAnalyser::create(const std::filesystem::path& folder,
                                                             const Job& job) {
  const auto finger = open_finger(folder);
  if (!finger) return finger.error();
  // The settings of the last calibration, so that a forecast equals its result.
  const auto inputs = CalibrationInputs::load(folder);
  const PipelineSettings settings =
      settings_for_presses(inputs ? inputs->pipeline : PipelineSettings());
  const auto checksum = reference_checksum(folder, (*finger)->finger);
  // A mapping would replace the brightness difference by depth.
  auto pipeline = Pipeline::create((*finger)->without_mapping(), settings, job);
  if (!pipeline) return pipeline.error();
  return std::shared_ptr<PressAnalyser>(
      new PressAnalyser(PressMeter(std::move(*pipeline), checksum ? *checksum : std::string())));
}

PressAnalysis PressAnalyser::operator()(const FramePtr& frame, double radius_mm) {
  PressAnalysis analysis;
  const auto result = meter_(frame, Job());
  if (!result) {
    analysis.problem = result.error();
    return analysis;
  }
  const std::shared_ptr<const MeasuredPress>& measured = *result;
  analysis.grey = measured->grey;
  analysis.measured = measured;
  if (!measured->press) {
    if (measured->shape)
      analysis.shape = std::shared_ptr<const FaceShape>(measured, &*measured->shape);
    analysis.problem = Error{measured->left_out, "", ""};
    return analysis;
  }
  analysis.shape = std::shared_ptr<const FaceShape>(measured, &measured->press->shape);
  if (!(radius_mm > 0)) return analysis;
  Press press = *measured->press;
  press.ball_radius_mm = radius_mm;
  const auto ball = find_ball(press, finger().face);
  if (ball)
    analysis.found_mm = ball->centre_mm;
  else
    analysis.problem = Error{ball.error().what, "", ball.error().advice};
  return analysis;
}

// Changes of the press notes, each an undo step.

namespace {

// Consecutive steps with the same id are undone together.
constexpr int kRadius = 5'000'000, kOperator = 5'000'001, kGrips = 5'100'000;

}  // namespace

void PressCollection::change(const StepWords& words, PressSet press_set, int merge_id) {
  if (press_set == press_set_ || folder_.empty()) return;
  undo_.push(new ValueChange<PressSet>(
      words, press_set_, std::move(press_set),
      [this, folder = folder_](const PressSet& value) {
        if (folder == folder_) set_press_set(value);
      },
      merge_id));
}

void PressCollection::change_radii(const StepWords& words, PressSet press_set, int merge_id) {
  // Outlines drawn by hand stay the same: the ball moves within its cone of view.
  if (analyser_ && analyser_->is_perspective())
    for (auto& [name, note] : press_set.notes)
      if (const double before = press_set_.radius_of(name); note.ball_mm && before > 0)
        *note.ball_mm *= press_set.radius_of(name) / before;
  change(words, std::move(press_set), merge_id);
}

void PressCollection::change_note(const StepWords& words, const std::string& name,
                                  const std::function<void(PressNote&)>& change_it, int merge_id) {
  PressSet press_set = press_set_;
  PressNote note = press_set.of(name);
  change_it(note);
  press_set.say(name, std::move(note));
  change(words, std::move(press_set), merge_id);
}

void PressCollection::set_radius(double radius_mm) {
  if (!(radius_mm > 0)) return;
  PressSet press_set = press_set_;
  press_set.ball_radius_mm = radius_mm;
  change_radii([] { return tr("change the ball's radius"); }, std::move(press_set), kRadius);
}

void PressCollection::set_radius_of(const std::string& name, double radius_mm) {
  PressSet press_set = press_set_;
  PressNote note = press_set.of(name);
  note.ball_radius_mm.reset();
  if (radius_mm > 0 && radius_mm != press_set.ball_radius_mm) note.ball_radius_mm = radius_mm;
  press_set.say(name, std::move(note));
  change_radii([name] { return tr("change the ball's radius of %1").arg(as_text(name)); },
               std::move(press_set), -1);
}

void PressCollection::set_depth_of(const std::string& name, const GivenDepth& depth) {
  change_note(
      [name] { return tr("change the measured depth of %1").arg(as_text(name)); }, name,
      [&](PressNote& note) { note.depth = depth.mm > 0 ? std::optional(depth) : std::nullopt; });
}

void PressCollection::set_step_of(const std::string& name, double step_mm) {
  change_note(
      [name] { return tr("change the step of %1").arg(as_text(name)); }, name,
      [&](PressNote& note) { note.step_mm = step_mm > 0 ? std::optional(step_mm) : std::nullopt; });
}

void PressCollection::set_body_of(const std::string& name, const fs::path& mesh) {
  change_note([name] { return tr("change the body of %1").arg(as_text(name)); }, name,
              [&](PressNote& note) {
                note.body = mesh.empty() ? std::nullopt : std::optional(mesh.string());
              });
}

void PressCollection::set_operator(const std::string& name) {
  PressSet press_set = press_set_;
  press_set.operator_name = name;
  change([] { return tr("change the operator"); }, std::move(press_set), kOperator);
}

void PressCollection::set_ball(const std::string& name, const Eigen::Vector3d& centre_mm,
                               int grip) {
  change_note([name] { return tr("move the outline of %1").arg(as_text(name)); }, name,
              [&](PressNote& note) { note.ball_mm = centre_mm; }, kGrips + grip);
}

void PressCollection::find_ball_again(const std::string& name) {
  change_note([name] { return tr("find the ball of %1").arg(as_text(name)); }, name,
              [](PressNote& note) { note.ball_mm.reset(); });
}

void PressCollection::leave_out(const std::string& name, const std::string& because) {
  change_note([name] { return tr("leave out %1").arg(as_text(name)); }, name,
              [&](PressNote& note) { note.excluded = because; });
}

void PressCollection::use_again(const std::string& name) {
  change_note([name] { return tr("put back %1").arg(as_text(name)); }, name,
              [](PressNote& note) { note.excluded.reset(); });
}

}  // namespace alltact
