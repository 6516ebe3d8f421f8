#include <cstdio>
#include <iostream>
#include <new>
#include <stdexcept>

#include "cli/commands.h"

namespace gradmesh {
namespace {

int run(int argc, char** argv) {
  CLI::App program(
      "Takes needless handles and patches out of gradient meshes, without visible change.",
      "gradmesh");
  program.set_version_flag("--version", GRADMESH_VERSION);
  program.require_subcommand(1);
  try {
    add_info(program);
    add_devices(program);
    add_simplify(program);
    add_render(program);
    add_compare(program);
    add_analyze(program);
    add_draw(program);
    add_report(program);
    add_convert(program);
    add_update(program);
    add_publish(program);
    add_helper(program);
    program.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return program.exit(error) == 0 ? 0 : 2;
  } catch (const std::invalid_argument& error) {
    std::cerr << "gradmesh: " << error.what() << "\n";
    return 2;
  } catch (const std::bad_alloc&) {
    std::cerr << "gradmesh: there is not enough memory for this.\n";
    return 1;
  } catch (const std::exception& error) {
    std::cerr << "gradmesh: " << error.what() << "\n";
    return 1;
  }
  return 0;
}

}  // namespace
}  // namespace gradmesh

int main(int argc, char** argv) {
  try {
    return gradmesh::run(argc, argv);
  } catch (...) {
    // Before the first option was known, or while an error was told.
    std::fputs("gradmesh: there is not enough memory to begin.\n", stderr);
    return 1;
  }
}
