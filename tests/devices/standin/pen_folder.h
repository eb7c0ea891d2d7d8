// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "support/scoped_variable.h"
#include "support/test_data.h"
#include "support/text_file.h"

namespace tactooth::test {

/// The files that the vendor's setup program writes for pens with these names; they exist as long as the object.
class PenFolder {
public:
    explicit PenFolder(const std::vector<std::string>& pens) {
        std::filesystem::create_directory(config());
        for (const std::string& pen : pens) writeText(config() / (pen + ".config"), "ModelType=OMNI\n");
    }

    [[nodiscard]] std::filesystem::path config() const { return folder_ / "config"; }

private:
    TemporaryFolder folder_;
    ScopedVariable home_{"GTDD_HOME", folder_.path().string()};
};

}  // namespace tactooth::test
