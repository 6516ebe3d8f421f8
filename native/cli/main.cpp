#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <new>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "cli/commands.h"

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace gradmesh {
namespace {

/// Returns the arguments in UTF-8, as all texts inside are, and the last one first, as CLI11 takes
/// them.
template <class Character>
std::vector<std::string> in_utf8(int argc, Character** argv) {
  std::vector<std::string> arguments;
  for (int i = argc - 1; i > 0; --i) {
    const std::u8string text = std::filesystem::path(argv[i]).u8string();
    arguments.emplace_back(text.begin(), text.end());
  }
  return arguments;
}

/// Throws std::invalid_argument if the first argument that is no option names no command: CLI11
/// would print the help where one asks for it, as if nothing were wrong. Takes the last argument
/// first.
void check_command(const CLI::App& program, const std::vector<std::string>& arguments) {
  const auto is_option = [](const std::string& argument) { return argument.starts_with('-'); };
  const auto name = std::find_if_not(arguments.rbegin(), arguments.rend(), is_option);
  if (name == arguments.rend()) return;
  const auto has_the_name = [&](const CLI::App* command) { return command->check_name(*name); };
  if (program.get_subcommands(has_the_name).empty())
    throw std::invalid_argument("there is no command \"" + *name +
                                "\"; gradmesh --help lists them.");
}

/// Keeps freed memory for what comes next. Pictures come and go, and to hand the pages of each back
/// to the system and take them anew costs up to a fifth of the time of a small mesh.
void keep_freed_memory() {
#ifdef __GLIBC__
  constexpr int mebibyte = 1 << 20;
  mallopt(M_MMAP_THRESHOLD, 32 * mebibyte);
  mallopt(M_TRIM_THRESHOLD, 64 * mebibyte);
#endif
}

template <class Character>
int run(int argc, Character** argv) {
  keep_freed_memory();
  CLI::App program(
      "Takes needless handles and patches out of gradient meshes, without visible change.",
      "gradmesh");
  program.set_version_flag("--version", GRADMESH_VERSION);
  program.require_subcommand(1);
  // A path may begin with a slash on Windows, too.
  program.allow_windows_style_options(false);
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
    add_merge(program);
    add_refine(program);
    add_color(program);
    add_one_mesh(program);
    add_publish(program);
    add_eye(program);
    add_trace(program);
    add_helper(program);
    std::vector<std::string> arguments = in_utf8(argc, argv);
    check_command(program, arguments);
    program.parse(std::move(arguments));
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

#ifdef _WIN32
// The arguments of main() are in the system's code page there, which lacks most letters.
int wmain(int argc, wchar_t** argv) {
#else
int main(int argc, char** argv) {
#endif
  try {
    return gradmesh::run(argc, argv);
  } catch (...) {
    // Before the first option was known, or while an error was told.
    std::fputs("gradmesh: there is not enough memory to begin.\n", stderr);
    return 1;
  }
}
