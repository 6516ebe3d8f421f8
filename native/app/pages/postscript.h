#pragma once

#include <chrono>
#include <string>
#include <string_view>

namespace gradmesh {

/// Returns true if the content is PostScript, which EPS and old .ai files are, also where EPS has
/// the header of DOS, which adds a preview.
bool is_postscript(std::string_view bytes);

/// Returns a PDF document that shows the same, with the same mesh shadings. Ghostscript makes it,
/// or the program that the environment variable GRADMESH_GHOSTSCRIPT names. `name` is that of the
/// file in messages. Throws InputError where there is no Ghostscript, on Windows always, where it
/// fails, and where it takes longer than `limit`: PostScript is a language of programs, and some of
/// these do not end.
std::string pdf_of_postscript(std::string_view bytes, const std::string& name,
                              std::chrono::milliseconds limit = std::chrono::minutes(1));

}  // namespace gradmesh
