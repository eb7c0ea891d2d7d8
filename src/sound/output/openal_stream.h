// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <AL/al.h>
#include <AL/alc.h>
#include <AL/alext.h>

#include <algorithm>
#include <array>
#include <memory>

#include "sound/output/sound_placement.h"
#include "sound/voices/soundscape.h"

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

/// Amplitude for a context with HRTF: at the near ear some frequencies come out twice as strong as they went in (1.85
/// times measured, cutting sound from the side), so that a source at its ceiling would clip.
inline constexpr float kHeadphoneGain = 0.5f;

/// An OpenAL device with one context and one source for each place of the soundscape, which play queues of short blocks
/// in step. Every call but the destructor needs its context() to be current.
class OpenAlStream {
public:
    /// Takes over `device`; none if it cannot make a context or the sources. `attributes` as for alcCreateContext;
    /// `gain` multiplies the amplitude.
    static std::unique_ptr<OpenAlStream> create(ALCdevice* device, const ALCint* attributes, float gain);
    ~OpenAlStream();
    OpenAlStream(const OpenAlStream&) = delete;
    OpenAlStream& operator=(const OpenAlStream&) = delete;

    [[nodiscard]] ALCdevice* device() const { return device_; }
    [[nodiscard]] ALCcontext* context() const { return context_; }

    /// Takes back the blocks that have been played. Once before filling up, not in between: in a source that ran dry
    /// each block counts as played as soon as it is queued.
    void reclaim();
    [[nodiscard]] bool hasRoom() const { return kMaxQueue - freeCount_ < queueLength_; }
    /// Blocks that the queue holds: what the device takes at a time, and enough more for a thread that is woken late.
    [[nodiscard]] int queueLength() const { return queueLength_; }
    /// Holds one block more from now on, for a thread that is woken later than was thought.
    void growQueue() { queueLength_ = std::min(queueLength_ + 1, kMaxQueue); }
    /// Appends a block for each place. Needs room.
    void queue(const SoundBlock& block);
    /// How long a sample that is queued now waits until it is heard, s: for what is before it in the queue, and for the
    /// device, as far as that tells.
    [[nodiscard]] double delay() const;
    /// Starts playing, again if it had run out of blocks; true if it was not playing.
    bool ensurePlaying();
    void place(const SoundPlacement& placement);

private:
    static constexpr int kMaxQueue = 32;
    using Buffers = std::array<unsigned, kMaxQueue>;

    OpenAlStream(ALCdevice* device, ALCcontext* context) : device_(device), context_(context) {}
    bool makeSources(float gain);

    ALCdevice* device_;
    ALCcontext* context_;
    LPALGETSOURCEDVSOFT offsetAndLatency_ = nullptr;  // null where OpenAL cannot tell
    std::array<unsigned, kSoundSources> sources_{};
    int queueLength_ = 0;
    std::array<Buffers, kSoundSources> buffers_{};
    std::array<Buffers, kSoundSources> free_{};
    int freeCount_ = 0;  // as many of each
};

}  // namespace tactooth
