/// \file
/// \brief Figures in the list of their program, their texts, and rows of tables.
#include "chapters/scratch.hpp"
#include "driver/figure_texts.hpp"
#include "driver/registry.hpp"
#include "support/test.hpp"

namespace tumble::chapters {
namespace {

std::string text_of_figure(const std::string& id) {
  return "[[figure]]\nid = \"" + id + "\"\nsection = \"2.1\"\ntitle = \"It falls\"\n" +
         "caption = \"\"\"\nIt falls for 5\n  <!-- drop: length of\nthe fall --> "
         "m,\nflat.\n\"\"\"\n";
}

}  // namespace

TEST_CASE("A figure gets its texts in one line, without the comments", "[unit][ledger]") {
  const Scratch scratch("texts");
  const auto texts =
      read_figure_texts(scratch.file("figures.toml", text_of_figure("b") + text_of_figure("a")));
  REQUIRE(texts.size() == 2);
  CHECK(texts[0].caption == "It falls for 5 <!-- drop: length of the fall --> m, flat.");
  const std::vector<Figure> figures = with_texts({{.name = "a"}, {.name = "b"}}, texts);
  REQUIRE(figures.size() == 2);
  CHECK(figures[0].name == "b");  // the order of the texts
  CHECK(figures[0].section == "2.1");
  CHECK(figures[0].title == "It falls");
  CHECK(figures[0].caption == "It falls for 5 m, flat.");
}

TEST_CASE("A figure without text and a text without figure are named", "[unit][ledger]") {
  const Scratch scratch("unmatched");
  const auto texts = read_figure_texts(scratch.file("figures.toml", text_of_figure("written")));
  CHECK_THROWS_WITH(with_texts({{.name = "measured"}}, texts),
                    Contains("describes written, which no source registers") &&
                        Contains("registers measured, which figures.toml does not describe"));
}

TEST_CASE("Every registered figure has a text in its chapter, and every text a figure",
          "[unit][ledger]") {
  const std::vector<FigureText> texts = read_of_chapters("figures.toml", read_figure_texts);
  CHECK(texts.size() > 40);
  CHECK_NOTHROW(with_texts(registered_figures(), texts));
}

TEST_CASE("A row takes numbers of any type, one for each column", "[unit][ledger]") {
  Table table{"", {{"count", "-", "a"}, {"x", "m", "b"}, {"y", "m", "c"}, {"on", "-", "d"}}};
  table.add(std::int64_t{3}, std::array<double, 2>{0.5, 0.1}, true);
  CHECK(table.rows == std::vector<std::vector<double>>{{3.0, 0.5, 0.1, 1.0}});
  CHECK_THROWS_WITH(table.add(1, 2.0), Contains("2 numbers for 4 columns"));
  CHECK(Quantity("count", "-", std::size_t{7}).value == 7.0);
}

}  // namespace tumble::chapters
