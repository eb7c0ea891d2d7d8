// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/files/atomic_file.h"
#include "journal/file/journal_file.h"

namespace tactooth {

/// An AtomicFile as a recording is written to. Its `commit` does the rest, and reports an error.
class AtomicJournalFile final : public JournalFile {
public:
    /// `file` outlives this object; nobody else writes to it.
    explicit AtomicJournalFile(AtomicFile& file) : file_(&file) {}
    Written write(std::span<const std::byte> bytes) override {
        file_->write(bytes);
        return {bytes.size(), 0};
    }
    int sync() override { return 0; }
    int publish() override { return 0; }

private:
    AtomicFile* file_;
};

}  // namespace tactooth
