// Re-zeroing the force, as steps that can be undone.
#pragma once

#include "widgets/live/live_session.h"

#include <QUndoStack>

namespace alltact {

/// The present reading of the live finger counts as no force. Does nothing where there is none.
/// Both outlive the steps.
void take_zero(LiveSession& session, QUndoStack& undo);
/// Forces count as measured again.
void drop_zero(LiveSession& session, QUndoStack& undo);

}  // namespace alltact
