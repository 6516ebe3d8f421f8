#include "window/eye/eye.h"

#include <algorithm>
#include <cstdlib>

#include "ops/color.h"

namespace gradmesh {
namespace {

/// Within how many pixels of the pointer a line is meant, on an ordinary screen.
constexpr double reach = 8;

/// Returns the patch that is the reason for an error; invalid if none is.
Face forbidding(const InputError& error) {
  const auto* const by_patch = dynamic_cast<const PatchForbids*>(&error);
  return by_patch ? by_patch->face : Face();
}

}  // namespace

Eye::Eye(std::vector<std::string> ids, Open open)
    : ids_(std::move(ids)), open_(std::move(open)), open_ones_(ids_.size()) {
  look_at_mesh(0);
}

void Eye::choose(std::size_t which) {
  refusal_.reset();
  forget_proposal();
  try {
    look_at_mesh(which);
  } catch (const InputError& error) {
    refusal_ = error.message();
  }
}

void Eye::look_at_mesh(std::size_t which) {
  if (!open_ones_[which]) open_ones_[which] = open_(ids_[which]);
  chosen_ = which;
  const glm::dvec2 size = viewport_.size();
  viewport_ = Viewport(editing().box());
  viewport_.resize(size);
  forget();
}

std::vector<const Editing*> Eye::changed() const {
  std::vector<const Editing*> changed;
  for (const auto& one : open_ones_)
    if (one && !one->session.shown().is_unchanged()) changed.push_back(one.get());
  return changed;
}

bool Eye::has_hand_work() const {
  return std::ranges::any_of(open_ones_, [](const auto& one) {
    if (!one) return false;
    const Session& session = one->session;
    return session.shown().state() < 0 || session.shown().is_made_by_hand() ||
           session.shown().problem().frame().weights || session.mesh().has_fixed_faces();
  });
}

SessionView Eye::view() const {
  SessionView view;
  view.width = int(viewport_.size().x);
  view.height = int(viewport_.size().y);
  view.density = density;
  view.to_pixels = to_pixels();
  view.split = looks.split;
  if (looks.flickers) {
    view.ground = SessionView::Ground::original;
    view.lines = view.proposal = false;
    return view;
  }
  view.ground = looks.ground;
  view.lines = looks.lines;
  view.handles = looks.handles;
  view.analysis = looks.known;
  if (looks.known == AnalysisKind::regions) view.patch = patch();
  view.region = looks.region;
  view.marked = marked_;
  return view;
}

void Eye::look_at(const WorstPlace& place) {
  viewport_.look_at(editing().view.point(place.place));
  circles_worst = true;
}

void Eye::forget_reasons() {
  refusal_.reset();
  why_not_.reset();
  forbids_ = {};
}

void Eye::attempt(const std::function<void(Session&)>& deed) {
  forget_reasons();
  try {
    session().hands().set_fits(fits);
    deed(session());
    forget();
  } catch (const InputError& error) {
    refusal_ = error.message();
    forbids_ = forbidding(error);
  }
  ++revision_;
}

void Eye::propose(const std::function<void(Session&)>& work_out) {
  forget_reasons();
  try {
    session().hands().set_fits(fits);
    work_out(session());
  } catch (const InputError& error) {
    session().hands().forget_proposal();
    why_not_ = error.message();
    forbids_ = forbidding(error);
  }
  ++revision_;
}

void Eye::forget_proposal() {
  if (!refusal_) forget_reasons();
  if (!session().hands().proposal()) return;
  session().hands().forget_proposal();
  ++revision_;
}

bool Eye::make() {
  if (!session().hands().proposal()) return false;
  attempt([](Session& session) { session.hands().make(); });
  return true;
}

std::optional<Pointed> Eye::pointed_at(glm::dvec2 pixel) const {
  return gradmesh::pointed_at(session().mesh(), to_pixels(), pixel, reach * density);
}

std::optional<CurveSearch::Found> Eye::curve() const {
  return session().curves().found(session().shown().form());
}

void Eye::slide(int state, bool moves_on) {
  const auto found = curve();
  if (!found || found->curve.states.empty()) return;
  state = std::clamp(state, 0, int(found->curve.states.size()) - 1);
  if (moves_on && state == session().shown().state()) return;
  attempt([&](Session& s) { s.show(s.shown().form(), state, moves_on); });
}

void Eye::step(int by) {
  if (session().shown().state() >= 0) return slide(session().shown().state() + by);
  const auto found = curve();
  if (!found) return;
  const std::vector<CurveState>& states = found->curve.states;
  // What was made by hand is where its own curve begins.
  if (session().mesh() == *states.front().mesh) return slide(by);
  const int handles = session().shown().now().counts().handles;
  const auto closest = std::ranges::min_element(states, {}, [&](const CurveState& state) {
    return std::abs(state.counts.handles - handles);
  });
  slide(int(closest - states.begin()));
}

void Eye::mark(const std::vector<Face>& faces, bool adds) {
  if (!adds) marked_.clear();
  marks_price_.reset();
  marked_.insert(marked_.end(), faces.begin(), faces.end());
  std::ranges::sort(marked_);
  marked_.erase(std::unique(marked_.begin(), marked_.end()), marked_.end());
}

void Eye::toggle_mark(Face face) {
  marks_price_.reset();
  if (std::erase(marked_, face) == 0) mark({face}, true);
}

void Eye::unmark() {
  marked_.clear();
  marks_price_.reset();
}

void Eye::price_marks() {
  marks_price_.reset();
  if (marked_.size() < 2) return;
  propose([&](Session& session) { session.hands().propose_merge(marked_); });
  const Proposal* const proposal = session().hands().proposal();
  marks_price_ = MarksPrice{proposal ? proposal->written.error : 0, why_not_};
  forget_proposal();
}

bool Eye::marks_are_protected() const {
  return !marked_.empty() &&
         std::ranges::all_of(marked_, [&](Face face) { return session().mesh().is_fixed(face); });
}

std::vector<Face> Eye::to_merge() const {
  if (marked_.size() > 1) return marked_;
  const std::vector<RegionPrice> all = regions();
  return std::size_t(looks.region) < all.size() ? all[std::size_t(looks.region)].patches : marked_;
}

void Eye::merge_marked() {
  attempt([faces = to_merge()](Session& session) {
    session.hands().propose_merge(faces);
    session.hands().make();
  });
}

void Eye::protect_marked() {
  const bool is_release = marks_are_protected();
  attempt([&](Session& session) { session.protection().protect(marked_, !is_release); });
}

void Eye::protect_others() {
  attempt([&](Session& session) { session.protection().protect_others(marked_); });
}

const std::vector<WorstPlace>& Eye::worst_places() {
  if (!worst_) worst_ = session().shown().worst_places(worst_count);
  return *worst_;
}

std::shared_ptr<const Analysis> Eye::known() const {
  return looks.known ? session().shown().analysis(*looks.known) : nullptr;
}

std::vector<RegionPrice> Eye::regions() const {
  const auto found = known();
  if (looks.known != AnalysisKind::regions || !found || !patch().valid()) return {};
  return largest_regions(*found, patch());
}

void Eye::step_region(int by) {
  const int count = int(regions().size());
  looks.region = count ? (looks.region + by + count) % count : 0;
}

void Eye::propose_color(const glm::dvec3& color) {
  const Mesh& mesh = session().mesh();
  const std::vector<Halfedge> corners = corners_at(mesh, element.point);
  if (corners.empty()) return;
  chosen_color = color;
  Pointed pointed;
  pointed.face = mesh.face(corners.front());
  pointed.corner = corners.front();
  propose([&](Session& session) { session.hands().propose_color(pointed, color, false); });
}

void Eye::make_color() {
  // Who has chosen a colour may want another.
  const Element kept = element;
  make();
  element = kept;
  chosen_color.reset();
}

void Eye::pick_color(glm::dvec2 pixel) {
  picks_color = false;
  propose_color(color_at(session(), view(), pixel));
  make_color();
}

void Eye::look_for_news(bool is_moving) {
  const auto found = curve();
  is_busy_ = found && !found->is_complete;
  if (!looks.known) return;
  if (!is_moving) {
    session().hands().set_fits(fits);
    session().analyses().request(*looks.known);
  }
  const bool is_known = known() != nullptr;
  if (is_known != was_known_) ++revision_;
  was_known_ = is_known;
  is_busy_ = is_busy_ || !is_known;
}

void Eye::forget() {
  unmark();
  why_not_.reset();
  patch_at_pointer = {};
  element = {};
  chosen_color.reset();
  picks_color = false;
  looks.region = 0;
  was_known_ = false;
  worst_.reset();
  circles_worst = false;
  ++revision_;
}

}  // namespace gradmesh
