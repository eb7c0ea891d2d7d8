// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace tactooth {

struct CaseNewOptions {
    std::filesystem::path out;
    std::vector<std::filesystem::path> from;
    std::string title;
    std::string licence;
    std::string provenance;
    std::optional<int> quadrant;
    std::string units;  ///< a name of kLengthUnits, or millimetres for each unit; empty: guessed
    std::string holes = "small";
    bool upsideDown = false;
    double turnDegrees = 0;
    bool noModel = false;
    std::vector<std::filesystem::path> burs;
    std::filesystem::path materials;
};

/// Makes a case of surfaces and says what was assumed about each.
[[nodiscard]] int runCaseNew(const CaseNewOptions& options);

struct CaseCheckOptions {
    std::filesystem::path path;
};

/// Opens a case as every command does, and tells what is wrong or might surprise.
[[nodiscard]] int runCaseCheck(const CaseCheckOptions& options);

struct CaseInfoOptions {
    std::filesystem::path path;
};

/// What a case says of itself.
[[nodiscard]] int runCaseInfo(const CaseInfoOptions& options);

struct CasePackOptions {
    std::filesystem::path folder;
    std::filesystem::path out;  ///< empty: the folder's name with .ttcase
};

/// Packs a case's folder into one file, after looking whether it can be opened.
[[nodiscard]] int runCasePack(const CasePackOptions& options);

}  // namespace tactooth
