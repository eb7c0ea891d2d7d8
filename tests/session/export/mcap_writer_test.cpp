// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/export/mcap_writer.h"

#include <gtest/gtest.h>

#include <cstdlib>

#include "support/test_data.h"

namespace tactooth {
namespace {

/// Reads the file by Python's standard library alone, which checks every record and checksum.
int readBySecondReader(const std::filesystem::path& file, const std::string& more = {}) {
    const std::string line =
        TACTOOTH_PYTHON " '" TACTOOTH_MCAP_READER "' '" + file.string() + "' " + more + " > /dev/null";
    return std::system(line.c_str());
}

TEST(Mcap, ItsChecksumIsThatOfZlib) {
    const std::string_view text = "123456789";  // the check value of CRC-32/ISO-HDLC
    EXPECT_EQ(crc32(std::as_bytes(std::span(text))), 0xCBF43926U);
    EXPECT_EQ(crc32(std::as_bytes(std::span(text.substr(4))), crc32(std::as_bytes(std::span(text.substr(0, 4))))),
              0xCBF43926U);
}

TEST(Mcap, ASecondReaderFindsWhatWasWritten) {
    const test::TemporaryFolder folder;
    auto writer = McapWriter::create(folder / "a.mcap", "test");
    ASSERT_TRUE(writer);
    const std::string schema = R"({"type": "object", "properties": {"n": {"type": "number"}}})";
    const auto one = writer->addChannel("/one", "test.One", schema);
    const auto two = writer->addChannel("/two", "test.Two", schema);
    for (int i = 0; i < 40'000; ++i) {  // several chunks
        const auto time = 1'000'000'000U + static_cast<std::uint64_t>(i) * 1'000'000U;
        writer->write(one, time, R"({"n": )" + std::to_string(i) + "}");
        if (i % 10 == 0) writer->write(two, time, R"({"n": 0.5})");
    }
    writer->endChunk();
    writer->write(two, 1'000'000'001U, R"({"n": 1})");  // earlier than what is before
    ASSERT_TRUE(writer->commit());
    EXPECT_EQ(readBySecondReader(folder / "a.mcap", "--expect /one=40000 --expect /two=4001"), 0);
    EXPECT_NE(readBySecondReader(folder / "a.mcap", "--expect /one=39999"), 0);
}

TEST(Mcap, WithoutMessagesIsAFile) {
    const test::TemporaryFolder folder;
    auto writer = McapWriter::create(folder / "a.mcap", "test");
    ASSERT_TRUE(writer);
    (void)writer->addChannel("/one", "test.One", "{}");
    ASSERT_TRUE(writer->commit());
    EXPECT_EQ(readBySecondReader(folder / "a.mcap", "--expect /one=0"), 0);
}

/// The reader that proves the files must itself see damage.
TEST(Mcap, TheSecondReaderSeesEachChangedByte) {
    const test::TemporaryFolder folder;
    auto writer = McapWriter::create(folder / "a.mcap", "test");
    ASSERT_TRUE(writer);
    const auto one = writer->addChannel("/one", "test.One", "{}");
    writer->write(one, 5, R"({"n": 1})");
    ASSERT_TRUE(writer->commit());
    EXPECT_EQ(readBySecondReader(folder / "a.mcap", "--mutate"), 0);
}

TEST(Mcap, WithoutAFolderHasItsSentence) {
    const test::TemporaryFolder folder;
    const auto writer = McapWriter::create(folder / "missing/a.mcap", "test");
    ASSERT_FALSE(writer);
    EXPECT_NE(writer.error().message().find("missing"), std::string::npos);
}

}  // namespace
}  // namespace tactooth
