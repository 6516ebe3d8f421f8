#include "files/picture_file.h"

#include <optional>
#include <stdexcept>

#include "base/error.h"
#include "files/atomic_file.h"
#include "files/image_module.h"
#include "files/jpeg_picture.h"
#include "files/picture_reducer.h"
#include "files/png_picture.h"

namespace gradmesh {
namespace {

/// Gives the picture to the sink where it is one that every build reads. Returns whether it is.
bool decode(std::string_view bytes, PictureSink& sink, std::optional<Message>& wrong) {
  if (is_png(bytes))
    wrong = decode_png(bytes, sink);
  else if (is_jpeg(bytes))
    wrong = decode_jpeg(bytes, sink);
  else
    return false;
  return true;
}

PictureReducer reducer(int longest) {
  if (longest < 1) throw std::invalid_argument("A picture is at least one pixel long.");
  return PictureReducer(longest);
}

Picture result(const PictureReducer& sink, std::optional<Message> wrong, const std::string& name) {
  if (!wrong) wrong = sink.wrong();
  if (wrong) throw InputError("{0} is not a readable picture: {1}.", name, *wrong);
  return sink.picture();
}

}  // namespace

Picture read_picture(const std::filesystem::path& path, int longest) {
  PictureReducer sink = reducer(longest);
  std::optional<Message> wrong;
  if (const std::string bytes = read_bytes(path); bytes.empty())
    wrong = Message("it is empty");
  else if (decode(bytes, sink, wrong))
    return result(sink, wrong, path.string());
  if (!wrong) wrong = image_codec().read_picture(path.string(), sink);
  return result(sink, wrong, path.string());
}

Picture picture_of_bytes(std::string_view bytes, const std::string& name, int longest) {
  PictureReducer sink = reducer(longest);
  std::optional<Message> wrong;
  if (!decode(bytes, sink, wrong)) wrong = Message("it is neither PNG nor JPEG");
  return result(sink, wrong, name);
}

}  // namespace gradmesh
