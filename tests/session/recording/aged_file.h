// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <string>

namespace tactooth::test {

/// A file of so many bytes, written so long ago.
inline void makeFile(const std::filesystem::path& file, std::size_t bytes, std::chrono::seconds age = {}) {
    std::ofstream(file) << std::string(bytes, 'x');
    std::filesystem::last_write_time(file, std::filesystem::file_time_type::clock::now() - age);
}

}  // namespace tactooth::test
