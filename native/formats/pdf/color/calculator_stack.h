#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

#include "base/clamped_int.h"
#include "formats/pdf/color/function_rule.h"

namespace gradmesh {

/// An operand of a calculator function: a number, or a truth value, 0 or 1. Integers and reals are
/// not told apart: all integers of PostScript are exact as doubles.
struct CalculatorOperand {
  double value = 0;
  bool is_truth = false;

  bool operator==(const CalculatorOperand&) const = default;

  /// Returns the operand without its fraction as an integer of 32 bits, the nearest there is.
  std::int32_t integer() const {
    return clamped_int(value, std::numeric_limits<std::int32_t>::min(),
                       std::numeric_limits<std::int32_t>::max());
  }
};

/// The operand stack of a calculator function (ISO 32000-1, 7.10.5.2), of 100 operands. What is
/// missing is 0 and what is too much is dropped, as a program of a stranger may do anything.
class CalculatorStack {
 public:
  void push(CalculatorOperand operand) {
    operand.value = pdf_number(operand.value);
    if (size_ < items_.size()) items_[size_++] = operand;
  }
  void push(double number) { push(CalculatorOperand{number, false}); }
  void push_truth(bool truth) { push(CalculatorOperand{truth ? 1.0 : 0.0, true}); }

  CalculatorOperand pop() { return size_ > 0 ? items_[--size_] : CalculatorOperand{}; }

  /// Pushes the topmost `count` operands again. Does nothing if there are not as many.
  void copy(double count) {
    const std::size_t first = size_ - clamped(count);
    if (count > static_cast<double>(size_)) return;
    for (std::size_t i = first, end = size_; i < end; ++i) push(items_[i]);
  }

  /// Pushes the operand that has `depth` others above it.
  void index(double depth) {
    const std::size_t above = clamped(depth);
    push(above < size_ ? items_[size_ - 1 - above] : CalculatorOperand{});
  }

  /// Moves the topmost `count` operands up by `shift`, those that leave at the top to the bottom.
  /// Does nothing if there are not as many.
  void roll(double count, const CalculatorOperand& shift) {
    const std::size_t rolled = clamped(count);
    if (rolled == 0 || count > static_cast<double>(size_)) return;
    const auto length = static_cast<std::int64_t>(rolled);
    const std::int64_t up = ((shift.integer() % length) + length) % length;
    const auto end = items_.begin() + static_cast<std::ptrdiff_t>(size_);
    std::rotate(end - length, end - up, end);
  }

 private:
  /// Returns a number of operands, within those that there are.
  std::size_t clamped(double count) const {
    return static_cast<std::size_t>(clamped_int(count, 0, static_cast<int>(size_)));
  }

  std::array<CalculatorOperand, 100> items_;
  std::size_t size_ = 0;
};

}  // namespace gradmesh
