#include "session/session.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>

#include "base/clamped_int.h"
#include "base/error.h"
#include "form/blocks.h"
#include "form/smooth_colors.h"
#include "mesh/face_outline.h"
#include "mesh/faces_under.h"
#include "mesh/rectangle.h"
#include "ops/fix.h"
#include "session/shape_edits.h"

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

/// Returns the patches of another mesh that lie under these.
std::vector<Face> faces_there(const Mesh& mesh, const std::vector<Face>& faces, const Mesh& there) {
  std::vector<Face> all;
  for (const Face face : faces) {
    const std::vector<Face> under = faces_under(there, face_outline(mesh, face));
    all.insert(all.end(), under.begin(), under.end());
  }
  return all;
}

/// Returns a mesh as it is painted.
Mesh with_own_colors(const Mesh& mesh) { return mesh.is_smooth() ? painted_mesh(mesh) : mesh; }

/// Returns the outlines of the patches of each of two meshes that the other one has not.
std::vector<FilledOutline> where_they_differ(const Mesh& one, const Mesh& other) {
  const auto bytes_of = [](const Patch& patch) {
    return std::string(reinterpret_cast<const char*>(&patch), sizeof patch);
  };
  std::vector<FilledOutline> areas;
  const auto add_those_without = [&](const Mesh& mesh, const Mesh& there) {
    std::set<std::string> known;
    for (const Face face : there.faces()) known.insert(bytes_of(there.patch(face)));
    for (const Face face : mesh.faces())
      if (!known.contains(bytes_of(mesh.patch(face)))) areas.push_back(face_outline(mesh, face));
  };
  add_those_without(one, other);
  add_those_without(other, one);
  return areas;
}

/// Returns the mesh of a problem, measured as it is, since it need not be written anew.
Candidate as_it_is(const Problem& problem) {
  Candidate found = problem.unchanged();
  found.measured =
      std::make_shared<MeasuredSurface>(*problem.reference(), found.mesh, false, nullptr);
  return found;
}

/// Ends a search, which is kept among others until it has ended.
template <class Search>
void retire(std::unique_ptr<Search>& search, std::vector<std::unique_ptr<Search>>& old) {
  std::erase_if(old, [](const auto& each) { return !each->is_busy(); });
  if (!search) return;
  search->end();
  old.push_back(std::move(search));
}

}  // namespace

Session::Session(const Problem& problem)
    : document_(prepared(problem)),
      problem_(document_),
      kinds_(curve_kinds(problem_)),
      curves_(std::make_unique<CurveSearch>(problem_)) {
  const CurveKind otherwise =
      problem_.mesh().is_smooth() ? CurveKind::one_gradient : CurveKind::blocks;
  form_in_document_ = kinds_.empty() ? otherwise : kinds_.front();
  start_ = now_ = as_it_is(document_);
  const auto basis = std::make_shared<const Basis>(
      Basis{std::make_shared<const Mesh>(problem_.mesh()), problem_.original()});
  place_ =
      kept_place_ = {form_in_document_, 0, basis, basis,
                     std::make_shared<const std::vector<WeightedArea>>(problem_.layout().weighted)};
  kept_ = now_.mesh;
  if (!kinds_.empty()) curves_->want(form_in_document_);
}

Session::~Session() {
  // Before one of them is waited for, all have to know.
  if (analyses_) analyses_->end();
  if (curves_) curves_->end();
}

bool Session::is_as_it_is(const Mesh& mesh, CurveKind form) const {
  // In another form it would be written as something else.
  return problem_.original() == document_.original() && mesh == problem_.mesh() &&
         form == form_in_document_;
}

bool Session::is_unchanged() const { return is_as_it_is(now_.mesh, place_.form); }

Candidate Session::measured(const Mesh& mesh, CurveKind form) const {
  if (is_as_it_is(mesh, form)) return as_it_is(problem_);
  const bool is_near = now_.measured && place_.form == form;
  Candidate found = problem_as(form).measure(mesh, is_near ? &now_ : nullptr);
  check_sizes(found.surface());
  return found;
}

AnalysisSearch& Session::analyses() {
  if (!analyses_ || analyses_->fits() != fits_) {
    retire(analyses_, old_analyses_);
    analyses_ = std::make_unique<AnalysisSearch>(problem_as(place_.form), place_.form, now_, fits_);
  }
  return *analyses_;
}

void Session::set_now(Candidate written) {
  now_ = std::move(written);
  proposal_.reset();
  retire(analyses_, old_analyses_);
}

std::vector<WorstPlace> Session::worst_places(int most) const {
  const Affine back = problem_.frame().to_pixels.inverse();
  std::vector<WorstPlace> worst =
      gradmesh::worst_places(now_.measured->map(), problem_.reference()->away_from_outline(), most);
  for (WorstPlace& each : worst) each.place = back.point(each.place);
  return worst;
}

void Session::show(CurveKind kind, int state, bool moves_on) {
  curves_->want(kind);
  const auto found = curves_->found(kind);
  if (!found || state < 0 || std::size_t(state) >= found->curve.states.size())
    throw std::invalid_argument("the curve has no state " + std::to_string(state) + " yet.");
  const Mesh mesh = *found->curve.states[std::size_t(state)].mesh;
  Place place = place_as(kind, state);
  place.basis = place.next;
  start_from(place);
  set_now(measured(mesh, kind));
  place_ = place;
  if (!moves_on) take_down(Message("Move along the curve"));
}

void Session::set_form(CurveKind form) {
  if (form == place_.form) return;
  if (form == CurveKind::blocks) check_has_own_colors(now_.mesh);
  if (form == CurveKind::one_gradient && (!problem_.gradient_rules || !find_grid(now_.mesh)))
    throw InputError(
        "the mesh is no grid of whole rows and columns, so it cannot be one gradient.");
  if (form == CurveKind::one_gradient && !has_one_color_at_each_point(now_.mesh))
    throw InputError("colours are sharp at a point, so the mesh cannot be one gradient.");
  become(measured(now_.mesh, form), place_as(form, is_start_of_curve(now_.mesh) ? 0 : -1),
         form == CurveKind::blocks ? Message("Make it blocks") : Message("Make it one gradient"));
}

const Session::Proposal& Session::propose(MadeEdit made, CurveKind form) {
  Candidate written = measured(made.mesh, form);
  proposal_ = Proposal{std::move(made), std::move(written), form};
  return *proposal_;
}

const Session::Proposal& Session::propose(const Pointed& pointed, HandEdit edit) {
  forget_proposal();
  return propose(is_gradient() ? edit_lines(now_.mesh, pointed, edit, fits_, problem_)
                               : edit_patches(now_.mesh, pointed, edit));
}

const Session::Proposal& Session::propose_straight(const Pointed& pointed) {
  forget_proposal();
  return propose(straightened(now_.mesh, pointed));
}

const Session::Proposal& Session::propose_curve(const Pointed& pointed) {
  forget_proposal();
  const Proposal& proposal = propose(bent(now_.mesh, pointed, *problem_.reference()));
  if (proposal.written.error < now_.error) return proposal;
  forget_proposal();
  throw InputError("as a curve this side would not be closer to the picture.");
}

const Session::Proposal& Session::propose_move(const Grip& grip, glm::dvec2 to) {
  forget_proposal();
  return propose(moved(now_.mesh, grip, to, problem_));
}

const Session::Proposal& Session::propose_color(const Pointed& pointed, const glm::dvec3& color,
                                                bool is_sharp) {
  forget_proposal();
  if (is_sharp && is_gradient())
    throw InputError("one gradient has one colour at each point; make it blocks first.");
  return propose(recolored(now_.mesh, pointed, color, is_sharp));
}

const Session::Proposal& Session::propose_joined(const Pointed& pointed) {
  forget_proposal();
  return propose(joined(now_.mesh, pointed));
}

const Session::Proposal& Session::propose_merge(const std::vector<Face>& faces) {
  forget_proposal();
  return propose(merged_patches(now_.mesh, faces), CurveKind::blocks);
}

bool Session::make() {
  if (!proposal_) return false;
  auto [made, written, form] = *std::exchange(proposal_, std::nullopt);
  if (fits_ && made.merged.valid()) {
    Candidate better = measured(fitted(written.mesh, false, {made.merged}, problem_), form);
    if (better.error < written.error) written = std::move(better);
  }
  const Place place = place_after(written.mesh, form, made.redraws);
  start_from(place);
  become(std::move(written), place, made.name);
  return true;
}

void Session::fit() {
  std::vector<Face> faces;
  for (const Face face : now_.mesh.faces()) faces.push_back(face);
  Candidate found = measured(fitted(now_.mesh, is_gradient(), faces, problem_), place_.form);
  if (!(found.error < now_.error)) return;
  const Place place = place_after(found.mesh, place_.form, false);
  start_from(place);
  become(std::move(found), place, Message("Fit to the picture"));
}

Session::Place Session::place_after(const Mesh& edited, CurveKind form, bool is_redrawn) const {
  Basis next = *place_.next;
  next.start = std::make_shared<const Mesh>(edited);
  for (FilledOutline& area : where_they_differ(with_own_colors(now_.mesh), with_own_colors(edited)))
    next.by_hand.push_back(std::move(area));
  next.original = with_areas(document_.original(), next.start, next.by_hand);
  next.is_redrawn = next.is_redrawn || is_redrawn;
  Place place = place_as(form, -1);
  place.next = std::make_shared<const Basis>(std::move(next));
  return place;
}

void Session::become(Candidate written, Place place, const Message& name) {
  set_now(std::move(written));
  place_ = place;
  take_down(name);
}

void Session::take_down(const Message& name) {
  if (kept_ == now_.mesh && kept_place_.form == place_.form && kept_place_.basis == place_.basis &&
      kept_place_.next == place_.next && kept_place_.weighted == place_.weighted) {
    kept_place_ = place_;
    return;
  }
  history_.erase(history_.begin() + std::ptrdiff_t(done_), history_.end());
  history_.push_back({name, MeshDifference(kept_, now_.mesh), kept_place_, place_});
  done_ = history_.size();
  kept_ = now_.mesh;
  kept_place_ = place_;
}

void Session::undo() {
  if (!can_undo()) return;
  const Change& change = history_[--done_];
  change.mesh.back(kept_);
  kept_place_ = change.before;
  show_kept();
}

void Session::redo() {
  if (!can_redo()) return;
  const Change& change = history_[done_++];
  change.mesh.forward(kept_);
  kept_place_ = change.after;
  show_kept();
}

void Session::show_kept() {
  start_from(kept_place_);
  set_now(measured(kept_, kept_place_.form));
  place_ = kept_place_;
}

void Session::start_from(const Place& place) {
  const bool has_other_weights = place.weighted != place_.weighted;
  if (has_other_weights) {
    problem_ = document_ = prepared(document_.weighted(*place.weighted));
    start_ = as_it_is(document_);
  }
  if (has_other_weights || place.basis != place_.basis) {
    // What was measured against another picture, or by other weights, helps no more.
    if (has_other_weights || place.basis->original != place_.basis->original)
      now_.measured = nullptr;
    problem_ = prepared(problem_on(*place.basis));
  }
  if (!has_other_weights && place.next == place_.next) return;
  retire(curves_, old_curves_);
  // Its own where it is another one, which is then painted in the background.
  const Problem next = place.next == place.basis ? problem_ : problem_on(*place.next);
  kinds_ = curve_kinds(next);
  curves_ = std::make_unique<CurveSearch>(next);
  if (std::ranges::find(kinds_, place.form) != kinds_.end()) curves_->want(place.form);
}

Problem Session::problem_on(const Basis& basis) const {
  const bool has_its_picture = basis.original == problem_.original();
  return (has_its_picture ? problem_ : document_.with_original(basis.original))
      .with_mesh(basis.start);
}

void Session::protect(const std::vector<Face>& faces, bool is_protected) {
  if (is_protected)
    set_protected(faces, {}, Message("Protect patches: {0}", faces.size()));
  else
    set_protected({}, faces, Message("Protect patches no longer: {0}", faces.size()));
}

void Session::protect_others(const std::vector<Face>& faces) {
  std::vector<Face> others;
  for (const Face face : now_.mesh.faces())
    if (std::ranges::find(faces, face) == faces.end()) others.push_back(face);
  set_protected(others, faces, Message("Protect all other patches"));
}

void Session::set_protected(const std::vector<Face>& fixed, const std::vector<Face>& released,
                            const Message& name) {
  Mesh mesh = now_.mesh, start = *place_.next->start;
  const std::vector<Face> fixed_there = faces_there(mesh, fixed, start);
  const std::vector<Face> released_there = faces_there(mesh, released, start);
  Journal journal(mesh), journal_there(start);
  set_fixed(journal, released, false);
  set_fixed(journal, fixed, true);
  // What lies under both stays as it is.
  set_fixed(journal_there, released_there, false);
  set_fixed(journal_there, fixed_there, true);
  Place place = place_as(place_.form, is_start_of_curve(now_.mesh) ? 0 : -1);
  Basis next = *place.next;
  next.start = std::make_shared<const Mesh>(std::move(start));
  const bool is_one = place.basis == place.next;
  place.next = std::make_shared<const Basis>(std::move(next));
  if (is_one) place.basis = place.next;
  start_from(place);
  become(measured(mesh, place.form), place, name);
}

void Session::weigh(const std::vector<Face>& faces, double factor) {
  if (!(factor >= least_weight && factor <= most_weight))
    throw InputError("errors may count a quarter to four times.");
  if (faces.empty())
    throw InputError("there are no patches in which errors could count otherwise.");
  std::vector<WeightedArea> areas = *place_.weighted;
  areas.push_back({{}, factor});
  for (const Face face : faces) areas.back().shapes.push_back(face_outline(now_.mesh, face));
  set_weights(std::move(areas), Message("Let errors count otherwise"));
}

void Session::weigh_alike() { set_weights({}, Message("Let errors count alike")); }

void Session::set_weights(std::vector<WeightedArea> areas, const Message& name) {
  // States of the curve by these weights have other meshes.
  Place place = place_as(place_.form, is_start_of_curve(now_.mesh) ? 0 : -1);
  place.weighted = std::make_shared<const std::vector<WeightedArea>>(std::move(areas));
  start_from(place);
  become(measured(now_.mesh, place.form), place, name);
}

double Session::weight_at(Face face) const {
  const Frame& frame = problem_.frame();
  if (!frame.weights) return 1;
  const glm::dvec2 at = frame.to_pixels.point(now_.mesh.patch(face).at(0.5, 0.5).position);
  const int x = clamped_pixel(std::floor(at.x)), y = clamped_pixel(std::floor(at.y));
  const bool is_inside = x >= 0 && y >= 0 && x < frame.width && y < frame.height;
  return is_inside ? *frame.weights->at(x, y) : 1;
}

std::vector<Face> Session::protected_faces() const {
  std::vector<Face> faces;
  for (const Face face : now_.mesh.faces())
    if (now_.mesh.is_fixed(face)) faces.push_back(face);
  return faces;
}

std::vector<Face> Session::faces_numbered(const std::vector<int>& numbers) const {
  const Mesh& mesh = now_.mesh;
  std::vector<Face> faces;
  for (const int number : numbers) {
    const bool is_there =
        number >= 0 && std::size_t(number) < mesh.face_slots() && mesh[Face{number}].alive;
    if (!is_there) throw InputError("there is no patch {0} in the mesh that is shown.", number);
    faces.push_back(Face{number});
  }
  return faces;
}

std::size_t Session::history_bytes() const {
  std::size_t sum = 0;
  for (const Change& change : history_) sum += change.mesh.bytes();
  return sum;
}

}  // namespace gradmesh
