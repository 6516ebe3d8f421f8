#include "formats/code/code_names.h"

#include <algorithm>
#include <array>

namespace gradmesh {
namespace {

/// File systems hold names of 255 bytes, and people read much shorter ones.
constexpr std::size_t longest_name = 48;

/// Names of the languages, and of what apps commonly use of the toolkits: a mesh of such a name
/// would hide that from the whole app.
constexpr std::array reserved{
    "any",      "array",        "bool",         "box",        "brush",        "button",
    "canvas",   "capsule",      "card",         "cgfloat",    "cgpoint",      "cgrect",
    "char",     "circle",       "color",        "column",     "composable",   "content",
    "data",     "date",         "dictionary",   "divider",    "double",       "ellipse",
    "error",    "fillstyle",    "float",        "floatarray", "font",         "foreach",
    "form",     "genericshape", "gradient",     "grid",       "group",        "hstack",
    "icon",     "image",        "int",          "intarray",   "int32",        "int64",
    "label",    "layout",       "link",         "list",       "long",         "longarray",
    "map",      "material",     "menu",         "mesh",       "meshgradient", "meshgradientpainter",
    "modifier", "never",        "nothing",      "offset",     "optional",     "outline",
    "painter",  "path",         "pathfilltype", "picker",     "protocol",     "rectangle",
    "result",   "row",          "scene",        "section",    "self",         "set",
    "shape",    "simd2",        "size",         "slider",     "spacer",       "state",
    "string",   "surface",      "switch",       "tab",        "table",        "task",
    "text",     "textfield",    "theme",        "timer",      "toggle",       "type",
    "uint32",   "unit",         "url",          "vector",     "view",         "void",
    "vstack",   "window",       "zstack"};

bool is_number(char c) { return c >= '0' && c <= '9'; }
bool is_small(char c) { return c >= 'a' && c <= 'z'; }
bool is_capital(char c) { return c >= 'A' && c <= 'Z'; }

std::string in_small_letters(std::string text) {
  for (char& c : text)
    if (is_capital(c)) c = char(c - 'A' + 'a');
  return text;
}

/// Returns the letters and digits of an id, each run of them beginning with a capital.
std::string camel_case(std::string_view id) {
  std::string name;
  bool begins = true;
  for (const char c : id) {
    const bool stays = is_number(c) || is_small(c) || is_capital(c);
    if (stays && name.size() < longest_name)
      name += begins && is_small(c) ? char(c - 'a' + 'A') : c;
    begins = !stays;
  }
  return name;
}

}  // namespace

std::string CodeNames::take(std::string_view id) {
  std::string name = camel_case(id);
  if (name.empty() || is_number(name.front())) name.insert(0, "Mesh");
  const std::string small = in_small_letters(name);
  if (std::ranges::any_of(reserved, [&](const char* word) { return small == word; }))
    name += small == "mesh" ? "1" : "Mesh";
  const auto data_of = [](const std::string& text) {
    return in_small_letters(text + std::string(data_suffix));
  };
  std::string free = name;
  for (int number = 2; taken_.contains(in_small_letters(free)) || taken_.contains(data_of(free));
       ++number)
    free = name + (is_number(name.back()) ? "_" : "") + std::to_string(number);
  taken_.insert({in_small_letters(free), data_of(free)});
  return free;
}

}  // namespace gradmesh
