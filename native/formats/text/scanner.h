#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace gradmesh {

/// The largest coordinate of a drawing; larger numbers are refused before they can overflow.
inline constexpr double max_coordinate = 1e9;

/// Reads numbers and single characters from an attribute's value, front to back, whatever the
/// locale. Every read skips blanks first.
class Scanner {
 public:
  explicit Scanner(std::string_view text) : rest_(text) {}

  /// Returns true if nothing but blanks is left.
  bool at_end();
  /// Returns the next character that is not blank; 0 at the end.
  char peek();
  /// Takes the next character if it is `c`. Returns true if it was.
  bool accept(char c);
  /// Takes one comma if there is one, as may separate two numbers.
  void skip_comma() { accept(','); }
  /// Takes letters, digits and '-' and returns them; empty if there are none.
  std::string_view word();
  /// Takes a finite number of at most `max_coordinate` and returns it; otherwise returns nothing
  /// and takes nothing. The words `nan` and `inf` are no numbers in SVG.
  std::optional<double> number();
  /// Takes a flag of an elliptical arc, 0 or 1, which no separator need follow, and returns it.
  std::optional<bool> flag();
  /// Returns the text that has not been read.
  std::string_view rest() const { return rest_; }

 private:
  void skip_blanks();

  std::string_view rest_;
};

bool is_blank(char c);
std::string_view trimmed(std::string_view text);
/// Returns the text with ASCII letters in lower case, as CSS compares its keywords.
std::string lower(std::string_view text);

/// Returns an opacity as Inkscape 1.2 reads it: the number that the text begins with, clamped to
/// [0, 1]. Inkscape knows no percentages here: 50% is read as 50, and so as 1.
std::optional<double> parse_opacity(std::string_view text);
/// Returns in user units a number with an optional absolute unit (px, in, cm, mm, pt, pc), or a
/// percentage of `whole`; nothing if it is a percentage and `whole` is not given.
std::optional<double> parse_length(std::string_view text, std::optional<double> whole);

}  // namespace gradmesh
