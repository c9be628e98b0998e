// Re-zeroing the force, as undo steps.
#pragma once

#include "widgets/live/live_session.h"

#include <QUndoStack>

namespace alltact {

/// Sets this reading of the live finger as zero force. `zero` is the reading that the user saw,
/// whatever was measured since. Does nothing without a finger. Session and stack outlive the steps.
void take_zero(LiveSession& session, QUndoStack& undo, const ForceZero& zero);
/// Shows forces as measured again.
void drop_zero(LiveSession& session, QUndoStack& undo);

}  // namespace alltact
