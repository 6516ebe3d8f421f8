#pragma once

#include "window/eye/eye.h"
#include "window/toolkit/ui.h"
#include "window/tools/toolbox.h"

namespace gradmesh {

/// What the sections of the panel beside the picture have in common: they show the Eye, and pass on
/// what a person does.
struct Panel {
  Ui& ui;
  Eye& eye;
  Toolbox& toolbox;
};

/// Show a section each.
void show_meshes(const Panel& panel);
void show_curve(const Panel& panel);
void show_looks(const Panel& panel);
void show_tools(const Panel& panel);
void show_marked(const Panel& panel);
void show_worst_places(const Panel& panel);
/// Shows the colour of the point that is looked at, if it is one.
void show_color(const Panel& panel);
/// Shows numbers and neighbours of the element that is looked at, if there is one, to who asks.
void show_structure(const Panel& panel);

}  // namespace gradmesh
