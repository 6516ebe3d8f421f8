#include "files/temporary_folder.h"

#include <stdlib.h>
#include <unistd.h>

#include <cerrno>
#include <string>
#include <system_error>

#include "base/error.h"

namespace gradmesh {

TemporaryFolder::TemporaryFolder() {
  std::error_code error;
  const std::filesystem::path folder = std::filesystem::temp_directory_path(error);
  std::string name = (folder / "gradmesh-XXXXXX").string();
  if (!error && !mkdtemp(name.data())) error = {errno, std::generic_category()};
  if (error)
    throw InputError("{0} cannot be written: {1}.", folder.empty() ? name : folder.string(),
                     error.message());
  path_ = name;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

}  // namespace gradmesh
