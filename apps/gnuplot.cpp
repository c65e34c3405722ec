/// \file
/// \brief Running gnuplot.
#include "gnuplot.hpp"

#include "tumble/record/table_file.hpp"

#include <cerrno>
#include <cstring>
#include <sys/wait.h>
#include <unistd.h>

namespace tumble::app {
namespace {

constexpr int kNoProgram = 127;  // as a shell tells it

}  // namespace

int run_program(const std::vector<std::string>& words, const std::filesystem::path& folder) {
  std::vector<char*> arguments;  // exec takes char*, and changes nothing
  for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  const pid_t child = fork();
  if (child < 0)
    throw CannotWrite(std::string("tumble: cannot start ") + words[0] + ": " +
                      std::strerror(errno));
  if (child == 0) {
    if (chdir(folder.c_str()) == 0) execvp(arguments[0], arguments.data());
    _exit(kNoProgram);
  }
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) continue;
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

void draw_with_gnuplot(const std::filesystem::path& folder, const std::string& script,
                       const std::string& commands, const std::string& picture) {
  const std::string part = picture + ".part";
  write_file(folder / script, "set output '" + part + "'\n" + commands);
  const int code = run_program({"gnuplot", script}, folder);
  std::error_code failed;
  if (code == 0) std::filesystem::rename(folder / part, folder / picture, failed);
  if (code == 0 && !failed) return;
  std::filesystem::remove(folder / part, failed);
  if (code == kNoProgram)
    throw CannotWrite("tumble: gnuplot is missing: install the package gnuplot-nox");
  throw CannotWrite("tumble: gnuplot could not draw " + (folder / picture).string() +
                    ", its script is " + script + " beside it");
}

}  // namespace tumble::app
