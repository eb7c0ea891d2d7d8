// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/io/run_metadata.h"

#include <array>
#include <ctime>
#include <fstream>
#include <iterator>
#include <thread>

#include "session/io/commit.h"

namespace tactooth {
namespace {

std::string processor() {
    std::ifstream file("/proc/cpuinfo");
    for (std::string line; std::getline(file, line);) {
        const std::size_t colon = line.find(": ");
        if (line.starts_with("model name") && colon != line.npos) return line.substr(colon + 2);
    }
    return "unknown processor";
}

std::string commandGiven() {
    std::ifstream file("/proc/self/cmdline", std::ios::binary);
    std::string words{std::istreambuf_iterator<char>(file), {}};
    while (words.ends_with('\0')) words.pop_back();
    for (char& c : words) {
        if (c == '\0') c = ' ';
    }
    return words;
}

std::string compilerAndOptions() {
#if defined(__clang__)
    const std::string compiler = "clang " __clang_version__;
#else
    const std::string compiler = "gcc " __VERSION__;
#endif
#if defined(NDEBUG)
    const std::string build = ", Release";
#else
    const std::string build = ", with asserts";
#endif
#if defined(TACTOOTH_SIMD_SCALAR)
    return compiler + build + ", scalar";
#elif defined(__AVX2__)
    return compiler + build + ", AVX2";
#else
    return compiler + build + ", SSE2";
#endif
}

std::string now() {
    const std::time_t time = std::time(nullptr);
    std::tm utc{};
    gmtime_r(&time, &utc);
    std::array<char, 32> text{};
    std::strftime(text.data(), text.size(), "%Y-%m-%dT%H:%M:%SZ", &utc);
    return text.data();
}

}  // namespace

RunMetadata currentRunMetadata() {
    return {processor() + ", " + std::to_string(std::thread::hardware_concurrency()) + " cores", compilerAndOptions(),
            kCommit, commandGiven(), now()};
}

}  // namespace tactooth
