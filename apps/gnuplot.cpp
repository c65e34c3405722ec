/// \file
/// \brief Running gnuplot.
#include "gnuplot.hpp"

#include "tumble/record/table_file.hpp"

#include "program.hpp"

namespace tumble::app {
void draw_with_gnuplot(const std::filesystem::path& folder, const std::string& script,
                       const std::string& commands, const std::string& picture) {
  const std::string part = picture + ".part";
  write_file(folder / script, "set output '" + part + "'\n" + commands);
  std::error_code failed;
  std::filesystem::remove(folder / part, failed);  // a link there would be followed
  const int code = run_program({"gnuplot", script}, folder);
  if (code == 0) std::filesystem::rename(folder / part, folder / picture, failed);
  if (code == 0 && !failed) return;
  std::filesystem::remove(folder / part, failed);
  if (code == kNoProgram)
    throw CannotWrite("tumble: gnuplot is missing: install the package gnuplot-nox");
  throw CannotWrite("tumble: gnuplot could not draw " + (folder / picture).string() +
                    ", its script is " + script + " beside it");
}

}  // namespace tumble::app
