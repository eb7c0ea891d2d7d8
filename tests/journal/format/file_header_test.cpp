// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "journal/format/file_header.h"

#include <gtest/gtest.h>

#include "geometry/util/byte_text.h"
#include "journal/codec/crc32c.h"
#include "journal/format/journal_block.h"
#include "support/expect_assert.h"

namespace tactooth {
namespace {

using Kind = HeaderStart::Kind;
using namespace std::string_view_literals;

HeaderStart parsed(std::string_view text) { return parseHeaderStart(asBytes(text)); }

TEST(FileHeader, HasTheDocumentedBytes) {
    const std::vector<std::byte> bytes = fileHeaderBytes("{}");
    ASSERT_EQ(bytes.size(), 22U);
    EXPECT_EQ(asText(std::span(bytes).first(18)), "\x89TTS\r\n\x1a\n\1\0\0\0\2\0\0\0{}"sv);
    EXPECT_EQ(fileHeaderCrc(bytes), crc32c(std::span(bytes).first(18)));
}

TEST(FileHeader, StatesVersionAndLength) {
    const std::vector<std::byte> bytes = fileHeaderBytes(R"({"a":1})");
    const HeaderStart start = parseHeaderStart(std::span(bytes).first(kHeaderStartBytes));
    EXPECT_EQ(start.kind, Kind::Valid);
    EXPECT_EQ(start.version, kJournalVersion);
    EXPECT_EQ(start.jsonBytes, 7U);
}

TEST(FileHeader, ReportsWhatItIsNot) {
    EXPECT_EQ(parsed("").kind, Kind::NoJournal);
    EXPECT_EQ(parsed("{").kind, Kind::NoJournal);
    EXPECT_EQ(parsed("solid tooth, not a session").kind, Kind::NoJournal);
    EXPECT_EQ(parsed("\x89TTS\n\x1a\n\n\1\0\0\0\2\0\0\0"sv).kind, Kind::NoJournal) << "copied as text";
    EXPECT_EQ(parsed("\x89TT").kind, Kind::Damaged);
    EXPECT_EQ(parsed("\x89TTS\r\n\x1a\n\1\0\0"sv).kind, Kind::Damaged);
    EXPECT_EQ(parsed("\x89TTS\r\n\x1a\n\1\0\0\0\2\0"sv).kind, Kind::Damaged);
    EXPECT_EQ(parsed("\x89TTS\r\n\x1a\n\1\0\0\0\1\0\x10\0"sv).kind, Kind::Damaged) << "more than a MiB";
    EXPECT_EQ(parsed("\x89TTS\r\n\x1a\n\2\0\0\0\2\0\0\0"sv).kind, Kind::OtherVersion);
    EXPECT_EQ(parsed("\x89TTS\r\n\x1a\n\2\0\0\0"sv).kind, Kind::OtherVersion) << "whatever follows the version";
}

TEST(FileHeader, HoldsAMebibyte) {
    EXPECT_EQ(fileHeaderBytes(std::string(kMaxHeaderBytes, ' ')).size(), kMaxHeaderBytes + kHeaderFrameBytes);
    EXPECT_ASSERT((void)fileHeaderBytes(std::string(kMaxHeaderBytes + 1, ' ')));
}

}  // namespace
}  // namespace tactooth
