#include "core/base/message_json.h"

#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

namespace alltact {
namespace {

using Json = nlohmann::ordered_json;
constexpr int kDeepest = 32;  // maximum nesting of messages

std::string text_at(const Json& json, const char* key) {
  const auto value = json.find(key);
  return value != json.end() && value->is_string() ? value->get<std::string>() : std::string();
}

Message message_within(const Json& json, int depth) {
  if (json.is_string()) return Message::typed(json.get<std::string>());
  if (!json.is_object() || depth > kDeepest) return {};
  std::vector<Message> parts;
  if (const auto list = json.find("parts"); list != json.end() && list->is_array())
    for (const Json& part : *list) parts.push_back(message_within(part, depth + 1));
  if (json.contains("say"))
    return Message::compose(Message::Kind::kTemplate, text_at(json, "say"), text_at(json, "of"), -1,
                            std::move(parts));
  if (json.contains("many")) {
    const auto count = json.find("count");
    return Message::compose(
        Message::Kind::kCounted, text_at(json, "many"), text_at(json, "one"),
        count != json.end() && count->is_number_integer() ? count->get<long>() : -1,
        std::move(parts));
  }
  if (json.contains("number"))
    return Message::compose(Message::Kind::kNumber, text_at(json, "number"), {}, -1, {});
  return Message::typed(text_at(json, "text"));
}

}  // namespace

Json message_json(const Message& message) {
  Json json = Json::object();
  switch (message.kind()) {
    case Message::Kind::kTyped:
      json["text"] = message.words();
      return json;
    case Message::Kind::kNumber:
      json["number"] = message.words();
      return json;
    case Message::Kind::kTemplate:
      json["say"] = message.words();
      if (!message.context().empty()) json["of"] = message.context();
      break;
    case Message::Kind::kCounted:
      json["count"] = message.count();
      json["many"] = message.words();
      json["one"] = message.context();
      break;
  }
  if (!message.parts().empty()) {
    Json parts = Json::array();
    for (const Message& part : message.parts()) parts.push_back(message_json(part));
    json["parts"] = std::move(parts);
  }
  return json;
}

Message message_of(const Json& json) { return message_within(json, 0); }

}  // namespace alltact
