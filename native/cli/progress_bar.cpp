#include "cli/progress_bar.h"

#include <csignal>
#include <cstdio>

#ifdef _WIN32
#include <io.h>
#define GRADMESH_IS_TERMINAL (_isatty(_fileno(stderr)) != 0)
#else
#include <unistd.h>
#define GRADMESH_IS_TERMINAL (isatty(STDERR_FILENO) != 0)
#endif

namespace gradmesh {
namespace {

volatile std::sig_atomic_t interrupted = 0;

void interrupt(int signal) {
  interrupted = 1;
  std::signal(signal, SIG_DFL);
}

}  // namespace

ProgressBar::ProgressBar(bool quiet) : visible_(!quiet && GRADMESH_IS_TERMINAL) {
  std::signal(SIGINT, interrupt);
}

ProgressBar::~ProgressBar() {
  if (visible_ && last_percent_ >= 0) std::fprintf(stderr, "\r\033[K");
  std::signal(SIGINT, SIG_DFL);
}

ProgressCallback ProgressBar::callback() {
  return [this](const Progress& progress) { return show(progress); };
}

bool ProgressBar::show(const Progress& progress) {
  const int percent = progress.total ? int(100 * progress.done / progress.total) : 100;
  if (visible_ && percent != last_percent_) {
    last_percent_ = percent;
    constexpr int width = 30;
    const int filled = percent * width / 100;
    const std::string bar = std::string(filled, '#') + std::string(width - filled, '.');
    std::fprintf(stderr, "\r\033[K[%s] %3d %%  %d %s, error %.4f", bar.c_str(), percent,
                 progress.handles > 0 ? progress.handles : progress.patches,
                 progress.handles > 0 ? "handles" : "patches", progress.error);
    std::fflush(stderr);
  }
  return interrupted == 0;
}

}  // namespace gradmesh
