// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <AL/alc.h>

#include <array>
#include <memory>
#include <optional>
#include <span>

#include "sound/sound_format.h"
#include "sound/sound_placement.h"

namespace tactooth {

/// Makes a context the current one of this thread alone (ALC_EXT_thread_local_context), so that several devices can be
/// used by several threads; undone at the end of the scope.
class ThreadContext {
public:
    explicit ThreadContext(ALCcontext* context);
    ~ThreadContext();
    ThreadContext(const ThreadContext&) = delete;
    ThreadContext& operator=(const ThreadContext&) = delete;
};

/// An OpenAL device with one context and one source that plays a queue of short blocks. Every call but the destructor
/// needs its context() to be current.
class OpenAlStream {
public:
    static constexpr int kQueue = 4;  ///< blocks: 20 ms, enough for a thread that is woken late

    /// Takes over `device`; none if it cannot make a context or a source. `attributes` as for alcCreateContext.
    static std::unique_ptr<OpenAlStream> create(ALCdevice* device, const ALCint* attributes);
    ~OpenAlStream();
    OpenAlStream(const OpenAlStream&) = delete;
    OpenAlStream& operator=(const OpenAlStream&) = delete;

    [[nodiscard]] ALCdevice* device() const { return device_; }
    [[nodiscard]] ALCcontext* context() const { return context_; }

    /// Takes back the blocks that have been played; true if the queue has room for another.
    bool hasRoom();
    /// Appends a block of one channel. Needs room.
    void queue(std::span<const float> mono);
    /// Starts playing, again if it had run out of blocks; true if it was not playing.
    bool ensurePlaying();
    void place(const SoundPlacement& placement);

private:
    OpenAlStream(ALCdevice* device, ALCcontext* context) : device_(device), context_(context) {}
    bool makeSource();

    ALCdevice* device_;
    ALCcontext* context_;
    unsigned source_ = 0;
    std::array<unsigned, kQueue> buffers_{};
    std::array<unsigned, kQueue> free_{};
    int freeCount_ = 0;
};

}  // namespace tactooth
