#include "formats/pdf/page/layers.h"

#include <algorithm>
#include <vector>

#include "formats/pdf/objects/dictionary.h"

namespace gradmesh {
namespace {

/// Expressions and memberships of strangers may lie in one another without end.
constexpr int deepest = 32;

/// Returns what the usage of a layer says of viewing it: by the categories of a usage application
/// (ISO 32000-1, tables 102 and 103) whose answer depends on nothing but the event.
std::optional<bool> state_by_usage(QPDFObjectHandle layer, QPDFObjectHandle categories) {
  std::optional<bool> state;
  for (QPDFObjectHandle category : elements_of(categories)) {
    if (!category.isName()) continue;
    const std::string name = category.getName();
    for (const char* which : {"/View", "/Print", "/Export"}) {
      if (name != which) continue;
      QPDFObjectHandle said = value_of(value_of(value_of(layer, "/Usage"), name), name + "State");
      if (said.isNameAndEquals("/OFF")) return false;
      if (said.isNameAndEquals("/ON")) state = true;
    }
  }
  return state;
}

}  // namespace

Layers::Layers(QPDFObjectHandle catalog) {
  QPDFObjectHandle usual = value_of(value_of(catalog, "/OCProperties"), "/D");
  is_on_ = !value_of(usual, "/BaseState").isNameAndEquals("/OFF");
  set(value_of(usual, "/ON"), true);
  set(value_of(usual, "/OFF"), false);
  set_by_usage(value_of(usual, "/AS"));
}

void Layers::set(QPDFObjectHandle layers, bool is_on) {
  for (QPDFObjectHandle layer : elements_of(layers)) known_[layer.getObjGen()] = is_on;
}

void Layers::set_by_usage(QPDFObjectHandle usages) {
  for (QPDFObjectHandle usage : elements_of(usages)) {
    if (!value_of(usage, "/Event").isNameAndEquals("/View")) continue;
    for (QPDFObjectHandle layer : elements_of(value_of(usage, "/OCGs")))
      if (const auto state = state_by_usage(layer, value_of(usage, "/Category")))
        known_[layer.getObjGen()] = *state;
  }
}

bool Layers::shows(QPDFObjectHandle content, int depth) const {
  if (!content.isDictionary() || depth > deepest) return true;
  if (value_of(content, "/Type").isNameAndEquals("/OCMD")) return shows_membership(content, depth);
  const auto known = known_.find(content.getObjGen());
  return known == known_.end() ? is_on_ : known->second;
}

bool Layers::shows_membership(QPDFObjectHandle membership, int depth) const {
  if (QPDFObjectHandle expression = value_of(membership, "/VE"); expression.isArray())
    return holds(expression, depth + 1);
  QPDFObjectHandle layers = value_of(membership, "/OCGs");
  std::vector<QPDFObjectHandle> all = elements_of(layers);
  if (layers.isDictionary()) all.push_back(layers);
  std::erase_if(all, [](QPDFObjectHandle layer) { return !layer.isDictionary(); });
  if (all.empty()) return true;
  const auto is_shown = [&](QPDFObjectHandle layer) { return shows(layer, depth + 1); };
  QPDFObjectHandle policy = value_of(membership, "/P");
  if (policy.isNameAndEquals("/AllOn")) return std::ranges::all_of(all, is_shown);
  if (policy.isNameAndEquals("/AllOff")) return std::ranges::none_of(all, is_shown);
  if (policy.isNameAndEquals("/AnyOff")) return !std::ranges::all_of(all, is_shown);
  return std::ranges::any_of(all, is_shown);
}

bool Layers::holds(QPDFObjectHandle expression, int depth) const {
  const std::vector<QPDFObjectHandle> parts = elements_of(expression);
  if (depth > deepest || parts.empty()) return true;
  const auto part_holds = [&](QPDFObjectHandle part) {
    return part.isArray() ? holds(part, depth + 1) : shows(part, depth + 1);
  };
  QPDFObjectHandle operation = parts[0];
  const auto first = parts.begin() + 1;
  if (operation.isNameAndEquals("/And")) return std::all_of(first, parts.end(), part_holds);
  if (operation.isNameAndEquals("/Or")) return std::any_of(first, parts.end(), part_holds);
  if (operation.isNameAndEquals("/Not") && parts.size() > 1) return !part_holds(parts[1]);
  return true;
}

}  // namespace gradmesh
