/// \file
/// \brief `tumble view`: a run in the browser.
#include "tumble/base/error.hpp"

#include "program.hpp"
#include "request.hpp"

#include <cstdio>

namespace tumble::app {
namespace {

// Debian has xdg-open, macOS has open. A browser that cannot be started is no mistake: the page is there.
bool opened(const std::filesystem::path& page) {
  for (const char* program : {"xdg-open", "open"})
    if (run_program({program, page.string()}, ".") == kDone) return true;
  return false;
}

}  // namespace

int view_command(const Request& request, bool open) {
  std::filesystem::path folder = request.scene;
  std::error_code none;
  int code = kDone;
  const bool sampled = is_sampling(folder);
  require::that(sampled || !request.motion,
                "--motion: " + request.scene + " is not a folder of tumble sample");
  if (!sampled && !std::filesystem::exists(folder / kTrajectoryFile, none))
    code = run_into(request, folder);
  if (stop_signal() != 0 || code == kBadInput) return code;
  RenderRequest page;
  page.folder = folder.string();
  page.form = "html";
  page.filtered = request.filter.has_value();
  page.motion = request.motion;
  render_command(page);
  const std::filesystem::path file =
      std::filesystem::absolute(folder / ("view" + suffix_of(page) + ".html"), none);
  if (open && !opened(file))
    std::printf("no browser could be started: open file://%s\n", file.c_str());
  return code;
}

}  // namespace tumble::app
