/// \file
/// \brief The command line of a chapter's program.
#include "driver/driver.hpp"

#include "driver/csv.hpp"
#include "driver/figure_texts.hpp"
#include "driver/played_scene.hpp"
#include "driver/registry.hpp"

#include <algorithm>
#include <cstdio>
#include <string>
#include <unistd.h>
#include <vector>

namespace tumble::chapters {
namespace {

constexpr int kDone = 0;
constexpr int kBadInput = 2;
constexpr int kNoResult = 3;
constexpr int kCannotWrite = 4;

// What the command line asks for.
struct Request {
  bool list = false;
  bool help = false;
  bool quick = false;
  std::vector<std::string> figures;  // empty: all
  std::string out = "build/figures";
  std::vector<std::string> set;  // each as key=value
};

Request parse(int argc, const char* const* argv) {
  Request request;
  for (int i = 1; i < argc; ++i) {
    const std::string option = argv[i];
    const auto next = [&]() -> std::string {
      if (i + 1 == argc) throw std::invalid_argument(option + " needs a value after it");
      return argv[++i];
    };
    if (option == "--list") {
      request.list = true;
    } else if (option == "--help") {
      request.help = true;
    } else if (option == "--quick") {
      request.quick = true;
    } else if (option == "--figure") {
      request.figures.push_back(next());
    } else if (option == "--out") {
      request.out = next();
    } else if (option == "--set") {
      request.set.push_back(next());
      const std::size_t equals = request.set.back().find('=');
      if (equals == std::string::npos || equals == 0)
        throw std::invalid_argument("'" + request.set.back() + "': give key=value");
    } else {
      throw std::invalid_argument("'" + option +
                                  "': there are --list, --figure NAME, --set KEY=VALUE, --quick, "
                                  "--out DIR, --help");
    }
  }
  return request;
}

void print_help(std::string_view program) {
  std::printf(
      "usage: %s [--list] [--figure NAME]... [--set KEY=VALUE]... [--quick] [--out DIR]\n"
      "Computes the numbers behind the figures of a chapter and writes them as CSV.\n"
      "  --list           every figure with its parameters, defaults and units\n"
      "  --figure NAME    only this one; may be given several times\n"
      "  --set KEY=VALUE  change a parameter (of the figure given)\n"
      "  --quick          small sizes, for a look or a test\n"
      "  --out DIR        where the files go (build/figures)\n"
      "exit codes: 0 done, 2 bad input, 3 no such result exists, 4 cannot write\n",
      std::string(program).c_str());
}

void print_list(std::span<const Figure> figures) {
  for (const Figure& figure : figures) {
    std::printf("%s (thesis %s): %s\n", figure.name.c_str(), figure.section.c_str(),
                figure.title.c_str());
    for (const Parameter& parameter : figure.parameters.all())
      std::printf("    %s = %s [%s] %s\n", parameter.key.c_str(), parameter.value.c_str(),
                  parameter.unit.c_str(), parameter.meaning.c_str());
  }
}

// The figures asked for, in their own order; a name that does not exist is reported with all that do.
std::vector<const Figure*> chosen(const Request& request, std::span<const Figure> figures) {
  if (request.figures.size() != 1 && !request.set.empty())
    throw std::invalid_argument("--set belongs to one figure: give --figure NAME too");
  for (const std::string& asked : request.figures) {
    std::string names;
    bool found = false;
    for (const Figure& figure : figures) {
      found = found || figure.name == asked;
      names += (names.empty() ? "" : ", ") + figure.name;
    }
    if (!found) throw std::invalid_argument("no figure '" + asked + "'; there are: " + names);
  }
  std::vector<const Figure*> result;
  for (const Figure& figure : figures)
    if (request.figures.empty() ||
        std::ranges::find(request.figures, figure.name) != request.figures.end())
      result.push_back(&figure);
  return result;
}

// The figure's parameters: default, then --quick, then as typed.
Parameters settings_of(const Figure& figure, const Request& request) {
  Parameters settings = figure.parameters;
  if (request.quick) set_all(settings, figure.quick);
  set_all(settings, request.set);
  return settings;
}

// The comment lines that every file of a figure begins with.
std::string head_of(std::string_view program, const Figure& figure, const Parameters& settings,
                    bool quick) {
  std::string command = std::string(program) + " --figure " + figure.name;
  std::string lines;
  bool changed = false;
  for (std::size_t i = 0; i < settings.all().size(); ++i) {
    const Parameter& parameter = settings.all()[i];
    if (parameter.value != figure.parameters.all()[i].value) {
      changed = true;
      command += " --set " + parameter.key + "=" + parameter.value;
    }
    lines += "# parameter: " + parameter.key + " = " + parameter.value + " [" + parameter.unit +
             "] " + parameter.meaning + '\n';
  }
  if (quick) command += " --quick";
  return "# figure: " + figure.name + "\n# thesis: " + figure.section +
         "\n# title: " + figure.title + "\n# command: " + command +
         "\n# settings: " + (changed ? "changed" : "default") + '\n' + lines;
}

// The numbers of a figure as a file, with everything that the index page shows of it.
std::string numbers_file(const std::string& head, const Figure& figure, const Result& result) {
  std::string text = head + "# caption: " + figure.caption + '\n' +
                     (result.film ? "# film: " + figure.film + '\n' : "") +
                     "quantity,unit,value,low,high,seeds\n";
  for (const Quantity& quantity : result.quantities)
    text += '"' + quantity.name + "\"," + quantity.unit + ',' + full_text(quantity.value) + ',' +
            full_text(quantity.low) + ',' + full_text(quantity.high) + ',' +
            std::to_string(quantity.seeds) + '\n';
  return text;
}

void compute(std::string_view program, const Figure& figure, const Request& request) {
  const Parameters settings = settings_of(figure, request);
  const Result result = figure.experiment(settings);
  if ((result.film != nullptr) == figure.film.empty())
    throw std::invalid_argument(figure.name + ": a film and a text about it go together");
  const std::string head = head_of(program, figure, settings, request.quick);
  const std::filesystem::path folder = request.out;
  for (const Table& table : result.tables) {
    const std::string name = figure.name + (table.suffix.empty() ? "" : "_") + table.suffix;
    write_file(folder / (name + ".csv"), csv_of(head, table));
  }
  for (const Drawing& drawing : result.drawings)
    write_file(folder / (figure.name + "_" + drawing.suffix + ".gp"), head + drawing.commands);
  if (result.film) write_file(folder / (figure.name + ".gif"), result.film());
  write_file(folder / (figure.name + "_numbers.csv"), numbers_file(head, figure, result));
}

void run(int argc, const char* const* argv, std::string_view program,
         std::span<const Figure> figures) {
  const Request request = parse(argc, argv);
  if (request.help) return print_help(program);
  if (request.list) return print_list(figures);

  const std::vector<const Figure*> todo = chosen(request, figures);
  const bool terminal = isatty(STDERR_FILENO) == 1;
  for (std::size_t i = 0; i < todo.size(); ++i) {
    if (terminal)
      std::fprintf(stderr, "\r\033[K[%zu/%zu] %s", i + 1, todo.size(), todo[i]->name.c_str());
    compute(program, *todo[i], request);
  }
  if (terminal) std::fprintf(stderr, "\r\033[K");
}

// Runs a program; a mistake becomes a line on the standard error stream.
int exit_code_of(std::string_view program, const std::function<void()>& body) {
  int code = kDone;
  std::string message;
  try {
    body();
  } catch (const std::invalid_argument& error) {
    code = kBadInput;
    message = error.what();
  } catch (const FileError& error) {
    code = kCannotWrite;
    message = error.what();
  } catch (const std::runtime_error& error) {
    code = kNoResult;
    message = error.what();
  }
  if (code != kDone)
    std::fprintf(stderr, "%s: %s\n", std::string(program).c_str(), message.c_str());
  return code;
}

}  // namespace

int run_chapter(int argc, const char* const* argv, const char* chapter, const char* folder) {
  const std::string program = std::string("reproduce_") + chapter;
  const std::string texts = std::string(folder) + "/figures.toml";
  return exit_code_of(program, [&] {
    run(argc, argv, program, with_texts(registered_figures(), read_figure_texts(texts)));
  });
}

}  // namespace tumble::chapters
