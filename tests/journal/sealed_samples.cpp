// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "sealed_samples.h"

#include <gtest/gtest.h>

#include "fake_journal_file.h"
#include "journal/file/journal_appender.h"

namespace tactooth::test {

std::shared_ptr<const SigningKey> sampleKey(unsigned number) {
    KeySeed seed{};
    seed[0] = static_cast<std::byte>(number);
    return SigningKey::fromSeed(seed);
}

std::string sealedHeader(const SigningKey& key) {
    return R"({"title":"sample","sealed":{"public_key":")" + keyText(key.publicKey()) + R"("}})";
}

std::vector<std::byte> sealedBytes(std::span<const JournalBlock> blocks, bool hasEnd,
                                   const std::shared_ptr<const SigningKey>& key) {
    const auto disk = std::make_shared<FakeDisk>();
    Expected<JournalAppender> appender = JournalAppender::begin(fileOn(disk), "sample", sealedHeader(*key), key);
    EXPECT_TRUE(appender);
    std::uint64_t end = 0;
    for (std::size_t i = 0; i < blocks.size(); ++i) {
        EXPECT_TRUE(appender->append(blocks[i]));
        if (i % 3 == 2) {
            EXPECT_TRUE(appender->sync());
        }
        end = blocks[i].firstTick + blocks[i].ticks;
    }
    if (hasEnd) {
        EXPECT_TRUE(appender->end(end));
    }
    return disk->bytes();
}

}  // namespace tactooth::test
