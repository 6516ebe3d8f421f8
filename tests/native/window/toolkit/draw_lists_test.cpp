// What Dear ImGui draws, as pixels (window/toolkit/draw_lists.h). No display is needed.
#include "window/toolkit/draw_lists.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <random>
#include <vector>

namespace gradmesh {
namespace {

constexpr int width = 64, height = 48;
constexpr std::uint32_t white = 0xffffff;

/// Draws over white, into the pixels that are returned row by row.
class DrawLists : public testing::Test {
 protected:
  DrawLists() {
    context_ = ImGui::CreateContext();
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.DisplaySize = {width, height};
    unsigned char* opacity = nullptr;
    io.Fonts->GetTexDataAsAlpha8(&opacity, &font_.width, &font_.height);
    font_.opacity = opacity;
    io.Fonts->SetTexID(&font_);
  }
  ~DrawLists() override { ImGui::DestroyContext(context_); }

  std::vector<std::uint32_t> painted(const std::function<void(ImDrawList&)>& draw) {
    ImGui::GetIO().DeltaTime = 1 / 60.0F;
    ImGui::NewFrame();
    draw(*ImGui::GetForegroundDrawList());
    ImGui::Render();
    std::vector<std::uint32_t> pixels(std::size_t(width * height), white);
    paint(*ImGui::GetDrawData(), {width, height, width, pixels.data()});
    return pixels;
  }

 private:
  ImGuiContext* context_;
  Texture font_;
};

std::uint32_t at(const std::vector<std::uint32_t>& pixels, int x, int y) {
  return pixels[std::size_t(y * width + x)];
}

TEST_F(DrawLists, a_rectangle_covers_the_pixels_whose_centres_it_holds) {
  const auto pixels = painted([](ImDrawList& list) {
    list.AddRectFilled({10, 8.4F}, {20.6F, 12.5F}, IM_COL32(255, 128, 0, 255));
  });
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const bool is_inside = x >= 10 && x < 21 && y >= 8 && y < 12;
      ASSERT_EQ(at(pixels, x, y), is_inside ? 0xff8000u : white) << x << ", " << y;
    }
}

TEST_F(DrawLists, triangles_that_meet_leave_no_seam_where_they_are_translucent) {
  const auto pixels = painted([](ImDrawList& list) {
    list.Flags &= ~ImDrawListFlags_AntiAliasedFill;
    list.AddQuadFilled({5, 3}, {60, 9}, {52, 44}, {9, 40}, IM_COL32(0, 0, 0, 51));
  });
  const auto inside = std::ranges::count(pixels, 0xccccccu);
  EXPECT_EQ(inside + std::ranges::count(pixels, white), width * height);
  // The area of the quadrilateral, by its diagonals.
  EXPECT_NEAR(double(inside), 0.5 * std::abs(47 * 31 - 41 * -51), 40);
}

TEST_F(DrawLists, triangles_around_any_point_cover_each_pixel_once) {
  std::mt19937 random(7);
  const auto number = [&](int least, int most) {
    return float(int(random() % unsigned(most - least + 1)) + least) / 4;
  };
  for (int round = 0; round < 50; ++round) {
    const ImVec2 middle(number(4, 4 * width - 4), number(4, 4 * height - 4));
    std::vector<ImVec2> around = {
        {0, 0},          {number(1, 200), 0},      {width, 0},  {width, number(1, 150)},
        {width, height}, {number(1, 200), height}, {0, height}, {0, number(1, 150)}};
    const auto pixels = painted([&](ImDrawList& list) {
      list.Flags &= ~ImDrawListFlags_AntiAliasedFill;
      for (std::size_t i = 0; i < around.size(); ++i)
        list.AddTriangleFilled(middle, around[i], around[(i + 1) % around.size()],
                               IM_COL32(0, 0, 0, 51));
    });
    EXPECT_EQ(std::ranges::count(pixels, 0xccccccu), width * height) << round;
  }
}

TEST_F(DrawLists, nothing_is_painted_beyond_what_is_clipped_or_the_surface) {
  const auto pixels = painted([](ImDrawList& list) {
    list.PushClipRect({20, 10}, {30, 20});
    list.AddCircleFilled({25, 15}, 1e5F, IM_COL32(10, 20, 30, 255), 8);
    list.PopClipRect();
    list.AddTriangleFilled({-1e9F, 40}, {1e9F, 40}, {0, 1e9F}, IM_COL32(1, 2, 3, 255));
  });
  EXPECT_EQ(at(pixels, 25, 15), 0x0a141eu);
  EXPECT_EQ(at(pixels, 19, 15), white);
  EXPECT_EQ(at(pixels, 30, 15), white);
  EXPECT_EQ(std::ranges::count(pixels, 0x0a141eu), 100);
}

TEST_F(DrawLists, colours_change_evenly) {
  const auto pixels = painted([](ImDrawList& list) {
    list.AddRectFilledMultiColor({0, 0}, {width, height}, IM_COL32(0, 0, 0, 255),
                                 IM_COL32(255, 0, 0, 255), IM_COL32(255, 255, 0, 255),
                                 IM_COL32(0, 255, 0, 255));
  });
  for (const auto& [x, y] : {std::pair(0, 0), {20, 30}, {63, 47}, {40, 5}}) {
    const std::uint32_t pixel = at(pixels, x, y);
    EXPECT_NEAR(double(pixel >> 16), 255 * (x + 0.5) / width, 1) << x << ", " << y;
    EXPECT_NEAR(double(pixel >> 8 & 255), 255 * (y + 0.5) / height, 1) << x << ", " << y;
  }
}

TEST_F(DrawLists, a_picture_is_shown_pixel_by_pixel) {
  std::vector<std::uint32_t> shown(12 * 9);
  for (std::size_t i = 0; i < shown.size(); ++i) shown[i] = std::uint32_t(0x010203 * i) & white;
  Texture texture{12, 9, nullptr, shown.data()};
  const auto pixels = painted([&](ImDrawList& list) { list.AddImage(&texture, {7, 5}, {19, 14}); });
  for (int y = 0; y < 9; ++y)
    for (int x = 0; x < 12; ++x)
      ASSERT_EQ(at(pixels, 7 + x, 5 + y), shown[std::size_t(12 * y + x)]) << x << ", " << y;
  EXPECT_EQ(at(pixels, 6, 5), white);
}

TEST_F(DrawLists, letters_are_inked_where_the_font_says) {
  const auto text = [&](const char* letters) {
    return painted([&](ImDrawList& list) {
      list.AddText({4, 4}, IM_COL32(0, 0, 0, 255), letters);
    });
  };
  const auto ink = [](const std::vector<std::uint32_t>& pixels) {
    return std::ranges::count_if(pixels, [](std::uint32_t p) { return p != white; });
  };
  EXPECT_EQ(ink(text(" ")), 0);
  EXPECT_GT(ink(text("i")), 3);
  EXPECT_GT(ink(text("mm")), ink(text("i")));
  EXPECT_EQ(text("mesh"), text("mesh"));
}

}  // namespace
}  // namespace gradmesh
