#include "widgets/live/zero_change.h"

#include "widgets/value_change.h"

#include <QCoreApplication>

namespace alltact {
namespace {

struct ZeroWords {
  Q_DECLARE_TR_FUNCTIONS(alltact::ZeroWords)
 public:
  static QString take() { return tr("re-zero the force"); }
  static QString drop() { return tr("show the force as measured"); }
};

void change_zero(LiveSession& session,
                 QUndoStack& undo,
                 const std::optional<SessionZero>& zero,
                 StepWords what) {
  using Zero = std::optional<SessionZero>;
  undo.push(new ValueChange<Zero>(
      std::move(what), session.force_zero(), zero, [&session](const Zero& requested) {
        session.set_force_zero(requested);
      }));
}

}  // namespace

void take_zero(LiveSession& session, QUndoStack& undo, const ForceZero& zero) {
  const FingerStatus& finger = session.status().finger;
  if (!finger.finger) return;
  change_zero(
      session,
      undo,
      SessionZero{zero, QDateTime::currentDateTime(), finger.folder, finger.finger->force_model},
      ZeroWords::take);
}

void drop_zero(LiveSession& session, QUndoStack& undo) {
  if (session.force_zero()) change_zero(session, undo, std::nullopt, ZeroWords::drop);
}

}  // namespace alltact
