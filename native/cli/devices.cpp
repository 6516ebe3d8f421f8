#include <cstdio>

#include "app/document/document.h"
#include "app/document/frames.h"
#include "app/runs/devices.h"
#include "cli/commands.h"
#include "cli/common_options.h"

namespace gradmesh {
namespace {

struct DevicesArguments {
  std::filesystem::path in;
  std::vector<std::string> ids;
  RunOptions options;
};

void print_device(const DeviceInfo& device) {
  std::printf("%s%s\n", device.name.empty() ? "a device without a name" : device.name.c_str(),
              device.is_hardware ? "" : ": a program in place of a graphics processor");
  if (!device.version.empty()) std::printf("  version %s\n", device.version.c_str());
  if (!device.problem.empty())
    std::printf("  cannot be used: %s\n", device.problem.c_str());
  else
    std::printf("  can be used%s\n", device.is_hardware ? "" : ", with --renderer egl only");
}

/// Prints what `auto` takes, and why.
void print_choice(const DevicesArguments& a, const std::vector<DeviceInfo>& devices) {
  const std::shared_ptr<Device> device = open_device(Renderer::automatic);
  if (!device) {
    std::printf("\nauto takes software: there is no %s.\n",
                devices.empty() ? "device" : "graphics processor that can be used");
    return;
  }
  if (a.in.empty()) {
    std::printf(
        "\nauto takes %s where that is faster; gradmesh devices IN tells for which meshes.\n",
        device->info().name.c_str());
    return;
  }
  std::printf("\n");
  const std::unique_ptr<Document> document = read_and_warn(a.in);
  for (const MeshEntry& entry : document->selected(a.ids)) {
    const Mesh mesh = document->mesh(entry);
    const RendererChoice choice =
        choose_renderer(device, mesh, frame_of(*document, entry, mesh, a.options.resolution),
                        a.options.metric, a.options.threads);
    std::printf("%s: auto takes %s: %s.\n", entry.id.c_str(),
                choice.takes_device ? device->info().name.c_str() : "software",
                choice.reason.english().c_str());
  }
}

void run_devices(const DevicesArguments& a) {
  const std::vector<DeviceInfo> devices = Device::list();
  if (devices.empty()) std::printf("EGL offers no device here.\n");
  for (const DeviceInfo& device : devices) print_device(device);
  print_choice(a, devices);
}

}  // namespace

void add_devices(CLI::App& program) {
  const auto a = std::make_shared<DevicesArguments>();
  CLI::App& command = *program.add_subcommand(
      "devices", "List the graphics processors, and which one --renderer auto takes");
  add_path(command, "IN", a->in, "Tell it for the meshes of this " + any_document());
  add_ids(command, a->ids);
  add_options(command, a->options, {"metric", "resolution", "threads"});
  command.callback([a] { run_devices(*a); });
}

}  // namespace gradmesh
