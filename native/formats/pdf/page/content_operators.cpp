#include "formats/pdf/page/content_operators.h"

#include <algorithm>
#include <iterator>

#include "base/error.h"
#include "base/limits.h"
#include "formats/pdf/page/clip_box.h"
#include "formats/pdf/page/dictionary.h"

namespace gradmesh {

struct ContentOperators::Entry {
  const char* name;
  std::size_t operands;
  Operator does;
};

const ContentOperators::Entry* ContentOperators::find(const std::string& name) {
  using C = ContentOperators;
  // ISO 32000-1, table 51. Strokes only end a path: meshes on strokes are left out.
  static const Entry entries[] = {
      {"q", 0, &C::save},           {"Q", 0, &C::restore},         {"cm", 6, &C::transform},
      {"gs", 1, &C::set_state},     {"m", 2, &C::move_to},         {"l", 2, &C::line_to},
      {"c", 6, &C::curve_to},       {"v", 4, &C::curve_from_here}, {"y", 4, &C::curve_to_there},
      {"re", 4, &C::rectangle},     {"h", 0, &C::close_path},      {"W", 0, &C::clip_nonzero},
      {"W*", 0, &C::clip_evenodd},  {"n", 0, &C::end_path},        {"S", 0, &C::end_path},
      {"s", 0, &C::end_path},       {"f", 0, &C::fill_nonzero},    {"F", 0, &C::fill_nonzero},
      {"f*", 0, &C::fill_evenodd},  {"B", 0, &C::fill_nonzero},    {"B*", 0, &C::fill_evenodd},
      {"b", 0, &C::fill_nonzero},   {"b*", 0, &C::fill_evenodd},   {"scn", 1, &C::set_color},
      {"sc", 1, &C::unset_pattern}, {"cs", 1, &C::unset_pattern},  {"g", 1, &C::unset_pattern},
      {"rg", 3, &C::unset_pattern}, {"k", 4, &C::unset_pattern},   {"sh", 1, &C::paint_shading},
      {"Do", 1, &C::paint_object},
  };
  const auto found = std::ranges::find(entries, name, &Entry::name);
  return found == std::end(entries) ? nullptr : found;
}

void ContentOperators::handleObject(QPDFObjectHandle object, std::size_t, std::size_t) {
  // More operands than any operator has are noise.
  constexpr std::size_t most_operands = 64;
  if (!object.isOperator()) {
    if (operands_.size() < most_operands) operands_.push_back(object);
    return;
  }
  const Entry* const entry = find(object.getOperatorValue());
  if (entry && operands_.size() >= entry->operands) (this->*entry->does)();
  operands_.clear();
}

QPDFObjectHandle ContentOperators::operand(std::size_t n) const {
  return n < operands_.size() ? operands_[n] : QPDFObjectHandle::newNull();
}

double ContentOperators::number(std::size_t n) const { return number_of(operand(n)).value_or(0); }

glm::dvec2 ContentOperators::point(std::size_t n) const { return {number(n), number(n + 1)}; }

QPDFObjectHandle ContentOperators::named(const char* category) const {
  QPDFObjectHandle name = operands_.back();
  if (!name.isName()) return QPDFObjectHandle::newNull();
  return value_of(value_of(resources_, category), name.getName());
}

void ContentOperators::save() {
  const std::uint64_t most = limits().nesting;
  if (saved_.size() < most) return saved_.push_back(state_);
  throw InputError("its content is nested {0} deep, {1}", most + 1,
                   beyond_limit("nesting", most, most + 1));
}

void ContentOperators::restore() {
  if (saved_.empty()) return;
  state_ = std::move(saved_.back());
  saved_.pop_back();
}

void ContentOperators::transform() {
  const Affine map{glm::dmat2(number(0), number(1), number(2), number(3)), point(4)};
  state_.to_page = state_.to_page * map;
}

void ContentOperators::set_state() {
  QPDFObjectHandle state = named("/ExtGState");
  if (const auto alpha = number_of(value_of(state, "/ca")))
    state_.opacity = std::clamp(*alpha, 0.0, 1.0);
  QPDFObjectHandle mask = value_of(state, "/SMask");
  if (mask.isName()) state_.mask = nullptr;
  if (mask.isDictionary()) state_.mask = reader_.mask_of(mask, resources_, state_);
}

void ContentOperators::add_step(PagePath::Step::Kind kind, glm::dvec2 a, glm::dvec2 b,
                                glm::dvec2 to) {
  const Affine& map = state_.to_page;
  path_.steps.push_back({kind, {map.point(a), map.point(b), map.point(to)}});
  here_ = to;
}

void ContentOperators::move_to() {
  begin_ = point(0);
  add_step(PagePath::Step::Kind::move, begin_, begin_, begin_);
}

void ContentOperators::line_to() {
  const glm::dvec2 to = point(0);
  add_step(PagePath::Step::Kind::line, to, to, to);
}

void ContentOperators::curve_to() {
  add_step(PagePath::Step::Kind::curve, point(0), point(2), point(4));
}

void ContentOperators::curve_from_here() {
  add_step(PagePath::Step::Kind::curve, here_, point(0), point(2));
}

void ContentOperators::curve_to_there() {
  add_step(PagePath::Step::Kind::curve, point(0), point(2), point(2));
}

void ContentOperators::rectangle() {
  const glm::dvec2 corner = point(0), size = point(2);
  begin_ = corner;
  add_step(PagePath::Step::Kind::move, corner, corner, corner);
  for (const glm::dvec2 by : {glm::dvec2(size.x, 0), size, glm::dvec2(0, size.y)})
    add_step(PagePath::Step::Kind::line, corner + by, corner + by, corner + by);
  close_path();
}

void ContentOperators::close_path() {
  add_step(PagePath::Step::Kind::close, begin_, begin_, begin_);
}

void ContentOperators::fill(FillRule rule) {
  if (state_.pattern) {
    Clips clips = state_.clips;
    add_to(clips, rule);
    QPDFObjectHandle pattern = *state_.pattern;
    paint(value_of(pattern, "/Shading"), base_ * matrix_of(value_of(pattern, "/Matrix")),
          std::move(clips));
  }
  end_path();
}

void ContentOperators::end_path() {
  if (clip_ && !path_.steps.empty()) add_to(state_.clips, *clip_);
  clip_.reset();
  path_ = {};
}

void ContentOperators::add_to(Clips& clips, FillRule rule) {
  constexpr std::size_t most_clips = 1000;
  if (clips.size() >= most_clips)
    throw InputError("it has more than {0} clip paths inside one another", most_clips);
  path_.rule = rule;
  clips.push_back(std::make_shared<const PagePath>(path_));
}

void ContentOperators::set_color() {
  state_.pattern.reset();
  QPDFObjectHandle pattern = named("/Pattern");
  constexpr double of_a_shading = 2;
  if (number_of(value_of(pattern, "/PatternType")) == of_a_shading) state_.pattern = pattern;
}

void ContentOperators::paint_shading() { paint(named("/Shading"), state_.to_page, state_.clips); }

void ContentOperators::paint(QPDFObjectHandle shading, const Affine& to_page, Clips clips) {
  const auto type = number_of(value_of(shading, "/ShadingType"));
  if (!type || *type < 4) return;
  const std::uint64_t most = limits().patches;
  if (reader_.painted_.size() >= most)
    throw InputError("it has more than {0} shadings, {1}", most,
                     beyond_limit("patches", most, most + 1));
  clip_to_box(clips, shading, to_page);
  reader_.painted_.push_back(
      {shading, to_page, std::move(clips), state_.opacity * state_.group_opacity, state_.mask});
}

void ContentOperators::paint_object() {
  QPDFObjectHandle form = named("/XObject");
  if (form.isStream() && value_of(form, "/Subtype").isNameAndEquals("/Form"))
    reader_.read_form(form, resources_, state_);
}

}  // namespace gradmesh
