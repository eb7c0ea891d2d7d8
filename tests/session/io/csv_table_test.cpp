// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/io/csv_table.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <fstream>
#include <iterator>
#include <limits>
#include <random>

#include "support/test_data.h"

namespace tactooth {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

constexpr std::array<std::string_view, 2> kColumns = {"t", "x"};

CsvTable parsed(std::string_view text) {
    Expected<CsvTable> table = parseCsv(text, "p.csv", kColumns);
    EXPECT_TRUE(table) << table.error().message();
    return table ? *table : CsvTable{};
}

std::string refusal(std::string_view text) {
    const Expected<CsvTable> table = parseCsv(text, "p.csv", kColumns);
    return table ? "accepted" : table.error().message();
}

TEST(CsvTable, ReadsColumnsByNameInTheOrderAskedFor) {
    const CsvTable table = parsed("x,name,t\n1.5,first,0\n-2e-3,second,0.001\n");
    ASSERT_EQ(table.rows(), 2U);
    EXPECT_THAT(table.row(0), ElementsAre(0, 1.5));
    EXPECT_THAT(table.row(1), ElementsAre(0.001, -0.002));
    EXPECT_EQ(table.at(1, 1), -0.002);
}

TEST(CsvTable, BlanksCommentsEmptyLinesAndWindowsLineEndsDoNotMatter) {
    const CsvTable table = parsed("\xEF\xBB\xBF# made by hand\r\n\r\n t , x \r\n 0 ,\t+1\r\n# pause\r\n\r\n1,2");
    ASSERT_EQ(table.rows(), 2U);
    EXPECT_THAT(table.row(0), ElementsAre(0, 1));
    EXPECT_THAT(table.row(1), ElementsAre(1, 2));
    EXPECT_EQ(table.where(0).in(Language::English), "p.csv, line 4");
    EXPECT_EQ(table.where(1).in(Language::English), "p.csv, line 7");
}

TEST(CsvTable, ReadsColumnsOfWordsAsTheyAreWritten) {
    constexpr std::array<std::string_view, 1> kWords = {"name"};
    const auto table = parseCsv("t,name,x\n0, soft caries ,1\n2,,3\n", "p.csv", kColumns, kWords);
    ASSERT_TRUE(table) << table.error().message();
    EXPECT_THAT(table->row(1), ElementsAre(2, 3));
    EXPECT_EQ(table->wordAt(0, 0), "soft caries");
    EXPECT_EQ(table->wordAt(1, 0), "");
    EXPECT_EQ(parseCsv("t,x\n0,1\n", "p.csv", kColumns, kWords).error().message(),
              "p.csv, line 1: the column 'name' is missing; expected the columns t,x,name, separated by commas, but "
              "found 't,x'.");
}

TEST(CsvTable, RefusesAMissingColumn) {
    EXPECT_EQ(
        refusal("t,y\n0,1\n"),
        "p.csv, line 1: the column 'x' is missing; expected the columns t,x, separated by commas, but found 't,y'.");
    EXPECT_THAT(refusal("t;x\n0;1\n"),
                HasSubstr("'t' is missing; expected the columns t,x, separated by commas, but found 't;x'."));
}

TEST(CsvTable, RefusesAColumnNamedTwice) {
    EXPECT_THAT(refusal("t,x,t\n0,1,2\n"), HasSubstr("line 1: the column 't' is named twice"));
}

TEST(CsvTable, RefusesTooFewAndTooManyFields) {
    EXPECT_EQ(refusal("t,x\n0,1\n\n0\n"), "p.csv, line 4: expected 2 fields, one for each named column, but found 1.");
    EXPECT_THAT(refusal("t,x\n0,1,2\n"),
                HasSubstr("line 2: expected 2 fields, one for each named column, but found 3"));
    EXPECT_THAT(refusal("t,x\n0,1,\n"), HasSubstr("found 3"));
}

TEST(CsvTable, RefusesWhatIsNotAFiniteNumber) {
    for (const std::string bad :
         {"", "abc", "1.5mm", "1,5", "0x10", "+-1", "1 2", "nan", "inf", "-inf", "1e999", "\"\"", "\"1", "\"1\"2"}) {
        const std::string message = refusal("t,x\n0,1\n1," + bad + "\n");
        EXPECT_THAT(message, HasSubstr("p.csv, line 3: ")) << bad;
    }
    EXPECT_EQ(refusal("t,x\n0,nan\n"),
              "p.csv, line 2: column 'x': expected a finite number with '.' as decimal point, but found 'nan'.");
}

/// The same table, written in other ways.
class AnyTable : public ::testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(CsvTable, AnyTable,
                         ::testing::Values("t,x\n0,1.5\n1,-2\n", "\"t\",\"x\"\n\"0\",\"1.5\"\n\"1\",\"-2\"\n",
                                           "\"t\" , \"x\"\r\n0, \"1.5\" \r\n1,-2", "sep=,\nt,x\n0,1.5\n1,-2\n",
                                           "sep=;\nt;x\n0;1.5\n1;-2\n", "\"sep=;\"\r\nt;x\r\n0;1.5\r\n1;-2\r\n",
                                           "SEP=|\nt|x\n0|1.5\n1|-2\n", "sep=\t\nt\tx\n0\t1.5\n1\t-2\n",
                                           "sep=\t\n\"t\"\t\"x\"\n\"0\"\t\"1.5\"\n 1 \t -2 \n",
                                           "\xEF\xBB\xBFsep=;\r\"t\";\"x\"\r0;1.5\r1;-2\r", "t,x\r0,1.5\r1,-2\r",
                                           "t,x\r\r\n0,1.5\n\r1,-2", "T,X\n0,1.5\n1,-2\n", "\"T\",\"X\"\n0,1.5\n1,-2\n",
                                           "X,T,x\n9,0,1.5\n9,1,-2\n", "note,t,x\n\"a, \"\"b\"\"\",0,1.5\n\"\",1,-2\n",
                                           "sep=;\nnote;t;x\n\"a;b\";0;1.5\na,b;1;-2\n"));

TEST_P(AnyTable, HoldsTheSame) {
    const CsvTable table = parsed(GetParam());
    ASSERT_EQ(table.rows(), 2U);
    EXPECT_THAT(table.row(0), ElementsAre(0, 1.5));
    EXPECT_THAT(table.row(1), ElementsAre(1, -2));
}

TEST(CsvTable, WordsComeWithoutTheirQuotes) {
    constexpr std::array<std::string_view, 1> kWords = {"name"};
    const auto table = parseCsv("t,name,x\n0,\"soft, \"\"old\"\" caries\",1\n2,\"\",3\n", "p.csv", kColumns, kWords);
    ASSERT_TRUE(table) << table.error().message();
    EXPECT_EQ(table->wordAt(0, 0), "soft, \"old\" caries");
    EXPECT_EQ(table->wordAt(1, 0), "");
}

TEST(CsvTable, NamesAQuoteThatDoesNotEnd) {
    EXPECT_EQ(refusal("t,x\n0,1\n\"1,2\n"),
              "p.csv, line 3: a cell in quotes must end with its line, and nothing but a separator may follow it.");
    EXPECT_THAT(refusal("t,\"x\n0,1\n"), HasSubstr("line 1: a cell in quotes"));
    EXPECT_THAT(refusal("t,x\n0,\"1\"\"\n"), HasSubstr("line 2: a cell in quotes"));
}

TEST(CsvTable, NamesADecimalComma) {
    EXPECT_THAT(refusal("sep=;\nt;x\n0;1,5\n"), HasSubstr("with '.' as decimal point, but found '1,5'."));
}

TEST(CsvTable, CapitalsThatMeanTwoColumnsAreRefused) {
    EXPECT_THAT(refusal("T,x,T\n0,1,2\n"), HasSubstr("line 1: the column 't' is named twice"));
}

TEST(CsvTable, TextInUtf16IsNamed) {
    EXPECT_EQ(refusal(std::string_view("\xFF\xFEt\0,\0x\0", 8)), "p.csv: this is text in UTF-16; save it as UTF-8.");
}

TEST(CsvTable, RefusesATextWithoutHeaderOrRows) {
    EXPECT_EQ(refusal("# nothing\n\n"), "p.csv: there is no line that names the columns; begin the file with t,x.");
    EXPECT_THAT(refusal("t,x\n"), HasSubstr("no rows below the names"));
}

TEST(CsvTable, RefusesAnEmptyAndAMissingFile) {
    const test::TemporaryFolder folder;
    std::ofstream(folder / "empty.csv").close();
    EXPECT_THAT(readCsv(folder / "empty.csv", kColumns).error().message(), HasSubstr("empty.csv: the file is empty"));
    EXPECT_THAT(readCsv(folder / "none.csv", kColumns).error().message(), HasSubstr("there is no such file"));
}

TEST(CsvWriter, WritesTheShortestTextOfANumber) {
    const test::TemporaryFolder folder;
    Expected<CsvWriter> writer = CsvWriter::create(folder / "r.csv", kColumns);
    ASSERT_TRUE(writer) << writer.error().message();
    writer->row(std::array{0.1, 3.0});
    writer->row(std::array{-1e-9, 1.0 / 3});
    ASSERT_TRUE(writer->commit());
    std::ifstream file(folder / "r.csv");
    const std::string content{std::istreambuf_iterator<char>(file), {}};
    EXPECT_EQ(content, "t,x\n0.1,3\n-1e-09,0.3333333333333333\n");
}

TEST(CsvWriter, EveryFiniteDoubleReadsBackBitForBit) {
    const test::TemporaryFolder folder;
    std::mt19937_64 random(20260105);
    std::vector<std::array<double, 2>> rows;
    while (rows.size() < 2000) {
        const std::array row = {std::bit_cast<double>(random()), std::bit_cast<double>(random())};
        if (std::isfinite(row[0]) && std::isfinite(row[1])) rows.push_back(row);
    }
    Expected<CsvWriter> writer = CsvWriter::create(folder / "r.csv", kColumns);
    ASSERT_TRUE(writer);
    for (const auto& row : rows) writer->row(row);
    ASSERT_TRUE(writer->commit());
    const Expected<CsvTable> table = readCsv(folder / "r.csv", kColumns);
    ASSERT_TRUE(table) << table.error().message();
    ASSERT_EQ(table->rows(), rows.size());
    for (std::size_t row = 0; row < rows.size(); ++row) {
        ASSERT_THAT(table->row(row), ElementsAre(rows[row][0], rows[row][1]));
    }
}

TEST(CsvWriter, WithoutCommitNoFileIsLeft) {
    const test::TemporaryFolder folder;
    {
        Expected<CsvWriter> writer = CsvWriter::create(folder / "r.csv", kColumns);
        ASSERT_TRUE(writer);
        writer->row(std::array{1.0, 2.0});
    }
    EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(CsvWriter, ANumberThatIsNotFiniteLeavesNoFile) {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    const test::TemporaryFolder folder;
    for (const double bad : {std::nan(""), -std::nan(""), kInfinity, -kInfinity, 1e308 * 10}) {
        auto file = CsvWriter::create(folder / "a.csv", std::array<std::string_view, 2>{"t", "x"});
        ASSERT_TRUE(file);
        file->row(std::array{0.0, 1.0});
        file->row(std::array{1.0, bad});
        const auto done = file->commit();
        ASSERT_FALSE(done);
        EXPECT_EQ(done.error().message(),
                  "row 2 of the table has a number that is not finite, so nothing is written; check size and unit of "
                  "the surfaces.");
    }
    EXPECT_FALSE(std::filesystem::exists(folder / "a.csv"));
}

}  // namespace
}  // namespace tactooth
