// The contacts that last over the frames of a recording, told after its frames were measured apart.
#pragma once

#include "core/result.h"
#include "core/sensing/contact/finger_contact_tracker.h"

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace alltact {

/// A frame measured by itself: its line of results.jsonl without a contact, and what decides it.
struct FrameLine {
  std::string frame;  ///< its name
  std::string line;
  bool is_measured = false;           ///< it has a depth
  double total_ms = 0;                ///< that measuring it took
  std::vector<std::string> warnings;  ///< for whoever watches; not kept
  std::string depth_packet;           ///< of the run's depth video (depth_video.h); not kept
  struct Contacts {
    ContactState::Seen seen;
    std::array<std::string, 5> texts;  ///< contact_text() of FrameContacts::by_face
    std::array<PushedFace, 5> faces{};
  };
  std::optional<Contacts> contacts;  ///< absent: the frame tells nothing of any

  /// As one line of a part's file, from which from_json() makes the same to the bit.
  [[nodiscard]] std::string to_json() const;
  /// Error without `where`: it was not made by to_json().
  [[nodiscard]] static Result<FrameLine> from_json(std::string_view text);
};

[[nodiscard]] FrameLine::Contacts contacts_of(const FrameContacts& frame);

/// Goes through frames in their order and tells which contact lasts.
class LastingContacts {
 public:
  /// False: the frames of this recording do not follow each other.
  explicit LastingContacts(bool is_continuous) : is_continuous_(is_continuous) {}

  struct Lasting {
    std::size_t which = 0;  ///< of FrameContacts::by_face
    ContactState::Told told;
  };
  /// nullopt: nothing touches. `seen`: null where the frame tells nothing of any contact.
  ///   faces: of FrameContacts::by_face
  [[nodiscard]] std::optional<Lasting> operator()(const ContactState::Seen* seen,
                                                  const std::array<PushedFace, 5>& faces);

 private:
  bool is_continuous_;
  ContactState state_;
  std::optional<PushedFace> face_;
};

/// Goes through frames in their order and completes their lines.
class ContactLines {
 public:
  explicit ContactLines(bool is_continuous) : lasting_(is_continuous) {}
  [[nodiscard]] std::string operator()(const FrameLine& frame);

 private:
  LastingContacts lasting_;
};

}  // namespace alltact
