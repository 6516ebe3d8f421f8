#include "service/translation.h"

#include <utility>

namespace gradmesh {
namespace {

thread_local const Ask* caller = nullptr;

}  // namespace

Caller::Caller(const Ask& ask) : before_(std::exchange(caller, &ask)) {}

Caller::~Caller() { caller = before_; }

Translation callers_translation() {
  return [](const std::string& text) {
    if (!caller) return text;
    const Json answer = (*caller)({{"ask", "translate"}, {"text", text}});
    return answer.is_string() ? answer.get<std::string>() : text;
  };
}

}  // namespace gradmesh
