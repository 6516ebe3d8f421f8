#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace gradmesh {

/// No coordinate of a drawing is larger; numbers beyond are refused before they can overflow.
inline constexpr double max_coordinate = 1e9;

/// Reads numbers and single characters from an attribute's value, front to back, whatever the
/// locale. Every read skips blanks first.
class Scanner {
 public:
  explicit Scanner(std::string_view text) : rest_(text) {}

  /// Nothing but blanks is left.
  bool at_end();
  /// Next character that is not blank; 0 at the end.
  char peek();
  /// Takes the next character if it is `c`.
  bool accept(char c);
  /// Takes one comma if there is one: what may separate two numbers.
  void skip_comma() { accept(','); }
  /// Takes letters, digits and '-'; empty where there are none.
  std::string_view word();
  /// A finite number of at most `max_coordinate`; nothing, and nothing taken, otherwise. The
  /// words `nan` and `inf` are no numbers in SVG.
  std::optional<double> number();
  /// A flag of an elliptical arc, 0 or 1; no separator need follow it.
  std::optional<bool> flag();
  /// What has not been read.
  std::string_view rest() const { return rest_; }

 private:
  void skip_blanks();

  std::string_view rest_;
};

bool is_blank(char c);
std::string_view trimmed(std::string_view text);
/// ASCII letters only, as CSS compares its keywords.
std::string lower(std::string_view text);

/// All of `text` as one number in the sense of Scanner::number.
std::optional<double> parse_number(std::string_view text);
/// An opacity as Inkscape 1.2 reads it: the number that the text begins with, clamped to [0, 1]. It
/// knows no percentages: 50% are 50, and so 1.
std::optional<double> parse_opacity(std::string_view text);
/// Number with an optional absolute unit (px, in, cm, mm, pt, pc) in user units, or a percentage
/// of `whole`; a percentage of nothing has no value.
std::optional<double> parse_length(std::string_view text, std::optional<double> whole);

}  // namespace gradmesh
