#include "base/closest_match.h"

#include <gtest/gtest.h>

namespace tribolog::closest_match_test {
namespace {

TEST(ClosestMatch, FindsSlipsCaseAndParts) {
  const std::vector<std::string> names = {"t_s", "q_rad", "tau_Nm"};
  EXPECT_EQ(closest_match("q_red", names), "q_rad");
  EXPECT_EQ(closest_match("Q_RAD", names), "q_rad");
  EXPECT_EQ(closest_match("tau", names), "tau_Nm");
  EXPECT_EQ(closest_match("q", names), "q_rad");
  EXPECT_EQ(closest_match("tau", {"t", "q"}), "");
  EXPECT_EQ(closest_match("tau_Nm_motor", names), "tau_Nm");
}

TEST(ClosestMatch, CountsSwappedNeighboursAsOneSlip) {
  EXPECT_EQ(closest_match("cvs", {"csv", "json"}), "csv");
  EXPECT_EQ(closest_match("dge", {"rad", "deg", "turn"}), "deg");
  EXPECT_EQ(closest_match("reprot", {"repair", "report"}), "report");
  EXPECT_EQ(closest_match("svc", {"csv"}), "");
}

TEST(ClosestMatch, IsEmptyWhereNothingIsClose) {
  EXPECT_EQ(closest_match("temperature", {"t_s", "q_rad"}), "");
  EXPECT_EQ(closest_match("x", {}), "");
  EXPECT_EQ(did_you_mean("temperature", {"q_rad"}), "");
}

TEST(ClosestMatch, TakesTextsOfAnyLength) {
  const std::string endless(1'000'000, 'x');
  EXPECT_EQ(closest_match(endless, {"a", endless + "y"}), endless + "y");
}

TEST(ListOfNames, StopsSomewhere) {
  EXPECT_EQ(list_of_names({"a", "b\n"}), R"('a', 'b\x0a')");
  EXPECT_EQ(list_of_names({"a", "b", "c", "d"}, 2), "'a', 'b', ... and 2 more");
}

}  // namespace
}  // namespace tribolog::closest_match_test
