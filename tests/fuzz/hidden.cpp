#include "raster/hidden.h"

#include <algorithm>
#include <cmath>

#include "choices.h"
#include "target.h"

namespace gradmesh::fuzz {
namespace {

/// Outlines of 1e-9 to 1e9 pixels, in one document, also far outside the frame.
class Outlines {
 public:
  explicit Outlines(Choices& choices) : choices_(choices) {}

  VisibleArea next() {
    VisibleArea area;
    for (unsigned sets = choices_.byte() % 3; sets > 0; --sets) {
      std::vector<FilledOutline>& set = area.sets.emplace_back();
      for (unsigned n = choices_.byte() % 3; n > 0; --n)
        set.push_back({outline(), choices_.byte() % 2 ? FillRule::evenodd : FillRule::nonzero});
    }
    return area;
  }

  double size() { return std::pow(10, int(choices_.byte() % 19) - 9); }

 private:
  Outline outline() {
    Outline result;
    for (unsigned polygons = choices_.byte() % 3; polygons > 0; --polygons) {
      std::vector<glm::dvec2>& polygon = result.emplace_back();
      for (unsigned points = choices_.byte() % 8; points > 0; --points) {
        const double x = coordinate();
        polygon.push_back({x, coordinate()});
      }
    }
    return result;
  }
  /// Also whole numbers, so that sides lie on the lines that are looked at.
  double coordinate() {
    const int share = int(choices_.byte()) - 128;
    return size() * (share % 2 ? share : share / 128.0);
  }

  Choices& choices_;
};

void require_rows(const HiddenPixels& hidden, const Frame& frame) {
  for (int y = 0; y < frame.height; ++y) {
    int end = -1;
    for (const HiddenPixels::Run run : hidden.row(y)) {
      require(end < run.begin && run.begin < run.end && run.end <= frame.width, "runs are apart");
      end = run.end;
      require(hidden.contains(run.begin, y) && !hidden.contains(run.end, y), "runs are hidden");
    }
  }
}

}  // namespace

void check(std::string_view bytes) {
  Choices choices(bytes);
  Frame frame{1 + int(choices.byte() % 40), 1 + int(choices.byte() % 40)};
  Outlines outlines(choices);
  frame.to_pixels = Affine::scaling({outlines.size(), outlines.size()});
  const VisibleArea area = outlines.next();
  require_rows(HiddenPixels(area, frame), frame);
}

}  // namespace gradmesh::fuzz
