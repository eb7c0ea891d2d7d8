// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "fake_journal_file.h"

#include <algorithm>
#include <cerrno>
#include <chrono>

namespace tactooth::test {
namespace {

constexpr auto kPatience = std::chrono::seconds(120);

class FakeFile final : public JournalFile {
public:
    explicit FakeFile(std::shared_ptr<FakeDisk> disk) : disk_(std::move(disk)) {}
    Written write(std::span<const std::byte> bytes) override { return disk_->write(bytes); }
    int sync() override { return disk_->sync(); }
    int publish() override { return disk_->publish(); }

private:
    std::shared_ptr<FakeDisk> disk_;
};

}  // namespace

std::unique_ptr<JournalFile> fileOn(const std::shared_ptr<FakeDisk>& disk) { return std::make_unique<FakeFile>(disk); }

bool FakeDisk::isInterrupted() {
    ++calls_;
    return faults_.interruptEvery != 0 && calls_ % faults_.interruptEvery == 0;
}

JournalFile::Written FakeDisk::write(std::span<const std::byte> bytes) {
    std::unique_lock lock(mutex_);
    isWaiting_ = true;
    changed_.notify_all();
    changed_.wait(lock, [&] { return !isHeld_; });
    isWaiting_ = false;
    if (isInterrupted()) return {0, EINTR};
    const std::size_t room = faults_.capacity - std::min(faults_.capacity, bytes_.size());
    if (room == 0 && !bytes.empty()) return {0, ENOSPC};
    const std::size_t count = std::min({bytes.size(), room, faults_.bytesAtOnce});
    bytes_.insert(bytes_.end(), bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(count));
    return {count, 0};
}

int FakeDisk::sync() {
    const std::lock_guard lock(mutex_);
    if (isInterrupted()) return EINTR;
    ++syncs_;
    changed_.notify_all();
    if (faults_.failingSync == syncs_) return faults_.syncFailure;
    synced_ = bytes_.size();
    return 0;
}

int FakeDisk::publish() { return faults_.publishFailure; }

void FakeDisk::hold() {
    const std::lock_guard lock(mutex_);
    isHeld_ = true;
    isWaiting_ = false;
}

void FakeDisk::release() {
    const std::lock_guard lock(mutex_);
    isHeld_ = false;
    changed_.notify_all();
}

bool FakeDisk::waitUntilHeld() {
    std::unique_lock lock(mutex_);
    return changed_.wait_for(lock, kPatience, [&] { return isWaiting_; });
}

std::vector<std::byte> FakeDisk::bytes() const {
    const std::lock_guard lock(mutex_);
    return bytes_;
}

std::vector<std::byte> FakeDisk::syncedBytes() const {
    const std::lock_guard lock(mutex_);
    return {bytes_.begin(), bytes_.begin() + static_cast<std::ptrdiff_t>(synced_)};
}

int FakeDisk::syncs() const {
    const std::lock_guard lock(mutex_);
    return syncs_;
}

bool FakeDisk::waitForSyncs(int count) {
    std::unique_lock lock(mutex_);
    return changed_.wait_for(lock, kPatience, [&] { return syncs_ >= count; });
}

}  // namespace tactooth::test
