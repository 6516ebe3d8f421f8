#include "raster/frame.h"

#include <algorithm>
#include <climits>
#include <cmath>

#include "base/clamped_int.h"
#include "base/error.h"
#include "base/limits.h"

namespace gradmesh {
namespace {

// Far from where products of a few such numbers leave the range of a double.
constexpr double smallest = 1e-60, largest = 1e60;

void check_place(glm::dvec2 p) {
  if (!(std::abs(p.x) < largest && std::abs(p.y) < largest))
    throw InputError("the mesh is too large, as its transforms place it.");
}

void check_size(const Frame& frame) {
  const Limits& most = limits();
  const auto longer = std::uint64_t(std::max(frame.width, frame.height));
  if (longer > most.resolution)
    throw InputError("a picture of {0} x {1} pixels is asked for, {2}.", frame.width, frame.height,
                     beyond_limit("resolution", most.resolution, longer));
  if (const std::uint64_t bytes = measuring_bytes(frame, 1); bytes > most.memory)
    throw InputError("to measure {0} x {1} pixels takes {2} bytes, {3}.", frame.width, frame.height,
                     bytes, beyond_limit("memory", most.memory, bytes));
}

}  // namespace

std::uint64_t measuring_bytes(const Frame& frame, std::size_t threads) {
  constexpr std::uint64_t bytes_of_all = 80, bytes_of_thread = 35;
  const std::uint64_t pixels = std::uint64_t(frame.width) * std::uint64_t(frame.height);
  return pixels * (bytes_of_all + bytes_of_thread * threads);
}

Frame fit_frame(const Mesh& mesh, const Affine& view, int resolution, FramePadding padding) {
  constexpr int steps = 8;
  Box box;
  for (const Face f : mesh.faces()) {
    const Patch patch = mesh.patch(f);
    for (int i = 0; i <= steps; ++i)
      for (int j = 0; j <= steps; ++j) {
        const glm::dvec2 p = view.point(patch.at(double(i) / steps, double(j) / steps).position);
        check_place(p);
        box.add(p);
      }
  }
  return fit_frame(box, view, resolution, padding);
}

Frame fit_frame(const Box& seen, const Affine& view, int resolution, FramePadding padding) {
  check_place(seen.low());
  check_place(seen.high());
  const glm::dvec2 size = seen.size();
  const double longer = std::max(size.x, size.y);
  if (!(longer > smallest)) throw InputError("the mesh has no size.");

  const double pad = padding.share * longer + padding.length;
  const double scale = resolution / (longer + 2 * pad);
  Frame frame;
  // The small addition keeps a side of exactly `resolution` pixels from being cut by rounding.
  frame.width = clamped_int((size.x + 2 * pad) * scale + 1e-9, 1, INT_MAX);
  frame.height = clamped_int((size.y + 2 * pad) * scale + 1e-9, 1, INT_MAX);
  check_size(frame);
  const Affine fit =
      Affine::scaling({scale, scale}) * Affine::translation(glm::dvec2(pad) - seen.low());
  frame.to_pixels = fit * view;
  return frame;
}

double coons_tolerance(const Frame& frame) {
  return 0.01 / std::sqrt(std::abs(frame.to_pixels.determinant()));
}

Window pixel_bounds(const Patch& patch, const Frame& frame) {
  Box box;
  for (const auto& row : bezier_net(patch))
    for (const Value& b : row) box.add(frame.to_pixels.point(b.position));
  return Window{clamped_pixel(std::floor(box.low().x)), clamped_pixel(std::floor(box.low().y)),
                clamped_pixel(std::ceil(box.high().x)), clamped_pixel(std::ceil(box.high().y))}
      .grown(1);
}

}  // namespace gradmesh
