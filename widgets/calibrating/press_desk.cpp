#include "widgets/calibrating/press_desk.h"

#include "calibration/finger/calibration_inputs.h"
#include "core/io/atomic_file.h"
#include "core/io/picture.h"
#include "core/sources/open/open_source.h"
#include "widgets/joined_words.h"
#include "widgets/report/report_words.h"

#include <algorithm>
#include <set>

#include <fmt/format.h>

namespace alltact {
namespace {

namespace fs = std::filesystem;

fs::path file_of(const fs::path& folder, const std::string& name) {
  return folder / kPressFolder / (name + ".png");
}

Status write_press(const fs::path& folder, const Frame& frame) {
  if (const Status made = make_folder(folder / kPressFolder); !made) return made;
  return write_picture(
      file_of(folder, frame.name), frame.grey, frame.controls ? *frame.controls : std::string());
}

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

bool before(const DeskPress& a, const DeskPress& b) {
  return a.name < b.name;
}

/// Of the ball that a press is searched for; 0: not told, or there is none.
double sought_mm(const PressSet& said, const std::string& press) {
  return said.of(press).step_mm ? 0.0 : said.radius_of(press);
}

/// What is in the folder, as a background thread found it: known at once.
struct Found {
  std::vector<fs::path> files;
  PressSet said;
  std::optional<Error> problem;
};

Found find_presses(const fs::path& folder) {
  Found found;
  auto files = kept_presses(folder);
  if (files)
    found.files = std::move(*files);
  else
    found.problem = files.error();
  const auto finger = open_finger(folder);
  if (finger) {
    found.said = (*finger)->presses;
    if ((*finger)->presses_problem) found.problem = (*finger)->presses_problem;
  }
  return found;
}

}  // namespace

struct PressDesk::Waiting {
  std::mutex mutex;
  std::optional<PressSet> said;  // of what changes quickly only the latest is written
  std::set<std::string> unkept;  // presses whose pictures could not be written
};

class PressDesk::AddOrRemove : public UndoStep {
 public:
  AddOrRemove(PressDesk& desk, StepWords words, std::vector<FramePtr> frames, bool adds)
      : UndoStep(std::move(words)),
        desk_(desk),
        frames_(std::move(frames)),
        adds_(adds),
        folder_(desk.folder_) {}
  void redo() override { go(adds_); }
  void undo() override { go(!adds_); }

 private:
  void go(bool adds) {
    if (desk_.folder_ != folder_) return;  // another finger is open: its presses are its own
    adds ? desk_.insert(frames_) : desk_.erase(frames_);
  }
  PressDesk& desk_;
  std::vector<FramePtr> frames_;
  bool adds_;
  fs::path folder_;
};

PressDesk::PressDesk(QUndoStack& undo, QObject* parent)
    : QObject(parent), undo_(undo), disk_(std::make_shared<DiskQueue>()) {
  connect(&adding_, &BackgroundWork::finished, this, &PressDesk::add_next);
  connect(&looking_, &BackgroundWork::finished, this, &PressDesk::look_at_next);
}

PressDesk::~PressDesk() = default;

std::optional<Error> PressDesk::problem() const {
  if (const auto disk = disk_->problem()) return disk;
  return problem_;
}

void PressDesk::open(const fs::path& folder) {
  ++opened_;
  if (folder != folder_) disk_->forget_problem();
  folder_ = folder;
  is_ready_ = false;
  problem_.reset();
  looker_.reset();
  presses_.clear();
  said_ = {};
  waiting_ = std::make_shared<Waiting>();
  to_add_.clear();
  load();
  Q_EMIT changed();
}

void PressDesk::load() {
  if (folder_.empty()) return loading_.stop();
  loading_.restart([this, folder = folder_, opened = opened_, disk = disk_](const Job&) {
    disk->wait();
    auto found = std::make_shared<Found>(find_presses(folder));
    return std::function<void()>([this, found, opened] {
      if (opened != opened_) return;
      problem_ = found->problem;
      said_ = found->said;
      for (const fs::path& file : found->files)
        presses_.push_back({file.stem().string(), nullptr, {}, false});
      std::sort(presses_.begin(), presses_.end(), before);
      load_looker();
      Q_EMIT changed();
    });
  });
}

/// Reads the reference, which takes seconds where it is long.
void PressDesk::load_looker() {
  loading_.start([this, folder = folder_, opened = opened_](const Job& job) {
    auto made =
        std::make_shared<Result<std::shared_ptr<PressLooker>>>(PressLooker::create(folder, job));
    return std::function<void()>([this, made, opened] {
      if (opened != opened_) return;
      is_ready_ = true;
      if (*made)
        looker_ = **made;
      else
        problem_ = made->error();
      look_at_next();
    });
  });
}

void PressDesk::look_at_next() {
  Q_EMIT changed();
  if (looking_.is_running() || !looker_) return;
  const auto next = std::find_if(
      presses_.begin(), presses_.end(), [](const DeskPress& press) { return !press.is_looked_at; });
  if (next == presses_.end()) return;
  looking_.start([this,
                  opened = opened_,
                  name = next->name,
                  given = next->frame,
                  file = file_of(folder_, next->name),
                  looker = looker_,
                  radius = sought_mm(said_, next->name)](const Job&) {
    FramePtr frame = given;
    LookedAt looked;
    if (!frame) {
      auto read = read_press(file);
      if (read && *read)
        frame = *read;
      else if (!read)
        looked.problem = read.error();
    }
    if (frame) looked = (*looker)(frame, radius);
    return std::function<void()>([this, opened, name, frame, looked, radius] {
      if (opened != opened_) return;
      const auto press = std::find_if(
          presses_.begin(), presses_.end(), [&](const DeskPress& one) { return one.name == name; });
      if (press == presses_.end()) return;
      press->frame = frame;
      press->looked = looked;
      press->is_looked_at = radius == sought_mm(said_, name);
    });
  });
}

const DeskPress* PressDesk::find(const std::string& name) const {
  for (const DeskPress& press : presses_)
    if (press.name == name) return &press;
  return nullptr;
}

bool PressDesk::has_ball(const DeskPress& press) const {
  const PressNote& note = said_.of(press.name);
  return !note.step_mm && (press.looked.found_mm || note.ball_mm);
}

bool PressDesk::is_kept(const std::string& name) const {
  if (!waiting_) return true;
  const std::lock_guard lock(waiting_->mutex);
  return !waiting_->unkept.contains(name);
}

void PressDesk::take_out_or_put_back(const std::string& name) {
  if (said_.of(name).excluded)
    put_back(name);
  else
    take_out(name, {});
}

QString PressDesk::words_to_take_out_or_put_back(const std::string& name) const {
  return said_.of(name).excluded ? tr("&Put back") : tr("Take &out");
}

bool PressDesk::is_usable(const DeskPress& press) const {
  const PressNote& note = said_.of(press.name);
  if (note.excluded) return false;
  const bool has_face = !press.is_looked_at || !press.looked.problem;
  return has_ball(press) || (note.step_mm && has_face);
}

int PressDesk::usable_count() const {
  return static_cast<int>(std::count_if(
      presses_.begin(), presses_.end(), [&](const DeskPress& press) { return is_usable(press); }));
}

void PressDesk::set_said(const PressSet& said) {
  for (DeskPress& press : presses_)
    if (sought_mm(said, press.name) != sought_mm(said_, press.name)) press.is_looked_at = false;
  said_ = said;
  bool is_waiting = false;
  {
    const std::lock_guard lock(waiting_->mutex);
    is_waiting = waiting_->said.has_value();
    waiting_->said = said_;
  }
  if (!is_waiting)
    disk_->add([waiting = waiting_, folder = folder_] {
      std::optional<PressSet> latest;
      {
        const std::lock_guard lock(waiting->mutex);
        latest.swap(waiting->said);
      }
      return latest ? FingerStore::of(folder)->keep_presses(*latest) : Status();
    });
  look_at_next();
}

std::string PressDesk::add(std::vector<FramePtr> frames) {
  if (!is_ready_ || frames.empty()) return {};
  std::set<std::string> taken;
  for (const DeskPress& press : presses_) taken.insert(press.name);
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

void PressDesk::remove(const std::string& name) {
  const DeskPress* press = find(name);
  if (press == nullptr || !press->frame) return;
  undo_.push(new AddOrRemove(
      *this, [name] { return tr("remove %1").arg(as_text(name)); }, {press->frame}, false));
}

void PressDesk::insert(const std::vector<FramePtr>& frames) {
  for (const FramePtr& frame : frames) {
    presses_.push_back({frame->name, frame, {}, false});
    disk_->add([folder = folder_, frame, waiting = waiting_] {
      const Status written = write_press(folder, *frame);
      const std::lock_guard lock(waiting->mutex);
      if (written)
        waiting->unkept.erase(frame->name);
      else
        waiting->unkept.insert(frame->name);
      return written;
    });
  }
  std::sort(presses_.begin(), presses_.end(), before);
  look_at_next();
}

void PressDesk::erase(const std::vector<FramePtr>& frames) {
  for (const FramePtr& frame : frames) {
    std::erase_if(presses_, [&](const DeskPress& press) { return press.name == frame->name; });
    disk_->add([file = file_of(folder_, frame->name)]() -> Status {
      std::error_code failed;
      fs::remove(file, failed);
      if (!failed) return {};
      return Error{
          en::say("the press could not be removed: {}", failed.message()), file.string(), ""};
    });
  }
  Q_EMIT changed();
}

void PressDesk::add_files(const std::vector<fs::path>& inputs) {
  to_add_.push_back(inputs);
  add_next();
}

void PressDesk::add_next() {
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
              return tr("add %n picture(s)", nullptr, count);
            },
            std::move(*frames),
            true));
      if (!twice.isEmpty())
        Q_EMIT refused({Meaning::kDoubtful,
                        tr("There are presses of these names already: %1.").arg(listed(twice)),
                        {},
                        {},
                        {}});
    });
  });
}

}  // namespace alltact
