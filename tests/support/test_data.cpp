// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "support/test_data.h"

#include <cstdlib>
#include <iostream>
#include <stdexcept>

namespace tactooth::test {

std::optional<std::filesystem::path> realTeethFolder() {
    const char* named = std::getenv("TACTOOTH_DATA");
    const std::filesystem::path folder =
        named != nullptr ? std::filesystem::path(named) : std::filesystem::path(TACTOOTH_SOURCE_DIR) / "../shared/data";
    if (std::filesystem::exists(folder / "openmandible")) return folder;
    std::cout << "[ NOTE     ] no real teeth found (TACTOOTH_DATA is not set): using the built-in teeth\n";
    return std::nullopt;
}

std::filesystem::path sourceFolder() { return TACTOOTH_SOURCE_DIR; }

TemporaryFolder::TemporaryFolder() {
    std::string pattern = (std::filesystem::temp_directory_path() / "tactooth-test-XXXXXX").string();
    if (mkdtemp(pattern.data()) == nullptr) throw std::runtime_error("cannot make a temporary folder");
    path_ = pattern;
}

TemporaryFolder::~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
}

}  // namespace tactooth::test
