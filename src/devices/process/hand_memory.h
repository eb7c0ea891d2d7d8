// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "devices/process/hand_link.h"
#include "geometry/util/expected.h"

namespace tactooth {

/// Memory with a HandLink in it that two processes share. It has no name: the hand process inherits the open file, so
/// no other process can open it.
class HandMemory {
public:
    /// New memory, in the program.
    [[nodiscard]] static Expected<HandMemory> create();
    /// The memory of an inherited file, in the hand process; takes the file over. Null where it is none of this layout.
    [[nodiscard]] static std::unique_ptr<HandMemory> open(int file);

    HandMemory(HandMemory&& other) noexcept;
    HandMemory& operator=(HandMemory&& other) = delete;
    HandMemory(const HandMemory&) = delete;
    HandMemory& operator=(const HandMemory&) = delete;
    ~HandMemory();

    [[nodiscard]] HandLink& link() const { return *link_; }
    /// For the hand process to inherit; closed at an exec.
    [[nodiscard]] int file() const { return file_; }

private:
    HandMemory(int file, HandLink* link) : file_(file), link_(link) {}

    int file_;
    HandLink* link_;
};

}  // namespace tactooth
