/// \file
/// \brief Files of whole lines, and JSON.
#include "tumble/record/table_file.hpp"

#include "tumble/record/json.hpp"

#include "support/files.hpp"
#include "support/test.hpp"

#include <csignal>
#include <filesystem>
#include <sys/resource.h>

TEST_CASE(
    "A table has the shortest digits that keep the bits, quotes where CSV asks for them, and whole "
    "rows",
    "[unit][record]") {
  const Folder folder("table_file");
  const auto path = folder.file("table.csv");
  {
    TableFile table(path, "number,text,whole");
    table.cell(0.1).cell("plain").cell(std::int64_t{-3}).end_row();
    table.cell(1.0 / 3.0).cell("a \"quoted\", text").cell(std::int64_t{4}).end_row();
    table.cell(5.0);  // a row that is never ended must not show
  }
  CHECK(content(path) ==
        "number,text,whole\n0.1,plain,-3\n"
        "0.3333333333333333,\"a \"\"quoted\"\", text\",4\n");
}

TEST_CASE("A file that cannot be written ends in an error that names it", "[unit][record]") {
  CHECK_THROWS_WITH(write_file("/nowhere/at/all", "text"),
                    Contains("/nowhere/at/all: No such file"));
  CHECK_THROWS_AS(TableFile("/nowhere/at/all", "a,b"), CannotWrite);
  if (!std::filesystem::exists("/dev/full")) {
    WARN("no /dev/full here: not tested");
    return;
  }
  CHECK_THROWS_AS(TableFile("/dev/full", "a,b"), CannotWrite);
  CHECK_THROWS_WITH(write_file("/dev/full", "text"), Contains("No space left"));
  CHECK(std::filesystem::exists("/dev/full"));  // half a file is removed, but not a device
}

TEST_CASE("A disk that fills up leaves whole rows, and nothing is written after that",
          "[unit][record]") {
  // The system's limit on the size of files stands for the disk; it is put back at the end.
  struct Limit {
    rlimit before{};
    explicit Limit(rlim_t bytes) {
      std::signal(SIGXFSZ, SIG_IGN);  // an error instead of an end
      getrlimit(RLIMIT_FSIZE, &before);
      rlimit now = before;
      now.rlim_cur = bytes;
      setrlimit(RLIMIT_FSIZE, &now);
    }
    ~Limit() {
      setrlimit(RLIMIT_FSIZE, &before);
      std::signal(SIGXFSZ, SIG_DFL);
    }
  };
  const Folder folder("full_disk");
  const auto path = folder.file("full.csv");
  const auto other = folder.file("full.json");
  std::int64_t failed = 0;  // the row at which the error came
  {
    TableFile table(path, "number,twice");
    const Limit limit(100000);
    for (std::int64_t k = 0; k < 100000 && failed == 0; ++k) {
      try {
        table.cell(k).cell(2 * k).end_row();
      } catch (const CannotWrite&) {
        failed = k;
      }
    }
    CHECK(failed > 0);
    table.cell(std::int64_t{-1}).cell(std::int64_t{-2}).end_row();  // would leave a hole
    CHECK_THROWS_AS(table.flush(), CannotWrite);
    CHECK_THROWS_WITH(write_file(other, std::string(200000, 'x')), Contains("full.json"));
  }
  CHECK(!std::filesystem::exists(other));  // half of it would be no JSON
  std::istringstream in(content(path));
  std::string line;
  std::getline(in, line);
  CHECK(line == "number,twice");
  std::int64_t rows = 0;
  bool right = true;
  while (std::getline(in, line)) {
    right = right && !in.eof() && line == std::to_string(rows) + "," + std::to_string(2 * rows);
    ++rows;
  }
  CHECK(right);
  CHECK(rows > 1000);
  CHECK(rows < failed);
}

TEST_CASE("JSON is written with commas, escapes and null for what is no number", "[unit][record]") {
  Json json;
  json.begin().field("name", std::string_view("a\"b\\c\n")).field("x", 0.5);
  json.field("nan", kNan).field("inf", kInfinity).field("count", std::int64_t{7});
  json.key("list").begin_list().item("one").item(1.0 / 3.0).end_list();
  json.key("empty").begin().end();
  json.end();
  CHECK(
      json.text() ==
      "{\n  \"name\": \"a\\\"b\\\\c\\u000a\",\n  \"x\": 0.5,\n  \"nan\": null,\n  \"inf\": null,\n"
      "  \"count\": 7,\n  \"list\": [\n    \"one\",\n    0.3333333333333333\n  ],\n  \"empty\": "
      "{}\n}\n");
}

TEST_CASE("Text in JSON may have every character", "[unit][record]") {
  std::string all;
  for (int c = 1; c < 0x80; ++c) all += static_cast<char>(c);
  Json json;
  json.begin().field("all", std::string_view(all)).field("ä", std::string_view("€")).end();
  const std::string text = json.text();
  CHECK(text.find("\\u0001\\u0002") != std::string::npos);
  CHECK(text.find("\\u001f !\\\"#") != std::string::npos);
  CHECK(text.find("[\\\\]") != std::string::npos);
  CHECK(text.find("\"ä\": \"€\"") != std::string::npos);
  int control = 0;
  for (const char c : text) control += static_cast<unsigned char>(c) < 0x20U && c != '\n' ? 1 : 0;
  CHECK(control == 0);
}
