// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/files/folder.h"

#include <gtest/gtest.h>

#include <fstream>

#include "support/test_data.h"

namespace tactooth {
namespace {

TEST(Folder, IsMadeWithThoseAboveItAndMayBeThereAlready) {
    const test::TemporaryFolder folder;
    for (int i = 0; i < 2; ++i) EXPECT_TRUE(makeFolder(folder / "a/b"));
    EXPECT_TRUE(std::filesystem::is_directory(folder / "a/b"));
    EXPECT_TRUE(makeFolder(folder / "a/b/"));
}

TEST(Folder, ThatCannotBeMadeIsNamed) {
    const test::TemporaryFolder folder;
    std::ofstream(folder / "file") << "x";
    for (const char* const name : {"file", "file/below"}) {
        const auto made = makeFolder(folder / name);
        ASSERT_FALSE(made) << name;
        EXPECT_NE(made.error().message().find((folder / name).string() + " cannot be made ("), std::string::npos)
            << made.error().message();
    }
}

}  // namespace
}  // namespace tactooth
