/// \file
/// \brief Texts that the TOML library does not survive are refused before it sees them.

#include "scenes/refusal.hpp"
#include "support/test.hpp"

using namespace tumble;
using tumble::test::kBox, tumble::test::refusal;

TEST_CASE("A key with very many dots, which the TOML library does not survive, is refused",
          "[unit][scenes]") {
  std::string dots = "a";
  for (int k = 0; k < 300000; ++k) dots += k % 2 == 0 ? ".a" : ". \"a\"";
  for (const std::string& text : {dots + " = 1", "[" + dots + "]", "[[" + dots + "]]",
                                  "x = {" + dots + " = 1}", "x = [" + dots + "]"})
    CHECK_THAT(refusal(kBox + "\n" + text + "\n"), Contains("dots"));
  CHECK(refusal("title = \"a.b" + dots + "\"\n" + std::string(kBox)).find("dots") ==
        std::string::npos);
  CHECK(parse_scene("# " + dots + "\n" + std::string(kBox), "my.toml").boxes.size() == 1);
}

TEST_CASE("A letter that is not ASCII may stand in quotes and comments alone", "[unit][scenes]") {
  for (const char* text : {"größe = 1\n", "[größe]\n", "x = ö\n", "x.ö = 1\n"})
    CHECK_THAT(refusal(kBox + std::string("\n") + text), Contains("ASCII"));
  CHECK(parse_scene("title = \"größe ' = ö\" # größe\n" + std::string(kBox), "my.toml").title ==
        "größe ' = ö");
}

TEST_CASE("A quote in a number hides no letter from the check before the TOML library",
          "[unit][scenes]") {
  // U+FEFC and U+FEFF; the library looks through what begins like a number to its end, whatever is in it.
  for (const std::string letter :
       {"\xEF\xBB\xBC", "\xEF\xBB\xBF", "ö", "\xC2\x85", "\xF0\x9F\x98\x80"}) {
    for (const char* before : {"x = 0\"", "x = 1.\"", "x = -'", "x = 1[\"", "x = 1=\"", "x = [1{'",
                               "x = 1\"\"\"", "x = +1\"\"\"\n"})
      CHECK_THAT(refusal(kBox + std::string("\n") + before + letter),
                 Contains("a number has a quote in it"));
    // Strings that end later than they seem to.
    for (const char* before : {"x = \"\"\"a\"\"\"\", 1", "x = ['''a''''', 1", "x = \"\\\\\", 1"})
      CHECK_THAT(refusal(kBox + std::string("\n") + before + letter), Contains("ASCII"));
    for (const char* before : {"x = \"\\", "x = \"\"\"\\", "x = \"\"\"a\\ \r\n\n\t "})
      CHECK_THAT(refusal(kBox + std::string("\n") + before + letter),
                 Contains("follows a backslash"));
    CHECK(parse_scene("title = \"\"\"1\"" + letter + "\"\"\"\"\"\n" + kBox, "my.toml").title ==
          "1\"" + letter + "\"\"");
  }
}
