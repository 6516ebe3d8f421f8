#pragma once

#include <concepts>
#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace gradmesh {

/// The text of a message with places {0}, {1}, ... for its arguments. The compiler checks that the
/// text is a literal and has a place for each of `arguments`, ten at most, and no other brace.
template <std::size_t arguments>
class MessageTemplate {
 public:
  consteval MessageTemplate(const char* text) : text_(text) {
    const std::string_view rest(text);
    bool used[10] = {};
    for (std::size_t i = 0; i < rest.size(); ++i) {
      if (rest[i] == '}') throw "a brace that closes no place";
      if (rest[i] != '{') continue;
      const std::size_t place = i + 1 < rest.size() ? std::size_t(rest[i + 1] - '0') : arguments;
      if (place >= arguments || i + 2 >= rest.size() || rest[i + 2] != '}')
        throw "a place without an argument";
      used[place] = true;
      i += 2;
    }
    for (std::size_t place = 0; place < arguments; ++place)
      if (!used[place]) throw "an argument without a place";
  }

  const char* text() const { return text_; }

 private:
  const char* text_;
};

/// Translates the template of a message into another language.
using Translation = std::function<std::string(const std::string&)>;

/// What a person is told: a template and its arguments, kept apart so that the message can be
/// translated. xgettext finds the templates by the names `Message` and `InputError`, and whoever
/// speaks to the person has the translations. Nothing here knows of languages.
class Message {
 public:
  /// Either text that is put into its place as it is, such as a name, or a message of its own.
  using Argument = std::variant<std::string, Message>;

  template <class... Arguments>
  Message(MessageTemplate<sizeof...(Arguments)> text, const Arguments&... arguments)
      : text_(text.text()) {
    (arguments_.push_back(argument(arguments)), ...);
  }

  const char* text() const { return text_; }
  const std::vector<Argument>& arguments() const { return arguments_; }

  std::string in(const Translation& translation) const;
  std::string english() const {
    return in([](const std::string& text) { return text; });
  }

 private:
  static Argument argument(std::string text) { return text; }
  static Argument argument(Message message) { return message; }
  static Argument argument(std::integral auto number) { return std::to_string(number); }

  const char* text_;
  std::vector<Argument> arguments_;
};

inline std::string Message::in(const Translation& translation) const {
  const std::string text = translation(text_);
  std::string said;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const std::size_t place = i + 2 < text.size() ? std::size_t(text[i + 1] - '0') : 0;
    if (text[i] != '{' || i + 2 >= text.size() || text[i + 2] != '}' ||
        place >= arguments_.size()) {
      said += text[i];
      continue;
    }
    const auto* const message = std::get_if<Message>(&arguments_[place]);
    said += message ? message->in(translation) : std::get<std::string>(arguments_[place]);
    i += 2;
  }
  return said;
}

}  // namespace gradmesh
