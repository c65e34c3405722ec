/// \file
/// \brief Processes and pipes.
#include "program.hpp"

#include "tumble/record/table_file.hpp"

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <exception>
#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace tumble::app {
namespace {

[[noreturn]] void fail(const std::string& program) {
  throw CannotWrite("tumble: cannot start " + program + ": " + std::strerror(errno));
}

// Writes all of it; false if the reader has ended.
bool write_all(int pipe, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = write(pipe, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  return true;
}

}  // namespace

int run_program(const std::vector<std::string>& words, const std::filesystem::path& folder,
                const std::function<void(const Feeder&)>& feed) {
  std::vector<char*> arguments;  // exec takes char*, and changes nothing
  for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  std::array<int, 2> ends{-1, -1};  // of the pipe: for reading, for writing
  if (feed && pipe2(ends.data(), O_CLOEXEC) != 0) fail(words[0]);
  // For a program that has ended, write() fails.
  const auto before = feed ? std::signal(SIGPIPE, SIG_IGN) : SIG_DFL;
  const pid_t child = fork();
  if (child == 0) {
    if (feed) {
      std::signal(SIGPIPE, SIG_DFL);
      dup2(ends[0], STDIN_FILENO);
    }
    if (chdir(folder.c_str()) == 0) execvp(arguments[0], arguments.data());
    _exit(kNoProgram);
  }
  if (feed) close(ends[0]);
  std::exception_ptr thrown;
  if (feed && child > 0) {
    try {
      feed([&](std::string_view bytes) { return write_all(ends[1], bytes); });
    } catch (...) {
      thrown = std::current_exception();
    }
  }
  if (feed) close(ends[1]);
  if (feed) std::signal(SIGPIPE, before);
  if (child < 0) fail(words[0]);
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) continue;
  if (thrown) std::rethrow_exception(thrown);
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

}  // namespace tumble::app
