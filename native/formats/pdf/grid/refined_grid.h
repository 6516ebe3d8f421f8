#pragma once

#include <map>
#include <utility>
#include <vector>

#include "form/smooth_colors.h"
#include "formats/pdf/grid/page_colors.h"
#include "mesh/parts.h"

namespace gradmesh {

/// An artist's grid with smooth colours and with more rows and columns where these are needed to
/// look like the page. Colours of Illustrator's meshes are smooth in the colour space of the page,
/// mostly CMYK, in which the mixture of two colours is another one than in sRGB.
class RefinedGrid {
 public:
  /// The grid is in page coordinates.
  RefinedGrid(PatchGrid grid, const PageColors& page);

  int rows() const { return int(row_lines_.size()) - 1; }
  int columns() const { return int(column_lines_.size()) - 1; }
  /// Returns the grid: parts of the artist's patches, with the colours that the page has at their
  /// corners, as multiples of 1 / 255.
  PatchGrid grid() const;

  /// Divides the row or the column whose halves come nearest to the page's colours for each patch
  /// that they add. Returns false where no division does, or none is needed.
  bool divide();

 private:
  /// Where rows, or columns, end: in those of the artist, of which the first one is from 0 to 1.
  using Lines = std::vector<double>;
  using Corner = SmoothColors::Corner;

  /// A place at which colours are compared, by rows and columns of the artist.
  struct Sample {
    double row, column;
    glm::dvec4 color;
  };

  const Patch& artists(double row, double column) const;
  const Value& corner(double row, double column) const;
  SmoothColors colors(const Lines& rows, const Lines& columns) const;
  /// Gives a patch the places and the colours of its corners.
  void set_corners(Patch& patch, const Lines& rows, const Lines& columns, std::size_t i,
                   std::size_t j) const;
  /// Returns the sum of squares by which colours differ from those of the page.
  double error(const Lines& rows, const Lines& columns);

  PatchGrid artists_;
  const PageColors& page_;
  Lines row_lines_, column_lines_;
  std::vector<Sample> samples_;
  double error_ = 0, looks_ = 0;
  mutable std::map<std::pair<double, double>, Value> corners_;
};

}  // namespace gradmesh
