#include "window/tools/toolbox.h"

#include "window/tools/edit_tool.h"
#include "window/tools/look_tool.h"
#include "window/tools/mark_tool.h"
#include "window/tools/shape_tool.h"

namespace gradmesh {

Toolbox::Toolbox() {
  tools_.push_back(std::make_unique<LookTool>());
  tools_.push_back(std::make_unique<EditTool>(HandEdit::merge));
  tools_.push_back(std::make_unique<ShapeTool>());
  for (const HandEdit edit : {HandEdit::split_rows, HandEdit::split_columns, HandEdit::split_both})
    tools_.push_back(std::make_unique<EditTool>(edit));
  for (const bool brushes : {false, true}) tools_.push_back(std::make_unique<MarkTool>(brushes));
}

void Toolbox::take(std::size_t which, Eye& eye) {
  in_hand().leave(eye);
  chosen_ = which;
}

bool Toolbox::take_first(Eye& eye) {
  if (chosen_ == first) return false;
  take(first, eye);
  return true;
}

bool Toolbox::take(const std::string& key, Eye& eye) {
  for (std::size_t i = 0; i < tools_.size(); ++i)
    if (key == tools_[i]->key()) {
      take(i, eye);
      return true;
    }
  return false;
}

}  // namespace gradmesh
