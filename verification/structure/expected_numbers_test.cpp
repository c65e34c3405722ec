/// \file
/// \brief Each expected number of a figure is used by something that a reader meets.
#include "structure/source_tree.hpp"
#include "support/catch.hpp"

#include <cctype>
#include <regex>

namespace tumble::structure {
namespace {

struct ExpectedNumber {
  std::size_t line;  // of expected.csv
  std::string figure;
  std::string quantity;
};

std::vector<ExpectedNumber> expected_numbers(const SourceFile& file) {
  static const std::regex row(R"re((\w+),(?:"([^"]*)"|([^",]*)),.*)re");
  std::vector<ExpectedNumber> numbers;
  const std::vector<std::string> lines = lines_of(file.text);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    std::smatch match;
    if (!lines[i].starts_with("figure,") && std::regex_match(lines[i], match, row))
      numbers.push_back({i + 1, match[1], match[2].matched ? match[2] : match[3]});
  }
  return numbers;
}

// Texts in double quotes, those that follow one another joined.
std::set<std::string> literals_in(const std::string& source) {
  static const std::regex pieces(R"re("((?:[^"\\\n]|\\.)*)"(\s*(?="))?)re");
  std::set<std::string> literals;
  std::string literal;
  for (std::sregex_iterator it(source.begin(), source.end(), pieces), end; it != end; ++it) {
    literal += (*it)[1];
    if ((*it)[2].matched) continue;
    literals.insert(literal);
    literal.clear();
  }
  return literals;
}

// Whether a name is one of the literals, or made of several of them and numbers, one after the other.
bool made_of(const std::string& name, const std::set<std::string>& literals) {
  std::vector<bool> reached(name.size() + 1, false);
  reached[0] = true;
  for (std::size_t at = 0; at < name.size(); ++at) {
    if (!reached[at]) continue;
    if (std::isdigit(static_cast<unsigned char>(name[at])) != 0) reached[at + 1] = true;
    for (const std::string& literal : literals)
      if (name.compare(at, literal.size(), literal) == 0) reached[at + literal.size()] = true;
  }
  return reached[name.size()];
}

// Whether a figure is named, or a family of figures that it belongs to: "gallery_".
bool names_figure(const std::string& figure, const std::set<std::string>& literals) {
  return literals.count(figure) > 0 ||
         std::ranges::any_of(literals, [&](const std::string& literal) {
           return literal.size() > 3 && literal.back() == '_' && figure.starts_with(literal);
         });
}

// All that can use a number.
struct NumberUsers {
  std::set<std::pair<std::string, std::string>> cited;  // on a page or in a caption
  std::vector<std::set<std::string>> named;   // by each record of a claim, erratum or choice
  std::vector<std::set<std::string>> tested;  // by each test file
  std::set<std::string> whole;  // figures whose script, or a test, reads all of their numbers

  [[nodiscard]] bool use(const ExpectedNumber& number) const {
    const auto names = [&](const std::set<std::string>& texts) {
      return texts.count(number.figure) > 0 && texts.count(number.quantity) > 0;
    };
    const auto tests = [&](const std::set<std::string>& literals) {
      return names_figure(number.figure, literals) && made_of(number.quantity, literals);
    };
    return cited.count({number.figure, number.quantity}) > 0 || whole.count(number.figure) > 0 ||
           std::ranges::any_of(named, names) || std::ranges::any_of(tested, tests);
  }
};

void add_citations(const std::string& text, NumberUsers& users) {
  static const std::regex comment(R"(<!--\s*(\w+):\s*([^>]*?)\s*-->)");
  static const std::regex line_break(R"(\s*\n\s*)");
  for (std::sregex_iterator it(text.begin(), text.end(), comment), end; it != end; ++it)
    users.cited.insert({(*it)[1], std::regex_replace((*it)[2].str(), line_break, " ")});
}

void add_records(const std::string& text, NumberUsers& users) {
  for (std::size_t at = text.find("[["); at != std::string::npos;) {
    const std::size_t next = text.find("\n[[", at + 1);
    users.named.push_back(literals_in(text.substr(at, next - at)));
    at = next;
  }
}

NumberUsers number_users(const std::vector<SourceFile>& files) {
  static const std::array<std::string_view, 3> records = {"/claims.toml", "/errata.toml",
                                                          "/choices.toml"};
  NumberUsers users;
  for (const SourceFile& file : files) {
    const std::string& path = file.path;
    const std::string name = path.substr(path.rfind('/') + 1);
    if (path.ends_with(".md") || name == "figures.toml") {
      add_citations(file.text, users);
    } else if (std::ranges::any_of(
                   records, [&](std::string_view ending) { return path.ends_with(ending); })) {
      add_records(file.text, users);
    } else if (path.ends_with(".gp")) {
      if (file.text.find("_numbers.csv") != std::string::npos)
        users.whole.insert(name.substr(0, name.size() - 3));
    } else if (path.starts_with("verification/") && path.ends_with("_test.cpp")) {
      users.tested.push_back(literals_in(file.text));
      if (name == "claims_test.cpp")  // compares every number of its figures
        users.whole.insert(users.tested.back().begin(), users.tested.back().end());
    }
  }
  return users;
}

Complaints unused_numbers(const std::vector<SourceFile>& files) {
  const NumberUsers users = number_users(files);
  Complaints complaints;
  for (const SourceFile& file : files) {
    if (!file.path.ends_with("/expected.csv")) continue;
    for (const ExpectedNumber& number : expected_numbers(file))
      if (!users.use(number))
        complaints.push_back(place(file, number.line) + number.figure + ", " + number.quantity +
                             ": no claim, erratum, choice, page, caption, picture or test uses it");
  }
  return complaints;
}

const SourceFile kExpected{
    "chapters/falling/expected.csv",
    "# What must come out.\nfigure,quantity,unit,value,tolerance,reason\n"
    "drop,\"speed, at 2 m\",m/s,6.26,0.01,by hand\ndrop,time,s,1,0,by hand\n"};

std::size_t unused_with(const SourceFile& user) { return unused_numbers({kExpected, user}).size(); }

}  // namespace

TEST_CASE("A number is used by a record, a page, a caption, a picture or a test", "[structure]") {
  CHECK(unused_with({"README.md", "Nothing."}) == 2);
  CHECK(unused_with({"chapters/falling/claims.toml",
                     "[[claim]]\nfigure = \"drop\"\nquantity = \"time\"\n"}) == 1);
  CHECK(unused_with({"chapters/falling/claims.toml",
                     "[[claim]]\nfigure = \"drop\"\n[[claim]]\nquantity = \"time\"\n"}) == 2);
  CHECK(unused_with({"chapters/falling/figures.toml", "6.3 <!-- drop: speed,\nat 2 m --> m/s"}) ==
        1);
  CHECK(unused_with({"chapters/falling/page.md", "1 <!-- other: time -->s"}) == 2);
  CHECK(unused_with({"figures/falling/drop.gp", "stats stem.'_numbers.csv'"}) == 0);
  CHECK(unused_with({"verification/falling/drop_test.cpp",
                     R"(f("drop", "speed, at " + to_string(2) + " m"))"}) == 1);
  CHECK(unused_with({"verification/chapters/claims_test.cpp", "{\"drop\"}"}) == 0);
}

TEST_CASE("Every expected number is used", "[structure]") {
  expect_none(unused_numbers(project_files()));
}

}  // namespace tumble::structure
