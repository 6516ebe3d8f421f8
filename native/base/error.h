#pragma once

#include <cstddef>
#include <stdexcept>

#include "base/message.h"

namespace gradmesh {

/// Thrown for bad input and for files that cannot be read or written. The message is one plain
/// sentence for the person, which names the file and the element where there is one. `what()` is
/// that sentence in English.
class InputError : public std::runtime_error {
 public:
  explicit InputError(Message message)
      : runtime_error(message.english()), message_(std::move(message)) {}
  template <class... Arguments>
  explicit InputError(MessageTemplate<sizeof...(Arguments)> text, const Arguments&... arguments)
      : InputError(Message(text, arguments...)) {}

  const Message& message() const { return message_; }

 private:
  Message message_;
};

}  // namespace gradmesh
