#include "helper/wire.h"

#include <algorithm>
#include <cmath>
#include <istream>
#include <limits>
#include <ostream>

#include "files/base64.h"

namespace gradmesh {
namespace {

constexpr int most_nesting = 32;
constexpr const char* bytes_key = "base64";
constexpr const char* number_key = "number";

/// Calls `change` for each value, those inside of others first.
template <class Change>
void for_each_value(Json& json, const Change& change) {
  if (json.is_structured())
    for (Json& member : json) for_each_value(member, change);
  change(json);
}

std::string name_of(double number) {
  if (std::isnan(number)) return "nan";
  return number < 0 ? "-inf" : "inf";
}

double number_named(const std::string& name) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if (name == "inf") return infinity;
  if (name == "-inf") return -infinity;
  if (name == "nan") return std::numeric_limits<double>::quiet_NaN();
  throw Garbled("'" + name + "' is no number.");
}

void make_plain(Json& json) {
  if (json.is_binary()) {
    const auto& bytes = json.get_binary();
    json = {{bytes_key, base64({reinterpret_cast<const char*>(bytes.data()), bytes.size()})}};
  } else if (json.is_number_float() && !std::isfinite(json.get<double>())) {
    json = {{number_key, name_of(json.get<double>())}};
  }
}

void restore(Json& json) {
  if (!json.is_object() || json.size() != 1 || !json.begin()->is_string()) return;
  const std::string text = json.begin()->get<std::string>();
  if (json.begin().key() == bytes_key) {
    const auto bytes = base64_bytes(text);
    if (!bytes) throw Garbled("bytes are no base64.");
    json = Json::binary({bytes->begin(), bytes->end()});
  } else if (json.begin().key() == number_key) {
    json = number_named(text);
  }
}

/// Returns the length of a message, which stands on a line before it; nothing at the end.
std::optional<std::size_t> read_length(std::istream& in) {
  constexpr int most_digits = 10;
  std::size_t length = 0;
  int digits = 0;
  for (int c; (c = in.get()) != std::istream::traits_type::eof(); ++digits) {
    if (c == '\n' && digits > 0 && length <= most_message_bytes) return length;
    if (c < '0' || c > '9' || digits == most_digits) throw Garbled("a message has no length.");
    length = 10 * length + std::size_t(c - '0');
  }
  if (digits > 0) throw Garbled("a message ends within its length.");
  return std::nullopt;
}

}  // namespace

std::string message_text(Json message) {
  for_each_value(message, make_plain);
  return message.dump(-1, ' ', false, Json::error_handler_t::replace);
}

Json text_message(const std::string& text) {
  const auto check = [](int depth, Json::parse_event_t, const Json&) {
    if (depth > most_nesting) throw Garbled("a message is nested too deep.");
    return true;
  };
  constexpr const char* no_json = "a message is no JSON.";
  // For the parser a null character, which JSON never holds, is the end of the text.
  if (text.find('\0') != text.npos) throw Garbled(no_json);
  Json message;
  try {
    message = Json::parse(text, check);
  } catch (const Json::exception&) {
    throw Garbled(no_json);
  }
  for_each_value(message, restore);
  return message;
}

std::optional<Json> read_message(std::istream& in) {
  const auto length = read_length(in);
  if (!length) return std::nullopt;
  std::string text;
  while (text.size() < *length) {
    constexpr std::size_t part = std::size_t(1) << 20;
    const std::size_t before = text.size();
    text.resize(before + std::min(part, *length - before));
    if (!in.read(text.data() + before, std::streamsize(text.size() - before)))
      throw Garbled("a message is shorter than its length.");
  }
  return std::make_optional(text_message(text));
}

void write_message(std::ostream& out, const Json& message) {
  const std::string text = message_text(message);
  out << text.size() << '\n' << text << std::flush;
}

}  // namespace gradmesh
