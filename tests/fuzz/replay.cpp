#include <algorithm>
#include <filesystem>
#include <iostream>
#include <vector>

#include "files/atomic_file.h"
#include "target.h"

/// In place of libFuzzer: `fuzz_TARGET FOLDER` calls the target with each file of the folder.
int main(int count, char** arguments) {
  if (count != 2) {
    std::cerr << "Usage: " << arguments[0] << " FOLDER\n";
    return 2;
  }
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(arguments[1]))
    files.push_back(entry.path());
  std::ranges::sort(files);
  for (const auto& file : files) {
    std::cout << file.filename().string() << std::endl;  // seen even where the target ends us
    gradmesh::fuzz::check(gradmesh::read_bytes(file));
  }
  if (files.empty()) std::cerr << arguments[1] << " has no files.\n";
  return files.empty();
}
