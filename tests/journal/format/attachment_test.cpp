// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "journal/format/attachment.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "geometry/util/byte_text.h"
#include "support/expect_assert.h"

namespace tactooth {
namespace {

TEST(Attachment, IsCutIntoPiecesThatSayWhereTheyBelong) {
    for (const std::size_t size : {std::size_t{0}, std::size_t{1}, kAttachmentPieceBytes, kAttachmentPieceBytes + 1,
                                   3 * kAttachmentPieceBytes}) {
        std::vector<std::byte> content(size);
        for (std::size_t i = 0; i < size; ++i) content[i] = static_cast<std::byte>(i * 7 + i / 1000);
        const std::vector<JournalBlock> blocks = attachmentBlocks("case", content);
        EXPECT_EQ(blocks.size(), std::max<std::size_t>(1, (size + kAttachmentPieceBytes - 1) / kAttachmentPieceBytes));
        std::vector<std::byte> together;
        for (const JournalBlock& block : blocks) {
            EXPECT_EQ(block.type, BlockType::Attachment);
            EXPECT_LE(block.payload.size(), kMaxStoredBytes);
            const auto piece = parseAttachment(block.payload);
            ASSERT_TRUE(piece);
            EXPECT_EQ(piece->name, "case");
            EXPECT_EQ(piece->totalBytes, size);
            EXPECT_EQ(piece->offset, together.size());
            together.insert(together.end(), piece->content.begin(), piece->content.end());
        }
        EXPECT_EQ(together, content);
    }
}

TEST(Attachment, RefusesAPieceBeyondItsFile) {
    std::vector<std::byte> payload = attachmentBlocks("a", asBytes("0123456789"))[0].payload;
    ASSERT_TRUE(parseAttachment(payload));
    const std::size_t total = sizeof(std::uint32_t) + 1, offset = total + sizeof(std::uint64_t);
    payload[total] = std::byte{9};
    EXPECT_FALSE(parseAttachment(payload));
    payload[total] = std::byte{11};
    EXPECT_TRUE(parseAttachment(payload)) << "one of several pieces";
    payload[offset] = std::byte{2};
    EXPECT_FALSE(parseAttachment(payload));
    std::ranges::fill(std::span(payload).subspan(offset, 8), std::byte{0xFF});
    EXPECT_FALSE(parseAttachment(payload));
}

TEST(Attachment, RefusesEveryBeginningOfItsHead) {
    const std::vector<std::byte> payload = attachmentBlocks("name", asBytes("x"))[0].payload;
    for (std::size_t size = 0; size + 1 < payload.size(); ++size)
        EXPECT_FALSE(parseAttachment(std::span(payload).first(size))) << size;
}

TEST(Attachment, HasAName) {
    EXPECT_ASSERT((void)attachmentBlocks("", {}));
    EXPECT_ASSERT((void)attachmentBlocks(std::string(kMaxAttachmentName + 1, 'a'), {}));
}

}  // namespace
}  // namespace tactooth
