#include "window/view/run.h"

#include "window/toolkit/catalogue.h"
#include "window/toolkit/desktop.h"
#include "window/toolkit/sdl_window.h"
#include "window/view/eye_window.h"
#include "window/view/settings.h"

namespace gradmesh {

Translation translation_for(const WindowChoices& choices) {
  return translation_into(choices.language ? std::vector{*choices.language}
                                           : preferred_languages());
}

bool simplify_by_eye(Eye& eye, const WindowChoices& choices) {
  const std::filesystem::path folder = settings_folder();
  // Without a folder nothing is remembered, rather than written where the program was started.
  const std::filesystem::path file = folder.empty() ? folder : folder / "by-eye";
  Settings settings = read_settings(file);
  eye.looks.lines = settings.lines;
  eye.looks.handles = settings.handles;
  eye.looks.by_patches = settings.by_patches;
  const Translation translation = translation_for(choices);
  const std::string title = choices.document + " - " + Message("Simplify by Eye").in(translation);
  SdlWindow screen(title, settings.width, settings.height,
                   OwnerTitle{choices.above, choices.document});
  eye.density = double(screen.density());
  const bool was_dark = choices.is_dark.value_or(settings.is_dark.value_or(prefers_dark()));
  EyeWindow window(eye, translation, was_dark);
  screen.run([&](const Happened& happened) { return window.show(happened); },
             [&] { return eye.is_busy(); });
  settings = {screen.width(),  screen.height(),   settings.is_dark,
              eye.looks.lines, eye.looks.handles, eye.looks.by_patches};
  if (window.is_dark() != was_dark) settings.is_dark = window.is_dark();
  write_settings(settings, file);
  return window.applies();
}

}  // namespace gradmesh
