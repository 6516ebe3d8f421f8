#include "session/shown_mesh.h"

#include <algorithm>
#include <cmath>

#include "base/clamped_int.h"
#include "base/error.h"

namespace gradmesh {
namespace {

/// Throws InputError if all points of a patch coincide, as readers refuse that: a line that is put
/// in again and again beside another may come to lie on it as it is written.
void check_sizes(const Mesh& written) {
  for (const Face face : written.faces()) {
    const Patch patch = written.patch(face);
    bool has_size = false;
    for (int side = 0; side < 4; ++side) {
      const Cubic<Value> line = patch.side(side);
      for (const glm::dvec2 way :
           {line.p1.position - line.p0.position, line.m0.position, line.m1.position})
        has_size = has_size || way != glm::dvec2(0);
    }
    if (!has_size) throw InputError("a patch would be too small to be written.");
  }
}

/// Returns the problem with everything painted that searches and edits share.
Problem prepared(Problem problem) {
  problem.bounds = {1};
  problem.trial();
  if (problem.gradient_rules) problem.as_gradient().trial();
  return problem;
}

/// Returns the mesh of a problem, measured as it is, since it need not be written anew.
Candidate as_it_is(const Problem& problem) {
  Candidate found = problem.unchanged();
  found.measured =
      std::make_shared<MeasuredSurface>(*problem.reference(), found.mesh, false, nullptr);
  return found;
}

MeshKind form_of(const Problem& problem, const std::vector<MeshKind>& kinds) {
  if (!kinds.empty()) return kinds.front();
  return problem.mesh().is_smooth() ? MeshKind::one_gradient : MeshKind::blocks;
}

Setting first_setting(const Problem& problem, MeshKind form) {
  const auto basis = std::make_shared<const Basis>(
      Basis{std::make_shared<const Mesh>(problem.mesh()), problem.original()});
  return {form, 0, basis, basis,
          std::make_shared<const std::vector<WeightedArea>>(problem.layout().weighted)};
}

}  // namespace

ShownMesh::ShownMesh(const Problem& problem)
    : document_(prepared(problem)),
      problem_(document_),
      kinds_(curve_kinds(problem_)),
      form_in_document_(form_of(problem_, kinds_)),
      start_(as_it_is(document_)),
      now_(start_),
      setting_(first_setting(problem_, form_in_document_)),
      history_(now_.mesh, setting_) {
  curves_.replace(std::make_unique<CurveSearch>(problem_));
  if (!kinds_.empty()) curves().request(form_in_document_);
}

ShownMesh::~ShownMesh() {
  // Before one of them is waited for, all have to know.
  analyses_.end();
  curves_.end();
}

Problem ShownMesh::problem_as_written() const {
  return document_.with_original(setting_.next->is_redrawn ? setting_.next->original
                                                           : document_.original());
}

bool ShownMesh::is_as_in_document(const Mesh& mesh, MeshKind form) const {
  // In another form it would be written as something else.
  return problem_.original() == document_.original() && mesh == problem_.mesh() &&
         form == form_in_document_;
}

Problem ShownMesh::problem_as(MeshKind form) const {
  return form == MeshKind::blocks ? problem_ : problem_.as_gradient();
}

Candidate ShownMesh::measured(const Mesh& mesh, MeshKind form) const {
  if (is_as_in_document(mesh, form)) return as_it_is(problem_);
  const bool is_near = now_.measured && setting_.form == form;
  Candidate found = problem_as(form).measure(mesh, is_near ? &now_ : nullptr);
  check_sizes(found.surface());
  return found;
}

std::vector<WorstPlace> ShownMesh::worst_places(int most) const {
  const Affine back = problem_.frame().to_pixels.inverse();
  std::vector<WorstPlace> worst =
      gradmesh::worst_places(now_.measured->map(), problem_.reference()->away_from_outline(), most);
  for (WorstPlace& each : worst) each.place = back.point(each.place);
  return worst;
}

std::vector<Face> ShownMesh::faces_numbered(const std::vector<int>& numbers) const {
  std::vector<Face> faces;
  for (const int number : numbers) {
    const bool is_there =
        number >= 0 && std::size_t(number) < mesh().face_slots() && mesh()[Face{number}].alive;
    if (!is_there) throw InputError("there is no patch {0} in the mesh that is shown.", number);
    faces.push_back(Face{number});
  }
  return faces;
}

std::vector<Face> ShownMesh::protected_faces() const {
  std::vector<Face> faces;
  for (const Face face : mesh().faces())
    if (mesh().is_fixed(face)) faces.push_back(face);
  return faces;
}

double ShownMesh::weight_at(Face face) const {
  const Frame& frame = problem_.frame();
  if (!frame.weights) return 1;
  const glm::dvec2 at = frame.to_pixels.point(mesh().patch(face).at(0.5, 0.5).position);
  const int x = clamped_pixel(std::floor(at.x)), y = clamped_pixel(std::floor(at.y));
  const bool is_inside = x >= 0 && y >= 0 && x < frame.width && y < frame.height;
  return is_inside ? *frame.weights->at(x, y) : 1;
}

AnalysisSearch& ShownMesh::analyses(bool fits) {
  if (!analyses_.get() || analyses_.get()->fits() != fits)
    analyses_.replace(
        std::make_unique<AnalysisSearch>(problem_as(setting_.form), setting_.form, now_, fits));
  return *analyses_.get();
}

std::shared_ptr<const Analysis> ShownMesh::analysis(AnalysisKind kind) const {
  return analyses_.get() ? analyses_.get()->found(kind) : nullptr;
}

Setting ShownMesh::setting_as(MeshKind form, int state) const {
  return {form, state, setting_.basis, setting_.next, setting_.weighted};
}

Setting ShownMesh::setting_as(MeshKind form) const {
  return setting_as(form, mesh() == *setting_.next->start ? 0 : -1);
}

void ShownMesh::show(Candidate written, const Setting& setting) {
  now_ = std::move(written);
  setting_ = setting;
  ++revision_;
  analyses_.replace(nullptr);
}

void ShownMesh::change(Candidate written, const Setting& setting, const Message& name) {
  show(std::move(written), setting);
  record(name);
}

void ShownMesh::undo() {
  if (!history_.can_undo()) return;
  history_.undo();
  show_recorded();
}

void ShownMesh::redo() {
  if (!history_.can_redo()) return;
  history_.redo();
  show_recorded();
}

void ShownMesh::show_recorded() {
  measure_in(history_.setting());
  show(measured(history_.mesh(), history_.setting().form), history_.setting());
}

void ShownMesh::measure_in(const Setting& setting) {
  const bool has_other_weights = setting.weighted != setting_.weighted;
  if (has_other_weights) {
    problem_ = document_ = prepared(document_.weighted(*setting.weighted));
    start_ = as_it_is(document_);
  }
  if (has_other_weights || setting.basis != setting_.basis) {
    // What was measured against another picture, or by other weights, helps no more.
    if (has_other_weights || setting.basis->original != setting_.basis->original)
      now_.measured = nullptr;
    problem_ = prepared(problem_on(*setting.basis));
  }
  if (!has_other_weights && setting.next == setting_.next) return;
  curves_.end();
  // Its own where it is another one, which is then painted in the background.
  const Problem next = setting.next == setting.basis ? problem_ : problem_on(*setting.next);
  kinds_ = curve_kinds(next);
  curves_.replace(std::make_unique<CurveSearch>(next));
  if (std::ranges::find(kinds_, setting.form) != kinds_.end()) curves().request(setting.form);
}

Problem ShownMesh::problem_on(const Basis& basis) const {
  const bool has_its_picture = basis.original == problem_.original();
  return (has_its_picture ? problem_ : document_.with_original(basis.original))
      .with_mesh(basis.start);
}

}  // namespace gradmesh
