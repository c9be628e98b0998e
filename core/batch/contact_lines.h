// Determines the contacts that last over the frames of a recording, after its frames were measured
// independently.
#pragma once

#include "core/result.h"
#include "core/sensing/contact/finger_contact_tracker.h"

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace alltact {

/// Result of one frame by itself: its line of results.jsonl without a contact, and the evidence of
/// contacts.
struct FrameLine {
  std::string frame;  ///< its name
  std::string line;
  bool is_measured = false;           ///< it has a depth
  double total_ms = 0;                ///< time to measure it
  std::vector<std::string> warnings;  ///< for progress messages; not stored
  std::string depth_packet;           ///< of the run's depth video (depth_video.h); not stored
  struct Contacts {
    ContactState::Observation seen;
    std::array<std::string, 5> texts;  ///< contact_text() of FrameContacts::by_face
    std::array<PushedFace, 5> faces{};
  };
  std::optional<Contacts> contacts;  ///< empty: the frame shows no evidence

  /// One line of a part's file; from_json() restores it to the bit.
  [[nodiscard]] std::string to_json() const;
  /// Error without `where`: it was not made by to_json().
  [[nodiscard]] static Result<FrameLine> from_json(std::string_view text);
};

[[nodiscard]] FrameLine::Contacts contacts_of(const FrameContacts& frame);

/// Takes frames in order and determines which contact lasts.
class LastingContacts {
 public:
  /// False: the frames of this recording are not consecutive.
  explicit LastingContacts(bool is_continuous) : is_continuous_(is_continuous) {}

  struct Lasting {
    std::size_t which = 0;  ///< index into FrameContacts::by_face
    ContactState::Estimate estimate;
  };
  /// nullopt: there is no contact. `seen`: null where the frame has no evidence of contacts.
  ///   faces: of FrameContacts::by_face
  [[nodiscard]] std::optional<Lasting> operator()(const ContactState::Observation* seen,
                                                  const std::array<PushedFace, 5>& faces);

 private:
  bool is_continuous_;
  ContactState state_;
  std::optional<PushedFace> face_;
};

/// Takes frames in order and completes their lines.
class ContactLines {
 public:
  explicit ContactLines(bool is_continuous) : lasting_(is_continuous) {}
  [[nodiscard]] std::string operator()(const FrameLine& frame);

 private:
  LastingContacts lasting_;
};

}  // namespace alltact
