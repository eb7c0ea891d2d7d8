// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "sound/output/sound_system_search.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>
#include <map>
#include <string>

#include "support/test_data.h"

namespace tactooth {
namespace {

/// A machine without sound, to which each test adds something.
class Machine {
public:
    void set(const std::string& name, const std::string& value) { variables_[name] = value; }
    void add(const std::string& path) {
        const std::filesystem::path file = folder_.path() / path;
        std::filesystem::create_directories(file.parent_path());
        std::ofstream(file) << "x";
    }
    [[nodiscard]] std::string at(const std::string& path) const { return (folder_.path() / path).string(); }
    [[nodiscard]] bool hasSound() const {
        return hasSoundSystem(folder_.path(), [this](const char* name) -> const char* {
            const auto found = variables_.find(name);
            return found == variables_.end() ? nullptr : found->second.c_str();
        });
    }

private:
    test::TemporaryFolder folder_;
    std::map<std::string, std::string> variables_;
};

TEST(SoundSystemSearch, FindsNothingOnAMachineWithoutSound) {
    Machine machine;
    machine.add("dev/snd/seq");  // which every Linux has
    machine.add("dev/snd/timer");
    machine.set("HOME", machine.at("home"));
    machine.add("home/.config/pulse/cookie");
    machine.set("XDG_RUNTIME_DIR", machine.at("run/user/1"));
    machine.set("DISPLAY", ":0");
    machine.set("ALSOFT_DRIVERS", "");
    EXPECT_FALSE(machine.hasSound());
    EXPECT_FALSE(Machine().hasSound());
}

TEST(SoundSystemSearch, ASoundCardIsEnough) {
    Machine machine;
    machine.add("dev/snd/pcmC0D0p");
    EXPECT_TRUE(machine.hasSound());
}

TEST(SoundSystemSearch, AServerIsFoundAsSoonAsItWaitsForPrograms) {
    const auto afterIt = [](const char* socket, const char* variable, const char* value) {
        Machine machine;
        machine.set(variable, machine.at(value));
        EXPECT_FALSE(machine.hasSound()) << socket;
        machine.add(socket);
        return machine.hasSound();
    };
    EXPECT_TRUE(afterIt("run/user/7/pulse/native", "XDG_RUNTIME_DIR", "run/user/7"));
    EXPECT_TRUE(afterIt("own/native", "PULSE_RUNTIME_PATH", "own"));
    EXPECT_TRUE(afterIt("home/.config/pulse/0123-runtime/native", "HOME", "home"));
    EXPECT_TRUE(afterIt("run/pulse/native", "HOME", "home"));
    EXPECT_TRUE(afterIt(("run/user/" + std::to_string(getuid()) + "/pulse/native").c_str(), "HOME", "home"));
}

TEST(SoundSystemSearch, WhatTheUserHasChosenCounts) {
    for (const auto& [name, value] : {std::pair("ALSOFT_DRIVERS", "null"), std::pair("PULSE_SERVER", "tcp:school:4713"),
                                      std::pair("DISPLAY", "school:10.0")}) {
        Machine machine;
        machine.set(name, value);
        EXPECT_TRUE(machine.hasSound()) << name;
    }
    Machine machine;
    machine.set("HOME", machine.at("home"));
    machine.add("home/.asoundrc");
    EXPECT_TRUE(machine.hasSound());
}

}  // namespace
}  // namespace tactooth
