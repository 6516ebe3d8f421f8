#pragma once

#include <iosfwd>
#include <optional>
#include <stdexcept>
#include <string>

#include "service/arguments.h"

namespace gradmesh {

/// Thrown where what was read is no message of the protocol (docs/reference/helper.md).
class Garbled : public std::runtime_error {
 public:
  using runtime_error::runtime_error;
};

/// The largest number of bytes of a message: a document as large as the limit allows, in base64,
/// and more than all that goes with it.
constexpr std::size_t most_message_bytes = std::size_t(1) << 30;

/// Returns the next message; nothing at the end of the stream. Takes no more memory than there are
/// bytes, whatever length is claimed. Throws Garbled.
std::optional<Json> read_message(std::istream& in);

/// Writes a message and flushes the stream.
void write_message(std::ostream& out, const Json& message);

/// Return the text that stands for a message, and the message of a text, in which bytes are
/// {"base64": text} and numbers that are not finite {"number": "nan", "inf" or "-inf"}. What is no
/// UTF-8 is replaced. The latter throws Garbled, also for what is nested deeper than any message.
std::string message_text(Json message);
Json text_message(const std::string& text);

}  // namespace gradmesh
