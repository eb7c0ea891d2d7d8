// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
// Cases as programs of other systems pack and name them.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <functional>

#include "session/cases/block_case.h"
#include "session/cases/open_case.h"
#include "support/test_data.h"

namespace tactooth {
namespace {

namespace fs = std::filesystem;

using test::archiveWith;

/// An archive of the block case whose names are changed as another system's program changes them.
std::vector<std::byte> repacked(const std::function<std::string(const std::string&)>& rename,
                                std::vector<CaseFile> more = {}) {
    for (CaseFile& file : test::blockCase()) more.push_back({rename(file.entry), std::move(file.bytes)});
    return packCase(std::move(more)).value();
}

std::string withBackslashes(std::string entry) {
    std::ranges::replace(entry, '/', '\\');
    return entry;
}

struct Packer {
    const char* name;
    std::function<std::string(const std::string&)> rename;
    std::vector<CaseFile> more = {};
};

class AnyPacker : public ::testing::TestWithParam<Packer> {};
INSTANTIATE_TEST_SUITE_P(
    ThirdPartyCase, AnyPacker,
    ::testing::Values(
        Packer{"folder", [](const std::string& entry) { return "mouth/" + entry; }},
        Packer{"two folders", [](const std::string& entry) { return "a/b/" + entry; }},
        Packer{"Finder, folder before __MACOSX",
               [](const std::string& entry) { return "Jaw/" + entry; },
               {{"__MACOSX/Jaw/._case.toml", bytesOf("x")}, {"Jaw/.DS_Store", bytesOf("x")}}},
        Packer{"Finder, folder behind __MACOSX",
               [](const std::string& entry) { return "jaw/" + entry; },
               {{"__MACOSX/jaw/._case.toml", bytesOf("x")}, {"__MACOSX/._jaw", bytesOf("x")}}},
        Packer{"Finder, an umlaut first",
               [](const std::string& entry) { return "\xC3\x84gypten/" + entry; },
               {{"__MACOSX/._x", bytesOf("x")}}},
        Packer{"Finder, without a folder",
               [](const std::string& entry) { return entry; },
               {{"__MACOSX/._case.toml", bytesOf("x")}, {"teeth/.DS_Store", bytesOf("x")}}},
        Packer{
            "notes beside", [](const std::string& entry) { return "jaw/" + entry; }, {{"a readme.txt", bytesOf("x")}}},
        Packer{"Windows", withBackslashes},
        Packer{"Windows, folder",
               [](const std::string& entry) { return withBackslashes("jaw/" + entry); },
               {{"jaw\\Thumbs.db", bytesOf("x")}, {"jaw\\desktop.ini", bytesOf("x")}}},
        Packer{"dot", [](const std::string& entry) { return "./" + entry; }},
        Packer{"dots", [](const std::string& entry) { return "./jaw/./" + entry; }},
        Packer{"doubled", [](const std::string& entry) { return "jaw//" + entry; }},
        Packer{"colon", [](const std::string& entry) { return "2026-11-25 10:15/" + entry; }},
        Packer{"long", [](const std::string& entry) { return std::string(240, 'x') + "/" + entry; }},
        Packer{"very long", [](const std::string& entry) { return std::string(900, 'x') + "/" + entry; }}));

TEST_P(AnyPacker, MakesAnArchiveThatOpens) {
    const auto bytes = repacked(GetParam().rename, GetParam().more);
    const auto store = CaseStore::openArchive(bytes, "x.ttcase");
    ASSERT_TRUE(store) << GetParam().name << ": " << store.error().message();
    EXPECT_EQ(store->entries().size(), test::blockCase().size());
    const auto opened = openCase(*store);
    EXPECT_TRUE(opened) << GetParam().name << ": " << opened.error().message();
}

TEST(ThirdPartyCase, WhatCannotBeANameIsRefusedByItsReason) {
    const auto reason = [](const std::string& name) {
        const auto bytes = archiveWith(name);
        const auto store = CaseStore::openArchive(bytes, "x.ttcase");
        return store ? "opened" : store.error().message();
    };
    EXPECT_NE(reason("a\nb").find("named 'a?b', which has control characters in its name"), std::string::npos);
    EXPECT_NE(reason(std::string(1001, 'a')).find("whose name is longer than 1000 bytes"), std::string::npos);
    EXPECT_LT(reason(std::string(1001, 'a')).size(), 300u);
    EXPECT_EQ(reason(std::string(1000, 'a')), "opened");
    EXPECT_EQ(reason("what: a case?"), "opened");
    for (const char* const out : {"..\\..\\evil", "\\\\server\\share", "C:\\evil", "d:/evil", "/evil", "a/..", ".."})
        EXPECT_NE(reason(out).find("points out of it"), std::string::npos) << out;
}

TEST(ThirdPartyCase, SeveralCasesInOneArchiveAreRefused) {
    std::vector<CaseFile> files;
    for (const char* const folder : {"a/", "b/"}) {
        for (CaseFile& file : test::blockCase()) files.push_back({folder + file.entry, std::move(file.bytes)});
    }
    const auto bytes = packCase(std::move(files)).value();
    const auto store = CaseStore::openArchive(bytes, "x.ttcase");
    ASSERT_FALSE(store);
    EXPECT_EQ(store.error().message(),
              "x.ttcase: the archive holds several cases, in a/ and b/; pack each on its own.");
}

constexpr const char* kComposed = "\xC3\xA4u\xC3\x9F\x65res.stl";     // äußeres
constexpr const char* kDecomposed = "a\xCC\x88u\xC3\x9F\x65res.stl";  // the same from a Mac

/// Folder and archive, with composed and decomposed names in the case and in the request.
TEST(ThirdPartyCase, AComposedNameIsTheSameAsADecomposedOne) {
    for (const char* const written : {kComposed, kDecomposed}) {
        const std::string name = std::string("teeth/") + written;
        const auto bytes = packCase({{"case.toml", bytesOf("x")}, {name, bytesOf("surface")}}).value();
        const auto archive = CaseStore::openArchive(bytes, "x.ttcase");
        const test::TemporaryFolder folder;
        fs::create_directories(folder / "teeth");
        std::ofstream(folder / "case.toml") << "x";
        std::ofstream(folder / name) << "surface";
        const auto open = CaseStore::open(folder.path());
        ASSERT_TRUE(archive && open);
        for (const char* const asked : {kComposed, kDecomposed}) {
            EXPECT_EQ(archive->read(std::string("teeth/") + asked).value(), bytesOf("surface"));
            EXPECT_EQ(open->read(std::string("teeth/") + asked).value(), bytesOf("surface"));
        }
        EXPECT_EQ(open->entries(), archive->entries());
    }
}

TEST(ThirdPartyCase, OfTwoNamesInAFolderTheOneThatIsWrittenSoIsRead) {
    const test::TemporaryFolder folder;
    std::ofstream(folder / kComposed) << "one";
    std::ofstream(folder / kDecomposed) << "two";
    const auto store = CaseStore::open(folder.path());
    ASSERT_TRUE(store);
    EXPECT_EQ(store->read(kComposed).value(), bytesOf("one"));
    EXPECT_EQ(store->read(kDecomposed).value(), bytesOf("two"));
}

TEST(ThirdPartyCase, ForeignFilesAreNoPartOfACase) {
    const test::TemporaryFolder folder;
    for (const char* const name :
         {"case.toml", "36.stl", "._36.stl", ".DS_Store", "Thumbs.db", "desktop.ini", ".gitignore"})
        std::ofstream(folder / name) << "x";
    fs::create_directories(folder / ".history");
    for (std::size_t i = 0; i <= kCaseLimits.entries; ++i)
        std::ofstream(folder / (".history/" + std::to_string(i))) << "x";
    const auto store = CaseStore::open(folder.path());
    ASSERT_TRUE(store);
    EXPECT_EQ(store->entries(), (std::vector<std::string>{"36.stl", "case.toml"}));
}

TEST(ThirdPartyCase, LinksInAnArchiveAreRefused) {
    std::string bytes(asText(packCase({{"case.toml", bytesOf("x")}, {"link.stl", bytesOf("/etc/passwd")}}).value()));
    // In the list at the archive's end: written by Unix, and a link's attributes.
    const std::size_t entry = bytes.rfind("PK\x01\x02");
    ASSERT_NE(entry, std::string::npos);
    bytes[entry + 5] = 3;
    bytes.replace(entry + 38, 4, std::string("\0\0\xFF\xA1", 4));
    const auto raw = bytesOf(bytes);
    const auto store = CaseStore::openArchive(raw, "x.ttcase");
    ASSERT_FALSE(store);
    EXPECT_NE(store.error().message().find("'link.stl', which points out of it"), std::string::npos);
}

}  // namespace
}  // namespace tactooth
