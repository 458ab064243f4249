#include "foramen/core/remedy.hpp"

#include <algorithm>
#include <utility>

namespace foramen {

Message::Message(std::string words, std::vector<Remedy> with)
    : text(std::move(words)), remedies(std::move(with)) {}

void Message::append(const Message& more) {
  text += more.text;
  for (const Remedy& remedy : more.remedies)
    if (std::find(remedies.begin(), remedies.end(), remedy) == remedies.end()) remedies.push_back(remedy);
}

std::vector<std::string> texts_of(const std::vector<Message>& messages) {
  std::vector<std::string> texts;
  for (const Message& message : messages) texts.push_back(message.text);
  return texts;
}

std::string worded(const Message& message, std::string (*name_of)(const Remedy& remedy)) {
  if (message.remedies.empty()) return message.text;
  std::string controls;
  for (const Remedy& remedy : message.remedies) controls += (controls.empty() ? "" : "; ") + name_of(remedy);
  return message.text + " (" + controls + ")";
}

}  // namespace foramen
