#include "app/pages/read_pdf.h"

namespace gradmesh {

PageMeshes read_pdf(std::string_view, const std::string& name, const PageChoice&) {
  throw InputError("{0}: this gradmesh was built without PDF.", name);
}

}  // namespace gradmesh
