#include "app/pages/postscript.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "base/error.h"

#ifndef _WIN32
#include <cstdlib>
#include <filesystem>
#include <vector>

#include "files/atomic_file.h"
#include "files/run_program.h"
#include "files/temporary_folder.h"
#endif

namespace gradmesh {
namespace {

/// What EPS begins with where it has the header of DOS (Adobe Technical Note 5002, 5.2).
constexpr std::string_view dos_mark = "\xC5\xD0\xD3\xC6";

/// Returns where PostScript begins behind what is for printers or was left there by programs: the
/// end of a job (Ctrl-D), a byte order mark, blank lines and commands of HP's printer job language.
/// Returns npos if something else is there.
std::size_t begin_of_postscript(std::string_view bytes) {
  constexpr std::string_view byte_order = "\xEF\xBB\xBF", job = "@PJL", end_of_job = "\x1B%-12345X";
  std::size_t at = bytes.starts_with(byte_order) ? byte_order.size() : 0;
  while (at < bytes.size()) {
    const std::string_view rest = bytes.substr(at);
    if (rest.starts_with("%!PS")) return at;
    if (rest.starts_with(end_of_job))
      at += end_of_job.size();
    else if (rest.starts_with(job))
      at += std::min(rest.find('\n'), rest.size());
    else if (std::string_view(" \t\r\n\x04").find(rest.front()) != bytes.npos)
      ++at;
    else
      break;
  }
  return bytes.npos;
}

#ifndef _WIN32

std::uint32_t little_endian(std::string_view bytes) {
  std::uint32_t number = 0;
  for (std::size_t n = 4; n-- > 0;) number = number << 8 | std::uint8_t(bytes[n]);
  return number;
}

/// Returns the PostScript of a file; nothing where a header of DOS leads beyond its end.
std::string_view without_header(std::string_view bytes) {
  if (!bytes.starts_with(dos_mark)) return bytes.substr(begin_of_postscript(bytes));
  constexpr std::size_t header = 30;
  if (bytes.size() < header) return {};
  const std::size_t offset = little_endian(bytes.substr(4)),
                    length = little_endian(bytes.substr(8));
  return offset < bytes.size() ? bytes.substr(offset, length) : std::string_view();
}

std::string ghostscript() {
  const char* const program = std::getenv("GRADMESH_GHOSTSCRIPT");
  return program && *program ? program : "gs";
}

#endif

}  // namespace

bool is_postscript(std::string_view bytes) {
  return bytes.starts_with(dos_mark) || begin_of_postscript(bytes) != bytes.npos;
}

#ifdef _WIN32

std::string pdf_of_postscript(std::string_view, const std::string& name,
                              std::chrono::milliseconds) {
  throw InputError("{0}: PostScript is not read on Windows; save it as PDF.", name);
}

#else

std::string pdf_of_postscript(std::string_view bytes, const std::string& name,
                              std::chrono::milliseconds limit) {
  const TemporaryFolder folder;
  // Ghostscript never sees the name of the person's file, which could be taken for an option.
  const std::filesystem::path from = folder.path() / "in.ps", to = folder.path() / "out.pdf";
  write_bytes(from, without_header(bytes));
  // Options for other colours, smaller files or older versions of PDF make pictures of meshes.
  const ProgramEnd end =
      run_program({ghostscript(), "-q", "-dSAFER", "-dBATCH", "-dNOPAUSE", "-sDEVICE=pdfwrite",
                   "-dEPSCrop", "-sOutputFile=" + to.string(), from.string()},
                  folder.path(), limit);
  if (end == ProgramEnd::not_started)
    throw InputError("{0}: PostScript is read where Ghostscript is installed (the program gs).",
                     name);
  if (end == ProgramEnd::out_of_time)
    throw InputError("{0}: Ghostscript takes too long to read it.", name);
  // Of a program that paints nothing there may be no document.
  if (end != ProgramEnd::done || !std::filesystem::is_regular_file(to))
    throw InputError("{0}: Ghostscript cannot read it.", name);
  return read_bytes(to);
}

#endif

}  // namespace gradmesh
