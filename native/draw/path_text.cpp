#include "draw/path_text.h"

#include "formats/text/number.h"

namespace gradmesh {

void PathText::command(char letter) {
  if (!text_.empty()) text_ += ' ';
  text_ += letter;
}

void PathText::add(glm::dvec2 point) {
  text_ += ' ';
  text_ += format_point(point);
}

void PathText::move(glm::dvec2 to) {
  command('M');
  add(view_.point(to));
}

void PathText::line(glm::dvec2 to) {
  command('L');
  add(view_.point(to));
}

void PathText::curve(const Cubic<Value>& curve) {
  command('C');
  add(view_.point(curve.bezier1().position));
  add(view_.point(curve.bezier2().position));
  add(view_.point(curve.p1.position));
}

void PathText::circle(glm::dvec2 center, double radius) {
  const glm::dvec2 middle = view_.point(center);
  const std::string arc = format_point(glm::dvec2(radius)) + " 0 1 1";
  command('M');
  add(middle - glm::dvec2(radius, 0));
  for (const double side : {1.0, -1.0}) {
    command('A');
    text_ += ' ';
    text_ += arc;
    add(middle + glm::dvec2(side * radius, 0));
  }
  close();
}

void PathText::diamond(glm::dvec2 center, double radius) {
  const glm::dvec2 middle = view_.point(center);
  command('M');
  for (const glm::dvec2 corner :
       {glm::dvec2(0, -1), glm::dvec2(1, 0), glm::dvec2(0, 1), glm::dvec2(-1, 0)})
    add(middle + radius * corner);
  close();
}

}  // namespace gradmesh
