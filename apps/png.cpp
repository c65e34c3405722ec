/// \file
/// \brief The one source that compiles stb_image_write.
#include "tumble/record/table_file.hpp"

#include "drawing_programs.hpp"

#ifdef TUMBLE_STB
#define STB_IMAGE_WRITE_STATIC
#define STB_IMAGE_WRITE_IMPLEMENTATION
#include <stb/stb_image_write.h>
#endif

namespace tumble::app {

#ifdef TUMBLE_STB
void write_png(const std::filesystem::path& path, const Raster& pixels) {
  std::string file;
  const auto take = [](void* to, void* bytes, int count) {
    static_cast<std::string*>(to)->append(static_cast<const char*>(bytes),
                                          static_cast<std::size_t>(count));
  };
  if (stbi_write_png_to_func(take, &file, pixels.width, pixels.height, 3, pixels.rgb.data(),
                             3 * pixels.width) == 0)
    throw CannotWrite("cannot write " + path.string());
  write_file(path, file);
}
#else
void write_png(const std::filesystem::path& path, const Raster&) {
  throw CannotWrite("cannot write " + path.string() +
                    ": this command was built without stb (Debian: libstb-dev); svg needs nothing");
}
#endif

}  // namespace tumble::app
