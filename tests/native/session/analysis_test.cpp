// What can be found out about the mesh of a session (session/analysis.h).
#include "session/analysis.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "base/error.h"
#include "sessions.h"
#include "simplify/simplify.h"

namespace gradmesh {
namespace {

using test::mesh_for;
using test::problem_for;
using test::view_of;

/// A mesh with regions that cost little.
Mesh calm_mesh(unsigned seed) {
  return test::grid_mesh({.rows = 5, .columns = 5, .color_noise = 0.005}, seed);
}

/// What is found out, waited for.
Analysis analysis(Session& session, AnalysisKind kind) {
  session.analyses().request(kind);
  session.analyses().wait();
  return *session.shown().analysis(kind);
}

TEST(Analysis, prices_of_lines_are_what_clicks_on_them_cost) {
  Session session(problem_for(calm_mesh(2)));
  session.protection().protect({{0}}, true);
  const std::vector<CurvePrice> prices = analysis(session, AnalysisKind::prices).prices;
  ASSERT_EQ(prices.size(), 40u);
  const double before = session.shown().now().error;
  int stay = 0;
  for (const CurvePrice& price : prices) {
    const Mesh& mesh = session.mesh();
    const Pointed pointed{.face = mesh.face(price.curve), .edge = price.curve};
    try {
      const double error = session.hands().propose(pointed, HandEdit::merge).written.error;
      EXPECT_NEAR(price.error, error - before, 1e-9);
    } catch (const InputError&) {
      EXPECT_EQ(price.error, std::numeric_limits<double>::infinity());
      ++stay;
    }
  }
  EXPECT_EQ(stay, 10) << "two lines are beside the patch that is protected";
}

TEST(Analysis, prices_of_blocks_are_those_of_single_edges) {
  Session session(problem_for(mesh_for(3)));
  session.hands().set_form(MeshKind::blocks);
  const std::vector<CurvePrice> prices = analysis(session, AnalysisKind::prices).prices;
  StopWatch watch(0, {});
  const std::vector<EdgePrice> edges = analyze_edges(session.shown().problem(), watch);
  ASSERT_EQ(prices.size(), edges.size());
  for (std::size_t i = 0; i < prices.size(); ++i) {
    EXPECT_EQ(prices[i].curve, edges[i].edge);
    EXPECT_NEAR(prices[i].error, edges[i].error, 1e-9);
  }
}

TEST(Analysis, what_is_found_out_is_forgotten_as_soon_as_the_mesh_is_another) {
  Session session(problem_for(mesh_for(4)));
  for (const AnalysisKind kind :
       {AnalysisKind::prices, AnalysisKind::regions, AnalysisKind::parts}) {
    EXPECT_FALSE(session.shown().analysis(kind));
    analysis(session, kind);
    EXPECT_TRUE(session.shown().analysis(kind));
  }
  session.hands().propose(*pointed_at(session.mesh(), view_of(session).to_pixels, {100, 100}, 1000),
                          HandEdit::merge);
  EXPECT_TRUE(session.shown().analysis(AnalysisKind::prices)) << "it is only shown";
  session.hands().make();
  EXPECT_FALSE(session.shown().analysis(AnalysisKind::prices));
  analysis(session, AnalysisKind::prices);
  session.undo();
  EXPECT_FALSE(session.shown().analysis(AnalysisKind::prices));
  // One that is left while it goes on does no harm.
  session.analyses().request(AnalysisKind::regions);
  session.redo();
  EXPECT_FALSE(session.shown().analysis(AnalysisKind::regions));
}

TEST(Analysis, regions_of_a_patch_hold_it_the_largest_first) {
  Session session(problem_for(calm_mesh(5)));
  const Analysis found = analysis(session, AnalysisKind::regions);
  const Face patch{12};
  const std::vector<RegionPrice> regions = largest_regions(found, patch);
  ASSERT_GT(regions.size(), 2u);
  for (std::size_t i = 0; i < regions.size(); ++i) {
    EXPECT_LE(regions[i].error, 0.01);
    EXPECT_TRUE(std::ranges::find(regions[i].patches, patch) != regions[i].patches.end());
    EXPECT_LE(regions[i].size(), regions[i > 0 ? i - 1 : 0].size());
  }
}

TEST(Analysis, what_is_known_is_painted_once_it_is_found_out) {
  Session session(problem_for(calm_mesh(6)));
  SessionView view = view_of(session);
  const Image plain = paint(session, view);
  view.patch = {12};
  std::vector<Image> pictures{plain};
  for (const AnalysisKind kind :
       {AnalysisKind::prices, AnalysisKind::regions, AnalysisKind::parts}) {
    view.analysis = kind;
    const Image before = paint(session, view);
    analysis(session, kind);
    const Image after = paint(session, view);
    EXPECT_NE(before, after);
    EXPECT_EQ(std::ranges::find(pictures, after), pictures.end());
    pictures.push_back(after);
  }
  view.analysis = AnalysisKind::regions;
  view.region = 1;
  EXPECT_EQ(std::ranges::find(pictures, paint(session, view)), pictures.end());
}

}  // namespace
}  // namespace gradmesh
