#include "base/limits.h"

#include <charconv>
#include <cstdlib>
#include <limits>
#include <stdexcept>
#include <string>

namespace gradmesh {
namespace {

struct Entry {
  std::string_view name;
  std::uint64_t Limits::*value;
  std::uint64_t most = std::numeric_limits<std::uint64_t>::max();
};

// `most` keeps elements to the stack of a thread, and pixels to a number that an int holds.
constexpr Entry entries[] = {
    {"document", &Limits::document},
    {"patches", &Limits::patches},
    {"nesting", &Limits::nesting, 5000},
    {"links", &Limits::links},
    {"resolution", &Limits::resolution, 16384},
    {"memory", &Limits::memory},
};

[[noreturn]] void refuse(std::string_view part) {
  std::string names;
  for (const Entry& e : entries) names += (names.empty() ? "" : ", ") + std::string(e.name);
  throw std::invalid_argument("GRADMESH_LIMITS: \"" + std::string(part) +
                              "\" is no limit with a possible number; there are " + names + ".");
}

void set(Limits& limits, std::string_view part) {
  const std::size_t equals = part.find('=');
  if (equals == part.npos) refuse(part);
  std::string_view number = part.substr(equals + 1);
  int shift = 0;
  for (const auto& [suffix, bits] : {std::pair{'K', 10}, {'M', 20}, {'G', 30}})
    if (number.ends_with(suffix)) {
      number.remove_suffix(1);
      shift = bits;
      break;
    }
  std::uint64_t value = 0;
  const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), value);
  for (const Entry& e : entries)
    if (e.name == part.substr(0, equals) && error == std::errc() && value > 0 &&
        end == number.data() + number.size() && value <= (e.most >> shift)) {
      limits.*e.value = value << shift;
      return;
    }
  refuse(part);
}

}  // namespace

Limits limits_from(std::string_view text) {
  Limits limits;
  while (!text.empty()) {
    const std::size_t comma = std::min(text.find(','), text.size());
    set(limits, text.substr(0, comma));
    text.remove_prefix(std::min(comma + 1, text.size()));
  }
  return limits;
}

const Limits& limits() {
  static const Limits from_environment = [] {
    const char* const text = std::getenv("GRADMESH_LIMITS");
    return limits_from(text ? text : "");
  }();
  return from_environment;
}

Message beyond_limit(std::string_view name, std::uint64_t limit, std::uint64_t needed) {
  return Message("more than the limit of {0}, which GRADMESH_LIMITS={1}={2} raises", limit,
                 std::string(name), needed);
}

}  // namespace gradmesh
