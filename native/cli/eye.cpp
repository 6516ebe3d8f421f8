#include "app/document/write_file.h"
#include "app/export/results_json.h"
#include "cli/commands.h"
#include "cli/common_options.h"

#ifdef GRADMESH_WINDOW
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <system_error>

#include "app/editing/editing.h"
#include "app/export/info.h"
#include "base/utf8_path.h"
#include "files/atomic_file.h"
#include "window/view/run.h"
#endif

namespace gradmesh {

namespace {

struct EyeArguments {
  std::filesystem::path in, out, report;
  std::vector<std::string> ids;
  std::vector<std::string> folders;
  std::string theme, language, above;
};

#ifdef GRADMESH_WINDOW

WindowChoices choices(const EyeArguments& a) {
  WindowChoices choices;
  if (!a.theme.empty()) choices.is_dark = a.theme == "dark";
  if (!a.language.empty()) choices.language = a.language;
  choices.document = a.in.filename().string();
  choices.above = a.above;
  return choices;
}

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

/// Does the writing; where that fails, what was made, which may be hours of work, is kept in the
/// folder for temporary files, and the error that is thrown says where.
template <class Write>
void write_or_keep(Document& made, const std::filesystem::path& out, const Write& write) try {
  write();
} catch (const InputError& why) {
  std::error_code ignored;
  const std::filesystem::path folder = std::filesystem::temp_directory_path(ignored);
  std::filesystem::path kept;
  for (int n = 1; kept.empty() || std::filesystem::exists(kept, ignored); ++n) {
    kept = folder / out.stem();
    kept += "-by-eye-" + std::to_string(n);
    kept += out.extension();
  }
  try {
    write_file(made, kept);
  } catch (const InputError&) {
    throw InputError(why.message());
  }
  throw InputError("{0} What was made is kept in {1}.", why.message(), kept.string());
}

void simplify(const EyeArguments& a) {
  const auto document = read_and_warn(a.in);
  if (document->pages() && a.out.empty())
    throw InputError("{0}: please say with --output where the SVG document is to be written.",
                     document->name());
  const std::filesystem::path& out = a.out.empty() ? a.in : a.out;
  check_target(*document, out);
  document->set_translation(translation_for(choices(a)));
  std::vector<std::filesystem::path> folders;
  for (const std::string& folder : a.folders) folders.push_back(utf8_path(folder));
  if (!folders.empty()) document->file().look_in(std::move(folders));
  std::vector<std::string> names;
  const std::map<std::string, MeshEntry> entries = named_entries(document->selected(a.ids), names);
  Eye eye(names, [&](const std::string& name) {
    return edit_by_eye(*document, entries.at(name), RunOptions());
  });
  if (!simplify_by_eye(eye, choices(a))) return;
  write_or_keep(*document, out, [&] {
    nlohmann::ordered_json meshes = nlohmann::ordered_json::array();
    for (const Editing* const editing : eye.changed()) {
      const MeshReport report = write_shown(*document, *editing, {});
      meshes.push_back(result_json(*document, report, RunOptions(), ""));
    }
    // The report first: where it cannot be written the document is still as it was.
    if (!a.report.empty())
      write_bytes(a.report, nlohmann::ordered_json{{"meshes", meshes}}.dump(2) + "\n");
    write_file(*document, out);
  });
}

/// Runs, and tells of bad input in the language of the window.
void run(const EyeArguments& a) {
  try {
    simplify(a);
  } catch (const InputError& error) {
    throw std::runtime_error(error.message().in(translation_for(choices(a))));
  }
}

#else

void run(const EyeArguments&) {
  throw InputError(
      "this gradmesh was built without a window; gradmesh simplify does the same by numbers.");
}

#endif

}  // namespace

void add_eye(CLI::App& program) {
  const auto a = std::make_shared<EyeArguments>();
  CLI::App& command = *program.add_subcommand(
      "eye", "Simplify by eye: a window with a slider, and tools to edit by hand");
  add_path(command, "IN", a->in, any_document())->required();
  add_path(command, "-o,--output", a->out, "Written by Apply; the document itself if not given");
  add_ids(command, a->ids);
  command.add_option("--folder", a->folders,
                     "Where linked pictures are looked for, instead of beside IN; may be repeated");
  command.add_option("--theme", a->theme, "dark or light; what was chosen last if not given")
      ->check(CLI::IsMember({"dark", "light"}));
  command.add_option("--language", a->language,
                     "Of the window, such as de; the desktop's if not given");
  command.add_option("--above", a->above,
                     "Stay in front of the foremost window whose title ends so, as Inkscape's");
  add_path(command, "--report", a->report, "Write a report of what was applied as JSON");
  command.callback([a] { run(*a); });
}

}  // namespace gradmesh
