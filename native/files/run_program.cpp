#include "files/run_program.h"

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/types.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <string_view>
#include <thread>

#ifdef __APPLE__
#include <crt_externs.h>
#else
extern char** environ;
#endif

namespace gradmesh {
namespace {

using Clock = std::chrono::steady_clock;

/// The standard streams of a program that nobody talks to.
class SilentStreams {
 public:
  SilentStreams() {
    posix_spawn_file_actions_init(&actions_);
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
      posix_spawn_file_actions_addopen(&actions_, stream, "/dev/null", O_RDWR, 0);
  }
  ~SilentStreams() { posix_spawn_file_actions_destroy(&actions_); }
  SilentStreams(const SilentStreams&) = delete;
  SilentStreams& operator=(const SilentStreams&) = delete;

  const posix_spawn_file_actions_t* actions() const { return &actions_; }

 private:
  posix_spawn_file_actions_t actions_;
};

char** own_environment() {
#ifdef __APPLE__
  // A library of macOS does not see `environ`.
  return *_NSGetEnviron();
#else
  return environ;
#endif
}

/// Returns the environment of this program, with another folder for temporary files.
std::vector<std::string> environment(const std::filesystem::path& temporary) {
  constexpr std::string_view key = "TMPDIR=";
  std::vector<std::string> entries{std::string(key) + temporary.string()};
  for (char** entry = own_environment(); entry && *entry; ++entry)
    if (!std::string_view(*entry).starts_with(key)) entries.emplace_back(*entry);
  return entries;
}

/// Returns the texts as C takes them, ended by null. They are not copied.
std::vector<char*> as_c_takes(std::vector<std::string>& texts) {
  std::vector<char*> pointers;
  for (std::string& text : texts) pointers.push_back(text.data());
  pointers.push_back(nullptr);
  return pointers;
}

/// Waits for a program to end. Kills it where the time is over.
ProgramEnd end_of(pid_t program, Clock::time_point over) {
  // Asked again and again, as no call that waits for a program has a limit on every system.
  constexpr std::chrono::milliseconds pause(10);
  for (int status = 0;;) {
    const pid_t ended = waitpid(program, &status, WNOHANG);
    if (ended == program)
      return WIFEXITED(status) && WEXITSTATUS(status) == 0 ? ProgramEnd::done : ProgramEnd::failed;
    // Where SIGCHLD is ignored nobody learns how it ended.
    if (ended < 0 && errno != EINTR) return ProgramEnd::failed;
    if (Clock::now() >= over) break;
    std::this_thread::sleep_for(pause);
  }
  kill(program, SIGKILL);
  while (waitpid(program, nullptr, 0) < 0 && errno == EINTR) {
  }
  return ProgramEnd::out_of_time;
}

}  // namespace

ProgramEnd run_program(const std::vector<std::string>& command,
                       const std::filesystem::path& temporary, std::chrono::milliseconds limit) {
  std::vector<std::string> arguments = command, settings = environment(temporary);
  const SilentStreams streams;
  pid_t program = 0;
  // It stays in the process group of this program, so that Ctrl+C ends it too.
  if (posix_spawnp(&program, arguments.front().c_str(), streams.actions(), nullptr,
                   as_c_takes(arguments).data(), as_c_takes(settings).data()) != 0)
    return ProgramEnd::not_started;
  return end_of(program, Clock::now() + limit);
}

}  // namespace gradmesh
