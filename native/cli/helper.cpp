#include "helper/helper.h"

#include <iostream>

#include "cli/commands.h"

#ifdef _WIN32
#include <fcntl.h>
#include <io.h>

#include <cstdio>
#endif

namespace gradmesh {
namespace {

/// Makes bytes on standard input and output come and go as they are.
void use_binary_pipes() {
#ifdef _WIN32
  _setmode(_fileno(stdin), _O_BINARY);
  _setmode(_fileno(stdout), _O_BINARY);
#endif
  std::ios::sync_with_stdio(false);
  // Reading happens on a thread of its own and must not flush what another one writes.
  std::cin.tie(nullptr);
}

}  // namespace

void add_helper(CLI::App& program) {
  CLI::App& command = *program.add_subcommand(
      "helper", "Work for another program that asks on standard input, such as the Python package");
  command.callback([] {
    use_binary_pipes();
    if (run_helper(std::cin, std::cout) != 0)
      throw std::runtime_error("what was read is none of the helper's messages.");
  });
}

}  // namespace gradmesh
