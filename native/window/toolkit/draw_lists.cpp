#include "window/toolkit/draw_lists.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "base/clamped_int.h"
#include "window/toolkit/imgui_versions.h"

namespace gradmesh {
namespace {

/// Pixels [x0, x1) x [y0, y1).
struct Clip {
  int x0, y0, x1, y1;
};

/// Returns the first pixel whose centre is at or beyond a place.
int first_pixel(float place) { return clamped_int(std::ceil(double(place) - 0.5), -1, 1 << 20); }

/// A number that changes evenly over the plane.
struct Slope {
  float at_origin = 0, along_x = 0, along_y = 0;

  float at(float x, float y) const { return at_origin + along_x * x + along_y * y; }
};

int channel(ImU32 color, int shift) { return int(color >> shift & 255); }

std::uint32_t mixed(std::uint32_t below, std::array<int, 3> color, int opacity) {
  if (opacity >= 255) return std::uint32_t(color[0] << 16 | color[1] << 8 | color[2]);
  std::uint32_t result = 0;
  for (int c = 0; c < 3; ++c) {
    const int shift = 16 - 8 * c, was = int(below >> shift & 255);
    // To the nearest, as of all whole numbers from 0 to 255 * 255.
    const int sum = color[std::size_t(c)] * opacity + was * (255 - opacity) + 127;
    result |= std::uint32_t(sum / 255) << shift;
  }
  return result;
}

class ListPainter {
 public:
  ListPainter(const Surface& surface, const Clip& clip, const Texture* texture)
      : surface_(surface), clip_(clip), texture_(texture) {}

  void triangle(const ImDrawVert& a, const ImDrawVert& b, const ImDrawVert& c);
  /// Paints the rectangle between two corners that are opposite, whose colours are those of `a`.
  void rectangle(const ImDrawVert& a, const ImDrawVert& c);

 private:
  struct Sample {
    std::array<int, 3> color;
    int opacity;
  };

  /// Returns the place in the texture of a place from 0 to 1.
  std::size_t place_in_texture(float u, float v) const {
    const int x = clamped_int(std::floor(double(u) * texture_->width), 0, texture_->width - 1);
    const int y = clamped_int(std::floor(double(v) * texture_->height), 0, texture_->height - 1);
    return std::size_t(y) * std::size_t(texture_->width) + std::size_t(x);
  }
  /// Changes a colour and its opacity to what the texture makes of them at a place in it.
  void take_texture(std::size_t at, Sample& sample) const {
    if (texture_->opacity) {
      sample.opacity = (sample.opacity * texture_->opacity[at] + 127) / 255;
      return;
    }
    for (int c = 0; c < 3; ++c) {
      int& of = sample.color[std::size_t(c)];
      of = (of * int(texture_->colors[at] >> (16 - 8 * c) & 255) + 127) / 255;
    }
  }
  void put(int x, int y, const Sample& sample) const {
    if (sample.opacity <= 0) return;
    std::uint32_t& pixel = surface_.pixels[std::ptrdiff_t(y) * surface_.stride + x];
    pixel = mixed(pixel, sample.color, sample.opacity);
  }

  /// Puts the same into the pixels [x0, x1) of a row.
  void fill_row(int y, int x0, int x1, const Sample& sample) const;

  const Surface& surface_;
  const Clip clip_;
  const Texture* const texture_;
};

void ListPainter::rectangle(const ImDrawVert& a, const ImDrawVert& c) {
  const int x0 = std::max(first_pixel(a.pos.x), clip_.x0);
  const int y0 = std::max(first_pixel(a.pos.y), clip_.y0);
  const int x1 = std::min(first_pixel(c.pos.x), clip_.x1);
  const int y1 = std::min(first_pixel(c.pos.y), clip_.y1);
  const float du = (c.uv.x - a.uv.x) / (c.pos.x - a.pos.x);
  const float dv = (c.uv.y - a.uv.y) / (c.pos.y - a.pos.y);
  const Sample whole{{channel(a.col, IM_COL32_R_SHIFT), channel(a.col, IM_COL32_G_SHIFT),
                      channel(a.col, IM_COL32_B_SHIFT)},
                     channel(a.col, IM_COL32_A_SHIFT)};
  if (x0 >= x1) return;
  const auto u = [&](int x) { return a.uv.x + du * (float(x) + 0.5F - a.pos.x); };
  const auto v = [&](int y) { return a.uv.y + dv * (float(y) + 0.5F - a.pos.y); };
  // Most rectangles are of one colour: their texture is a place without size.
  if (!texture_ || (du == 0 && dv == 0)) {
    Sample sample = whole;
    if (texture_) take_texture(place_in_texture(u(x0), v(y0)), sample);
    for (int y = y0; y < y1; ++y) fill_row(y, x0, x1, sample);
    return;
  }
  std::vector<std::size_t> columns;
  for (int x = x0; x < x1; ++x) columns.push_back(place_in_texture(u(x), 0));
  const bool is_copy = texture_->colors && a.col == IM_COL32_WHITE;
  for (int y = y0; y < y1; ++y) {
    const std::size_t row = place_in_texture(0, v(y));
    std::uint32_t* const pixels = surface_.pixels + std::ptrdiff_t(y) * surface_.stride;
    for (int x = x0; x < x1; ++x) {
      const std::size_t at = row + columns[std::size_t(x - x0)];
      if (is_copy) {
        pixels[x] = texture_->colors[at] & 0xffffff;
        continue;
      }
      Sample sample = whole;
      take_texture(at, sample);
      put(x, y, sample);
    }
  }
}

void ListPainter::fill_row(int y, int x0, int x1, const Sample& sample) const {
  if (sample.opacity < 255) {
    for (int x = x0; x < x1; ++x) put(x, y, sample);
    return;
  }
  std::uint32_t* const row = surface_.pixels + std::ptrdiff_t(y) * surface_.stride;
  std::fill(row + x0, row + x1, mixed(0, sample.color, sample.opacity));
}

constexpr int parts = 256;

/// Returns the place of a pixel's centre in 256ths of a pixel.
std::int64_t in_parts(int pixel) { return std::int64_t(pixel) * parts + parts / 2; }

std::array<std::int64_t, 2> in_parts(ImVec2 place) {
  static constexpr double most = 1 << 20;
  const auto whole = [](double value) {
    return std::int64_t(std::llround(std::clamp(value, -most, most) * parts));
  };
  return {whole(double(place.x)), whole(double(place.y))};
}

/// Returns the quotient of a number and one above 0, rounded down.
std::int64_t floored(std::int64_t number, std::int64_t by) {
  return number >= 0 ? number / by : -((by - 1 - number) / by);
}

int limited(std::int64_t pixel, int least, int most) {
  return int(std::clamp<std::int64_t>(pixel, least, most));
}

/// One side of a triangle whose corners come clockwise, y downwards: which pixels are inside of it.
/// Places are in 256ths of a pixel, so that two triangles with the same side agree.
class Edge {
 public:
  Edge(const std::array<std::int64_t, 2>& from, const std::array<std::int64_t, 2>& to)
      : from_(from), dx_(to[0] - from[0]), dy_(to[1] - from[1]) {
    const bool is_top = dy_ == 0 && dx_ > 0, is_left = dy_ < 0;
    // A centre on a side is inside of the triangle right of it or below.
    least_ = is_top || is_left ? 0 : 1;
  }

  /// Takes of the pixels [x0, x1) of a row those away that are not inside.
  void clip(int y, int& x0, int& x1) const {
    // Inside is where dx (y - from.y) - dy (x - from.x) >= least.
    const std::int64_t room = dx_ * (in_parts(y) - from_[1]) - least_;
    if (dy_ == 0 && room < 0) x1 = x0;
    // The last place that is inside, or the first one: counted from the centre of pixel 0.
    if (dy_ > 0)
      x1 = limited(floored(from_[0] + floored(room, dy_) - parts / 2, parts) + 1, x0, x1);
    if (dy_ < 0)
      x0 = limited(-floored(-(from_[0] - floored(room, -dy_) - parts / 2), parts), x0, x1);
  }

 private:
  const std::array<std::int64_t, 2> from_;
  const std::int64_t dx_, dy_;
  std::int64_t least_;
};

void ListPainter::triangle(const ImDrawVert& first, const ImDrawVert& second,
                           const ImDrawVert& third) {
  std::array<const ImDrawVert*, 3> v{&first, &second, &third};
  const auto doubled_area = [&] {
    const ImVec2 a = v[0]->pos, b = v[1]->pos, c = v[2]->pos;
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
  };
  if (doubled_area() < 0) std::swap(v[1], v[2]);
  const float area = doubled_area();
  if (!(area > 0)) return;
  const ImVec2 a = v[0]->pos, b = v[1]->pos, c = v[2]->pos;
  const auto slope = [&](float of_a, float of_b, float of_c) {
    Slope s;
    s.along_x = ((of_b - of_a) * (c.y - a.y) - (of_c - of_a) * (b.y - a.y)) / area;
    s.along_y = ((of_c - of_a) * (b.x - a.x) - (of_b - of_a) * (c.x - a.x)) / area;
    s.at_origin = of_a - s.along_x * a.x - s.along_y * a.y;
    return s;
  };
  const auto of_color = [&](int shift) {
    return slope(float(channel(v[0]->col, shift)), float(channel(v[1]->col, shift)),
                 float(channel(v[2]->col, shift)));
  };
  const std::array<Slope, 4> colors{of_color(IM_COL32_R_SHIFT), of_color(IM_COL32_G_SHIFT),
                                    of_color(IM_COL32_B_SHIFT), of_color(IM_COL32_A_SHIFT)};
  const Slope u = slope(v[0]->uv.x, v[1]->uv.x, v[2]->uv.x);
  const Slope w = slope(v[0]->uv.y, v[1]->uv.y, v[2]->uv.y);
  const auto pa = in_parts(a), pb = in_parts(b), pc = in_parts(c);
  const std::array<Edge, 3> edges{Edge(pa, pb), Edge(pb, pc), Edge(pc, pa)};
  const int x0 = std::max(first_pixel(std::min({a.x, b.x, c.x})) - 1, clip_.x0);
  const int y0 = std::max(first_pixel(std::min({a.y, b.y, c.y})) - 1, clip_.y0);
  const int x1 = std::min(first_pixel(std::max({a.x, b.x, c.x})) + 1, clip_.x1);
  const int y1 = std::min(first_pixel(std::max({a.y, b.y, c.y})) + 1, clip_.y1);
  for (int y = y0; y < y1; ++y) {
    int first_x = x0, end = std::max(x0, x1);
    for (const Edge& edge : edges) edge.clip(y, first_x, end);
    for (int x = first_x; x < end; ++x) {
      const float fx = float(x) + 0.5F, fy = float(y) + 0.5F;
      const auto level = [&](const Slope& s) {
        return clamped_int(std::round(double(s.at(fx, fy))), 0, 255);
      };
      Sample sample{{level(colors[0]), level(colors[1]), level(colors[2])}, level(colors[3])};
      if (texture_) take_texture(place_in_texture(u.at(fx, fy), w.at(fx, fy)), sample);
      put(x, y, sample);
    }
  }
}

/// Returns true if four corners, in turn, are those of a rectangle along the axes from its top left
/// corner on, in one colour and with a piece of the texture that lies likewise.
bool is_rectangle(const ImDrawVert& a, const ImDrawVert& b, const ImDrawVert& c,
                  const ImDrawVert& d) {
  const auto is_one = [](ImVec2 p, ImVec2 q, ImVec2 r, ImVec2 s) {
    return p.y == q.y && q.x == r.x && r.y == s.y && s.x == p.x;
  };
  return a.col == b.col && b.col == c.col && c.col == d.col && a.pos.x < c.pos.x &&
         a.pos.y < c.pos.y && is_one(a.pos, b.pos, c.pos, d.pos) && is_one(a.uv, b.uv, c.uv, d.uv);
}

void paint(const ImDrawList& list, const ImDrawCmd& command, const ListPainter& shared) {
  ListPainter painter = shared;
  const ImDrawVert* const vertices = list.VtxBuffer.Data + command.VtxOffset;
  const ImDrawIdx* const indices = list.IdxBuffer.Data + command.IdxOffset;
  for (unsigned i = 0; i + 3 <= command.ElemCount; i += 3) {
    const ImDrawIdx* const at = indices + i;
    const ImDrawVert &a = vertices[at[0]], &b = vertices[at[1]], &c = vertices[at[2]];
    // Two triangles a, b, c and a, c, d: most of what is drawn is such rectangles.
    if (i + 6 <= command.ElemCount && at[3] == at[0] && at[4] == at[2] &&
        is_rectangle(a, b, c, vertices[at[5]])) {
      painter.rectangle(a, c);
      i += 3;
    } else {
      painter.triangle(a, b, c);
    }
  }
}

}  // namespace

void paint(const ImDrawData& data, const Surface& surface) {
  for (int n = 0; n < data.CmdListsCount; ++n)
    for (const ImDrawCmd& command : data.CmdLists[n]->CmdBuffer) {
      if (command.UserCallback) continue;
      const auto whole = [](float place, int most) {
        return clamped_int(std::round(double(place)), 0, most);
      };
      const ImVec4 r = command.ClipRect;
      const ImVec2 o = data.DisplayPos;
      const Clip clip{whole(r.x - o.x, surface.width), whole(r.y - o.y, surface.height),
                      whole(r.z - o.x, surface.width), whole(r.w - o.y, surface.height)};
      paint(*data.CmdLists[n], command, ListPainter(surface, clip, texture_of(command)));
    }
}

}  // namespace gradmesh
