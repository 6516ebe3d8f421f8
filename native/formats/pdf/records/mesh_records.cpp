#include "formats/pdf/records/mesh_records.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>

#include "base/clamped_int.h"
#include "base/limits.h"
#include "formats/pdf/grid/joined_curves.h"

namespace gradmesh {
namespace {

/// A corner, with the handles to the next corner and to the one before, counterclockwise.
struct Node {
  glm::dvec2 place, next, before;
};

/// A point of a side that has no colour, with its handles against and along the grid's direction.
struct Anchor {
  glm::dvec2 place, back, on;
};

/// Four corners from the lower left on, counterclockwise, and the anchors of the left, lower, right
/// and upper side, each from left to right or from below.
struct RecordPatch {
  int column = 0, row = 0;
  std::vector<Node> nodes;
  std::array<std::vector<Anchor>, 4> anchors;
};

/// A command of a record: its operands as text, and its name.
struct Command {
  std::string_view operands, name;
};

/// Reads the commands of one record, which may go over several lines.
class Commands {
 public:
  explicit Commands(std::string_view text) : rest_(text) {}

  std::optional<Command> next() {
    const std::size_t end = rest_.find(" X#");
    if (end == rest_.npos) return {};
    std::string_view command = rest_.substr(0, end);
    rest_.remove_prefix(end + 3);
    const std::size_t name = command.find_last_of(" /");
    if (name == command.npos) return Command{{}, command};
    return Command{command.substr(0, name), command.substr(name + 1)};
  }

 private:
  std::string_view rest_;
};

/// Returns the last numbers of an array, or nothing if there are not as many.
template <std::size_t count>
std::optional<std::array<double, count>> last_numbers(std::string_view operands) {
  constexpr double farthest = 1e6;
  const std::size_t end = operands.rfind(']');
  if (end == operands.npos) return {};
  std::string_view rest = operands.substr(0, end);
  std::array<double, count> numbers;
  for (std::size_t n = count; n-- > 0;) {
    const std::size_t last = rest.find_last_not_of(" \r\n");
    if (last == rest.npos) return {};
    rest = rest.substr(0, last + 1);
    const std::size_t begin = rest.find_last_of(" [\r\n");
    const std::string_view word = rest.substr(begin == rest.npos ? 0 : begin + 1);
    const auto read = std::from_chars(word.data(), word.data() + word.size(), numbers[n]);
    if (read.ec != std::errc() || read.ptr != word.data() + word.size() ||
        !(std::abs(numbers[n]) <= farthest))
      return {};
    rest.remove_suffix(word.size());
  }
  return numbers;
}

/// Records have y up.
glm::dvec2 point(double x, double y) { return {x, -y}; }

/// A record as it is read, command by command.
class Record {
 public:
  /// Returns false where the record is broken.
  bool take(const Command& command) {
    if (command.name == "Size") return take_size(command.operands);
    if (command.name == "P") return begin_patch(command.operands);
    if (command.name == "N") return add_node(command.operands);
    if (command.name == "A" || command.name == "S") return add_anchor(command.operands);
    return true;
  }

  int rows() const { return rows_; }
  int columns() const { return columns_; }
  const std::vector<RecordPatch>& patches() const { return patches_; }

 private:
  bool take_size(std::string_view operands) {
    const auto size = last_numbers<2>(operands);
    if (!size || rows_ > 0) return false;
    const int most = clamped_int(double(limits().patches), 1, 1 << 20);
    columns_ = clamped_int((*size)[0], 0, most);
    rows_ = clamped_int((*size)[1], 0, most);
    return rows_ > 0 && columns_ > 0 && std::int64_t(rows_) * columns_ <= most;
  }

  bool begin_patch(std::string_view operands) {
    const auto place = last_numbers<2>(operands);
    if (!place || patches_.size() >= std::size_t(rows_) * std::size_t(columns_)) return false;
    RecordPatch& patch = patches_.emplace_back();
    patch.column = clamped_int((*place)[0], -1, columns_);
    patch.row = clamped_int((*place)[1], -1, rows_);
    return patch.column >= 0 && patch.column < columns_ && patch.row >= 0 && patch.row < rows_;
  }

  bool add_node(std::string_view operands) {
    // Before these are the colour and perhaps the opacity.
    const auto n = last_numbers<8>(operands);
    if (!n || patches_.empty() || patches_.back().nodes.size() >= 4) return false;
    patches_.back().nodes.push_back(
        {point((*n)[0], (*n)[1]), point((*n)[2], (*n)[3]), point((*n)[5], (*n)[6])});
    return true;
  }

  bool add_anchor(std::string_view operands) {
    constexpr std::size_t most_anchors = 1000;
    const auto n = last_numbers<7>(operands);
    if (!n || patches_.empty()) return false;
    RecordPatch& patch = patches_.back();
    if (patch.nodes.size() >= 4) return false;
    std::vector<Anchor>& side = patch.anchors[patch.nodes.size()];
    side.push_back({point((*n)[0], (*n)[1]), point((*n)[2], (*n)[3]), point((*n)[4], (*n)[5])});
    return side.size() <= most_anchors;
  }

  int rows_ = 0, columns_ = 0;
  std::vector<RecordPatch> patches_;
};

/// Returns the one curve from a corner to another, with these handles and anchors between.
ControlRow side_through(glm::dvec2 from, glm::dvec2 from_handle, const std::vector<Anchor>& anchors,
                        glm::dvec2 to_handle, glm::dvec2 to) {
  std::vector<ControlRow> rows;
  for (const Anchor& anchor : anchors) {
    rows.push_back({from, from_handle, anchor.back, anchor.place});
    from = anchor.place;
    from_handle = anchor.on;
  }
  rows.push_back({from, from_handle, to_handle, to});
  return rows.size() == 1 ? rows.front() : closest_line(parts_by_speed(rows));
}

std::vector<Anchor> reversed(std::vector<Anchor> anchors) {
  std::reverse(anchors.begin(), anchors.end());
  for (Anchor& anchor : anchors) std::swap(anchor.back, anchor.on);
  return anchors;
}

/// Returns the sides from the upper left corner on, clockwise.
std::array<ControlRow, 4> sides_of(const RecordPatch& patch) {
  const Node &lower_left = patch.nodes[0], &lower_right = patch.nodes[1],
             &upper_right = patch.nodes[2], &upper_left = patch.nodes[3];
  const auto& [left, lower, right, upper] = patch.anchors;
  return {
      side_through(upper_left.place, upper_left.before, upper, upper_right.next, upper_right.place),
      side_through(upper_right.place, upper_right.before, reversed(right), lower_right.next,
                   lower_right.place),
      side_through(lower_right.place, lower_right.before, reversed(lower), lower_left.next,
                   lower_left.place),
      side_through(lower_left.place, lower_left.before, left, upper_left.next, upper_left.place)};
}

std::optional<ArtistsGrid> grid_of(const Record& record) {
  const auto count = std::size_t(record.rows()) * std::size_t(record.columns());
  if (count == 0 || record.patches().size() != count) return {};
  std::vector<std::optional<std::array<ControlRow, 4>>> sides(count);
  const auto at = [&](int row, int column) -> std::optional<std::array<ControlRow, 4>>& {
    return sides[std::size_t(row) * std::size_t(record.columns()) + std::size_t(column)];
  };
  for (const RecordPatch& patch : record.patches()) {
    // Row 0 of the record is the lowest.
    auto& own = at(record.rows() - 1 - patch.row, patch.column);
    if (own || patch.nodes.size() != 4) return {};
    own = sides_of(patch);
  }
  ArtistsGrid grid{record.rows(), record.columns(), {}, true};
  for (int i = 0; i < grid.rows; ++i)
    for (int j = 0; j < grid.columns; ++j) {
      std::array<ControlRow, 4>& own = *at(i, j);
      // Neighbours have one side, whichever of both says how it runs.
      if (i > 0) own[0] = reversed_row((*at(i - 1, j))[2]);
      if (j > 0) own[3] = reversed_row((*at(i, j - 1))[1]);
      PagePatch& patch = grid.patches.emplace_back();
      for (std::size_t k = 0; k < 4; ++k)
        for (std::size_t n = 0; n < 3; ++n) patch.outer[3 * k + n] = own[k][n];
      set_zero_twist(patch);
    }
  return grid;
}

}  // namespace

std::vector<ArtistsGrid> read_mesh_records(std::string_view data) {
  constexpr std::string_view begin = "/Mesh X!", end = "/End X!";
  std::vector<ArtistsGrid> grids;
  for (std::size_t at = data.find(begin); at != data.npos; at = data.find(begin, at)) {
    at += begin.size();
    const std::size_t last = data.find(end, at);
    if (last == data.npos) break;
    Record record;
    Commands commands(data.substr(at, last - at));
    bool is_whole = true;
    while (is_whole)
      if (const auto command = commands.next())
        is_whole = record.take(*command);
      else
        break;
    if (auto grid = is_whole ? grid_of(record) : std::nullopt) grids.push_back(*std::move(grid));
    at = last;
  }
  return grids;
}

}  // namespace gradmesh
