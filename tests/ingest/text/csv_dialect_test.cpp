#include "ingest/text/csv_dialect.h"

#include <gtest/gtest.h>

#include "base/temporary_directory.h"

namespace tribolog::csv_dialect_test {
namespace {

std::vector<std::string> texts(std::string_view row, ingest::text::Delimiter delimiter) {
  std::vector<std::string> result;
  for (const ingest::text::Field& field : ingest::text::split_row(row, delimiter, {"f", 1, 0}))
    result.push_back(field.text);
  return result;
}

using Texts = std::vector<std::string>;

TEST(SplitRow, RespectsQuotes) {
  EXPECT_EQ(texts(R"(a,"b, c",d)", ingest::text::Delimiter::comma), (Texts{"a", "b, c", "d"}));
  EXPECT_EQ(texts(R"("say ""hi""",2)", ingest::text::Delimiter::comma), (Texts{"say \"hi\"", "2"}));
  EXPECT_EQ(texts(R"("a b" c)", ingest::text::Delimiter::spaces), (Texts{"a b", "c"}));
  EXPECT_EQ(texts(R"(a, "b" ,c)", ingest::text::Delimiter::comma), (Texts{"a", "b", "c"}));
}

TEST(SplitRow, KeepsEmptyFields) {
  EXPECT_EQ(texts(",a,", ingest::text::Delimiter::comma), (Texts{"", "a", ""}));
  EXPECT_EQ(texts(",", ingest::text::Delimiter::comma), (Texts{"", ""}));
  EXPECT_EQ(texts("\t\ta", ingest::text::Delimiter::tab), (Texts{"", "", "a"}));
}

TEST(SplitRow, TakesAnyNumberOfBlanksAsOne) {
  EXPECT_EQ(texts("  1   2\t3  ", ingest::text::Delimiter::spaces), (Texts{"1", "2", "3"}));
}

TEST(SplitRow, KnowsTheColumnOfEveryField) {
  const auto fields =
      ingest::text::split_row(R"(a, bb,"c")", ingest::text::Delimiter::comma, {"f", 1, 0});
  ASSERT_EQ(fields.size(), 3U);
  EXPECT_EQ(fields[0].column, 1U);
  EXPECT_EQ(fields[1].column, 4U);
  EXPECT_EQ(fields[2].column, 7U);
}

TEST(SplitRow, RefusesBrokenQuotesAndEndlessRows) {
  const auto refusal = [](const std::string& row) {
    return test::refusal_of<InputError>([&] {
      return ingest::text::split_row(row, ingest::text::Delimiter::comma, {"f.csv", 3, 0});
    });
  };
  EXPECT_EQ(refusal("1,\"abc"),
            "f.csv:3:3: quote is not closed in its line; hint: a line end within quotes is not "
            "supported");
  EXPECT_EQ(
      refusal("\"a\"b,1"),
      "f.csv:3:4: text after a closing quote, found 'b,1', expected a delimiter or the end of "
      "the line");
  EXPECT_EQ(refusal("1," + std::string(70'000, 'x')),
            "f.csv:3:3: field is longer than 64 KiB, found 70000 bytes");
  EXPECT_EQ(refusal(std::string(5000, ',')), "");
  EXPECT_EQ(refusal(std::string(70'000, ',')), "f.csv:3: more than 65536 columns");
}

TEST(SniffDelimiter, FindsTheOneThatFitsHeaderAndRows) {
  EXPECT_EQ(ingest::text::sniff_delimiter("a,b\n1,2\n", "f"), ingest::text::Delimiter::comma);
  EXPECT_EQ(ingest::text::sniff_delimiter("a;b\n1,5;2,5\n", "f"),
            ingest::text::Delimiter::semicolon);
  EXPECT_EQ(ingest::text::sniff_delimiter("a [x,y];b\n1;2\n", "f"),
            ingest::text::Delimiter::semicolon);
  EXPECT_EQ(ingest::text::sniff_delimiter("a\tb c\n1\t2\n", "f"), ingest::text::Delimiter::tab);
  EXPECT_EQ(ingest::text::sniff_delimiter("  a  b\n 1   2 \n", "f"),
            ingest::text::Delimiter::spaces);
  EXPECT_EQ(ingest::text::sniff_delimiter("time, q [rad], tau [Nm]\n1, 2, 3\n", "f"),
            ingest::text::Delimiter::comma);
  EXPECT_EQ(ingest::text::sniff_delimiter("tau [Nm]\n1\n2\n", "f"), ingest::text::Delimiter::comma)
      << "one column";
  EXPECT_EQ(ingest::text::sniff_delimiter("a;b;\n1;2;\n", "f"), ingest::text::Delimiter::semicolon);
}

TEST(SniffDelimiter, AsksWhereTwoFit) {
  EXPECT_EQ(test::refusal_of<InputError>(
                [] { return ingest::text::sniff_delimiter("a;b,c;d\n1;2,3;4\n", "f.csv"); }),
            "f.csv:1: it is not clear what separates the columns, expected semicolons or commas; "
            "hint: state it: [log] delimiter = \"comma\", \"semicolon\", \"tab\" or \"spaces\"");
}

TEST(HeaderField, SplitsNameAndUnit) {
  const ingest::log::ColumnHeader header = ingest::text::read_header_field("tau [N m]");
  EXPECT_EQ(header.full, "tau [N m]");
  EXPECT_EQ(header.name, "tau");
  EXPECT_EQ(header.unit, "N m");
  EXPECT_EQ(ingest::text::read_header_field("t(s)").unit, "s");
  EXPECT_EQ(ingest::text::read_header_field("q").unit, "");
  EXPECT_EQ(ingest::text::read_header_field("[s]").name, "[s]");
  EXPECT_EQ(ingest::text::read_header_field("]").name, "]");
}

}  // namespace
}  // namespace tribolog::csv_dialect_test
