/// \file
/// \brief The references and the sources that use them name each other.
#include "structure/source_tree.hpp"
#include "support/catch.hpp"

#include <regex>

namespace tumble::structure {
namespace {

// An entry of site/references.md: authors, year, and the parts of the library that use it.
struct Reference {
  std::string head;                  // "Baraff 1994"
  std::vector<std::string> authors;  // surnames
  std::string year;
  std::vector<std::string> users;  // names in namespace tumble
};

std::vector<std::string> matches_of(const std::string& text, const std::regex& form) {
  std::vector<std::string> found;
  for (std::sregex_iterator it(text.begin(), text.end(), form), end; it != end; ++it)
    found.push_back((*it)[1]);
  return found;
}

std::vector<Reference> references_in(const std::string& page) {
  static const std::regex entry(R"(\\anchor ref_\w+ \*\*([^*]+)\*\*([^]*?)(?=\n- |\n#|$(?![^])))");
  static const std::regex author(R"(([A-ZÀ-Þ][^ ,.]*(?: (?:[Ss]axcé|Lidec|Leeuwen))?))");
  static const std::regex used(R"(tumble::(\w+))");
  std::vector<Reference> references;
  for (std::sregex_iterator it(page.begin(), page.end(), entry), end; it != end; ++it) {
    Reference reference;
    reference.head = (*it)[1];
    const std::vector<std::string> years =
        matches_of(reference.head, std::regex(R"(((?:19|20)\d\d))"));
    if (!years.empty()) reference.year = years.back();
    reference.authors = matches_of(reference.head, author);
    reference.users = matches_of((*it)[2], used);
    references.push_back(reference);
  }
  return references;
}

bool names_one_of(const std::string& text, const std::vector<std::string>& words) {
  return std::ranges::any_of(
      words, [&](const std::string& word) { return text.find(word) != std::string::npos; });
}

// Whether a name stands in a text, and not as a part of another one.
bool has_word(const std::string& text, const std::string& word) {
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) {
    const std::size_t after = at + word.size();
    if ((at == 0 || !in_name(text[at - 1])) && (after == text.size() || !in_name(text[after])))
      return true;
  }
  return false;
}

// Users that do not exist, and users none of whose files names an author.
Complaints broken_uses(const std::vector<Reference>& references,
                       const std::vector<SourceFile>& code) {
  Complaints complaints;
  for (const Reference& reference : references) {
    for (const std::string& user : reference.users) {
      bool exists = false;
      bool cited = false;
      for (const SourceFile& file : code) {
        if (!has_word(file.text, user)) continue;
        exists = true;
        cited = cited || names_one_of(file.text, reference.authors);
      }
      if (!exists) complaints.push_back(reference.head + ": there is no tumble::" + user);
      if (exists && !cited)
        complaints.push_back(reference.head + ": no file with tumble::" + user +
                             " names an author");
    }
  }
  return complaints;
}

// "Mirtich 2000" or "\see Mirtich, ..." in a comment, without such an entry.
Complaints missing_entries(const std::vector<Reference>& references,
                           const std::vector<SourceFile>& code) {
  static const std::regex citation(R"(([A-Z][a-zé]+) \(?((?:19|20)\d\d)\b)");
  static const std::regex see(R"(\\see ([A-Z][^ ,;]+(?: [A-Z][^ ,;]+)?)(?:,| and [A-Z]| et al))");
  Complaints complaints;
  for (const SourceFile& file : code) {
    for (const std::string& comment : comments_of(file.text)) {
      if (!names_one_of(comment, {"\\see ", " 19", " 20", "(19", "(20"})) continue;
      for (const auto& [form, dated] : {std::pair{citation, true}, {see, false}}) {
        for (std::sregex_iterator it(comment.begin(), comment.end(), form), end; it != end; ++it) {
          const std::smatch& match = *it;
          const bool known =
              std::ranges::any_of(references, [&, with_year = dated](const Reference& one) {
                return (!with_year || one.year == match[2]) && names_one_of(match[1], one.authors);
              });
          if (!known)
            complaints.push_back(file.path + ": " + match.str() + " is not among the references");
        }
      }
    }
  }
  return complaints;
}

const std::string kPage =
    "- \\anchor ref_baraff1994 **Baraff 1994.** David\n  Baraff. Used in tumble::Solver.\n"
    "- \\anchor ref_pang2000 **Pang and Trinkle 2000.** Read.\n";

}  // namespace

TEST_CASE("A reference without user and a citation without entry are found", "[structure]") {
  const auto references = references_in(kPage);
  CHECK(broken_uses(references, {{"a.hpp", "/// Baraff.\nclass Solver;\n"}}).empty());
  CHECK(broken_uses(references, {{"a.hpp", "class Solver;\n"}}).size() == 1);
  CHECK(broken_uses(references, {{"a.hpp", "class Other;\n"}}).size() == 1);
  CHECK(missing_entries(references, {{"a.hpp", "/// Trinkle 2000\n"}}).empty());
  CHECK(missing_entries(references, {{"a.hpp", "/// Trinkle 1996\n"}}).size() == 1);
  CHECK(missing_entries(references, {{"a.hpp", "/// \\see Lemke, it\n"}}).size() == 1);
}

TEST_CASE("References and sources name each other", "[structure]") {
  const auto files = project_files();
  const std::vector<Reference> references =
      references_in(file_called(files, "site/references.md").text);
  CHECK(references.size() > 40);
  const std::vector<SourceFile> code = code_in(files, "src/");
  expect_none(broken_uses(references, code));
  expect_none(missing_entries(references, code));
}

TEST_CASE("README shows the first example as it is compiled", "[structure]") {
  const auto files = project_files();
  const auto text_of = [&](const char* path) { return file_called(files, path).text; };
  const std::string mark = "// [stack]\n";
  const std::string example = text_of("examples/link/stack.cpp");
  const std::size_t begin = example.find(mark) + mark.size();
  const std::string code = example.substr(begin, example.rfind(mark) - begin);
  REQUIRE(code.size() > 200);
  const std::string readme = text_of("README.md");
  CHECK(readme.find("```cpp\n" + code + "```\n") != std::string::npos);
  std::string output = text_of("examples/link/stack_output.txt");
  output.pop_back();
  CHECK(readme.find("`" + output + "`") != std::string::npos);
}

}  // namespace tumble::structure
