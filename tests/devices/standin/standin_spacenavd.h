// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <filesystem>
#include <thread>

namespace tactooth::test {

/// A driver that uses spacenavd's protocol on its own socket and has no SpaceMouse.
class StandinSpacenavd {
public:
    explicit StandinSpacenavd(const std::filesystem::path& socket);
    ~StandinSpacenavd();
    StandinSpacenavd(const StandinSpacenavd&) = delete;
    StandinSpacenavd& operator=(const StandinSpacenavd&) = delete;

    /// Displacement right, up and away, and the rotations about these axes. False if no client listens.
    bool move(const std::array<int, 6>& axes);
    bool button(int number, bool down);
    [[nodiscard]] bool hasClient() const { return client_.load() >= 0; }

private:
    bool send(const std::array<std::int32_t, 8>& event);
    void serve(const std::stop_token& stop);

    std::filesystem::path socket_;
    int listener_ = -1;
    std::atomic<int> client_{-1};
    std::jthread server_;
};

}  // namespace tactooth::test
