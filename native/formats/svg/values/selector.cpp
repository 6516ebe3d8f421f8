#include "formats/svg/values/selector.h"

#include <algorithm>
#include <charconv>
#include <set>
#include <utility>

#include "formats/svg/values/css_text.h"
#include "formats/svg/xml/node.h"
#include "formats/text/scanner.h"

namespace gradmesh {
namespace {

const xmlNode* element_before(const xmlNode* node) {
  do node = node->prev;
  while (node && node->type != XML_ELEMENT_NODE);
  return node;
}

const xmlNode* element_after(const xmlNode* node) {
  do node = node->next;
  while (node && node->type != XML_ELEMENT_NODE);
  return node;
}

bool has_word(std::string_view text, std::string_view word) {
  for (std::size_t i = 0; i < text.size();) {
    std::size_t end = i;
    while (end < text.size() && !is_blank(text[end])) ++end;
    if (text.substr(i, end - i) == word && !word.empty()) return true;
    i = end + 1;
  }
  return false;
}

/// Returns true for an element without comments, elements and texts but blanks.
bool holds_nothing(const xmlNode* element) {
  for (const xmlNode* child = element->children; child; child = child->next)
    if (child->type != XML_TEXT_NODE || !trimmed(view(child->content)).empty()) return false;
  return true;
}

bool speaks(const xmlNode* element, std::string_view language) {
  constexpr std::string_view xml = "http://www.w3.org/XML/1998/namespace";
  for (const xmlNode* node = element; node; node = parent_element(node))
    if (const auto found = attribute(node, "lang", xml)) return found->starts_with(language);
  return false;
}

}  // namespace

bool Selector::Place::holds(const xmlNode* element) const {
  int number = 1;
  for (const xmlNode* node = element;;) {
    node = from_end ? element_after(node) : element_before(node);
    if (!node) break;
    number += !of_type || view(node->name) == view(element->name);
  }
  const int steps = number - b;
  return a == 0 ? steps == 0 : steps % a == 0 && steps / a >= 0;
}

bool Selector::Condition::holds(const xmlNode* element) const {
  switch (kind) {
    case Kind::id:
      return attribute(element, "id") == value;
    case Kind::attribute:
      return attribute(element, name.c_str()).has_value();
    case Kind::equals:
      return attribute(element, name.c_str()) == value;
    case Kind::word:
      return has_word(attribute(element, name.c_str()).value_or(""), value);
    case Kind::prefix: {
      const auto found = attribute(element, name.c_str());
      return found && found->starts_with(value);
    }
    case Kind::place:
      return (!is_root || !parent_element(element)) && (!is_empty || holds_nothing(element)) &&
             std::ranges::all_of(places, [&](const Place& p) { return p.holds(element); });
    case Kind::language:
      return speaks(element, value);
    case Kind::nothing:
      break;
  }
  return false;
}

bool Selector::Compound::holds(const xmlNode* node) const {
  return (element.empty() || element == view(node->name)) &&
         std::ranges::all_of(conditions, [&](const Condition& c) { return c.holds(node); });
}

/// Tries the elements before and around one; none twice for the same compound, of which there would
/// be too many.
class Selector::Search {
 public:
  explicit Search(const std::vector<Compound>& compounds) : compounds_(compounds) {}

  /// Returns true if the first `count` compounds match and the last of these is `node`.
  bool matches(const xmlNode* node, std::size_t count) {
    const Compound& last = compounds_[count - 1];
    if (!last.holds(node)) return false;
    if (count == 1) return true;
    if (!tried_.insert({node, count}).second) return false;
    const bool is_around = last.combinator == ' ' || last.combinator == '>';
    const bool is_next = last.combinator == '>' || last.combinator == '+';
    for (;;) {
      node = is_around ? parent_element(node) : element_before(node);
      if (!node) return false;
      if (matches(node, count - 1)) return true;
      if (is_next) return false;
    }
  }

 private:
  const std::vector<Compound>& compounds_;
  std::set<std::pair<const xmlNode*, std::size_t>> tried_;
};

bool Selector::matches(const xmlNode* element) const {
  return Search(compounds_).matches(element, compounds_.size());
}

Selector::Specificity Selector::specificity() const {
  Specificity sum{};
  for (const Compound& compound : compounds_) {
    sum[2] += !compound.element.empty();
    for (const Condition& condition : compound.conditions)
      ++sum[condition.kind == Kind::id ? 0 : 1];
  }
  return sum;
}

std::string Selector::key() const {
  const Compound& last = compounds_.back();
  for (const Condition& c : last.conditions)
    if (c.kind == Kind::id) return "#" + c.value;
  for (const Condition& c : last.conditions)
    if (c.kind == Kind::word && c.name == "class") return "." + c.value;
  return last.element.empty() ? "*" : last.element;
}

/// Reads selectors from a text without comments.
class SelectorParser {
 public:
  using Compound = Selector::Compound;
  using Condition = Selector::Condition;
  using Kind = Selector::Kind;
  using Place = Selector::Place;

  explicit SelectorParser(std::string_view text) : rest_(trimmed(text)) {}

  std::vector<Selector> list() {
    std::vector<Selector> selectors;
    do {
      Selector selector;
      if (!read(selector)) return {};
      selectors.push_back(std::move(selector));
    } while (take(','));
    return rest_.empty() ? std::move(selectors) : std::vector<Selector>();
  }

 private:
  bool at(std::string_view any) const {
    return !rest_.empty() && any.find(rest_.front()) != any.npos;
  }
  bool take(char c) {
    if (rest_.empty() || rest_.front() != c) return false;
    rest_.remove_prefix(1);
    return true;
  }
  void skip_blanks() {
    while (!rest_.empty() && is_blank(rest_.front())) rest_.remove_prefix(1);
  }

  bool read(Selector& selector) {
    char combinator = ' ';
    skip_blanks();
    do {
      Compound compound{combinator, {}, {}};
      if (!read(compound)) return false;
      selector.compounds_.push_back(std::move(compound));
      skip_blanks();
      combinator = ' ';
      if (at(">+~")) {
        combinator = rest_.front();
        rest_.remove_prefix(1);
        skip_blanks();
      }
    } while (!rest_.empty() && !at(","));
    return true;
  }

  bool read(Compound& compound) {
    const bool is_any = take('*');
    if (!is_any) compound.element = take_css_name(rest_);
    if (!compound.element.empty()) {
      const std::string_view behind = rest_;
      skip_blanks();
      if (!at("#.[:")) rest_ = behind;
    }
    while (at("#.[:"))
      if (!read_condition(compound.conditions)) return false;
    return is_any || !compound.element.empty() || !compound.conditions.empty();
  }

  bool read_condition(std::vector<Condition>& conditions) {
    const char first = rest_.front();
    rest_.remove_prefix(1);
    Condition condition{};
    if (first == '#') {
      condition.kind = Kind::id;
      condition.value = take_css_letters(rest_);
      if (condition.value.empty()) return false;
    } else if (first == '.') {
      condition.kind = Kind::word;
      condition.name = "class";
      condition.value = take_css_name(rest_);
      if (condition.value.empty()) return false;
    } else if (first == '[' ? !read_attribute(condition) : !read_pseudo(condition)) {
      return false;
    }
    conditions.push_back(std::move(condition));
    return true;
  }

  bool read_attribute(Condition& condition) {
    skip_blanks();
    condition.kind = Kind::attribute;
    condition.name = take_css_name(rest_);
    if (condition.name.empty()) return false;
    skip_blanks();
    if (take(']')) return true;
    condition.kind = take('~') ? Kind::word : take('|') ? Kind::prefix : Kind::equals;
    if (!take('=')) return false;
    skip_blanks();
    if (at("\"'")) {
      const std::size_t end = rest_.find(rest_.front(), 1);
      if (end == rest_.npos) return false;
      condition.value = rest_.substr(1, end - 1);
      rest_.remove_prefix(end + 1);
    } else {
      condition.value = take_css_name(rest_);
      if (condition.value.empty()) return false;
    }
    skip_blanks();
    return take(']');
  }

  bool read_pseudo(Condition& condition) {
    const std::string name = take_css_name(rest_);
    if (name.empty()) return false;
    if (take('(')) return read_function(name, condition);
    constexpr Place first, last{0, 1, false, true}, first_of_type{0, 1, true, false},
        last_of_type{0, 1, true, true};
    condition.kind = Kind::place;
    if (name == "root") {
      condition.is_root = true;
    } else if (name == "empty") {
      condition.is_empty = true;
    } else if (name == "first-child") {
      condition.places = {first};
    } else if (name == "last-child") {
      condition.places = {last};
    } else if (name == "only-child") {
      condition.places = {first, last};
    } else if (name == "first-of-type") {
      condition.places = {first_of_type};
    } else if (name == "last-of-type") {
      condition.places = {last_of_type};
    } else if (name == "only-of-type") {
      condition.places = {first_of_type, last_of_type};
    } else {
      condition.kind = Kind::nothing;
    }
    return true;
  }

  bool read_function(const std::string& name, Condition& condition) {
    const std::size_t end = rest_.find(')');
    if (end == rest_.npos) return false;
    const std::string argument(trimmed(rest_.substr(0, end)));
    rest_.remove_prefix(end + 1);
    std::string_view word = argument;
    const bool is_word = !take_css_name(word).empty() && word.empty();
    condition.kind = Kind::nothing;
    if (name == "lang" && is_word) {
      condition.kind = Kind::language;
      condition.value = argument;
    }
    if (!name.starts_with("nth-")) return is_word;
    if (argument.find_first_not_of("0123456789n+- oddev") != argument.npos) return false;
    Place place;
    place.of_type = name == "nth-of-type";
    place.from_end = name == "nth-last-child";
    if (!place.of_type && !place.from_end && name != "nth-child") return true;
    if (read_place(argument, place)) {
      condition.kind = Kind::place;
      condition.places = {place};
    }
    return true;
  }

  /// Reads `odd`, `even`, `b`, `an`, or `an+b`; b is not negative.
  static bool read_place(std::string text, Place& place) {
    std::erase_if(text, is_blank);
    if (text == "odd") text = "2n+1";
    if (text == "even") text = "2n";
    const auto number = [](std::string_view digits, int& result) {
      if (digits.starts_with('+')) digits.remove_prefix(1);
      const auto [end, error] =
          std::from_chars(digits.data(), digits.data() + digits.size(), result);
      return error == std::errc() && end == digits.data() + digits.size() && std::abs(result) < 1e6;
    };
    const std::size_t n = text.find('n');
    if (n == text.npos) return number(text, place.b);
    const std::string a = text.substr(0, n), b = text.substr(n + 1);
    place.b = 0;
    if (!b.empty() && (b[0] != '+' || !number(b, place.b))) return false;
    if (a.empty() || a == "+" || a == "-") {
      place.a = a == "-" ? -1 : 1;
      return true;
    }
    return number(a, place.a);
  }

  std::string_view rest_;
};

std::vector<Selector> parse_selectors(std::string_view text) { return SelectorParser(text).list(); }

}  // namespace gradmesh
