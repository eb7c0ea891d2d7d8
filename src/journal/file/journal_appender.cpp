// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "journal/file/journal_appender.h"

#include <algorithm>
#include <cerrno>
#include <utility>

#include "geometry/util/assert.h"
#include "geometry/util/messages.h"
#include "geometry/util/system_reason.h"
#include "journal/file/messages.h"
#include "journal/format/file_header.h"

namespace tactooth {
namespace {

/// Signals that may interrupt one write before that counts as a failure of the file.
constexpr int kMaxInterruptions = 100;

/// Writes all bytes, in as many steps as the file takes. Returns an errno.
int writeAll(JournalFile& file, std::span<const std::byte> bytes) {
    int interruptions = 0;
    while (!bytes.empty()) {
        const JournalFile::Written written = file.write(bytes);
        TACTOOTH_ASSERT(written.bytes <= bytes.size());
        bytes = bytes.subspan(written.bytes);
        const bool isInterrupted = written.failure == EINTR && ++interruptions < kMaxInterruptions;
        if (written.failure != 0 && !isInterrupted) return written.failure;
        if (written.failure == 0 && written.bytes == 0) return EIO;  // it would go on for ever
    }
    return 0;
}

int syncWhole(JournalFile& file) {
    for (int i = 0; i < kMaxInterruptions; ++i) {
        if (const int failure = file.sync(); failure != EINTR) return failure;
    }
    return EINTR;
}

}  // namespace

Expected<JournalAppender> JournalAppender::begin(std::unique_ptr<JournalFile> file, std::string name,
                                                 std::string_view headerJson, std::shared_ptr<const SigningKey> seal) {
    TACTOOTH_ASSERT(file != nullptr);
    const std::vector<std::byte> header = fileHeaderBytes(headerJson);
    int failure = writeAll(*file, header);
    if (failure == 0) failure = syncWhole(*file);
    if (failure == 0) failure = file->publish();
    if (failure == EEXIST) return unexpected(msg::kJournalExists, name);
    if (failure != 0) return unexpected(msg::kOutputNotWritten, name, systemReason(failure));
    JournalAppender appender(std::move(file), std::move(name), fileHeaderCrc(header));
    appender.bytes_ = header.size();
    if (seal != nullptr) appender.sealer_.emplace(std::move(seal)).noteWritten(header);
    return appender;
}

JournalAppender::JournalAppender(std::unique_ptr<JournalFile> file, std::string name, std::uint32_t headerCrc)
    : file_(std::move(file)), name_(std::move(name)), encoder_(headerCrc) {}

bool JournalAppender::append(const JournalBlock& block) {
    if (!canWrite()) return false;
    const std::optional<std::vector<std::byte>> bytes = encoder_.encode(block);
    if (bytes) return writeBlock(block.type, block.firstTick, block.ticks, *bytes);
    LostFacts tooLarge;
    tooLarge.add(block);
    appendLost(tooLarge);
    return false;
}

bool JournalAppender::appendStored(const BlockHeader& header, std::span<const std::byte> stored) {
    return canWrite() && writeBlock(header.type, header.firstTick, header.ticks, encoder_.chain(header, stored));
}

bool JournalAppender::appendLost(const LostFacts& facts) {
    lostBlocks_ += facts.blocks;
    return append(lostBlock(facts));
}

bool JournalAppender::sync() {
    if (fault_) return false;
    if (!isDirty_) return true;
    if (!seal(endTick_, SealPoint::Running)) return false;
    // After a failed sync nobody knows what is on the disk, and a second one may succeed without it.
    if (const int failure = syncWhole(*file_); failure != 0) return stop(failure);
    isDirty_ = false;
    return true;
}

bool JournalAppender::end(std::uint64_t tick) {
    ClosedFacts facts;
    facts.indexOffset = bytes_;
    if (!append(indexBlock(tick, keyframes_)) || !seal(tick, SealPoint::End)) return false;
    facts.blocks = blocks_;
    facts.lostBlocks = lostBlocks_;
    if (!append(closedBlock(tick, facts))) return false;
    if (sealer_) sealer_->noteSigned();  // the signature before it leaves only one form to this block
    return sync();
}

/// Signs what no signature covers yet, if the recording is sealed.
bool JournalAppender::seal(std::uint64_t tick, SealPoint point) {
    if (!sealer_ || !sealer_->hasUnsigned()) return true;
    if (!append(sealer_->sign(tick, point))) return false;
    sealer_->noteSigned();
    return true;
}

bool JournalAppender::canWrite() {
    if (!fault_ && blocks_ == kMaxBlocks) stop(Message(msg::kJournalFull, name_, kMaxBlocks));
    return !fault_;
}

bool JournalAppender::writeBlock(BlockType type, std::uint64_t firstTick, std::uint32_t ticks,
                                 std::span<const std::byte> bytes) {
    TACTOOTH_ASSERT(bytes.size() >= kBlockHeaderBytes);
    const std::uint64_t offset = bytes_;
    if (!write(bytes)) return false;
    if (type == BlockType::Keyframe) keyframes_.push_back({firstTick, offset});
    ++blocks_;
    endTick_ = std::max(endTick_, firstTick + ticks);
    TACTOOTH_ASSERT(bytes_ == offset + bytes.size());
    return true;
}

bool JournalAppender::write(std::span<const std::byte> bytes) {
    isDirty_ = true;
    if (const int failure = writeAll(*file_, bytes); failure != 0) return stop(failure);
    bytes_ += bytes.size();
    if (sealer_) sealer_->noteWritten(bytes);
    return true;
}

bool JournalAppender::stop(int failure) {
    if (failure == ENOENT) return stop(Message(msg::kJournalDeleted, name_));
    return stop(Message(msg::kJournalStopped, name_, systemReason(failure)));
}

bool JournalAppender::stop(Message why) {
    TACTOOTH_ASSERT(!fault_);
    fault_ = std::move(why);
    return false;
}

}  // namespace tactooth
