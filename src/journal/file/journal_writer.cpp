// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "journal/file/journal_writer.h"

#include <utility>

#include "geometry/files/file_bytes.h"
#include "geometry/util/assert.h"

namespace tactooth {

Expected<std::unique_ptr<JournalWriter>> JournalWriter::create(const std::filesystem::path& path,
                                                               std::string_view headerJson, const Options& options) {
    Expected<std::unique_ptr<JournalFile>> file = createJournalFile(path);
    if (!file) return Unexpected{file.error()};
    return start(std::move(*file), displayName(path), headerJson, options);
}

Expected<std::unique_ptr<JournalWriter>> JournalWriter::create(const std::filesystem::path& path,
                                                               std::string_view headerJson) {
    return create(path, headerJson, Options());
}

Expected<std::unique_ptr<JournalWriter>> JournalWriter::start(std::unique_ptr<JournalFile> file, std::string name,
                                                              std::string_view headerJson, const Options& options) {
    Expected<JournalAppender> appender =
        JournalAppender::begin(std::move(file), std::move(name), headerJson, options.seal);
    if (!appender) return Unexpected{appender.error()};
    return std::unique_ptr<JournalWriter>(new JournalWriter(std::move(*appender), options));
}

JournalWriter::JournalWriter(JournalAppender appender, const Options& options)
    : options_(options),
      appender_(std::move(appender)),
      queue_(options.queue),
      bytes_(appender_.bytes()),
      thread_([this] { run(); }) {}

JournalWriter::~JournalWriter() { end(std::nullopt); }

bool JournalWriter::append(JournalBlock block) {
    TACTOOTH_ASSERT(!isOfContainer(block.type));
    const std::lock_guard lock(mutex_);
    if (!fault_ && !isEnding_ && !queue_.hasRoomFor(block)) {
        queue_.drop(block);
        ++lost_;
        return false;
    }
    return accept(std::move(block));
}

bool JournalWriter::appendWhenRoom(JournalBlock block) {
    TACTOOTH_ASSERT(!isOfContainer(block.type));
    std::unique_lock lock(mutex_);
    done_.wait(lock, [&] { return fault_ || isEnding_ || queue_.hasRoomFor(block); });
    return accept(std::move(block));
}

bool JournalWriter::accept(JournalBlock block) {
    if (fault_ || isEnding_) {
        ++lost_;
        return false;
    }
    queue_.push(std::move(block));
    ++accepted_;
    wake_.notify_one();
    return true;
}

Expected<void> JournalWriter::flush() {
    std::unique_lock lock(mutex_);
    const std::uint64_t wanted = accepted_;
    if (synced_ < wanted) {
        isFlushWanted_ = true;
        wake_.notify_one();
    }
    done_.wait(lock, [&] { return fault_ || synced_ >= wanted; });
    if (fault_) return unexpected(*fault_);
    return {};
}

Expected<void> JournalWriter::close(std::uint64_t tick) {
    TACTOOTH_ASSERT(tick <= kMaxTick);
    TACTOOTH_ASSERT(thread_.joinable());
    end(tick);
    if (const std::optional<Message> stopped = fault()) return unexpected(*stopped);
    return {};
}

void JournalWriter::end(std::optional<std::uint64_t> closeTick) {
    if (!thread_.joinable()) return;
    {
        const std::lock_guard lock(mutex_);
        isEnding_ = true;
        closeTick_ = closeTick;
        wake_.notify_one();
        done_.notify_all();  // for those who wait for room
    }
    thread_.join();
}

std::optional<Message> JournalWriter::fault() const {
    const std::lock_guard lock(mutex_);
    return fault_;
}

std::uint64_t JournalWriter::lostBlocks() const {
    const std::lock_guard lock(mutex_);
    return lost_;
}

std::uint64_t JournalWriter::bytes() const {
    const std::lock_guard lock(mutex_);
    return bytes_;
}

void JournalWriter::run() {
    std::unique_lock lock(mutex_);
    for (bool isLast = false; !isLast;) {
        waitForWork(lock);
        Batch batch = takeBatch();
        lock.unlock();
        done_.notify_all();  // there is room again
        write(batch);
        lock.lock();
        fault_ = appender_.fault();
        bytes_ = appender_.bytes();
        lost_ += batch.failed;
        if (!appender_.isDirty()) synced_ = batch.accepted;
        isLast = batch.isLast;
        done_.notify_all();
    }
}

void JournalWriter::waitForWork(std::unique_lock<std::mutex>& lock) {
    const auto hasWork = [this] { return !queue_.empty() || isFlushWanted_ || isEnding_; };
    if (syncDue_) {
        wake_.wait_until(lock, *syncDue_, hasWork);
    } else {
        wake_.wait(lock, hasWork);
    }
}

JournalWriter::Batch JournalWriter::takeBatch() {
    Batch batch;
    batch.entries = queue_.takeAll();
    batch.accepted = accepted_;
    batch.isSyncWanted = std::exchange(isFlushWanted_, false);
    batch.isLast = isEnding_;
    batch.closeTick = closeTick_;
    if (batch.isLast) batch.lostBehind = queue_.takeLost();
    return batch;
}

void JournalWriter::write(Batch& batch) {
    writeEntries(batch);
    if (batch.lostBehind) appender_.appendLost(*batch.lostBehind);
    if (batch.closeTick && !appender_.fault()) appender_.end(*batch.closeTick);
    syncIfDue(batch.isSyncWanted || batch.isLast);
}

void JournalWriter::writeEntries(Batch& batch) {
    for (const BlockQueue::Entry& entry : batch.entries) {
        if (entry.lostBefore) appender_.appendLost(*entry.lostBefore);
        if (!appender_.append(entry.block)) ++batch.failed;
        syncIfDue(false);
    }
}

void JournalWriter::syncIfDue(bool isWanted) {
    if (appender_.isDirty() && !appender_.fault()) {
        const Clock::time_point now = Clock::now();
        if (!syncDue_) syncDue_ = now + options_.syncPeriod;
        if (isWanted || now >= *syncDue_) appender_.sync();
    }
    if (!appender_.isDirty() || appender_.fault()) syncDue_.reset();
}

}  // namespace tactooth
