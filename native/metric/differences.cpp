#include "metric/differences.h"

#include <algorithm>
#include <cstdint>
#include <cstring>

namespace gradmesh {
namespace {

constexpr int largest_width = 768, largest_height = 64;
/// Up to so many columns between two tiles cost less than what a tile computes around itself.
constexpr int smallest_gap = 16;

int pieces(int length, int largest) { return (length + largest - 1) / largest; }

/// A loop that vectorises.
void mark(const std::uint8_t* a, const std::uint8_t* b, int count,
          std::uint8_t* __restrict differing) {
  for (int i = 0; i < count; ++i) differing[i] |= a[i] ^ b[i];
}

/// Finds the tiles of one strip of rows.
class StripSearch {
 public:
  StripSearch(const Image& a, const Image& b, Window searched, Window strip, int reach)
      : a_(a), b_(b), strip_(strip), reach_(reach), seen_(strip.grown(reach).clipped(searched)) {}

  void append_to(std::vector<Window>& tiles) const {
    if (seen_.empty()) return;
    static thread_local std::vector<std::uint8_t> differing;
    mark_columns(differing);
    int begin = 0, end = 0;
    for (int x = seen_.x0; x < seen_.x1; ++x) {
      if (differing[x - seen_.x0] == 0) continue;
      if (x - reach_ > end + smallest_gap || begin == end) {
        append_run(begin, end, tiles);
        begin = x - reach_;
      }
      end = x + 1 + reach_;
    }
    append_run(begin, end, tiles);
  }

 private:
  /// Sets the bytes of the columns in which any pixel differs to anything but 0.
  void mark_columns(std::vector<std::uint8_t>& differing) const {
    const int width = seen_.width();
    differing.assign(width, 0);
    for (int c = 0; c < 3; ++c)
      for (int y = seen_.y0; y < seen_.y1; ++y)
        mark(a_.at(seen_.x0, y, c), b_.at(seen_.x0, y, c), width, differing.data());
  }

  /// Cuts columns [begin, end) where they are too many.
  void append_run(int begin, int end, std::vector<Window>& tiles) const {
    begin = std::max(begin, strip_.x0);
    end = std::min(end, strip_.x1);
    const int width = end - begin, count = pieces(width, largest_width);
    for (int i = 0; i < count; ++i)
      append_trimmed(begin + width * i / count, begin + width * (i + 1) / count, tiles);
  }

  /// Leaves out rows at the top and the bottom that no difference reaches.
  void append_trimmed(int begin, int end, std::vector<Window>& tiles) const {
    const int x0 = std::max(begin - reach_, seen_.x0), x1 = std::min(end + reach_, seen_.x1);
    int first = seen_.y0, last = seen_.y1 - 1;
    while (first <= last && equal(first, x0, x1)) ++first;
    while (first <= last && equal(last, x0, x1)) --last;
    const Window tile = {begin, std::max(first - reach_, strip_.y0), end,
                         std::min(last + 1 + reach_, strip_.y1)};
    if (first <= last) tiles.push_back(tile);
  }

  bool equal(int y, int x0, int x1) const {
    for (int c = 0; c < 3; ++c)
      if (std::memcmp(a_.at(x0, y, c), b_.at(x0, y, c), x1 - x0) != 0) return false;
    return true;
  }

  const Image &a_, &b_;
  Window strip_;
  int reach_;
  Window seen_;  ///< Where differences are looked for.
};

}  // namespace

void append_tiles_near_differences(const Image& a, const Image& b, Window searched, Window window,
                                   int reach, std::vector<Window>& tiles) {
  const int height = window.height(), count = pieces(height, largest_height);
  for (int i = 0; i < count; ++i) {
    const Window strip = {window.x0, window.y0 + height * i / count, window.x1,
                          window.y0 + height * (i + 1) / count};
    StripSearch(a, b, searched, strip, reach).append_to(tiles);
  }
}

}  // namespace gradmesh
