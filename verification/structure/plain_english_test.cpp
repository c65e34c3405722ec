/// \file
/// \brief Words of comments, messages and test names that a reader would have to decode.
#include "structure/source_tree.hpp"
#include "support/catch.hpp"

#include <cctype>
#include <regex>

namespace tumble::structure {
namespace {

struct Rule {
  std::vector<std::string> parts;  // what it finds has one of them: they are found sooner
  std::regex words;
  std::string plainer;

  [[nodiscard]] bool may_apply(const std::string& prose) const {
    return std::ranges::any_of(
        parts, [&](const std::string& part) { return prose.find(part) != std::string::npos; });
  }
};

// Comments and the insides of literals in small letters: whatever is blank in the code alone.
std::string prose_of(const std::string& text) {
  std::string prose = code_of(text);
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool code = prose[i] == text[i] && text[i] != '\n';
    prose[i] = code ? ' ' : static_cast<char>(std::tolower(static_cast<unsigned char>(text[i])));
  }
  return prose;
}

const std::vector<Rule>& rules() {
  const auto form = [](const char* words) { return std::regex(words, std::regex::optimize); };
  static const std::vector<Rule> all{
      {{"who", "nobody", "somebody", "anybody"},
       form(R"(\b(who|whom|whoever|nobody|somebody|anybody)\b)"),
       "a body is \"it\""},
      {{"tell", "told"},
       form(R"(\b(tell|tells|telling|told|teller)\b)"),
       "classify, report, detect, distinguish, show"},
      {{"let"}, form(R"(\b(let|lets|letting) go\b)"), "release"},
      {{"parting"}, form(R"(\bparting\b)"), "separating, separation velocity"},
      {{"what is"}, form(R"(///.*\bwhat is\b)"), "name it with a noun"},
      {{"/// \\brief "},
       form(R"(^/// \\brief (what|who|how|where|when|why)\b)"),
       "a brief is a noun phrase"}};
  return all;
}

Complaints old_dialect(const std::vector<SourceFile>& files) {
  Complaints complaints;
  for (const SourceFile& file : files) {
    const std::vector<std::string> lines = lines_of(prose_of(file.text));
    for (std::size_t i = 0; i < lines.size(); ++i) {
      const std::size_t first = lines[i].find_first_not_of(' ');
      if (first == std::string::npos) continue;
      const std::string prose = lines[i].substr(first);
      for (const Rule& rule : rules()) {
        std::smatch match;
        if (rule.may_apply(prose) && std::regex_search(prose, match, rule.words))
          complaints.push_back(place(file, i + 1) + "'" + match.str() + "': " + rule.plainer);
      }
    }
  }
  return complaints;
}

}  // namespace

TEST_CASE("A word that has a plainer one is found", "[structure]") {
  const auto found = [](const char* text) { return old_dialect({{"a.hpp", text}}).size(); };
  CHECK(old_dialect({{"a.hpp", std::string("\n// bodies w") + "ho rest\n"}}) ==
        Complaints{std::string("a.hpp:2: 'w") + "ho': a body is \"it\""});
  CHECK(found("say(\"To"
              "ld by its speed\");\n") == 1);
  CHECK(found("/// \\brief W"
              "hat a step does\n") == 1);
  CHECK(found("/// The share of w"
              "hat is left\n") == 1);
  CHECK(found("int nobo"
              "dy = 0;  // a name in code is looked at elsewhere\n") == 0);
  CHECK(found("// whose arms, somewhat, a total and a retold tale\n") == 0);
}

TEST_CASE("Comments and messages and test names use plain English", "[structure]") {
  const auto files = project_files();
  auto code = code_in(files, "");
  std::erase_if(code, [](const SourceFile& file) {
    return file.path.starts_with("verification/structure/plain_english");  // which quotes them
  });
  expect_none(old_dialect(code));
}

}  // namespace tumble::structure
