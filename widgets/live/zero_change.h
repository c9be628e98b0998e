// Re-zeroing the force, as steps that can be undone.
#pragma once

#include "widgets/live/live_session.h"

#include <QUndoStack>

namespace alltact {

/// A reading of the live finger counts as no force: the one its user saw, whatever came since. Does
/// nothing where there is no finger. Session and stack outlive the steps.
void take_zero(LiveSession& session, QUndoStack& undo, const ForceZero& zero);
/// Forces count as measured again.
void drop_zero(LiveSession& session, QUndoStack& undo);

}  // namespace alltact
