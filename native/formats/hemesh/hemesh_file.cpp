#include "formats/hemesh/hemesh_file.h"

#include <charconv>
#include <cmath>

#include "base/error.h"
#include "formats/text/excerpt.h"
#include "formats/text/number.h"
#include "formats/text/scanner.h"

namespace gradmesh {
namespace {

class LineReader {
 public:
  LineReader(std::string_view text, const std::string& name) : text_(text), name_(name) {}

  /// Goes to the next line. Returns false if only blanks follow.
  bool advance() {
    if (trimmed(text_).empty()) return false;
    const std::size_t end = std::min(text_.find('\n'), text_.size());
    rest_ = trimmed(text_.substr(0, end));
    text_.remove_prefix(std::min(end + 1, text_.size()));
    ++line_;
    values_ = 0;
    return true;
  }

  bool at_end() const { return rest_.empty(); }
  std::string_view rest() const { return rest_; }

  std::string_view word() {
    ++values_;
    if (at_end()) fail(Message("value {0} is missing", values_));
    std::size_t end = 0;
    while (end < rest_.size() && !is_blank(rest_[end])) ++end;
    const std::string_view result = rest_.substr(0, end);
    rest_ = trimmed(rest_.substr(end));
    return result;
  }

  double number() {
    const std::string_view text = word();
    double value = 0;
    if (!parses_as(text, value) || !(std::abs(value) <= largest_hemesh_number))
      fail(Message("{0} is not a number, or not between -1e9 and 1e9", excerpt(text)));
    return value;
  }

  int integer() {
    const std::string_view text = word();
    int value = 0;
    if (!parses_as(text, value)) fail(Message("{0} is not a whole number", excerpt(text)));
    return value;
  }

  glm::dvec2 pair() {
    const double x = number();
    return {x, number()};
  }
  /// Reads a colour or a derivative of one, and adds `alpha`, the fourth channel that the format
  /// lacks.
  glm::dvec4 color(double alpha) {
    const double r = number(), g = number();
    return {r, g, number(), alpha};
  }
  Value derivative() {
    const glm::dvec2 position = pair();
    return {position, color(0)};
  }

  void expect_end() const {
    if (!at_end()) fail(Message("{0} is too much", excerpt(rest_)));
  }

  [[noreturn]] void fail(const Message& reason) const { fail_at_line(name_, line_, reason); }

 private:
  template <class Number>
  static bool parses_as(std::string_view text, Number& value) {
    const char* end = text.data() + text.size();
    const auto result = std::from_chars(text.data(), end, value);
    return result.ec == std::errc{} && result.ptr == end;
  }

  std::string_view text_;
  const std::string& name_;
  std::string_view rest_;
  int line_ = 0;
  int values_ = 0;
};

HemeshFile::Halfedge parse_halfedge(LineReader& line) {
  HemeshFile::Halfedge h;
  line.pair();
  h.twist = line.derivative();
  h.color = line.color(1);
  h.handles[0] = line.integer();
  h.handles[1] = line.integer();
  h.twin = line.integer();
  h.prev = line.integer();
  h.next = line.integer();
  h.patch = line.integer();
  // The first child: some writers put any word here.
  line.word();
  h.is_child = line.integer() != 0;
  if (h.is_child) {
    h.parent = line.integer();
    line.integer();
    line.integer();
    const glm::dvec2 interval = line.pair();
    h.interval = {interval.x, interval.y};
    h.recolored = !line.at_end() && line.integer() != 0;
  } else {
    line.integer();
    line.integer();
    h.origin = line.integer();
  }
  return h;
}

std::array<int, 4> parse_counts(LineReader& lines, std::string_view text) {
  std::array<int, 4> counts;
  for (int& count : counts) {
    count = lines.integer();
    // Each record takes at least two bytes, so no count can ask for absurd amounts of memory.
    if (count < 0 || std::size_t(count) > text.size())
      lines.fail(Message("it announces {0} records, which cannot be", count));
  }
  lines.expect_end();
  return counts;
}

/// Text of numbers with blanks between and a line break at the end.
class LineWriter {
 public:
  LineWriter& operator<<(int value) { return put(std::to_string(value)); }
  // Adding 0 makes 0 of -0.
  LineWriter& operator<<(double value) { return put(format_exactly(value + 0.0)); }
  LineWriter& operator<<(glm::dvec2 v) { return *this << v.x << v.y; }
  LineWriter& operator<<(glm::dvec4 color) { return *this << color.r << color.g << color.b; }
  LineWriter& operator<<(const Value& v) { return *this << v.position << v.color; }
  LineWriter& operator<<(Interval interval) { return *this << interval.first << interval.second; }
  LineWriter& operator<<(const std::array<int, 2>& pair) { return *this << pair[0] << pair[1]; }

  void end_line() {
    text_ += '\n';
    at_start_ = true;
  }
  void heading(std::string_view line) {
    text_ += line;
    end_line();
  }
  std::string text() && { return std::move(text_); }

 private:
  LineWriter& put(const std::string& value) {
    if (!at_start_) text_ += ' ';
    text_ += value;
    at_start_ = false;
    return *this;
  }

  std::string text_;
  bool at_start_ = true;
};

}  // namespace

void fail_at_line(const std::string& name, int line, const Message& reason) {
  throw InputError("{0}, line {1}: {2}.", name, line, reason);
}

HemeshFile parse_hemesh(std::string_view text, const std::string& name) {
  LineReader lines(text, name);
  if (!lines.advance() || lines.rest() != "HEMESH")
    fail_at_line(name, 1, Message("it does not say HEMESH, so this is no .hemesh file"));
  const auto next_line = [&] {
    if (!lines.advance()) throw InputError("{0}: the file ends too early.", name);
  };
  next_line();
  const auto [points, handles, patches, halfedges] = parse_counts(lines, text);

  HemeshFile file;
  for (int i = 0; i < points; ++i) {
    next_line();
    const glm::dvec2 position = lines.pair();
    file.points.push_back({position, lines.integer()});
    lines.expect_end();
  }
  for (int i = 0; i < handles; ++i) {
    next_line();
    const int halfedge = lines.integer();
    file.handles.push_back({halfedge, lines.derivative()});
    lines.expect_end();
  }
  for (int i = 0; i < patches; ++i) {
    next_line();
    file.patches.push_back(lines.integer());
    lines.expect_end();
  }
  for (int i = 0; i < halfedges; ++i) {
    next_line();
    file.halfedges.push_back(parse_halfedge(lines));
  }
  if (lines.advance()) lines.fail(Message("there are more lines than line 2 announces"));
  return file;
}

std::string format_hemesh(const HemeshFile& file) {
  LineWriter out;
  out.heading("HEMESH");
  out << int(file.points.size()) << int(file.handles.size()) << int(file.patches.size())
      << int(file.halfedges.size());
  out.end_line();
  for (const HemeshFile::Point& p : file.points) {
    out << p.position << p.halfedge;
    out.end_line();
  }
  for (const HemeshFile::Handle& handle : file.handles) {
    out << handle.halfedge << handle.tangent;
    out.end_line();
  }
  for (const int halfedge : file.patches) {
    out << halfedge;
    out.end_line();
  }
  for (const HemeshFile::Halfedge& h : file.halfedges) {
    out << h.interval << h.twist << h.color << h.handles << h.twin << h.prev << h.next << h.patch
        << h.first_child << int(h.is_child);
    if (h.is_child)
      out << h.parent << h.handles << h.interval << int(h.recolored);
    else
      out << h.handles << h.origin;
    out.end_line();
  }
  return std::move(out).text();
}

}  // namespace gradmesh
