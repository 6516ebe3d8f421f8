#include "formats/pdf/page/read_function.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "pdf_documents.h"

namespace gradmesh {
namespace {

/// Reads the function that is object 5 of a document with these.
Function function_of(const std::vector<std::string>& objects) {
  const std::string bytes = pdf_document("", "", objects);
  QPDF file;
  file.setSuppressWarnings(true);
  file.processMemoryFile("a.pdf", bytes.data(), bytes.size());
  return read_function(file.getObjectByID(5, 0));
}

constexpr const char* line = "<< /FunctionType 2 /Domain [0 1] /C0 [0] /C1 [1] /N 1 >>";

/// A function of so many parts, which are all the same.
std::string stitched(const std::string& part, int count) {
  std::string functions, bounds, encode;
  for (int n = 0; n < count; ++n) {
    functions += part + " ";
    encode += "0 1 ";
    if (n > 0) bounds += std::to_string(double(n) / count) + " ";
  }
  return "<< /FunctionType 3 /Domain [0 1] /Functions [" + functions + "] /Bounds [" + bounds +
         "] /Encode [" + encode + "] >>";
}

double value_at(const Function& function, double in) { return function(std::span(&in, 1)).at(0); }

TEST(PdfReadFunction, MayHaveMorePartsThanValues) {
  const Function function = function_of({stitched(line, 100)});
  EXPECT_NEAR(value_at(function, 0.705), 0.5, 1e-3);
}

TEST(PdfReadFunction, LiesWithinAsManyAsAFunctionMay) {
  const auto nested = [](int depth) {
    std::string function = line;
    for (int n = 1; n < depth; ++n) function = stitched(function, 1);
    return function_of({function});
  };
  EXPECT_NEAR(value_at(nested(max_function_depth), 0.25), 0.25, 1e-12);
  EXPECT_THROW(nested(max_function_depth + 1), InputError);
  EXPECT_THROW(function_of({stitched("5 0 R", 1)}), InputError);
}

/// Without that there were a million million functions to read.
TEST(PdfReadFunction, IsReadOnceThoughOthersHoldItAgainAndAgain) {
  std::vector<std::string> objects;
  for (int n = 0; n < 12; ++n) objects.push_back(stitched(std::to_string(6 + n) + " 0 R", 10));
  objects.push_back(line);
  EXPECT_NEAR(value_at(function_of(objects), 1), 1, 1e-12);
}

}  // namespace
}  // namespace gradmesh
