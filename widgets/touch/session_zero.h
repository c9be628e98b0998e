// Zero of a finger's forces, valid while the program runs.
#pragma once

#include "widgets/touch/touch_history.h"

#include <QDateTime>
#include <filesystem>
#include <string>

namespace alltact {

/// A zero with its finger and force model; it does not apply to others.
struct SessionZero {
  ForceZero zero;
  QDateTime since;
  std::filesystem::path finger;  ///< folder
  std::string model;             ///< Finger::force_model
  bool operator==(const SessionZero&) const = default;
};

}  // namespace alltact
