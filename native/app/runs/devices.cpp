#include "app/runs/devices.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <mutex>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "base/error.h"
#include "base/parallel.h"
#include "base/utf8_path.h"
#include "files/atomic_file.h"
#include "mesh/build.h"
#include "simplify/simplify.h"

namespace gradmesh {
namespace {

using nlohmann::json;

constexpr std::array<const char*, 3> names{"auto", "software", "egl"};

std::string seconds_text(double seconds) {
  char text[32];
  std::snprintf(text, sizeof text, "%.2g", seconds);
  return text;
}

/// Returns a square of `side` patches along each side, in soft colours, that cannot be merged
/// without error.
Mesh trial_mesh(int side) {
  const auto corner = [](int i, int j) {
    const double wave = 0.5 + 0.4 * ((i * 7 + j * 5) % 11) / 11.0;
    return Value{{10.0 * j, 10.0 * i}, {wave, 1 - 0.5 * wave, 0.3 + 0.05 * ((i + j) % 4), 1}};
  };
  const auto straight = [](const Value& a, const Value& b) {
    return Cubic<Value>{a, b - a, b - a, b};
  };
  MeshParts parts;
  parts.curves = grid_curves(side, side);
  for (int i = 0; i < side; ++i)
    for (int j = 0; j < side; ++j) {
      const Value a = corner(i, j), b = corner(i, j + 1), c = corner(i + 1, j + 1),
                  d = corner(i + 1, j), twist = a - b + c - d;
      parts.patches.push_back(
          patch_from_sides({straight(a, b), straight(b, c), straight(c, d), straight(d, a)},
                           {twist, -twist, twist, -twist}));
    }
  return build_mesh(parts);
}

/// Pixels that pricing regions takes, as a multiple of those for pricing edges, as found with 1,600
/// patches.
constexpr double regions_to_edges = 8;
/// About the seconds of one core for a pixel, and the seconds that pricing must take on the cores
/// for a device to be worth its start.
constexpr double typical_per_pixel = 1e-7, worth_a_start = 0.5;

std::size_t thread_number(int threads) {
  return threads > 0 ? std::size_t(threads) : thread_count();
}

/// Returns the seconds that pricing all edges of the mesh takes, the shorter of two runs, as
/// shaders are built in the first.
double pricing_seconds(const Mesh& mesh, const RunOptions& options) {
  double least = 1e30;
  for (int run = 0; run < 2; ++run) {
    const auto start = std::chrono::steady_clock::now();
    StopWatch watch = watch_of(options);
    analyze_edges(problem_of(std::make_shared<const Mesh>(mesh), options), watch);
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    least = std::min(least, seconds.count());
  }
  return least;
}

Speed measure(RunOptions options) {
  const std::array<int, 2> resolutions{64, 320};
  const Mesh mesh = trial_mesh(8);
  std::array<double, 2> pixels, seconds;
  for (std::size_t i = 0; i < 2; ++i) {
    options.resolution = resolutions[i];
    const Frame frame = fit_frame(mesh, options.view, options.resolution, options.padding);
    pixels[i] = priced_pixels(mesh, frame, options.metric) / regions_to_edges;
    seconds[i] = pricing_seconds(mesh, options);
  }
  Speed speed;
  speed.per_pixel = std::max(0.0, (seconds[1] - seconds[0]) / (pixels[1] - pixels[0]));
  speed.start = std::max(0.0, seconds[0] - speed.per_pixel * pixels[0]);
  return speed;
}

/// Returns the file that keeps the speeds; empty if the user has no home.
std::filesystem::path speeds_file() {
  const auto variable = [](const char* key) {
    const char* const value = std::getenv(key);
    return utf8_path(value ? value : "");
  };
  std::filesystem::path folder = variable("XDG_CACHE_HOME");
#ifdef _WIN32
  if (folder.empty()) folder = variable("LOCALAPPDATA");
#endif
  if (folder.empty() && !variable("HOME").empty()) folder = variable("HOME") / ".cache";
  return folder.empty() ? folder : folder / "gradmesh" / "renderers.json";
}

json read_speeds(const std::filesystem::path& file) {
  try {
    json known = json::parse(read_bytes(file), nullptr, false);
    return known.is_object() ? known : json::object();
  } catch (const InputError&) {
    return json::object();
  }
}

std::string key_of(const Device& device, int threads) {
  return device.info().name + " | " + device.info().version + " | " + GRADMESH_VERSION + " | " +
         std::to_string(thread_number(threads));
}

}  // namespace

const char* name(Renderer renderer) { return names[std::size_t(renderer)]; }

Renderer renderer_named(const std::string& name) {
  const auto found = std::ranges::find(names, name);
  if (found == names.end())
    throw std::invalid_argument("there is no renderer '" + name +
                                "'; there are auto, software and egl.");
  return Renderer(found - names.begin());
}

std::shared_ptr<Device> open_device(Renderer renderer) {
  if (renderer == Renderer::software) return nullptr;
  return Device::open(renderer == Renderer::automatic);
}

void use_renderer(RunOptions& options, Renderer wanted,
                  const std::function<void(const std::string& reason)>& tell) {
  options.device_if_faster = wanted == Renderer::automatic;
  if (wanted == Renderer::egl) options.device = open_device(wanted);
  options.device_lost = [tell](const DeviceError& error) { tell(error.what()); };
  if (wanted == Renderer::egl && !options.device) tell(no_device);
}

double priced_pixels(const Mesh& mesh, const Frame& frame, MetricKind metric) {
  const int reach = metric_reach(metric);
  double pixels = 0;
  for (const Halfedge edge : inner_edges(mesh)) {
    // A side with T-junctions has no face, and nothing is merged across it as a whole.
    const Halfedge across = mesh.is_leaf(edge) ? leaf_across(mesh, edge) : Halfedge();
    if (!across.valid()) continue;
    const Window both = pixel_bounds(mesh.patch(mesh.face(edge)), frame)
                            .united(pixel_bounds(mesh.patch(mesh.face(across)), frame))
                            .grown(reach)
                            .clipped(frame.window());
    if (!both.empty()) pixels += double(both.width()) * both.height();
  }
  return regions_to_edges * pixels;
}

Speeds measure_speeds(const std::shared_ptr<Device>& device, int threads) {
  RunOptions options;
  options.threads = threads;
  Speeds speeds;
  speeds.software = measure(options);
  options.device = device;
  options.device_lost = [](const DeviceError& error) { throw error; };
  speeds.device = measure(options);
  return speeds;
}

Speeds known_speeds(const std::shared_ptr<Device>& device, int threads) {
  const std::filesystem::path file = speeds_file();
  json known = file.empty() ? json::object() : read_speeds(file);
  const std::string key = key_of(*device, threads);
  try {
    const json& values = known.at(key);
    return {{values.at("software").at(0), values.at("software").at(1)},
            {values.at("device").at(0), values.at("device").at(1)}};
  } catch (const json::exception&) {
    // Not measured yet, or the file is damaged.
  }
  const Speeds speeds = measure_speeds(device, threads);
  if (file.empty()) return speeds;
  known[key] = {{"software", {speeds.software.start, speeds.software.per_pixel}},
                {"device", {speeds.device.start, speeds.device.per_pixel}}};
  try {
    std::filesystem::create_directories(file.parent_path());
    write_bytes(file, known.dump(2) + "\n");
  } catch (const std::exception&) {
    // It is measured again the next time.
  }
  return speeds;
}

RendererChoice faster(const Speeds& speeds, double pixels) {
  const double software = speeds.software.seconds(pixels), device = speeds.device.seconds(pixels);
  return {device < software,
          Message("pricing takes about {0} s on the device and {1} s in software",
                  seconds_text(device), seconds_text(software))};
}

RendererChoice choose_renderer(const std::shared_ptr<Device>& device, const Mesh& mesh,
                               const Frame& frame, MetricKind metric, int threads) {
  try {
    return faster(known_speeds(device, threads), priced_pixels(mesh, frame, metric));
  } catch (const DeviceError& error) {
    return {false, error.message()};
  }
}

std::shared_ptr<Device> automatic_device(const Mesh& mesh, const Frame& frame, MetricKind metric,
                                         int threads) {
  const double pixels = priced_pixels(mesh, frame, metric);
  if (pixels * typical_per_pixel < worth_a_start * double(thread_number(threads))) return nullptr;
  // Opened once for all meshes of a document.
  static std::mutex mutex;
  static std::weak_ptr<Device> opened;
  const std::lock_guard lock(mutex);
  std::shared_ptr<Device> device = opened.lock();
  if (!device) opened = device = open_device(Renderer::automatic);
  if (!device || !choose_renderer(device, mesh, frame, metric, threads).takes_device)
    return nullptr;
  return device;
}

}  // namespace gradmesh
