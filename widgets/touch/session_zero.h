// From which reading on a finger's forces count, for as long as the program runs.
#pragma once

#include "widgets/touch/touch_history.h"

#include <QDateTime>
#include <filesystem>
#include <string>

namespace alltact {

/// A zero with what it belongs to: no other finger's forces count from it, nor another model's.
struct SessionZero {
  ForceZero zero;
  QDateTime since;
  std::filesystem::path finger;  ///< folder
  std::string model;             ///< Finger::force_model
  bool operator==(const SessionZero&) const = default;
};

}  // namespace alltact
