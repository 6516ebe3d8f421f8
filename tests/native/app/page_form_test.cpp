// Which mesh stands for the patches of a page.
#include "app/pages/page_form.h"

#include <gtest/gtest.h>

#include "formats/pdf/shading/patch_around.h"

using namespace gradmesh;

namespace {

constexpr int strips = 40;

/// The colour at point j of a row of patches.
using ColorAt = glm::dvec4 (*)(int j);

glm::dvec4 grey(int) { return {0.5, 0.5, 0.5, 1}; }

/// Ten levels off, in one channel at each of three places.
glm::dvec4 off(int j) {
  glm::dvec4 color = grey(j);
  for (int channel = 0; channel < 3; ++channel)
    if (j == 8 + 12 * channel) color[channel] += 10.0 / 255;
  return color;
}

std::vector<PagePatch> row_of(ColorAt color) {
  std::vector<PagePatch> patches;
  for (int j = 0; j < strips; ++j) {
    const double x = 10 * j;
    patches.push_back(straight_patch<glm::dvec4>({{{x, 0}, {x + 10, 0}, {x + 10, 100}, {x, 100}}},
                                                 {color(j), color(j + 1), color(j + 1), color(j)}));
  }
  return patches;
}

MeshForm form_of(const std::vector<PagePatch>& patches, MeshForm::Kind kind) {
  PatchGrid grid{1, strips, {}};
  for (const PagePatch& patch : patches) grid.patches.push_back(mesh_patch(patch));
  MeshForm form{parts_of({grid}), kind};
  form.mesh.smooth = kind == MeshForm::Kind::artists;
  return form;
}

MeshForm::Kind chosen(ColorAt color) {
  const std::vector<PagePatch> page = row_of(grey);
  const auto goes_on = [] { return true; };
  return choose_form(page,
                     MeshForms({form_of(row_of(color), MeshForm::Kind::artists),
                                form_of(page, MeshForm::Kind::page)}),
                     goes_on)
      .value()
      .kind;
}

TEST(PageForm, is_the_first_that_looks_as_the_page) {
  EXPECT_EQ(chosen(grey), MeshForm::Kind::artists);
}

// Of all samples 98 of 100 are near enough, and of the pixels, whose channels must all be, 92.
TEST(PageForm, is_near_in_all_channels_of_a_pixel) { EXPECT_EQ(chosen(off), MeshForm::Kind::page); }

TEST(PageForm, is_none_where_it_was_stopped) {
  const std::vector<PagePatch> page = row_of(grey);
  int asked = 0;
  const auto goes_on = [&asked] { return ++asked < 2; };
  // The first of them does not look as the page does.
  EXPECT_FALSE(choose_form(page,
                           MeshForms({form_of(row_of(off), MeshForm::Kind::artists),
                                      form_of(page, MeshForm::Kind::page)}),
                           goes_on));
  EXPECT_EQ(asked, 2);
}

}  // namespace
