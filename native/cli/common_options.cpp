#include "cli/common_options.h"

#include <algorithm>
#include <cstdio>
#include <iostream>
#include <limits>

#include "app/pages/read_document.h"
#include "app/runs/devices.h"
#include "base/utf8_path.h"

namespace gradmesh {
namespace {

/// Returns what says on the command line what the range of a T is, and refuses other values.
template <class T>
CLI::Validator within(const OptionEntry::Range& range) {
  if (range.most < std::numeric_limits<double>::infinity())
    return CLI::Range(T(range.least), T(range.most));
  return CLI::NonNegativeNumber;
}

/// Adds an option as its type asks for.
struct Adding {
  CLI::App& command;
  SimplifyOptions& options;
  const OptionEntry& entry;
  const std::string flag, help;

  template <class T>
  CLI::Option* operator()(T SimplifyOptions::*member) const {
    CLI::Option* option = command.add_option(flag, options.*member, help);
    if (entry.range) option->check(within<T>(*entry.range));
    return option->capture_default_str();
  }
  template <class T>
  CLI::Option* operator()(std::optional<T> SimplifyOptions::*member) const {
    CLI::Option* option = command.add_option(flag, options.*member, help);
    return entry.range ? option->check(within<T>(*entry.range)) : option;
  }
  CLI::Option* operator()(std::uint64_t SimplifyOptions::*member) const {
    return command.add_option(flag, options.*member, help)
        ->check(CLI::NonNegativeNumber)
        ->capture_default_str();
  }
  CLI::Option* operator()(std::vector<int> SimplifyOptions::*member) const {
    return command.add_option(flag, options.*member, help)->delimiter(',');
  }
  CLI::Option* operator()(bool SimplifyOptions::*member) const {
    // Only what is seen counts unless a person says otherwise, so there is no need to ask for it.
    return command.add_flag("!--whole-mesh", options.*member,
                            "SVG: what outlines, clip paths and masks hide of the mesh counts too");
  }
  CLI::Option* operator()(const NamedValue& value) const {
    const auto set = [&options = options, value](const std::string& name) {
      value.set(options, name);
    };
    return command.add_option_function<std::string>(flag, set, help)
        ->check(CLI::IsMember(value.names()))
        ->default_str(value.get(options));
  }
};

/// Returns the id and the factor of "ID=FACTOR". An id may hold a "=". Throws std::invalid_argument
/// if there is no id or no number.
std::pair<std::string, double> weight_in(const std::string& text) {
  const std::size_t end = text.rfind('=');
  double factor = 0;
  if (end == 0 || end == text.npos || !CLI::detail::lexical_cast(text.substr(end + 1), factor))
    throw std::invalid_argument("--weigh needs an id and a number, as in eyes=4, not \"" + text +
                                "\".");
  return {text.substr(0, end), factor};
}

}  // namespace

std::string any_document() {
  std::string words;
  for (const Format& format : all_formats())
    words.append(words.empty() ? "" : ", ").append(format.document);
  return words + " or " + page_document();
}

void add_page_options(CLI::App& command, PageChoice& choice) {
  command.add_option("--page", choice.page, page_document() + ": only this page, from 1")
      ->check(CLI::PositiveNumber);
  command.add_option("--password", choice.password, page_document() + ": what it is encrypted by");
  command.add_flag("--all-layers", choice.all_layers,
                   page_document() + ": read layers that are off, too");
}

std::unique_ptr<Document> read_and_warn(const std::filesystem::path& path,
                                        const PageChoice& choice) {
  std::unique_ptr<Document> document = read_document(path, choice);
  if (document->pages())
    for (const Message& sentence : document->pages()->left_out)
      std::fprintf(stderr, "gradmesh: %s\n", sentence.english().c_str());
  return document;
}

std::string flag_of(const std::string& option) {
  std::string flag = "--" + option;
  std::ranges::replace(flag, '_', '-');
  return flag;
}

void add_options(CLI::App& command, SimplifyOptions& options,
                 const std::vector<std::string>& names) {
  for (const OptionEntry& entry : all_options()) {
    if (std::ranges::find(names, entry.name) == names.end()) continue;
    std::string heeding;
    for (const std::string& method : methods_with(entry.name))
      heeding.append(heeding.empty() ? "" : ", ").append(method);
    const std::string help = heeding.empty() ? entry.help : heeding + ": " + entry.help;
    std::visit(Adding{command, options, entry, flag_of(entry.name), help}, entry.value);
  }
}

CLI::Option* add_path(CLI::App& command, const std::string& names, std::filesystem::path& path,
                      const std::string& description) {
  return command.add_option_function<std::string>(
      names, [&path](const std::string& text) { path = utf8_path(text); }, description);
}

void add_original_option(CLI::App& command, std::filesystem::path& original) {
  add_path(command, "--original", original,
           "Measure against the mesh of this file, of the same id or the only one");
}

std::unique_ptr<Document> take_original(const std::filesystem::path& original, Document& document) {
  if (original.empty()) return nullptr;
  std::unique_ptr<Document> other = read_and_warn(original);
  document.measure_against(other.get());
  return other;
}

void add_ids(CLI::App& command, std::vector<std::string>& ids) {
  command.add_option("--id", ids, "Only this object, or all meshes inside it; may be repeated")
      ->take_all()
      ->expected(1);
}

void add_id(CLI::App& command, std::string& id) {
  command.add_option("--id", id, "Which mesh, where there are several");
}

CLI::Option* add_weigh_option(CLI::App& command, ShapeWeights& weights,
                              const std::string& description) {
  const auto add = [&weights](const std::vector<std::string>& texts) {
    for (const std::string& text : texts) weights.push_back(weight_in(text));
  };
  return command.add_option_function<std::vector<std::string>>("--weigh", add, description)
      ->type_name("ID=FACTOR")
      ->take_all()
      ->expected(1);
}

void add_renderer_option(CLI::App& command, std::string& renderer) {
  command
      .add_option("--renderer", renderer,
                  "What measures errors: software (the cores), egl (a graphics processor), or "
                  "auto, the faster one")
      ->check(CLI::IsMember({"auto", "software", "egl"}))
      ->capture_default_str();
}

void take_renderer(const std::string& renderer, RunOptions& options) {
  use_renderer(options, renderer_named(renderer), say_without_device);
}

void say_without_device(const std::string& reason) {
  std::cerr << "gradmesh: " << reason << "; it goes on in software.\n";
}

void add_analysis_options(CLI::App& command, PricePaths& analyses) {
  add_path(command, "--load-analysis", analyses.load,
           "Take prices from this file, which an earlier run has saved");
  add_path(command, "--save-analysis", analyses.save, "Save all prices that were used");
}

}  // namespace gradmesh
