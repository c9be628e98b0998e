#include "widgets/calibrating/press_model.h"

#include "widgets/language.h"
#include "widgets/report/report_words.h"

#include <QFont>
#include <QPixmap>
#include <algorithm>

namespace alltact {
namespace {

QString punch_state_text(double step_mm, const CollectedPress& press, const StepFit* fit) {
  if (fit != nullptr && fit->step_mm == step_mm)
    return PressModel::tr("a step of %1 mm reads %2 mm")
        .arg(local_mm(fit->step_mm, 3), local_mm(fit->estimated_mm, 3));
  if (press.is_analysed && press.analysis.problem) return refusal_word(*press.analysis.problem);
  return PressModel::tr("a punch with a step of %1 mm").arg(local_mm(step_mm, 3));
}

QString ball_state_text(const BallFit& ball) {
  const QString depth = local_mm(ball.depth_mm, 2);
  const auto error = press_error_mm(ball);
  const QString found =
      error ? PressModel::tr("%1 mm deep, error %2 mm: %3")
                  .arg(depth, local_mm(*error, 3), error_word(meaning_of_error(*error)))
            : PressModel::tr("%1 mm deep, error unknown").arg(depth);
  if (!ball.given_depth) return found;
  return found + QLatin1Char('\n') +
         PressModel::tr("measured %1 mm deep, the solution has %2 mm")
             .arg(local_mm(ball.given_depth->mm, 3), local_mm(ball.indentation_mm, 3));
}

}  // namespace

const BallFit* fitted_ball(const CalibrationRun& run, const std::string& press) {
  if (!run.result()) return nullptr;
  for (const BallFit& ball : run.result()->calibration.balls)
    if (ball.press == press) return &ball;
  return nullptr;
}

const StepFit* fitted_step(const CalibrationRun& run, const std::string& press) {
  if (!run.result()) return nullptr;
  for (const StepFit& step : run.result()->calibration.steps)
    if (step.press == press) return &step;
  return nullptr;
}

QString press_state_text(const CollectedPress& press,
                         const PressCollection& collection,
                         const CalibrationRun& run) {
  const PressNote& note = collection.press_set().of(press.name);
  if (!collection.is_saved(press.name)) return PressModel::tr("not written to the disk");
  if (note.excluded)
    return note.excluded->empty() ? PressModel::tr("taken out")
                                  : PressModel::tr("taken out: %1").arg(as_text(*note.excluded));
  if (note.step_mm) return punch_state_text(*note.step_mm, press, fitted_step(run, press.name));
  if (const BallFit* ball = fitted_ball(run, press.name)) return ball_state_text(*ball);
  if (note.ball_mm) return PressModel::tr("ball put by hand");
  if (!press.is_analysed) return PressModel::tr("being looked at");
  if (press.analysis.found_mm) return PressModel::tr("ball found");
  if (press.analysis.problem)
    return press.analysis.shape || press.analysis.grey.empty()
               ? refusal_word(*press.analysis.problem)
               : PressModel::tr("no face seen");
  return PressModel::tr("the ball's radius is missing");
}

std::optional<Meaning> press_meaning(const CollectedPress& press,
                                     const PressCollection& collection,
                                     const CalibrationRun& run) {
  const PressNote& note = collection.press_set().of(press.name);
  if (!collection.is_saved(press.name)) return Meaning::kBad;
  if (note.excluded) return std::nullopt;
  if (!note.step_mm)
    if (const BallFit* ball = fitted_ball(run, press.name))
      if (const auto error = press_error_mm(*ball)) return meaning_of_error(*error);
  if (press.is_analysed && press.analysis.problem && !note.ball_mm) return Meaning::kDoubtful;
  return std::nullopt;
}

PressModel::PressModel(const PressCollection& collection,
                       const CalibrationRun& run,
                       QObject* parent)
    : QAbstractListModel(parent), collection_(collection), run_(run) {
  connect(&collection_, &PressCollection::changed, this, &PressModel::follow);
  connect(&run_, &CalibrationRun::changed, this, &PressModel::follow);
  follow();
}

void PressModel::follow() {
  std::vector<std::string> names;
  for (const CollectedPress& press : collection_.presses()) names.push_back(press.name);
  const auto error = [this](const std::string& name) {
    const BallFit* ball =
        collection_.press_set().of(name).excluded ? nullptr : fitted_ball(run_, name);
    return ball == nullptr ? 0.0 : press_error_mm(*ball).value_or(0.0);
  };
  std::stable_sort(names.begin(), names.end(), [&](const auto& a, const auto& b) {
    return error(a) > error(b);
  });
  if (names != names_) {
    beginResetModel();
    names_ = std::move(names);
    endResetModel();
  } else if (!names_.empty()) {
    Q_EMIT dataChanged(index(0), index(static_cast<int>(names_.size()) - 1));
  }
}

int PressModel::row_of(const std::string& name) const {
  const auto found = std::find(names_.begin(), names_.end(), name);
  return found == names_.end() ? -1 : static_cast<int>(found - names_.begin());
}

std::string PressModel::name_at(int row) const {
  return row < 0 || row >= rowCount() ? std::string() : names_[static_cast<std::size_t>(row)];
}

int PressModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(names_.size());
}

QVariant PressModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid() || index.row() >= rowCount()) return {};
  const CollectedPress* press = collection_.find(name_at(index.row()));
  if (press == nullptr) return {};
  switch (role) {
    case Qt::DisplayRole:
      return QStringLiteral("%1\n%2").arg(as_text(press->name),
                                          press_state_text(*press, collection_, run_));
    case Qt::ToolTipRole:
      return press->analysis.problem
                 ? in_window_language(en::say("{}.", press->analysis.problem->message()))
                 : QString();
    case Qt::DecorationRole: {
      const QPixmap thumbnail = thumbnails_.of(
          *press, known_ball(*press, collection_, run_), press_meaning(*press, collection_, run_));
      return thumbnail.isNull() ? QVariant() : thumbnail;
    }
    case Qt::FontRole: {
      QFont font;
      font.setStrikeOut(collection_.press_set().of(press->name).excluded.has_value());
      return font;
    }
    case kName:
      return as_text(press->name);
    default:
      return {};
  }
}

}  // namespace alltact
