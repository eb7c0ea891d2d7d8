// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <future>
#include <utility>

#include "session/model/file_writer.h"

namespace tactooth::test {

/// A file before all others that is written when it is opened.
class WriterGate {
public:
    explicit WriterGate(FileWriter& writer) {
        writer.write(
            [opened = std::shared_future<void>(promise_.get_future())](const GoesOn&) -> Expected<bool> {
                opened.wait();
                return true;
            },
            {});
    }
    ~WriterGate() { open(); }
    WriterGate(const WriterGate&) = delete;
    WriterGate& operator=(const WriterGate&) = delete;

    void open() {
        if (!std::exchange(isOpen_, true)) promise_.set_value();
    }

private:
    std::promise<void> promise_;
    bool isOpen_ = false;
};

}  // namespace tactooth::test
