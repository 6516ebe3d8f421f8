#include "formats/pdf/page/content_operators.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "base/error.h"
#include "base/limits.h"
#include "formats/pdf/objects/dictionary.h"
#include "formats/pdf/page/clip_box.h"
#include "formats/pdf/page/graphics_state.h"
#include "formats/pdf/page/pattern_cell.h"

namespace gradmesh {
namespace {

/// Returns a path without the steps after which nothing is drawn: no stroke shows them.
PagePath without_idle_moves(const PagePath& path) {
  PagePath drawn;
  const auto is_move = [](const PagePath::Step& step) {
    return step.kind == PagePath::Step::Kind::move;
  };
  for (std::size_t n = 0; n < path.steps.size(); ++n)
    if (!is_move(path.steps[n]) || (n + 1 < path.steps.size() && !is_move(path.steps[n + 1])))
      drawn.steps.push_back(path.steps[n]);
  return drawn;
}

std::shared_ptr<const NamedSpaces> named_spaces(QPDFObjectHandle resources) {
  QPDFObjectHandle spaces = value_of(resources, "/ColorSpace");
  if (!spaces.isDictionary() || spaces.getKeys().empty()) return nullptr;
  return std::make_shared<const NamedSpaces>(NamedSpaces{spaces, spaces.unparse()});
}

/// Returns false if a coordinate is farther than those of any page, or no number at all.
bool lies_near_pages(const PagePath& path) {
  constexpr double farthest = 1e6;
  return std::ranges::all_of(path.steps, [](const PagePath::Step& step) {
    return std::ranges::all_of(step.points, [](const glm::dvec2& point) {
      return std::abs(point.x) <= farthest && std::abs(point.y) <= farthest;
    });
  });
}

}  // namespace

ContentOperators::ContentOperators(ContentReader& reader, QPDFObjectHandle resources,
                                   const GraphicsState& state)
    : reader_(reader),
      resources_(std::move(resources)),
      spaces_(named_spaces(resources_)),
      base_(state.to_page),
      state_(state) {}

struct ContentOperators::Entry {
  const char* name;
  std::size_t operands;
  Operator does;
  /// Whether text that is shown before and behind it may be one area.
  bool continues_text = false;
};

const ContentOperators::Entry* ContentOperators::find(const std::string& name) {
  using C = ContentOperators;
  constexpr FillRule nonzero = FillRule::nonzero, evenodd = FillRule::evenodd;
  // ISO 32000-1, table 51.
  static const Entry entries[] = {
      {"BDC", 2, &C::begin_layer},
      {"BMC", 0, &C::begin_marked},
      {"EMC", 0, &C::end_marked},
      {"q", 0, &C::save},
      {"Q", 0, &C::restore},
      {"cm", 6, &C::transform},
      {"gs", 1, &C::set_state},
      {"w", 1, &C::set_width},
      {"J", 1, &C::set_cap},
      {"j", 1, &C::set_join},
      {"M", 1, &C::set_miter},
      {"d", 2, &C::set_dash},
      {"m", 2, &C::move_to},
      {"l", 2, &C::line_to},
      {"c", 6, &C::curve_to},
      {"v", 4, &C::curve_from_here},
      {"y", 4, &C::curve_to_there},
      {"re", 4, &C::rectangle},
      {"h", 0, &C::close_path},
      {"W", 0, &C::clip_nonzero},
      {"W*", 0, &C::clip_evenodd},
      {"n", 0, &C::end_path},
      {"f", 0, &C::fill_path<nonzero>},
      {"F", 0, &C::fill_path<nonzero>},
      {"f*", 0, &C::fill_path<evenodd>},
      {"S", 0, &C::stroke_path},
      {"s", 0, &C::close_and_stroke},
      {"B", 0, &C::fill_and_stroke<nonzero>},
      {"B*", 0, &C::fill_and_stroke<evenodd>},
      {"b", 0, &C::close_fill_and_stroke<nonzero>},
      {"b*", 0, &C::close_fill_and_stroke<evenodd>},
      {"scn", 1, &C::set_fill_color},
      {"sc", 1, &C::unset_fill_pattern},
      {"cs", 1, &C::unset_fill_pattern},
      {"g", 1, &C::unset_fill_pattern},
      {"rg", 3, &C::unset_fill_pattern},
      {"k", 4, &C::unset_fill_pattern},
      {"SCN", 1, &C::set_stroke_color},
      {"SC", 1, &C::unset_stroke_pattern},
      {"CS", 1, &C::unset_stroke_pattern},
      {"G", 1, &C::unset_stroke_pattern},
      {"RG", 3, &C::unset_stroke_pattern},
      {"K", 4, &C::unset_stroke_pattern},
      {"BT", 0, &C::begin_text},
      {"ET", 0, &C::end_text},
      {"Tr", 1, &C::set_text_mode},
      {"Tf", 2, &C::set_font, true},
      {"Tc", 1, &C::set_character_space, true},
      {"Tw", 1, &C::set_word_space, true},
      {"Tz", 1, &C::set_text_scale, true},
      {"TL", 1, &C::set_leading, true},
      {"Ts", 1, &C::set_rise, true},
      {"Td", 2, &C::move_line, true},
      {"TD", 2, &C::move_line_and_set_leading, true},
      {"Tm", 6, &C::set_text_matrix, true},
      {"T*", 0, &C::next_line, true},
      {"Tj", 1, &C::show_text, true},
      {"TJ", 1, &C::show_texts, true},
      {"'", 1, &C::show_on_next_line, true},
      {"\"", 3, &C::show_spaced_on_next_line, true},
      {"sh", 1, &C::paint_shading},
      {"Do", 1, &C::paint_object},
  };
  const auto found = std::ranges::find(entries, name, &Entry::name);
  return found == std::end(entries) ? nullptr : found;
}

void ContentOperators::handleObject(QPDFObjectHandle object, std::size_t, std::size_t) {
  // More operands than any operator has are noise.
  constexpr std::size_t most_operands = 64;
  if (object.isInlineImage()) return mark_other();
  if (!object.isOperator()) {
    if (operands_.size() < most_operands) operands_.push_back(object);
    return;
  }
  const Entry* const entry = find(object.getOperatorValue());
  if (!entry || !entry->continues_text) paint_text();
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

void ContentOperators::begin_layer() {
  QPDFObjectHandle tag = operand(operands_.size() - 2);
  const bool is_off = tag.isNameAndEquals("/OC") && !reader_.layers().shows(named("/Properties"));
  marked_.push_back(is_off);
  hidden_ += is_off;
}

void ContentOperators::end_marked() {
  if (marked_.empty()) return;
  hidden_ -= marked_.back();
  marked_.pop_back();
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

void ContentOperators::transform() { state_.to_page = state_.to_page * map_of_operands(); }

Affine ContentOperators::map_of_operands() const {
  return {glm::dmat2(number(0), number(1), number(2), number(3)), point(4)};
}

void ContentOperators::set_state() {
  QPDFObjectHandle state = named("/ExtGState");
  if (const auto alpha = number_of(value_of(state, "/ca")))
    state_.opacity = std::clamp(*alpha, 0.0, 1.0);
  if (const auto alpha = number_of(value_of(state, "/CA")))
    state_.stroke_opacity = std::clamp(*alpha, 0.0, 1.0);
  if (QPDFObjectHandle modes = value_of(state, "/BM"); !modes.isNull())
    state_.blend_mode = blend_mode_of(modes);
  set_line_style(state_.line, state);
  QPDFObjectHandle mask = value_of(state, "/SMask");
  if (mask.isName() || mask.isDictionary()) reader_.set_mask(mask, resources_, state_);
}

void ContentOperators::add_step(PagePath::Step::Kind kind, glm::dvec2 a, glm::dvec2 b,
                                glm::dvec2 to) {
  // What comes before the first point of a path is an error, and no path of SVG.
  if (path_.steps.empty() && kind != PagePath::Step::Kind::move) return;
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
  // Closed twice, its part would be followed by another one, of a single point.
  if (!path_.steps.empty() && path_.steps.back().kind == PagePath::Step::Kind::close) return;
  add_step(PagePath::Step::Kind::close, begin_, begin_, begin_);
}

template <FillRule rule>
void ContentOperators::fill_path() {
  path_.rule = rule;
  fill(path_);
  end_path();
}

void ContentOperators::stroke_path() {
  stroke(path_);
  end_path();
}

void ContentOperators::close_and_stroke() {
  close_path();
  stroke_path();
}

template <FillRule rule>
void ContentOperators::fill_and_stroke() {
  path_.rule = rule;
  fill(path_);
  stroke_path();
}

template <FillRule rule>
void ContentOperators::close_fill_and_stroke() {
  close_path();
  fill_and_stroke<rule>();
}

void ContentOperators::fill(const PagePath& area) {
  if (!state_.pattern) return mark_area(area);
  Clips clips = state_.clips;
  add_to(clips, area);
  paint_pattern(*state_.pattern, std::move(clips), state_.opacity, nullptr);
}

void ContentOperators::stroke(const PagePath& path) {
  if (!state_.stroke_pattern) return mark_other();
  PagePath drawn = without_idle_moves(path);
  if (drawn.steps.empty() || !lies_near_pages(drawn)) return;
  paint_pattern(*state_.stroke_pattern, state_.clips, state_.stroke_opacity,
                std::make_shared<const PageStroke>(
                    page_stroke(std::move(drawn), state_.line, state_.to_page)));
}

void ContentOperators::end_path() {
  if (clip_ && !path_.steps.empty()) {
    path_.rule = *clip_;
    add_to(state_.clips, path_);
  }
  clip_.reset();
  path_ = {};
}

void ContentOperators::add_to(Clips& clips, const PagePath& area) {
  constexpr std::size_t most_clips = 1000;
  if (clips.size() >= most_clips)
    throw InputError("it has more than {0} clip paths inside one another", most_clips);
  clips.push_back(std::make_shared<const PagePath>(area));
}

void ContentOperators::mark_area(const PagePath& path) {
  if (!reader_.marks_ || is_hidden()) return;
  MaskArea area{state_.clips, state_.opacity};
  for (const PageGroup* group = state_.group.get(); group; group = group->around.get())
    area.opacity *= group->opacity;
  add_to(area.clips, path);
  if (state_.mask || state_.group_mask || !state_.mask_clips.empty()) return mark_other();
  reader_.marks_->areas.push_back(std::move(area));
}

void ContentOperators::mark_other() {
  if (reader_.marks_ && !is_hidden()) reader_.marks_->has_others = true;
}

void ContentOperators::set_color(std::optional<PagePattern>& pattern) {
  pattern.reset();
  if (QPDFObjectHandle found = named("/Pattern"); !found.isNull())
    pattern = {found, base_ * matrix_of(value_of(found, "/Matrix")), resources_, spaces_};
}

void ContentOperators::paint_shading() {
  paint({named("/Shading"), spaces_, state_.to_page, state_.clips, state_.opacity, nullptr});
}

void ContentOperators::paint_pattern(const PagePattern& pattern, Clips clips, double opacity,
                                     std::shared_ptr<const PageStroke> stroke) {
  QPDFObjectHandle object = pattern.object;
  if (object.isStream()) return paint_cell(pattern, std::move(clips), opacity, std::move(stroke));
  paint({value_of(object, "/Shading"), pattern.spaces, pattern.to_page, std::move(clips), opacity,
         nullptr, std::move(stroke)});
}

void ContentOperators::paint_cell(const PagePattern& pattern, Clips clips, double opacity,
                                  std::shared_ptr<const PageStroke> stroke) {
  if (reader_.marks_) return mark_other();
  const Affine& to_page = pattern.to_page;
  const PatternCell cell =
      cell_within(pattern.object, to_page, stroke ? stroke->path : *clips.back());
  GraphicsState inside = state_;
  inside.to_page = to_page * Affine::translation(cell.place);
  inside.clips = std::move(clips);
  clip_to_box(inside.clips, pattern.object, inside.to_page);
  begin_group(inside, {.opacity = opacity});
  inside.pattern.reset();
  inside.stroke_pattern.reset();
  inside.text = {};
  inside.line = {};
  inside.is_hidden = is_hidden();
  inside.is_repeated = state_.is_repeated || !cell.is_only;
  if (stroke) inside.stroke_around = std::move(stroke);
  reader_.read_within(pattern.object, pattern.resources, inside);
}

void ContentOperators::paint(PaintedShading painted) {
  const auto type = number_of(value_of(painted.shading, "/ShadingType"));
  if (!type || *type < 4) return mark_other();
  if (is_hidden()) {
    ++reader_.hidden_;
    return;
  }
  const std::uint64_t most = limits().patches;
  if (reader_.painted_.size() >= most)
    throw InputError("it has more than {0} shadings, {1}", most,
                     beyond_limit("patches", most, most + 1));
  clip_to_box(painted.clips, painted.shading, painted.to_page);
  painted.clips.insert(painted.clips.begin(), state_.mask_clips.begin(), state_.mask_clips.end());
  painted.opacity *= state_.mask_opacity;
  painted.is_repeated = state_.is_repeated;
  painted.has_text_boxes = state_.has_text_boxes;
  if (!painted.stroke) painted.stroke = state_.stroke_around;
  painted.blend_mode = state_.blend_mode;
  painted.group = state_.group;
  painted.mask = through_both(state_.group_mask, state_.mask);
  reader_.painted_.push_back(std::move(painted));
}

void ContentOperators::paint_object() {
  QPDFObjectHandle form = named("/XObject");
  if (!form.isStream() || !value_of(form, "/Subtype").isNameAndEquals("/Form")) return mark_other();
  GraphicsState state = state_;
  state.is_hidden = is_hidden();
  reader_.read_form(form, resources_, std::move(state));
}

}  // namespace gradmesh
