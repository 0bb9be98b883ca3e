#include <cstdint>
#include <limits>

#include <gtest/gtest.h>

#include "base/error.h"
#include "render/workers/messages.h"

namespace tribolog::render::statement_message_test {
namespace {

Statement through_a_message(const Statement& statement) {
  workers::Message message;
  workers::put_statement(message, statement);
  return workers::take_statement(message);
}

/// With a value of each kind.
Statement every_kind() {
  const Statement inner{"drawing.series_labelled", {{"label", "T_{f} '\x1b'"}}};
  return {"drawing.test",
          {{"number", -std::numeric_limits<double>::denorm_min()},
           {"count", std::numeric_limits<std::int64_t>::min()},
           {"text", std::string("a\0b", 3)},
           {"series", inner},
           {"all", std::vector<Statement>{inner, {}, Statement::verbatim("as it is")}},
           {"none", std::vector<Statement>{}}}};
}

/// So many statements around one.
Statement nested(int depth) {
  Statement statement{"drawing.blank"};
  for (int i = 0; i < depth; ++i) statement = {"drawing.test", {{"inner", statement}}};
  return statement;
}

TEST(StatementMessage, KeepsCodeAndValues) {
  for (const Statement& one : {Statement{}, Statement("drawing.blank"), every_kind(), nested(8)}) {
    EXPECT_EQ(through_a_message(one), one);
  }
}

TEST(StatementMessage, LeavesWhatFollows) {
  workers::Message message;
  workers::put_statement(message, every_kind());
  message.put(std::uint32_t{7});
  EXPECT_EQ(workers::take_statement(message), every_kind());
  EXPECT_EQ(message.take_number(), 7U);
}

TEST(StatementMessage, RefusesOneThatEndsEarly) {
  workers::Message whole;
  workers::put_statement(whole, every_kind());
  for (std::size_t size = 0; size < whole.bytes().size(); ++size) {
    workers::Message cut = whole;
    cut.bytes().resize(size);
    EXPECT_THROW(workers::take_statement(cut), FigureError) << size;
  }
}

TEST(StatementMessage, RefusesStatementsTooDeepInStatements) {
  EXPECT_THROW(through_a_message(nested(9)), FigureError);
  EXPECT_THROW(through_a_message(nested(1'000)), FigureError);
}

TEST(StatementMessage, RefusesWhatIsNoCodeAndNoKindOfValue) {
  workers::Message no_code;
  no_code.put(std::string("not a code"));
  no_code.put(std::uint32_t{0});
  EXPECT_THROW(workers::take_statement(no_code), FigureError);
  workers::Message long_code;
  long_code.put(std::string(1000, 'a'));
  long_code.put(std::uint32_t{0});
  EXPECT_THROW(workers::take_statement(long_code), FigureError);
  workers::Message no_kind;
  no_kind.put(std::string("drawing.blank"));
  no_kind.put(std::uint32_t{1});
  no_kind.put(std::string("number"));
  no_kind.put(std::uint32_t{4});
  no_kind.put(std::string());
  EXPECT_THROW(workers::take_statement(no_kind), FigureError);
}

}  // namespace
}  // namespace tribolog::render::statement_message_test
