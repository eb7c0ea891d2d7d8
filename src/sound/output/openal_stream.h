// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <AL/al.h>
#include <AL/alc.h>
#include <AL/alext.h>

#include <algorithm>
#include <array>
#include <memory>
#include <optional>

#include "sound/output/room_reverb.h"
#include "sound/output/sound_placement.h"
#include "sound/voices/soundscape.h"

namespace tactooth {

/// Makes a context current for this thread only (ALC_EXT_thread_local_context), so that several threads can use several
/// devices; undone at the end of the scope.
class ThreadContext {
public:
    explicit ThreadContext(ALCcontext* context);
    ~ThreadContext();
    ThreadContext(const ThreadContext&) = delete;
    ThreadContext& operator=(const ThreadContext&) = delete;
};

/// Gain for a context with HRTF: at the near ear some frequencies are amplified up to twice (1.85 times measured,
/// cutting sound from the side), so that a source at its ceiling would clip.
inline constexpr float kHeadphoneGain = 0.5f;

/// An OpenAL device with one context and one source for each position of the soundscape; the sources play queues of
/// short blocks in step. Every call except the destructor needs its context() to be current.
class OpenAlStream {
public:
    /// Takes ownership of `device`; null if it cannot make a context or the sources. `attributes` are those of
    /// alcCreateContext; `gain` multiplies the amplitude. `room`: adds the sound of the surgery, if OpenAL can.
    static std::unique_ptr<OpenAlStream> create(ALCdevice* device, const ALCint* attributes, float gain, bool room);
    ~OpenAlStream();
    OpenAlStream(const OpenAlStream&) = delete;
    OpenAlStream& operator=(const OpenAlStream&) = delete;

    [[nodiscard]] ALCdevice* device() const { return device_; }
    [[nodiscard]] ALCcontext* context() const { return context_; }

    /// Takes back the blocks that have been played. Call it once before filling, not in between: in a source that ran
    /// dry each block counts as played as soon as it is queued.
    void reclaim();
    [[nodiscard]] bool hasRoom() const { return kMaxQueue - freeCount_ < queueLength_; }
    /// Length of the queue in blocks: what the device takes at a time, and enough more for a thread that wakes up late.
    [[nodiscard]] int queueLength() const { return queueLength_; }
    /// Makes the queue one block longer, for a thread that wakes up later than expected.
    void growQueue() { queueLength_ = std::min(queueLength_ + 1, kMaxQueue); }
    /// Appends a block for each position. Needs room in the queue.
    void queue(const SoundBlock& block);
    /// Time from now until a sample that is queued now is heard, s: for the queue before it, and for the device, as far
    /// as OpenAL reports it.
    [[nodiscard]] double delay() const;
    /// Starts playing, also after an underrun; true if it was not playing.
    bool ensurePlaying();
    void place(const SoundPlacement& placement);

private:
    static constexpr int kMaxQueue = 32;
    using Buffers = std::array<unsigned, kMaxQueue>;

    OpenAlStream(ALCdevice* device, ALCcontext* context) : device_(device), context_(context) {}
    bool makeSources(float gain, bool room);

    ALCdevice* device_;
    ALCcontext* context_;
    LPALGETSOURCEDVSOFT offsetAndLatency_ = nullptr;  // null where OpenAL does not report it
    std::array<unsigned, kSoundSources> sources_{};
    int queueLength_ = 0;
    std::array<Buffers, kSoundSources> buffers_{};
    std::array<Buffers, kSoundSources> free_{};
    int freeCount_ = 0;  // the same number for each source
    std::optional<RoomReverb> room_;
};

}  // namespace tactooth
