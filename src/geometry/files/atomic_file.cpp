// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/files/atomic_file.h"

#include "geometry/files/file_transaction.h"
#include "geometry/files/pending_file.h"
#include "geometry/files/unfinished_files.h"
#include "geometry/util/assert.h"
#include "geometry/util/byte_text.h"

namespace tactooth {
namespace {

Expected<void> renameAlone(PendingFile& file) {
    int reason = 0;
    {
        const auto lock = lockRenames();
        reason = renameTogether({file.naming()}).reason;
        if (reason == 0) file.close();
    }
    if (reason != 0) return file.cannotBeNamed(reason);
    return {};
}

}  // namespace

Expected<AtomicFile> AtomicFile::create(const std::filesystem::path& path) {
    if (FileTransaction* set = FileTransaction::current(); set != nullptr) {
        if (auto file = set->handOut(path)) return AtomicFile(std::move(file), set);
    }
    auto file = PendingFile::open(path);
    if (!file) return Unexpected{file.error()};
    return AtomicFile(std::move(*file), nullptr);
}

AtomicFile::AtomicFile(std::unique_ptr<PendingFile> file, FileTransaction* set) : file_(std::move(file)), set_(set) {}
AtomicFile::AtomicFile(AtomicFile&&) noexcept = default;
AtomicFile::~AtomicFile() = default;

void AtomicFile::write(std::span<const std::byte> bytes) { file_->write(bytes); }
void AtomicFile::write(std::string_view text) { file_->write(asBytes(text)); }

Expected<void> AtomicFile::commit() {
    TACTOOTH_ASSERT(file_ != nullptr);
    std::unique_ptr<PendingFile> file = std::move(file_);
    if (auto done = file->finish(); !done) return done;
    if (set_ != nullptr) {
        set_->takeFinished(std::move(file));
        return {};
    }
    return renameAlone(*file);
}

Expected<void> writeFile(const std::filesystem::path& path, std::span<const std::byte> bytes) {
    Expected<AtomicFile> file = AtomicFile::create(path);
    if (!file) return Unexpected{file.error()};
    file->write(bytes);
    return file->commit();
}

Expected<void> writeFile(const std::filesystem::path& path, std::string_view text) {
    return writeFile(path, asBytes(text));
}

}  // namespace tactooth
