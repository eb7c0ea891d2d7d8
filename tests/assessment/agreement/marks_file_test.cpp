// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "assessment/agreement/marks_file.h"

#include <gmock/gmock.h>

#include <random>

#include "support/mutation.h"

namespace tactooth {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

std::string refusalOf(std::string_view text) {
    const auto marks = parseMarks(text, "marks.csv");
    if (marks) return {};
    EXPECT_THAT(marks.error().message(), StartsWith("marks.csv"));
    EXPECT_THAT(marks.error().message(), ::testing::EndsWith("."));
    EXPECT_THAT(marks.error().in(Language::Japanese), ::testing::EndsWith("。"));
    return marks.error().message();
}

TEST(MarksFile, IsReadInAnyOrderWithOtherColumns) {
    const auto marks = parseMarks(
        "\xEF\xBB\xBFTeacher,note,mark,Student,work\r\nDr. A,good,85.5,\"Lee, K.\",w1\r\n\r\nDr. B,,100,\"Lee, "
        "K.\",w1\r\n"
        "Dr. A,,0,高橋,w2\r\n",
        "marks.csv");
    ASSERT_TRUE(marks) << marks.error().message();
    ASSERT_EQ(marks->size(), 3U);
    EXPECT_EQ((*marks)[0].work, "w1");
    EXPECT_EQ((*marks)[0].student, "Lee, K.");
    EXPECT_EQ((*marks)[0].teacher, "Dr. A");
    EXPECT_EQ((*marks)[0].mark, 85.5);
    EXPECT_EQ((*marks)[2].student, "高橋");
    EXPECT_EQ((*marks)[2].mark, 0);
    const auto students = studentsOf(*marks);
    EXPECT_EQ(students.size(), 2U);
    EXPECT_EQ(students.at("w2"), "高橋");
}

TEST(MarksFile, MayHaveSemicolons) {
    const auto marks = parseMarks("sep=;\nwork;student;teacher;mark\nw1;s;t;70\n", "marks.csv");
    ASSERT_TRUE(marks) << marks.error().message();
    EXPECT_EQ((*marks)[0].mark, 70);
}

TEST(MarksFile, ComparesNamesAsAMacAndAPcWriteThem) {
    // The same letter in one and in two characters.
    const auto marks = parseMarks("work,student,teacher,mark\nB\xC3\xA9,s,t,70\nBe\xCC\x81,s,u,60\n", "marks.csv");
    ASSERT_TRUE(marks) << marks.error().message();
    EXPECT_EQ((*marks)[0].work, (*marks)[1].work);
    EXPECT_THAT(refusalOf("work,student,teacher,mark\nB\xC3\xA9,s,t,70\nBe\xCC\x81,s,t,60\n"), HasSubstr("line 3"));
}

TEST(MarksFile, IsRefusedWithASentenceThatNamesTheLine) {
    const std::string head = "work,student,teacher,mark\nw1,s1,t1,70\n";
    const std::vector<std::array<std::string, 2>> mistakes = {
        {head + "w2,s1,t1,101\n", "marks.csv, line 3: column 'mark': expected a number from 0 to 100, but found 101."},
        {head + "w2,s1,t1,-0.5\n", "from 0 to 100, but found -0.5."},
        {head + "w2,s1,t1,good\n", "line 3: column 'mark': expected a finite number"},
        {head + "w2,s1,t1,\n", "but found ''"},
        {head + "w2,s1,t1,nan\n", "expected a finite number"},
        {head + "w2,s1,t1,1e999\n", "expected a finite number"},
        {head + "w2,s1,t1,\"85,5\"\n", "with '.' as decimal point, but found '85,5'"},
        {head + "w2,s1,t1,8 5\n", "expected a finite number"},
        {head + "w2,s1,t1,85%\n", "but found '85%'"},
        {head + "w2,s1,t1\n", "expected 4 fields"},
        {head + ",s1,t1,70\n", "line 3: the column 'work' is empty here; write a name."},
        {head + "w2,\"  \",t1,70\n", "the column 'student' is empty"},
        {head + "w2,s1,\"\",70\n", "the column 'teacher' is empty"},
        {head + "w1,s1,t1,80\n",
         "line 3: the teacher 't1' has marked the work 'w1' before (marks.csv, line 2); keep one of the two."},
        {head + "w1,s2,t2,80\n", "the work 'w1' is of the student 's2' here, but of 's1' before (marks.csv, line 2)"},
        {head + "w2,s\xFF,t1,70\n", "line 3: the column 'student' has bytes that are not UTF-8"},
        {"work,student,teacher\nw1,s1,t1\n", "line 1: the column 'mark' is missing"},
        {"work,teacher,mark\nw1,t1,70\n", "the column 'student' is missing"},
        {"work;student;teacher;mark\nw1;s1;t1;70\n", "separated by commas"},
        {"work,student,teacher,mark,mark\nw1,s1,t1,70,80\n", "the column 'mark' is named twice"},
        {"work,student,teacher,mark\n", "there are no rows"},
        {"", "there is no line that names the columns"},
        {"\n\n# marks\n", "there is no line that names the columns"},
        {std::string("\xFF\xFEw\0o\0", 6), "UTF-16"},
        {head + "w2,\"s1,t1,70\n", "a cell in quotes must end"},
        {std::string("PK\x03\x04\0\0\0\0", 8), "is missing"},
    };
    for (const auto& [text, sentence] : mistakes) EXPECT_THAT(refusalOf(text), HasSubstr(sentence)) << text;
}

TEST(MarksFile, TakesAClassButNotEverything) {
    std::string many = "work,student,teacher,mark\n";
    for (int i = 0; i < 51; ++i) many += "w,s,t" + std::to_string(i) + ",70\n";
    EXPECT_THAT(refusalOf(many), HasSubstr("line 52: there are more than 50 teachers"));
    std::string tooMany = "work,student,teacher,mark\n";
    for (int i = 0; i < 100'000; ++i) tooMany += "w" + std::to_string(i) + ",s,t,70\n";
    EXPECT_TRUE(parseMarks(tooMany, "marks.csv"));
    EXPECT_THAT(refusalOf(tooMany + "w,s,t,70\n"), HasSubstr("line 100002: there are more than 100000 marks"));
}

TEST(MarksFile, ShowsNoControlCharactersOfAName) {
    const std::string refused = refusalOf("work,student,teacher,mark\nw\x1B[31m,s,t,70\nw\x1B[31m,s,t,80\n");
    EXPECT_THAT(refused, HasSubstr("line 3"));
    EXPECT_EQ(refused.find('\x1B'), std::string::npos);
}

TEST(MarksFile, ThatIsDamagedIsReadOrRefused) {
    std::mt19937 random(1);
    const std::vector<std::string> others = {"sep=;\nteacher;mark;work;student\n\"t;1\";50;w;s\n"};
    int read = 0, refused = 0;
    for (int trial = 0; trial < 3000; ++trial) {
        std::string text = "work,student,teacher,mark\nw1,s1,t1,70\nw2,\"s, 2\",t1,85.5\nw1,s1,t2,100\n";
        for (int i = 0; i <= trial % 3; ++i) test::mutate(text, others, random);
        const auto marks = parseMarks(text, "marks.csv");
        ++(marks ? read : refused);
        if (!marks) {
            EXPECT_THAT(marks.error().message(), StartsWith("marks.csv"));
            continue;
        }
        for (const TeacherMark& each : *marks) {
            EXPECT_FALSE(each.work.empty() || each.student.empty() || each.teacher.empty());
            EXPECT_TRUE(each.mark >= 0 && each.mark <= 100);
        }
    }
    EXPECT_GT(read, 100);
    EXPECT_GT(refused, 1000);
}

TEST(MarksFile, ThatIsMissingIsNamed) {
    const auto marks = readMarks("nowhere/marks.csv");
    ASSERT_FALSE(marks);
    EXPECT_THAT(marks.error().message(), HasSubstr("nowhere/marks.csv: there is no such file"));
}

}  // namespace
}  // namespace tactooth
