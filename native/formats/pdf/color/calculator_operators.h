#pragma once

#include <string_view>

#include "formats/pdf/color/calculator_stack.h"

namespace gradmesh {

/// What an operator of a calculator function does to its operands.
using CalculatorOperator = void (*)(CalculatorStack&);

/// Returns the operator of this name, but for `if` and `ifelse`; null if there is none.
CalculatorOperator calculator_operator(std::string_view name);

}  // namespace gradmesh
