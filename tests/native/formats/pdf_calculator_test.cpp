#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "formats/pdf/color/function.h"
#include "pdf_numbers.h"

namespace gradmesh {
namespace {

/// Returns what the program makes of `in`, which it reads and leaves within +-1000.
Numbers calculated(const std::string& program, const Numbers& in, std::size_t outputs) {
  const Function function(
      CalculatorFunction{Ranges(std::max<std::size_t>(in.size(), 1), {-1000, 1000}),
                         Ranges(outputs, {-1000, 1000}), program});
  return function(in);
}

TEST(PdfCalculator, operators) {
  struct Case {
    const char* program;
    Numbers left;
  };
  for (const auto& [program, left] : std::vector<Case>{
           {"{ -2.5 abs 1 2 add }", {2.5, 3}},
           {"{ 0 1 atan 1 0 atan -100 0 atan 1 1 atan }", {0, 90, 270, 45}},
           {"{ 3.2 ceiling -4.8 ceiling 3.2 floor -4.8 floor }", {4, -4, 3, -5}},
           {"{ 60 cos 30 sin 0 cos }", {0.5, 0.5, 1}},
           {"{ -47.8 cvi 52.3 cvi 7 cvr }", {-47, 52, 7}},
           {"{ 3 2 div 9 0.5 exp -9 -1 exp }", {1.5, 3, -1.0 / 9}},
           {"{ 3 2 idiv -5 2 idiv 4 2 idiv }", {1, -2, 2}},
           {"{ 5 3 mod -5 3 mod 5 2 mod }", {2, -2, 1}},
           {"{ 10 ln 100 log }", {std::log(10.0), 2}},
           {"{ 6 7 mul 4.5 neg 2 3 sub 16 sqrt }", {42, -4.5, -1, 4}},
           {"{ 3.5 round -6.5 round -2.4 round 3.2 truncate -4.8 truncate }", {4, -6, -2, 3, -4}},
           {"{ 99 1 and 52 7 and 17 5 or 7 3 xor 52 not }", {1, 4, 21, 4, -53}},
           {"{ true false and true false or true true xor true not }", {0, 1, 0, 0}},
           {"{ 7 3 bitshift 142 -3 bitshift 1 40 bitshift 1 -1000 bitshift }", {56, 17, 0, 0}},
           {"{ 1 1 eq 1 2 eq 1 2 ne 1 true eq }", {1, 0, 1, 0}},
           {"{ 1 2 gt 2 2 ge 1 2 lt 2 2 le }", {0, 1, 1, 1}},
           {"{ 1 2 3 2 copy }", {1, 2, 3, 2, 3}},
           {"{ 1 2 exch 3 dup 4 pop }", {2, 1, 3, 3}},
           {"{ 4 5 6 0 index 3 index }", {4, 5, 6, 6, 4}},
           {"{ 1 2 3 3 -1 roll }", {2, 3, 1}},
           {"{ 1 2 3 3 1 roll }", {3, 1, 2}},
           {"{ 1 2 3 3 7 roll }", {3, 1, 2}},
           {"{ 1 2 3 3 0 roll }", {1, 2, 3}},
           {"{ 1 2 lt {3} if 1 2 gt {4} if }", {3}},
           {"{ true {1 {2}{3} ifelse}{4} ifelse false {5}{6}ifelse }", {2, 6}},
           {"{%a comment } \r1%another\n.5 -.5 +3 1. 2e1}", {1, 0.5, -0.5, 3, 1, 20}},
       }) {
    SCOPED_TRACE(program);
    expect_numbers(calculated(program, {}, left.size()), left);
  }
}

TEST(PdfCalculator, operators_read_inputs_in_their_order) {
  expect_numbers(calculated("{ sub }", {7, 4}, 1), {3});
  expect_numbers(calculated("{ 1 index 0.5 gt {exch} {pop 0} ifelse }", {1, 2}, 2), {2, 1});
}

TEST(PdfCalculator, a_program_may_use_its_stack_wrongly) {
  expect_numbers(calculated("{ pop pop pop add }", {3}, 2), {0, 0});
  expect_numbers(calculated("{ 5 }", {3}, 3), {0, 3, 5});
  expect_numbers(calculated("{ pop 7 9 copy -1 copy 1e30 copy }", {3}, 1), {7});
  expect_numbers(calculated("{ 7 99 index }", {3}, 2), {7, 0});
  expect_numbers(calculated("{ 7 -1e30 index }", {3}, 1), {7});
  expect_numbers(calculated("{ 7 8 99 1 roll }", {3}, 2), {7, 8});
  expect_numbers(calculated("{ 7 8 -3 1 roll 2 -1e30 roll }", {3}, 2), {7, 8});
  expect_numbers(calculated("{ 1 0 div }", {3}, 1), {1000});
  expect_numbers(calculated("{ 1 0 idiv 1 0 mod 0 0 div -1 sqrt }", {3}, 4), {0, 0, 0, 0});
  expect_numbers(calculated("{ -2147483648 -1 idiv 1e9 div -1e30 1 bitshift -9 -1 mod }", {3}, 3),
                 {2.147483648, 0, 0});
  std::string many = "{";
  for (int i = 1; i <= 150; ++i) many += " " + std::to_string(i);
  // The stack holds the input and 99 numbers.
  expect_numbers(calculated(many + "}", {3}, 1), {99});
}

TEST(PdfCalculator, programs_that_cannot_be_read) {
  const std::string deep = std::string(100, '{') + std::string(100, '}');
  std::string nested = "{";
  for (int i = 0; i < 100; ++i) nested += " true {";
  for (int i = 0; i < 100; ++i) nested += " } if";
  std::string longest = "{";
  for (int i = 0; i < 200'000; ++i) longest += " 1";
  for (const std::string& program : std::vector<std::string>{"",
                                                             "{",
                                                             "}",
                                                             "1",
                                                             "{ 1 } 2",
                                                             "{ foo }",
                                                             "{ nan }",
                                                             "{ inf }",
                                                             "{ 16#ff }",
                                                             "{ +-1 }",
                                                             "{ 1e999 }",
                                                             "{ {1} }",
                                                             "{ true {1} {2} if }",
                                                             "{ true {1} ifelse }",
                                                             "{ if }",
                                                             "{ ifelse }",
                                                             "{ true {1} 2 if }",
                                                             "{ 1 (a) }",
                                                             "% {",
                                                             "{ true {1",
                                                             "{ 1 ] }",
                                                             deep,
                                                             nested + "}",
                                                             longest + "}"})
    EXPECT_THROW(calculated(program, {}, 1), InputError) << program.substr(0, 40);
}

}  // namespace
}  // namespace gradmesh
