/// \file
/// \brief The history of the repository: no rule is younger than the number that it judges.
#include "chapters/scratch.hpp"
#include "driver/csv.hpp"
#include "driver/ledger.hpp"
#include "support/test.hpp"

namespace tumble::chapters {
namespace {

const std::filesystem::path kSource = TUMBLE_SOURCE_DIR;

// From this moment on each rule is committed before its number; some older ones say that they were not.
const std::string kFrom = "2026-11-26 02:00";

// What git prints; empty if it fails.
std::string git(const std::string& arguments) {
  const std::string command = "git -C '" + kSource.string() + "' " + arguments + " 2>/dev/null";
  const std::unique_ptr<FILE, int (*)(FILE*)> pipe(popen(command.c_str(), "r"), pclose);
  std::string text;
  char piece[4096];
  while (pipe && std::fgets(piece, sizeof piece, pipe.get()) != nullptr) text += piece;
  return text;
}

// Where a number is first in the history.
struct FirstCommit {
  std::string hash;
  std::string date;  // of its author: it stays if commits are put on others
};

// By "chapter: quantity".
using FirstCommits = std::map<std::string, FirstCommit>;

// A row that a commit adds to or takes from a chapter's table.
struct ChangedRow {
  std::string chapter;
  std::string line;
  std::string quantity;
};

// The quantities that a commit adds are new, unless it takes the same row, number and all, from another chapter: such a
// row has moved, and its quantity is as old as it was there.
void note_commit(FirstCommits& first, const FirstCommit& commit,
                 const std::vector<ChangedRow>& added, const std::vector<ChangedRow>& taken) {
  for (const ChangedRow& row : added) {
    const auto old = std::ranges::find_if(taken, [&](const ChangedRow& other) {
      return other.line == row.line && other.chapter != row.chapter;
    });
    const auto known =
        old == taken.end() ? first.end() : first.find(old->chapter + ": " + old->quantity);
    first.emplace(row.chapter + ": " + row.quantity, known == first.end() ? commit : known->second);
  }
}

FirstCommits first_commits(std::istream& history) {
  FirstCommits first;
  FirstCommit now;
  std::string from, to;
  std::vector<ChangedRow> added, taken;
  const auto chapter_in = [](const std::string& line) {
    return line.substr(15, line.find('/', 15) - 15);
  };
  const auto note = [](std::vector<ChangedRow>& rows, const std::string& chapter,
                       const std::string& line) {
    const auto cells = split_csv("head\n" + line + '\n');
    if (cells.size() == 2 && cells[1].size() > 1) rows.push_back({chapter, line, cells[1][1]});
  };
  for (std::string line; std::getline(history, line);) {
    if (line.rfind("commit ", 0) == 0) {
      note_commit(first, now, added, taken);
      added.clear();
      taken.clear();
      now = {line.substr(7, 40), line.substr(48)};
    } else if (line.rfind("--- ", 0) == 0) {
      from = line.rfind("--- a/chapters/", 0) == 0 ? chapter_in(line) : "";
    } else if (line.rfind("+++ ", 0) == 0) {
      to = line.rfind("+++ b/chapters/", 0) == 0 ? chapter_in(line) : "";
    } else if (line.rfind('+', 0) == 0) {
      note(added, to, line.substr(1));
    } else if (line.rfind('-', 0) == 0) {
      note(taken, from, line.substr(1));
    }
  }
  note_commit(first, now, added, taken);
  return first;
}

// A file of claims as it was in a commit, or just before it.
std::filesystem::path file_at(const Scratch& scratch, const std::string& commit,
                              const std::string& name) {
  return scratch.file(name, git("show '" + commit + ":" + name + "'"));
}

template <class Rule>
bool same_rule(const Rule& a, const Rule& b) {
  return a.quantity == b.quantity && a.unit == b.unit && a.confirmed == b.confirmed &&
         a.refuted == b.refuted;
}

// Whether the second measurement had its rule before its number, word by word.
bool was_ruled(const Second& second, const std::vector<Second>& before) {
  return std::ranges::any_of(before, [&](const Second& rule) {
    return rule.id == second.id && same_rule(rule, second) && rule.scene == second.scene &&
           rule.control == second.control && rule.otherwise == second.otherwise &&
           rule.ruled == second.ruled;
  });
}

bool was_ruled(const Claim& claim, const std::vector<Claim>& before) {
  return std::ranges::any_of(
      before, [&](const Claim& rule) { return rule.id == claim.id && same_rule(rule, claim); });
}

}  // namespace

TEST_CASE("No rule is younger than its number", "[unit][ledger]") {
  if (git("rev-parse --is-shallow-repository") != "false\n" ||
      git("ls-files chapters/open_claims.toml").empty()) {
    WARN("there is no history here to compare rules with: skipped");
    return;
  }
  std::istringstream history(
      git("log --reverse --topo-order -p -U0 --date=format:'%Y-%m-%d %H:%M' "
          "--format='commit %H %ad' -- 'chapters/*/expected.csv'"));
  const FirstCommits first = first_commits(history);
  REQUIRE(first.size() > 500);
  const Scratch scratch("history");
  int compared = 0;
  for (const auto& entry : std::filesystem::directory_iterator(kSource / "chapters")) {
    const std::string chapter = entry.path().filename().string();
    const std::string name = "chapters/" + chapter + "/claims.toml";
    if (!std::filesystem::exists(kSource / name)) continue;
    // The state before the commit of a number; a number that no commit has needs its rule in the last one.
    const auto before = [&](const std::string& quantity) {
      const auto found = first.find(chapter + ": " + quantity);
      return found == first.end() ? FirstCommit{"HEAD", kFrom}
                                  : FirstCommit{found->second.hash + '^', found->second.date};
    };
    for (const Second& second : read_seconds(kSource / name)) {
      if (second.run.empty()) continue;
      INFO(second.place << "its rule has to be committed, alone, before its number");
      CHECK(was_ruled(second, read_seconds(file_at(scratch, before(second.quantity).hash, name))));
      ++compared;
    }
    for (const Claim& claim : read_claims(kSource / name)) {
      const FirstCommit commit = before(claim.quantity);
      if (!claim.comparable || commit.date < kFrom) continue;
      INFO(claim.place << "its rule has to be committed, in open_claims.toml, before its number");
      CHECK(was_ruled(claim,
                      read_claims(file_at(scratch, commit.hash, "chapters/open_claims.toml"))));
      ++compared;
    }
  }
  CHECK(compared > 0);
}

TEST_CASE("A number that moves to another chapter is as old as it was, and a changed one is new",
          "[unit][ledger]") {
  const std::string old(40, 'a'), late(40, 'b');
  const auto moved = [&](const std::string& line) {
    std::istringstream history("commit " + old + " 2026-11-26 03:00\n--- /dev/null\n" +
                               "+++ b/chapters/falling/expected.csv\n+depth,deepest,m,1,0,it\n" +
                               "commit " + late + " 2026-11-26 04:00\n--- /dev/null\n" +
                               "+++ b/chapters/breaking/expected.csv\n+" + line +
                               "\n--- a/chapters/falling/expected.csv\n" +
                               "+++ b/chapters/falling/expected.csv\n-depth,deepest,m,1,0,it\n");
    return first_commits(history).at("breaking: deepest").hash;
  };
  CHECK(moved("depth,deepest,m,1,0,it") == old);
  CHECK(moved("depth,deepest,m,2,0,it") == late);
}

TEST_CASE("Verdicts by a first rule stay as they were when second words were added, but for mends",
          "[unit][ledger]") {
  const std::string then = "b8247b2";
  if (git("cat-file -t " + then) != "commit\n") {
    WARN("there is no history here to compare verdicts with: skipped");
    return;
  }
  const Scratch scratch("frozen");
  // Of a chapter: what the rule of each claim says of the number that is written down.
  const auto verdicts = [](const std::filesystem::path& claims,
                           const std::filesystem::path& expected) {
    const std::vector<DrawnFigure> figures = expected_figures({expected});
    std::map<std::string, std::string> said;
    for (const Claim& claim : read_claims(claims)) {
      if (!claim.comparable) continue;
      const double number =
          find_number(figures, claim.figure, claim.quantity, claim.place).expected;
      said[claim.id] = claim.confirmed + ' ' + claim.refuted + ": " +
                       verdict_text(read_rule(claim.confirmed, claim.refuted).verdict(number));
    }
    return said;
  };
  std::map<std::string, std::string> now;  // claims may have moved to another chapter
  for (const std::filesystem::path& claims : files_of_chapters("claims.toml"))
    now.merge(verdicts(claims, claims.parent_path() / "expected.csv"));
  // What a mend of a technique has turned since, under the same rule; CHANGELOG names it.
  const std::map<std::string, std::string> turned = {{"3.1a", ">= 0.8 < 0.5: confirmed"},
                                                     {"2.6.3a", "<= 0 > 0.01: confirmed"},
                                                     {"2.7.2b", ">= 1.5 <= 1: refuted"}};
  std::size_t compared = 0;
  std::istringstream names(git("ls-tree -r --name-only " + then + " -- chapters"));
  for (std::string name; std::getline(names, name);) {
    if (!name.ends_with("/claims.toml")) continue;
    // Then there were no second words.
    std::string text = git("show '" + then + ":" + name + "'");
    const std::string words = "reads = \"stands\"\nreads_because = \"-\"\n";
    for (std::size_t at = 0; (at = text.find("\ntest = ", at)) != std::string::npos;
         at += words.size() + 2)
      text.insert(at + 1, words);
    const std::string numbers = name.substr(0, name.rfind('/')) + "/expected.csv";
    for (const auto& [id, verdict] :
         verdicts(scratch.file(name, text), file_at(scratch, then, numbers))) {
      INFO("claim " << id);
      REQUIRE(now.count(id) == 1);
      ++compared;
      if (turned.count(id) == 1) {
        CHECK(now.at(id) == turned.at(id));
      } else {
        CHECK(now.at(id) == verdict);
      }
    }
  }
  CHECK(compared == 57);
}

}  // namespace tumble::chapters
