// A number given for a calibration that its presses contradict.
#pragma once

#include "core/base/message.h"
#include "core/finger/finger.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace alltact {

enum class ContradictionKind {
  kContactWiderThanBall = 1,  ///< a dark part is wider than the ball itself
  kContactDeeperThanLayer,    ///< a ball lies deeper than the layer is thick
  kDepthBeyondMapping,        ///< a press is darker than the mapping reaches
  kFaceWidthAgainstCamera,    ///< the face's edges and the camera give another width
  kReferenceContact,          ///< skin is brighter in presses than in the reference
};
/// As finger.yaml writes it: "contact_wider_than_ball", ...
[[nodiscard]] std::string_view to_string(ContradictionKind kind);

struct Contradiction {
  ContradictionKind kind;
  std::vector<std::string> presses;  ///< that show it, by name
  double given_mm = 0;               ///< the number: a ball's radius, the layer, the width, a depth
  /// in the presses: the smallest value, or a position along the face
  double measured_mm = 0;
  double measured_to_mm = 0;  ///< the greatest; 0: as measured_mm
  int of = 0;                 ///< presses that were analysed
};

/// The number is certainly wrong, so that no depth is valid: the grade is unfit at best.
[[nodiscard]] bool rules_out_use(ContradictionKind kind);

/// The two sides of the contradiction, and what to check.
[[nodiscard]] Message sentence(const Contradiction& contradiction);

/// The form stored in finger.yaml, where presses are counted, and back; nullopt for a kind of a
/// later version.
[[nodiscard]] RecordedContradiction recorded(const Contradiction& contradiction);
[[nodiscard]] std::optional<Contradiction> from_record(const RecordedContradiction& recorded);

}  // namespace alltact
