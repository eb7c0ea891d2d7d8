// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "journal/file/attachment_reader.h"

#include <gtest/gtest.h>

#include "geometry/util/byte_text.h"
#include "journal/file/messages.h"
#include "journal/format/attachment.h"
#include "journal_samples.h"

namespace tactooth {
namespace {

using Bytes = std::vector<std::byte>;

/// Two files of several pieces, one piece of each in turn, among other blocks.
std::vector<JournalBlock> mixedBlocks(const Bytes& first, const Bytes& second) {
    std::vector<JournalBlock> blocks = test::sampleBlocks(41, 1);
    const std::vector<JournalBlock> one = attachmentBlocks("one", first), two = attachmentBlocks("two", second);
    for (std::size_t i = 0; i < std::max(one.size(), two.size()); ++i) {
        if (i < one.size()) blocks.push_back(one[i]);
        if (i < two.size()) blocks.push_back(two[i]);
    }
    return blocks;
}

TEST(AttachmentReader, PutsTheFilesTogether) {
    Bytes first(2 * kAttachmentPieceBytes + 5), second(kAttachmentPieceBytes + 1);
    for (std::size_t i = 0; i < first.size(); ++i) first[i] = static_cast<std::byte>(i / 777);
    for (std::size_t i = 0; i < second.size(); ++i) second[i] = static_cast<std::byte>(i / 555);
    const Bytes bytes = test::journalBytes(mixedBlocks(first, second), true);
    const auto journal = JournalReader::parse(bytes, "sample");
    ASSERT_TRUE(journal);
    EXPECT_EQ(readAttachment(*journal, "one").value(), first);
    EXPECT_EQ(readAttachment(*journal, "two").value(), second);
    EXPECT_EQ(asText(readAttachment(*journal, "fnv1a:0123456789abcdef").value()), "a case of no importance");
}

TEST(AttachmentReader, RefusesAFileOfWhichAPieceIsMissing) {
    std::vector<JournalBlock> blocks = mixedBlocks(Bytes(2 * kAttachmentPieceBytes + 5), Bytes(1));
    blocks.pop_back();
    const Bytes bytes = test::journalBytes(blocks, false);
    const auto journal = JournalReader::parse(bytes, "sample");
    const auto read = readAttachment(*journal, "one");
    ASSERT_FALSE(read);
    EXPECT_EQ(read.error().message(),
              "sample: the recording does not hold all of 'one', which it needs; use a copy of the file.");
    EXPECT_TRUE(readAttachment(*journal, "another").error().contains(msg::kJournalAttachmentMissing));
}

TEST(AttachmentReader, RefusesAFileThatIsTooLong) {
    const Bytes bytes = test::journalBytes(mixedBlocks(Bytes(100), Bytes(1)), false);
    const auto journal = JournalReader::parse(bytes, "sample");
    EXPECT_TRUE(readAttachment(*journal, "one", 100));
    EXPECT_TRUE(readAttachment(*journal, "one", 99).error().contains(msg::kJournalAttachmentTooLong));
}

}  // namespace
}  // namespace tactooth
