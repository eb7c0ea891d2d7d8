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
    std::string units;  ///< a name of kLengthUnits, or millimetres per unit; empty: guessed
    std::string holes = "small";
    bool upsideDown = false;
    double turnDegrees = 0;
    bool noModel = false;
    std::vector<std::filesystem::path> burs;
    std::filesystem::path materials;
};

/// Makes a case from surfaces and prints the assumptions about each.
[[nodiscard]] int runCaseNew(const CaseNewOptions& options);

struct CaseCheckOptions {
    std::filesystem::path path;
};

/// Opens a case as every command does. Prints its errors and anything that may surprise the user.
[[nodiscard]] int runCaseCheck(const CaseCheckOptions& options);

struct CaseInfoOptions {
    std::filesystem::path path;
};

/// Prints the contents of a case.
[[nodiscard]] int runCaseInfo(const CaseInfoOptions& options);

struct CasePackOptions {
    std::filesystem::path folder;
    std::filesystem::path out;  ///< empty: the folder's name with .ttcase
};

/// Packs the folder of a case into one file. First checks that the case opens.
[[nodiscard]] int runCasePack(const CasePackOptions& options);

}  // namespace tactooth
