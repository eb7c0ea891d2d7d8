// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "devices/openhaptics/pen_names.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "standin/pen_folder.h"

namespace tactooth {
namespace {

namespace fs = std::filesystem;
using test::PenFolder;
using test::ScopedVariable;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

TEST(PenNames, TheDefaultOneComesFirstAndTheOthersAreSorted) {
    const PenFolder pens({"Right", "Left", "Default Device", "An older pen", "B. 2"});
    EXPECT_THAT(configuredPens(), ElementsAre("Default Device", "An older pen", "B. 2", "Left", "Right"));
}

TEST(PenNames, NeedNoDefaultOne) {
    const PenFolder pens({"Right", "左"});
    EXPECT_THAT(configuredPens(), ElementsAre("Right", "左"));
}

TEST(PenNames, OnlyFilesOfSettingsCount) {
    const PenFolder pens({"Left"});
    fs::create_directory(pens.config() / "Folder.config");
    fs::create_symlink("/no/such/file", pens.config() / "Gone.config");
    for (const char* name : {"Left.config~", "Left.txt", ".config", "config"})
        test::writeText(pens.config() / name, "");
    EXPECT_THAT(configuredPens(), ElementsAre("Left"));
}

TEST(PenNames, AFolderThatIsMissingOrCannotBeReadHasNone) {
    const PenFolder pens({});
    EXPECT_THAT(configuredPens(), IsEmpty());
    fs::remove(pens.config());
    EXPECT_THAT(configuredPens(), IsEmpty());
    test::writeText(pens.config(), "no folder");
    EXPECT_THAT(configuredPens(), IsEmpty());
    fs::remove(pens.config());
    fs::create_symlink(pens.config(), pens.config());
    EXPECT_THAT(configuredPens(), IsEmpty());
}

TEST(PenNames, StandInTheUsersFolderIfNoVariableNamesAnother) {
    const test::TemporaryFolder home;
    const ScopedVariable user("HOME", home.path().string());
    fs::create_directories(home / ".3dsystems" / "config");
    test::writeText(home / ".3dsystems" / "config" / "Left.config", "");
    for (const std::optional<std::string>& unset : {std::optional<std::string>(), std::optional<std::string>("")}) {
        const ScopedVariable none("GTDD_HOME", unset);
        EXPECT_THAT(configuredPens(), ElementsAre("Left"));
    }
    const PenFolder others({"Right"});
    EXPECT_THAT(configuredPens(), ElementsAre("Right"));
}

}  // namespace
}  // namespace tactooth
