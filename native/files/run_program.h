#pragma once

#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

namespace gradmesh {

/// How the run of a program ended.
enum class ProgramEnd {
  done,         ///< with the exit status 0
  failed,       ///< with another one, or by a signal
  not_started,  ///< there is no such program, or it cannot be run
  out_of_time   ///< it took longer than the limit, and was killed
};

/// Runs a program with these arguments, the first of which names it, and waits for its end. No
/// shell sees them; a name without a slash is looked for in PATH. The program reads nothing, what
/// it writes to its standard output and error is discarded, and `temporary` is its folder for
/// temporary files. Not on Windows.
ProgramEnd run_program(const std::vector<std::string>& command,
                       const std::filesystem::path& temporary, std::chrono::milliseconds limit);

}  // namespace gradmesh
