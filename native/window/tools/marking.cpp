#include "window/tools/marking.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "window/eye/words.h"

namespace gradmesh {

void Marking::drag(Eye& eye, glm::dvec2 from, glm::dvec2 to, const Held& held, bool is_first) {
  if (is_first) {
    eye.forget_proposal();
    way_.clear();
    if (!held.shift) eye.unmark();
  }
  if (brushes() || held.alt) {
    way_.clear();
    eye.mark(faces_touched(eye.session().mesh(), eye.to_pixels(), {from, to}), true);
    return;
  }
  if (way_.empty()) way_.push_back(from);
  way_.push_back(to);
  inside_ = faces_covered(eye.session().mesh(), eye.to_pixels(), outline());
}

void Marking::drop(Eye& eye, const Held&) {
  if (way_.size() > 1) eye.mark(inside_, true);
  way_.clear();
  eye.price_marks();
}

void Marking::draw(const Eye& eye, const Pen& pen) const {
  if (way_.size() < 2) return;
  const Mesh& mesh = eye.session().mesh();
  for (const Face face : inside_)
    pen.line(points_around(mesh, face, eye.to_pixels()), true, Pen::Ink::picked);
  pen.line(outline(), true, Pen::Ink::outline);
}

std::vector<glm::dvec2> Marking::outline() const {
  // How far a drag may go aside and still be straight, by its length.
  constexpr double straight = 0.1;
  const glm::dvec2 from = way_.front(), to = way_.back(), along = to - from;
  const double most = straight * glm::dot(along, along);
  const bool is_straight = std::ranges::all_of(way_, [&](glm::dvec2 p) {
    const glm::dvec2 way = p - from;
    return std::abs(way.x * along.y - way.y * along.x) <= most;
  });
  if (!is_straight) return way_;
  return {from, {to.x, from.y}, to, {from.x, to.y}};
}

std::optional<Message> Marking::hint(const Eye& eye) const {
  const std::size_t count = eye.marked().size();
  if (count == 0) return std::nullopt;
  if (count == 1) return Message("One patch is marked. P protects it, or releases it.");
  const auto& price = eye.marks_price();
  if (!price) return Message("Marked patches: {0}. P protects them, Enter makes them one.", count);
  if (price->why_not)
    return Message("Marked patches: {0}. P protects them. Enter does nothing: {1}", count,
                   *price->why_not);
  return Message("Marked patches: {0}. P protects them, Enter makes them one: error {1}", count,
                 error_after(price->error, eye.session().shown().now().error));
}

}  // namespace gradmesh
