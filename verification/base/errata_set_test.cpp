/// \file
/// \brief Lists of errata are read as they are meant.
#include "tumble/base/errata_set.hpp"

#include "support/catch.hpp"

#include <stdexcept>
#include <string>

using namespace tumble;

TEST_CASE("A list of errata holds what it names and nothing else", "[unit][base]") {
  const ErrataSet set(" C1, DM17,RK1 ,C1");
  CHECK(set.text() == "C1,RK1,DM17");
  for (const std::string& id : ErrataSet::known())
    CHECK(set.has(id) == (id == "C1" || id == "RK1" || id == "DM17"));
  CHECK(ErrataSet(set.text()) == set);
  CHECK(ErrataSet("").text() == "none");
  CHECK(ErrataSet("none") == ErrataSet());
  CHECK(ErrataSet("all") == ErrataSet::all());
  CHECK(ErrataSet::all().without("G8").with("G8") == ErrataSet::all());
  CHECK_FALSE(ErrataSet::all().without("C10").has("C10"));
  CHECK(ErrataSet::all().without("C10").has("C1"));
}

TEST_CASE("There are 57 errata of damped integration", "[unit][base]") {
  // 6 + 11 + 4 + 4 + 17 + 7 + 8
  CHECK(ErrataSet::known().size() == 57);
  CHECK(ErrataSet::known().front() == "D1");
  CHECK(ErrataSet::known().back() == "G8");
}

TEST_CASE("The two parts of appendix A have errata of their own", "[unit][base]") {
  const auto timewarp = ErrataSet::known(Listings::timewarp);
  CHECK(timewarp.size() == 19);  // 10 + 9
  CHECK(timewarp.front() == "T1");
  CHECK(timewarp.back() == "F9");
  const ErrataSet set(" F1,T10", Listings::timewarp);
  CHECK(set.text() == "T10,F1");
  CHECK(set.has("T10"));
  CHECK_FALSE(set.has("T1"));
  const ErrataSet all = ErrataSet::all(Listings::timewarp);
  CHECK(ErrataSet("all", Listings::timewarp) == all);
  CHECK(all.has("F9"));
  CHECK_FALSE(all.has("D1"));
  CHECK_FALSE(ErrataSet::all().has("T1"));
  CHECK_THROWS_AS(ErrataSet("C1", Listings::timewarp), std::invalid_argument);
  CHECK_THROWS_AS(ErrataSet("T1"), std::invalid_argument);
}

TEST_CASE("An erratum that is none is refused with those that there are", "[unit][base]") {
  for (const char* list : {"C12", "C0", "c1", "C1,,C2", "C1,", ",", "C1 C2", "none,C1", "all,C1"}) {
    INFO(list);
    CHECK_THROWS_AS(ErrataSet(list), std::invalid_argument);
  }
  CHECK_THROWS_AS(ErrataSet().has("X8"), std::invalid_argument);
  CHECK_THROWS_AS(ErrataSet().with(""), std::invalid_argument);
  try {
    static_cast<void>(ErrataSet("C1,Q7"));
  } catch (const std::invalid_argument& error) {
    const std::string message = error.what();
    CHECK(message.find("'Q7'") != std::string::npos);
    CHECK(message.find("RK1 to RK4") != std::string::npos);
  }
}
