// From what each frame tells to the contact that lasts over them.
#pragma once

#include "core/finger/finger.h"
#include "core/sensing/contact/contact_state.h"
#include "core/sensing/contact/finger_contact.h"

#include <array>
#include <optional>
#include <vector>

#include <Eigen/Core>

namespace alltact {

/// All that a frame by itself tells of a contact: what was seen, and the contact as it would be
/// with each face that the frame before may have left behind.
struct FrameContacts {
  ContactState::Seen seen;
  std::array<FingerContact, 5> by_face;  ///< 0: none before; else a PushedFace
};

/// Remembers what touched in the frames before.
class FingerContactTracker {
 public:
  struct FrameSigns {
    std::optional<double> time_s;               ///< of any clock
    const FaceShape* shape = nullptr;           ///< needed
    const Markers* markers = nullptr;           ///< null: none were found
    const Push* push = nullptr;                 ///< null: no marker tells one
    const ContactSettings* settings = nullptr;  ///< needed with `push`
    const Eigen::MatrixXd* ways_px2 = nullptr;  ///< ways_covariance_px2(); needed with `push`
    const std::vector<ContactRegion>* regions = nullptr;  ///< null: no depth was told
  };
  /// nullopt: nothing touches.
  [[nodiscard]] std::optional<FingerContact> operator()(const FrameSigns& frame);
  /// Remembers nothing: for frames that are measured apart from those before them.
  [[nodiscard]] static FrameContacts alone(const FrameSigns& frame);
  /// The next frame is not the neighbour of the last one in time.
  void forget() { *this = FingerContactTracker(); }

 private:
  ContactState state_;
  std::optional<PushedFace> face_;
};

}  // namespace alltact
