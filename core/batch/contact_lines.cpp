#include "core/batch/contact_lines.h"

#include "core/sensing/result_json.h"

#include <nlohmann/json.hpp>

namespace alltact {
namespace {

using Json = nlohmann::ordered_json;

Json seen_json(const ContactState::Observation& seen) {
  Json entry = Json::object();
  if (seen.time_s) entry["time_s"] = *seen.time_s;
  entry["strength"] = seen.strength;
  if (seen.position_mm) {
    entry["place_mm"] = {seen.position_mm->x(), seen.position_mm->y()};
    const Eigen::Matrix2d& c = seen.position_covariance_mm2;
    entry["covariance_mm2"] = {c(0, 0), c(0, 1), c(1, 0), c(1, 1)};
  }
  entry["skin_along_mm"] = seen.skin_along_mm;
  return entry;
}

ContactState::Observation seen_of(const Json& entry) {
  ContactState::Observation seen;
  if (entry.contains("time_s")) seen.time_s = entry.at("time_s").get<double>();
  seen.strength = entry.at("strength");
  if (entry.contains("place_mm")) {
    const Json &position = entry.at("place_mm"), &c = entry.at("covariance_mm2");
    seen.position_mm = Eigen::Vector2d(position.at(0), position.at(1));
    seen.position_covariance_mm2 << c.at(0), c.at(1), c.at(2), c.at(3);
  }
  seen.skin_along_mm = entry.at("skin_along_mm");
  return seen;
}

}  // namespace

FrameLine::Contacts contacts_of(const FrameContacts& frame) {
  FrameLine::Contacts contacts;
  contacts.seen = frame.seen;
  for (std::size_t i = 0; i < contacts.texts.size(); ++i) {
    contacts.texts[i] = contact_text(frame.by_face[i]);
    contacts.faces[i] = frame.by_face[i].face;
  }
  return contacts;
}

std::string FrameLine::to_json() const {
  Json json;
  json["frame"] = frame;
  json["line"] = line;
  json["measured"] = is_measured;
  json["total_ms"] = total_ms;
  if (contacts) {
    json["seen"] = seen_json(contacts->seen);
    // All five are mostly equal; each text is stored once.
    Json texts = Json::array(), which = Json::array(), faces = Json::array();
    for (std::size_t i = 0; i < contacts->texts.size(); ++i) {
      std::size_t same = 0;
      while (contacts->texts[same] != contacts->texts[i]) ++same;
      if (same == i) texts.push_back(contacts->texts[i]);
      which.push_back(same == i ? texts.size() - 1 : which.at(same).get<std::size_t>());
      faces.push_back(static_cast<int>(contacts->faces[i]));
    }
    json["contacts"] = std::move(texts);
    json["which"] = std::move(which);
    json["faces"] = std::move(faces);
  }
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

Result<FrameLine> FrameLine::from_json(std::string_view text) {
  try {
    const Json json = Json::parse(text);
    FrameLine frame;
    frame.frame = json.at("frame");
    frame.line = json.at("line");
    frame.is_measured = json.at("measured");
    frame.total_ms = json.at("total_ms");
    if (!json.contains("seen")) return frame;
    Contacts contacts;
    contacts.seen = seen_of(json.at("seen"));
    for (std::size_t i = 0; i < contacts.texts.size(); ++i) {
      const Json& part = json.at("contacts").at(json.at("which").at(i).get<std::size_t>());
      contacts.texts[i] = part.get<std::string>();
      const int face = json.at("faces").at(i);
      if (face < 1 || face > 4 || !Json::accept(contacts.texts[i])) throw std::out_of_range("face");
      contacts.faces[i] = static_cast<PushedFace>(face);
    }
    frame.contacts = std::move(contacts);
    return frame;
  } catch (const std::exception&) {
    return Error{en::say("a line of it is damaged"), "", en::say("reconstruct this part again")};
  }
}

std::optional<LastingContacts::Lasting> LastingContacts::operator()(
    const ContactState::Observation* seen, const std::array<PushedFace, 5>& faces) {
  if (!is_continuous_) {
    state_.forget();
    face_.reset();
  }
  if (seen == nullptr) return std::nullopt;
  const ContactState::Estimate estimate = state_.add(*seen);
  if (!estimate.has_contact) {
    face_.reset();
    return std::nullopt;
  }
  const std::size_t before = face_ ? static_cast<std::size_t>(*face_) : 0;
  face_ = faces[before];
  return Lasting{before, estimate};
}

std::string ContactLines::operator()(const FrameLine& frame) {
  const auto& contacts = frame.contacts;
  const auto lasting =
      contacts ? lasting_(&contacts->seen, contacts->faces) : lasting_(nullptr, {});
  return lasting ? with_contact(frame.line, contacts->texts[lasting->which], lasting->estimate)
                 : frame.line;
}

}  // namespace alltact
