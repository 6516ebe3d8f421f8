#include "cli/commands.h"
#include "cli/common_options.h"

#ifdef GRADMESH_WINDOW
#include <map>

#include "app/editing.h"
#include "window/view/run.h"
#endif

namespace gradmesh {

#ifdef GRADMESH_WINDOW

namespace {

struct EyeArguments {
  std::filesystem::path in, out;
  std::vector<std::string> ids;
  std::string theme, language;
};

/// Returns what a person calls the meshes: their ids, of which an object has two whose fill and
/// stroke are meshes.
std::map<std::string, MeshEntry> named_entries(const std::vector<MeshEntry>& entries,
                                               std::vector<std::string>& names) {
  std::map<std::string, MeshEntry> named;
  for (const MeshEntry& entry : entries) {
    const std::string name = named.contains(entry.id) ? entry.id + " (stroke)" : entry.id;
    named.emplace(name, entry);
    names.push_back(name);
  }
  return named;
}

void run(const EyeArguments& a) {
  const auto document = Document::read_file(a.in);
  std::vector<std::string> names;
  const std::map<std::string, MeshEntry> entries = named_entries(document->selected(a.ids), names);
  Eye eye(names, [&](const std::string& name) {
    return edit_by_eye(*document, entries.at(name), RunOptions());
  });
  WindowChoices choices;
  if (!a.theme.empty()) choices.is_dark = a.theme == "dark";
  if (!a.language.empty()) choices.language = a.language;
  if (!simplify_by_eye(eye, choices)) return;
  for (const Editing* const editing : eye.changed()) write_shown(*document, *editing, {});
  document->write_file(a.out.empty() ? a.in : a.out);
}

}  // namespace

void add_eye(CLI::App& program) {
  const auto a = std::make_shared<EyeArguments>();
  CLI::App& command = *program.add_subcommand(
      "eye", "Simplify in a window, where it is seen what that costs, and edit by hand");
  // Not in the list of commands until all of it works.
  command.group("");
  add_path(command, "IN", a->in, any_document())->required();
  add_path(command, "-o,--output", a->out, "Written by Apply; the document itself if not given");
  add_ids(command, a->ids);
  command.add_option("--theme", a->theme, "dark or light; what was chosen last if not given")
      ->check(CLI::IsMember({"dark", "light"}));
  command.add_option("--language", a->language,
                     "Of the window, such as de; the desktop's if not given");
  command.callback([a] { run(*a); });
}

#else

void add_eye(CLI::App&) {}

#endif

}  // namespace gradmesh
