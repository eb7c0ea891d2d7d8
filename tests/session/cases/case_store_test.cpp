// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/cases/case_store.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <random>

#include "geometry/files/atomic_file.h"
#include "session/cases/block_case.h"
#include "session/cases/open_case.h"
#include "support/mutation.h"
#include "support/test_data.h"

namespace tactooth {
namespace {

namespace fs = std::filesystem;

using test::archiveWith;

/// The size that the archive's lists claim for its only file is replaced.
std::vector<std::byte> archiveClaiming(std::uint32_t claimed, std::size_t real) {
    std::string bytes(asText(packCase({{"case.toml", bytesOf(std::string(real, 'x'))}}).value()));
    const auto word = [](std::size_t value) {
        std::string text;
        for (int i = 0; i < 4; ++i) text += static_cast<char>(value >> (8 * i) & 0xff);
        return text;
    };
    for (std::size_t at = bytes.find(word(real)); at != std::string::npos; at = bytes.find(word(real), at + 1)) {
        bytes.replace(at, 4, word(claimed));
    }
    return bytesOf(bytes);
}

TEST(CaseStore, FolderAndArchiveHoldTheSame) {
    const test::TemporaryFolder folder;
    for (const CaseFile& file : test::blockCase()) {
        fs::create_directories((folder / file.entry).parent_path());
        ASSERT_TRUE(writeFile(folder / file.entry, file.bytes));
    }
    const auto packed = packCase(test::blockCase());
    ASSERT_TRUE(packed);
    const auto fromFolder = CaseStore::open(folder.path());
    const auto fromText = CaseStore::open(folder / "case.toml");
    const auto fromArchive = CaseStore::openArchive(*packed, "x.ttcase");
    ASSERT_TRUE(fromFolder && fromText && fromArchive);
    EXPECT_EQ(fromFolder->entries(), fromArchive->entries());
    for (const CaseFile& file : test::blockCase()) {
        EXPECT_EQ(fromFolder->read(file.entry).value(), file.bytes);
        EXPECT_EQ(fromText->read(file.entry).value(), file.bytes);
        EXPECT_EQ(fromArchive->read(file.entry).value(), file.bytes);
    }
}

TEST(CaseStore, TheSameFilesGiveTheSameBytes) {
    auto files = test::blockCase();
    const auto once = packCase(files).value();
    std::ranges::reverse(files);
    EXPECT_EQ(packCase(files).value(), once);
}

TEST(CaseStore, AnArchiveOfAFolderIsReadFromThatFolder) {
    auto files = test::blockCase();
    for (CaseFile& file : files) file.entry = "mouth/" + file.entry;
    const auto bytes = packCase(files).value();
    const auto store = CaseStore::openArchive(bytes, "x.ttcase");
    ASSERT_TRUE(store);
    EXPECT_TRUE(store->read("case.toml"));
    EXPECT_TRUE(openCase(*store));
}

TEST(CaseStore, EntriesThatPointOutAreRefused) {
    for (const char* const name : {"../../etc/passwd", "/etc/cron.d/evil", "a/../../../b", "c:\\windows\\x"}) {
        const auto bytes = archiveWith(name);
        const auto store = CaseStore::openArchive(bytes, "evil.ttcase");
        ASSERT_FALSE(store) << name;
        EXPECT_NE(store.error().message().find("points out of it"), std::string::npos) << store.error().message();
    }
    const test::TemporaryFolder folder;
    std::ofstream(folder / "case.toml") << "format = 1";
    std::ofstream(fs::path(folder.path()).concat("-secret")) << "secret";
    const auto store = CaseStore::open(folder.path());
    ASSERT_TRUE(store);
    EXPECT_FALSE(store->read("../" + folder.path().filename().string() + "-secret"));
    fs::remove(fs::path(folder.path()).concat("-secret"));
}

TEST(CaseStore, LinksOutOfTheFolderAreRefused) {
    const test::TemporaryFolder folder, other;
    std::ofstream(other / "secret.stl") << "secret";
    std::ofstream(folder / "case.toml") << "format = 1";
    fs::create_symlink(other / "secret.stl", folder / "mine.stl");
    const auto store = CaseStore::open(folder.path());
    ASSERT_TRUE(store);
    const auto bytes = store->read("mine.stl");
    ASSERT_FALSE(bytes);
    EXPECT_NE(bytes.error().message().find("leads out of the case's folder"), std::string::npos);
}

TEST(CaseStore, ClaimsOfGigabytesAreRefusedAtOnce) {
    const auto bytes = archiveClaiming(0xfffffff0U, 70000);
    const auto store = CaseStore::openArchive(bytes, "big.ttcase");
    ASSERT_FALSE(store);
    EXPECT_NE(store.error().message().find("claims to unpack"), std::string::npos) << store.error().message();
}

TEST(CaseStore, ABombIsRefusedByWhatItClaims) {
    const auto bytes = packCase({{"case.toml", std::vector<std::byte>(std::size_t{40} << 20)}});
    ASSERT_TRUE(bytes);
    ASSERT_LT(bytes->size(), 100'000u);  // zeros pack a thousand times smaller
    const auto store = CaseStore::openArchive(*bytes, "bomb.ttcase");
    ASSERT_FALSE(store);
    EXPECT_NE(store.error().message().find("more than any surface does"), std::string::npos);
}

TEST(CaseStore, ABombThatClaimsToBeSmallGivesNoMoreThanItClaims) {
    const auto bytes = archiveClaiming(50'000, 5'000'000);
    const auto store = CaseStore::openArchive(bytes, "bomb.ttcase");
    ASSERT_TRUE(store);
    const auto text = store->read("case.toml");
    ASSERT_FALSE(text);
    EXPECT_NE(text.error().message().find("damaged"), std::string::npos);
}

TEST(CaseStore, TooManyFilesAreRefused) {
    std::vector<CaseFile> files;
    for (std::size_t i = 0; i <= kCaseLimits.entries; ++i) files.push_back({std::to_string(i), bytesOf("x")});
    const auto bytes = packCase(files).value();
    const auto store = CaseStore::openArchive(bytes, "many.ttcase");
    ASSERT_FALSE(store);
    EXPECT_NE(store.error().message().find("1001 files"), std::string::npos) << store.error().message();
}

TEST(CaseStore, GarbageIsNoArchive) {
    const auto bytes = bytesOf("this is no archive at all");
    const auto store = CaseStore::openArchive(bytes, "garbage.ttcase");
    ASSERT_FALSE(store);
    EXPECT_EQ(store.error().message().rfind("garbage.ttcase: this is no zip archive", 0), 0u);
}

TEST(CaseStore, CasesAreRecognisedByName) {
    const test::TemporaryFolder folder;
    EXPECT_TRUE(isCase("mouth.ttcase"));
    EXPECT_TRUE(isCase("somewhere/case.toml"));
    EXPECT_FALSE(isCase("tooth.stl"));
    EXPECT_FALSE(isCase(folder.path()));
    std::ofstream(folder / "case.toml") << "format = 1";
    EXPECT_TRUE(isCase(folder.path()));
}

/// Two hundred damaged archives: each is opened, or refused with one sentence.
TEST(CaseStore, DamagedArchivesAreOpenedOrRefused) {
    const std::string sound(asText(packCase(test::blockCase()).value()));
    const std::vector<std::string> seeds = {sound};
    std::mt19937 random(20261121);
    int refused = 0;
    for (int round = 0; round < 200; ++round) {
        std::string bytes = sound;
        for (int change = 0; change < 3; ++change) test::mutate(bytes, seeds, random);
        const auto raw = bytesOf(bytes);
        const auto store = CaseStore::openArchive(raw, "mutant");
        const auto opened = store ? openCase(*store) : Expected<OpenedCase>(Unexpected{store.error()});
        if (opened) continue;
        ++refused;
        const std::string& sentence = opened.error().message();
        EXPECT_TRUE(sentence.starts_with("mutant")) << sentence;
        EXPECT_TRUE(sentence.ends_with('.')) << sentence;
        EXPECT_EQ(sentence.find('\n'), std::string::npos) << sentence;
    }
    EXPECT_GT(refused, 20);
}

}  // namespace
}  // namespace tactooth
