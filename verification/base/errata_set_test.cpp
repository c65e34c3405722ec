/// \file
/// \brief Lists of errata are read as they are meant.
#include "tumble/base/errata_set.hpp"

#include "support/test.hpp"

using namespace tumble;

namespace {

const ErrataList& known_here() {
  static const ErrataList list(std::array<ErrataGroup, 3>{{{"C", 12}, {"RK", 4}, {"D", 2}}});
  return list;
}

using Set = ErrataSetOf<known_here>;

}  // namespace

TEST_CASE("A list of errata holds what it names and nothing else", "[unit][base]") {
  const Set set(" C1, D2,RK1 ,C1");
  CHECK(set.text() == "C1,RK1,D2");
  for (const std::string& id : Set::known())
    CHECK(set.has(id) == (id == "C1" || id == "RK1" || id == "D2"));
  CHECK(Set(set.text()) == set);
  CHECK(Set("").text() == "none");
  CHECK(Set("none") == Set());
  CHECK(Set("all") == Set::all());
  CHECK(Set::all().without("D2").with("D2") == Set::all());
  CHECK_FALSE(Set::all().without("C10").has("C10"));
  CHECK(Set::all().without("C10").has("C1"));
}

TEST_CASE("Ids of errata are numbered in the order of their groups", "[unit][base]") {
  CHECK(Set::known().size() == 18);
  CHECK(Set::known().front() == "C1");
  CHECK(Set::known().back() == "D2");
}

TEST_CASE("An unknown erratum is refused with the known ones", "[unit][base]") {
  for (const char* list : {"C13", "C0", "c1", "C1,,C2", "C1,", ",", "C1 C2", "none,C1", "all,C1"}) {
    INFO(list);
    CHECK_THROWS_AS(Set(list), std::invalid_argument);
  }
  CHECK_THROWS_AS(Set().has("T1"), std::invalid_argument);
  CHECK_THROWS_AS(Set().with(""), std::invalid_argument);
  CHECK_THROWS_WITH(
      Set("C1,Q7"),
      "tumble: erratum 'Q7': expected C1 to C12, RK1 to RK4 or D1 to D2, or none, or all");
}
