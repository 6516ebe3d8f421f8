// Sessions over small meshes, for tests.
#pragma once

#include <random>

#include "app/document/svg_rules.h"
#include "form/written_patch.h"
#include "mesh/build.h"
#include "meshes.h"
#include "problems.h"
#include "session/picture.h"
#include "session/session.h"

namespace gradmesh::test {

inline Problem problem_for(const Mesh& mesh) {
  RunOptions options;
  options.resolution = 150;
  options.rules = block_rules();
  options.gradient_rules = gradient_rules({});
  return problem(mesh, options);
}

/// A mesh with colours that SVG can hold.
inline Mesh mesh_for(unsigned seed) {
  std::mt19937 random(seed);
  MeshParts parts =
      grid_parts({.rows = 5, .columns = 5, .position_noise = 0.03, .color_noise = 0.05}, random);
  for (Patch& patch : parts.patches) patch = as_written(patch, 0);
  return build_mesh(parts);
}

inline SessionView view_of(const Session& session, int size = 200) {
  SessionView view;
  view.width = view.height = size;
  const Frame& frame = session.shown().problem().frame();
  view.to_pixels = Affine::scaling(glm::dvec2(double(size) / frame.width)) * frame.to_pixels;
  return view;
}

}  // namespace gradmesh::test
