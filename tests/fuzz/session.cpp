// Whatever a person does by eye, in whatever order.
#include <random>

#include "any_deeds.h"
#include "choices.h"
#include "target.h"

namespace gradmesh::fuzz {
namespace {

Mesh chosen_mesh(Choices& choices) {
  const unsigned size = choices.byte(), noise = choices.byte();
  std::mt19937 random(choices.byte());
  MeshParts parts = test::grid_parts({.rows = 1 + int(size % 4),
                                      .columns = 1 + int(size / 4 % 4),
                                      .position_noise = noise % 8 / 20.0,
                                      .color_noise = noise / 8 % 4 / 10.0},
                                     random);
  for (Patch& patch : parts.patches) {
    patch = as_written(patch, 0);
    if (noise >= 128) make_coons(patch);
  }
  return build_mesh(parts);
}

void require_none(const std::string& broken) {
  if (!broken.empty()) std::fprintf(stderr, "%s\n", broken.c_str());
  require(broken.empty(), "all is as it must be");
}

}  // namespace

void check(std::string_view bytes) {
  Choices choices(bytes);
  RunOptions options;
  options.resolution = 40;
  options.threads = 1;
  options.rules = block_rules();
  options.gradient_rules = gradient_rules({});
  Session session(test::problem(chosen_mesh(choices), options));
  session.curves().wait();
  test::AnyDeeds deeds(session, [&] { return choices.byte(); });
  while (!choices.at_end()) {
    deeds.next();
    require_none(deeds.broken());
  }
  require_none(deeds.broken_by_going_back());
}

}  // namespace gradmesh::fuzz
