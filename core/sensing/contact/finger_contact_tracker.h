// Tracks the contact of a finger over the frames of a source.
#pragma once

#include "core/finger/finger.h"
#include "core/sensing/contact/contact_state.h"
#include "core/sensing/contact/finger_contact.h"

#include <array>
#include <optional>
#include <vector>

#include <Eigen/Core>

namespace alltact {

/// All evidence of one frame: the observation, and the contact for each face that the frame before
/// may have had.
struct FrameContacts {
  ContactState::Observation seen;
  std::array<FingerContact, 5> by_face;  ///< 0: none before; else a PushedFace
};

/// Stores the contact of the frames before.
class FingerContactTracker {
 public:
  struct FrameInput {
    std::optional<double> time_s;               ///< of any clock
    const FaceShape* shape = nullptr;           ///< required
    const Markers* markers = nullptr;           ///< null: none were found
    const Push* push = nullptr;                 ///< null: no marker shows one
    const ContactSettings* settings = nullptr;  ///< required with `push`
    /// displacement_covariance_px2(); required with `push`
    const Eigen::MatrixXd* displacement_cov_px2 = nullptr;
    const std::vector<ContactRegion>* regions = nullptr;  ///< null: there is no depth
  };
  /// nullopt: there is no contact.
  [[nodiscard]] std::optional<FingerContact> operator()(const FrameInput& frame);
  /// Uses no state: for frames that are measured independently of those before them.
  [[nodiscard]] static FrameContacts single_frame(const FrameInput& frame);
  /// Resets the state: the next frame does not follow the last one in time.
  void forget() { *this = FingerContactTracker(); }

 private:
  ContactState state_;
  std::optional<PushedFace> face_;
};

}  // namespace alltact
