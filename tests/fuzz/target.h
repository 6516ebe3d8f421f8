#pragma once

#include <cstdio>
#include <cstdlib>
#include <string_view>
#include <vector>

#include "base/error.h"
#include "mesh/mesh.h"
#include "mesh/validate.h"

namespace gradmesh::fuzz {

/// The fuzz target, which each program defines. It returns, whatever the bytes are: the answer to
/// bad input is an InputError, which the target takes; everything else ends the program. libFuzzer
/// calls it with bytes of its own making (preset `fuzz`), the tests of every other build with those
/// of corpus/.
void check(std::string_view bytes);

/// The file's name in messages.
inline constexpr const char* input_name = "input";

/// Ends the program where `holds` is false, so that the input is kept.
inline void require(bool holds, const char* what) {
  if (holds) return;
  std::fprintf(stderr, "Not so: %s.\n", what);
  std::abort();
}

inline void require_sound(const Mesh& mesh) {
  const std::vector<std::string> broken = validate(mesh);
  if (!broken.empty()) std::fprintf(stderr, "%s\n", broken.front().c_str());
  require(broken.empty(), "the mesh is sound");
}

/// One sentence for a person: one line that ends in a full stop and has no control characters,
/// whatever of the input it quotes.
inline void require_sentence(std::string_view message) {
  bool is_line = !message.empty() && message.back() == '.';
  for (const char c : message) is_line = is_line && (c < 0 || c >= ' ') && c != '\x7f';
  if (!is_line) std::fprintf(stderr, "%.*s\n", int(message.size()), message.data());
  require(is_line, "the message is one line with a full stop");
}

/// Does `work`; false where it ends in an InputError.
template <class Work>
bool accepts(const Work& work) {
  try {
    work();
    return true;
  } catch (const InputError& error) {
    require_sentence(error.what());
    return false;
  }
}

/// Does `work`, which bad input is no excuse for not doing.
template <class Work>
void must_accept(const Work& work, const char* what) {
  try {
    work();
  } catch (const InputError& error) {
    std::fprintf(stderr, "%s\n", error.what());
    require(false, what);
  }
}

}  // namespace gradmesh::fuzz
