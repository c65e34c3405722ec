/// \file
/// \brief Small files for tests of what reads them, and the numbers of a figure.
#pragma once

#include "support/catch.hpp"
#include "support/files.hpp"

#include <filesystem>
#include <fstream>
#include <string>

#ifndef TUMBLE_SOURCE_DIR
#define TUMBLE_SOURCE_DIR "."  // where the build does not say
#endif

namespace tumble::chapters {

// A folder of one test and its process, removed when the test ends.
class Scratch {
 public:
  // Begins with no file in it.
  explicit Scratch(const std::string& name) : folder_("chapters_" + name) {}

  // Writes a file.
  [[nodiscard]] std::filesystem::path file(const std::string& name, const std::string& text) const {
    const std::filesystem::path path = folder_.file(name);
    std::filesystem::create_directories(path.parent_path());
    std::ofstream(path, std::ios::binary) << text;
    return path;
  }

  // Writes what a figure computed: `NAME_numbers.csv`, in folder `figures`.
  [[nodiscard]] std::filesystem::path figure(const std::string& name, const std::string& rows,
                                             const std::string& settings = "default") const {
    return file("figures/" + name + "_numbers.csv",
                "# figure: " + name + "\n# thesis: 2.1\n# title: A < B & \"C\"\n# command: " +
                    "reproduce_falling --figure " + name + "\n# settings: " + settings +
                    "\n# parameter: step = 0.1 [s] time step\n# caption: It falls.\n" +
                    "quantity,unit,value,low,high,seeds\n" + rows)
        .parent_path();
  }

 private:
  test::Folder folder_;
};

// The folder of the chapters.
inline std::filesystem::path chapters_folder() {
  return std::filesystem::path(TUMBLE_SOURCE_DIR) / "chapters";
}

// The files of this name that the chapters have, by chapter.
inline std::vector<std::filesystem::path> files_of_chapters(const std::string& name) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(chapters_folder()))
    if (std::filesystem::exists(entry.path() / name)) files.push_back(entry.path() / name);
  std::ranges::sort(files);  // a directory has no order
  return files;
}

// What is read from them, in one list.
template <class Read>
auto read_of_chapters(const std::string& name, const Read& read) {
  decltype(read(std::filesystem::path())) all;
  for (const std::filesystem::path& file : files_of_chapters(name)) {
    const auto more = read(file);
    all.insert(all.end(), more.begin(), more.end());
  }
  return all;
}

// A text in which a part that it has to have is another one.
inline std::string replaced(std::string text, const std::string& old_text,
                            const std::string& new_text) {
  const std::size_t at = text.find(old_text);
  REQUIRE(at != std::string::npos);
  return text.replace(at, old_text.size(), new_text);
}

// One claim, as a chapter's claims.toml has it: a speed of at least 1 m/s confirms it.
inline std::string claim_on_speed(const std::string& statement) {
  return "[[claim]]\nid = \"2.1a\"\nsection = \"2.1\"\nstatement = \"" + statement + R"("
experiment = "A box is dropped."
technique = "basic"
reading = "ours"
quantity = "speed"
unit = "m/s"
confirmed = ">= 1"
refuted = "< 1"
reason = "One is fast."
figure = "claim_2_1a_fall"
test = "A box falls"
reads = "stands"
reads_because = "Because."
)";
}

}  // namespace tumble::chapters
