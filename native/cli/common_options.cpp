#include "cli/common_options.h"

namespace gradmesh {

void add_metric_option(CLI::App& command, std::string& metric) {
  command.add_option("--metric", metric, "How pictures are compared")
      ->check(CLI::IsMember({"flip", "ssim"}))
      ->capture_default_str();
}

void add_resolution_option(CLI::App& command, int& resolution) {
  command.add_option("--resolution", resolution, "Pixels along the longer side")
      ->check(CLI::Range(16, 8192))
      ->capture_default_str();
}

}  // namespace gradmesh
