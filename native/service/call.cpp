#include "service/call.h"

namespace gradmesh {

std::vector<std::uint64_t> Call::named() const {
  std::vector<std::uint64_t> numbers;
  for (const char* const name : {"document", "original", "after", "framed_as"})
    if (const auto number = get<std::optional<std::uint64_t>>(name)) numbers.push_back(*number);
  return numbers;
}

ProgressCallback Call::progress() const {
  return [this](const Progress& p) {
    const Json answer = ask_({{"ask", "progress"},
                              {"done", p.done},
                              {"total", p.total},
                              {"patches", p.patches},
                              {"error", p.error},
                              {"handles", p.handles},
                              {"mesh", p.mesh},
                              {"meshes", p.meshes}});
    return answer.is_null() || answer == true;
  };
}

std::function<void(const Image&)> Call::show() const {
  if (!get("show", false)) return {};
  return [this](const Image& picture) {
    ask_({{"ask", "show"},
          {"width", picture.width},
          {"height", picture.height},
          {"bytes", Json::binary(interleaved(picture))}});
  };
}

std::function<void(const std::string&)> Call::device_lost() const {
  return [this](const std::string& reason) { ask_({{"ask", "device_lost"}, {"reason", reason}}); };
}

}  // namespace gradmesh
