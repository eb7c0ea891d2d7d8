// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace tactooth::test {

/// The folder with the real CT teeth: $TACTOOTH_DATA, else ../shared/data beside the source tree; none if neither
/// exists. A test then uses the built-in teeth, and prints that it does.
[[nodiscard]] std::optional<std::filesystem::path> realTeethFolder();

/// The folder of the sources, of which tests read files.
[[nodiscard]] std::filesystem::path sourceFolder();

/// A new folder for the files of one test, removed with the object.
class TemporaryFolder {
public:
    TemporaryFolder();
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    [[nodiscard]] std::filesystem::path operator/(const std::string& name) const { return path_ / name; }
    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path path_;
};

}  // namespace tactooth::test
