// What a person may do in a session, in any order, by a row of bytes.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "base/error.h"
#include "form/handles.h"
#include "mesh/validate.h"
#include "session/session.h"
#include "sessions.h"

namespace gradmesh::test {

/// Deeds of which each is chosen by the next bytes, and what must be so after each.
class AnyDeeds {
 public:
  AnyDeeds(Session& session, std::function<unsigned()> byte)
      : session_(session), byte_(std::move(byte)), first_(session.mesh()) {}

  /// Does the next deed. What cannot be done must say so in one sentence and change nothing.
  void next() {
    const Mesh before = session_.mesh();
    const auto fixed = session_.shown().protected_faces();
    problem_.clear();
    changes_protection_ = false;
    try {
      deed();
    } catch (const InputError& why_not) {
      const std::string text = why_not.what();
      if (text.empty() || text.back() != '.') problem_ = "no sentence: " + text;
      if (!(session_.mesh() == before)) problem_ = "changed, but: " + text;
    }
    if (!changes_protection_ && !keeps(before, fixed))
      problem_ = "what is protected has changed by deed " + std::to_string(deed_);
  }

  /// Returns what of the session is not as it must be; empty if all is.
  std::string broken() const {
    if (!problem_.empty()) return problem_;
    const Mesh& mesh = session_.mesh();
    for (const std::string& each : validate(mesh)) return each;
    if (session_.shown().is_unchanged()) return "";
    const Problem& problem = session_.shown().problem();
    const bool is_blocks = session_.shown().form() == MeshKind::blocks;
    const double again = (is_blocks ? problem : problem.as_gradient()).measure(mesh).error;
    return std::abs(session_.shown().now().error - again) < 1e-9 ? "" : "the error is another";
  }

  /// Takes all back and does it again. Returns what is then not as it was; empty if all is.
  std::string broken_by_going_back() {
    // What was shown last may not have been recorded.
    if (!session_.history().can_undo() && !session_.history().can_redo()) return "";
    session_.undo();
    session_.redo();
    std::vector<Mesh> done;
    while (session_.history().can_undo()) {
      if (!session_.history().undo_name()) return "a deed has no name";
      done.push_back(session_.mesh());
      session_.undo();
    }
    if (!(session_.mesh() == first_)) return "all undone, the mesh is another";
    for (std::size_t i = done.size(); i > 0; --i) {
      session_.redo();
      if (!(session_.mesh() == done[i - 1])) return "done again, the mesh is another";
    }
    return "";
  }

 private:
  /// Splits only make meshes larger; from here on they are left out.
  static constexpr int many_faces = 60;

  glm::dvec2 place() { return {200 * byte_() / 255.0, 200 * byte_() / 255.0}; }

  std::vector<Face> faces() {
    const glm::dvec2 a = place(), b = a + place() / 2.0;
    return faces_covered(session_.mesh(), view_of(session_).to_pixels,
                         {a, {b.x, a.y}, b, {a.x, b.y}});
  }

  void deed() {
    switch (deed_ = byte_() % 12) {
      case 0:
        return show();
      case 1:
        changes_protection_ = true;
        return session_.undo();
      case 2:
        changes_protection_ = true;
        return session_.redo();
      case 3:
        return session_.hands().set_form(byte_() % 2 ? MeshKind::blocks : MeshKind::one_gradient);
      case 4:
        return session_.hands().fit();
      case 5:
        changes_protection_ = true;
        return byte_() % 4 ? session_.protection().protect(faces(), byte_() % 2)
                           : session_.protection().protect_others(faces());
      case 10: {
        constexpr double factors[] = {0.25, 1, 4};
        return session_.protection().weigh(faces(), factors[byte_() % 3]);
      }
      case 6:
        session_.hands().propose_merge(faces());
        break;
      case 7:
        move();
        break;
      default:
        session_.hands().set_fits(byte_() % 2);
        point();
    }
    session_.hands().make();
  }

  void show() {
    const auto found = session_.curves().found(MeshKind::one_gradient);
    if (found && found->is_complete && !found->curve.states.empty())
      session_.show(MeshKind::one_gradient, int(byte_() % found->curve.states.size()), byte_() % 2);
    // A state is that of a mesh of which other patches may have been protected.
    changes_protection_ = true;
  }

  void move() {
    const Affine to_pixels = view_of(session_).to_pixels;
    const glm::dvec2 from = place(), by = place() / 10.0 - 10.0;
    if (const auto grip = grip_at(session_.mesh(), to_pixels, from, 60))
      session_.hands().propose_move(*grip, to_pixels.inverse().point(from + by));
  }

  void point() {
    const auto pointed = pointed_at(session_.mesh(), view_of(session_).to_pixels, place(), 60);
    if (!pointed) return;
    const bool may_grow = session_.mesh().face_count() < many_faces;
    switch (const unsigned which = byte_() % 8; which) {
      case 0:
        session_.hands().propose_straight(*pointed);
        return;
      case 1:
        session_.hands().propose_curve(*pointed);
        return;
      case 2:
        session_.hands().propose_color(*pointed, {byte_() / 255.0, byte_() / 255.0, 0.5},
                                       byte_() % 2);
        return;
      case 3:
        session_.hands().propose_joined(*pointed);
        return;
      default:
        session_.hands().propose(*pointed, may_grow ? HandEdit(which % 4) : HandEdit::merge);
    }
  }

  bool keeps(const Mesh& before, const std::vector<Face>& fixed) const {
    const Mesh& after = session_.mesh();
    for (const Face face : fixed) {
      const Patch patch = before.patch(face);
      // A grid that is built anew may begin its patches at other corners.
      const bool is_there = std::ranges::any_of(after.faces(), [&](Face f) {
        return after.is_fixed(f) && std::ranges::any_of(after.sides(f), [&](Halfedge top) {
                 return is_same(after.patch(top), patch);
               });
      });
      if (!is_there) return false;
    }
    return true;
  }

  /// Of a grid that is built anew the last bits of a patch may be others.
  static bool is_same(const Patch& a, const Patch& b) {
    for (const double u : {0.0, 0.3, 0.7, 1.0})
      for (const double v : {0.0, 0.3, 0.7, 1.0}) {
        const Value p = a.at(u, v), q = b.at(u, v);
        if (glm::distance(p.position, q.position) > 1e-9 || glm::distance(p.color, q.color) > 1e-9)
          return false;
      }
    return true;
  }

  Session& session_;
  std::function<unsigned()> byte_;
  const Mesh first_;
  std::string problem_;
  bool changes_protection_ = false;
  unsigned deed_ = 0;
};

}  // namespace gradmesh::test
