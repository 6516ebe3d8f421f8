#include "formats/svg/gradient/color_texts.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "formats/svg/gradient/mesh_gradient.h"
#include "formats/svg/gradient/rows.h"
#include "formats/svg/tree/own.h"
#include "formats/svg/values/color.h"
#include "formats/svg/values/mesh_names.h"
#include "formats/svg/xml/node.h"

namespace gradmesh {
namespace {

/// What rounding to 8 bits may do, and a little of what a memory rounds.
constexpr double rounded_away = 0.501 / 255;

/// More than that nobody picks by hand, and attributes have limits.
constexpr std::size_t longest_list = 1'000'000;

std::string colors_name(const MeshObject& object) {
  return object.is_group() ? "colors" : paint_name(object.role) + std::string("-colors");
}

void add_stops(const SvgTree& tree, const xmlNode* gradient, ColorTexts& texts) {
  const xmlNode* const holder = gradient ? rows_holder(tree, gradient) : nullptr;
  if (!holder) return;
  for (const xmlNode* row : mesh_rows(holder))
    for (const xmlNode* patch : mesh_patches(row))
      for (const xmlNode* stop : child_elements(patch, "stop"))
        texts.add(stop_color_text(tree.styles(), stop));
}

}  // namespace

double ColorText::opacity_beside(double opacity) const {
  return color.a > 0 ? std::min(1.0, opacity / color.a) : 1.0;
}

void ColorTexts::add(std::string_view text) {
  std::string own = own_color_text(text);
  if (own.empty()) return;
  const glm::dvec4 color = *parse_translucent_color(own);
  const auto [first, last] = texts_.equal_range(color.r);
  const auto is_same = [&](const auto& known) { return known.second.text == own; };
  if (std::any_of(first, last, is_same)) return;
  texts_.emplace(color.r, ColorText{std::move(own), color});
}

void ColorTexts::add_list(std::string_view list) {
  while (!list.empty()) {
    const std::size_t end = std::min(list.find(';'), list.size());
    add(list.substr(0, end));
    list.remove_prefix(std::min(end + 1, list.size()));
  }
}

std::string ColorTexts::list() const {
  std::string list;
  for (const auto& [red, text] : texts_) list.append(list.empty() ? "" : ";").append(text.text);
  return list;
}

const ColorText* ColorTexts::find(const glm::dvec4& color) const {
  const ColorText* best = nullptr;
  double least = rounded_away;
  for (auto at = texts_.lower_bound(color.r - rounded_away);
       at != texts_.end() && at->first <= color.r + rounded_away; ++at) {
    const glm::dvec4 difference = color - at->second.color;
    if (difference.a > rounded_away) continue;
    const double most =
        std::max({std::abs(difference.r), std::abs(difference.g), std::abs(difference.b)});
    if (most > least || (best && most == least)) continue;
    best = &at->second;
    least = most;
  }
  return best;
}

ColorTexts color_texts(const SvgTree& tree, const MeshObject& object) {
  ColorTexts texts;
  if (const auto list = own_attribute(object.node, colors_name(object).c_str()))
    texts.add_list(*list);
  if (!object.is_group()) {
    add_stops(tree, object.gradient, texts);
    return texts;
  }
  for (const xmlNode* path : child_elements(object.node))
    if (is_block(path))
      add_stops(tree, referenced_mesh(tree, tree.styles().declared(path, "fill")), texts);
  return texts;
}

void remember_color_texts(const MeshObject& object, const ColorTexts& texts) {
  std::string list = texts.list();
  if (list.size() > longest_list) list.clear();
  set_own_attribute(object.node, colors_name(object).c_str(), list);
}

}  // namespace gradmesh
