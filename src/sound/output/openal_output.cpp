// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "sound/output/openal_output.h"

#include <AL/alc.h>
#include <AL/alext.h>
#include <pthread.h>
#include <sched.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <utility>

#include "sound/output/audio_libraries.h"
#include "sound/output/openal_stream.h"
#include "sound/output/sound_system_search.h"

namespace tactooth {

namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

constexpr auto kPoll = 2500us;         // a block: what a period took is replaced before the next one
constexpr auto kRetryAfter = 3s;       // for a sound card that is plugged in later
constexpr double kMaxLatency = 0.030;  // s: up to here the queue grows after an underrun
constexpr int kStaleBlocks = 80;       // 0.2 s without a new state: the simulation is paused or gone
constexpr int kConnectedEvery = 100;   // blocks between two checks of the device's connection

// Waits, unless the thread is asked to stop.
void pause(const std::stop_token& stop, std::chrono::seconds time) {
    std::mutex mutex;
    std::condition_variable_any wake;
    std::unique_lock lock(mutex);
    wake.wait_for(lock, stop, time, [] { return false; });
}

std::unique_ptr<OpenAlStream> openDefaultDevice(bool headphones, bool room) {
    if (!hasSoundSystem()) return nullptr;
    silenceAlsaMessages();
    // The direct sound is limited already (PeakLimiter); OpenAL's own limiter would add a quarter to its cost for
    // nothing.
    const std::array<ALCint, 7> attributes{ALC_FREQUENCY,
                                           kSoundRate,
                                           ALC_HRTF_SOFT,
                                           headphones ? ALC_TRUE : ALC_FALSE,
                                           ALC_OUTPUT_LIMITER_SOFT,
                                           room ? ALC_TRUE : ALC_FALSE,
                                           0};
    return OpenAlStream::create(alcOpenDevice(nullptr), attributes.data(), headphones ? kHeadphoneGain : 1.0f, room);
}

// Priority over ordinary programs, below the servo loop (which takes more than the lowest priority). Where the system
// does not allow it, the queue has to be long enough.
void askForPriority() {
    sched_param parameters{};
    parameters.sched_priority = sched_get_priority_min(SCHED_FIFO);
    (void)pthread_setschedparam(pthread_self(), SCHED_FIFO, &parameters);
}

bool isConnected(ALCdevice* device) {
    ALCint connected = ALC_TRUE;
    if (alcIsExtensionPresent(device, "ALC_EXT_disconnect") == ALC_TRUE) {
        alcGetIntegerv(device, ALC_CONNECTED, 1, &connected);
    }
    return connected == ALC_TRUE;
}

}  // namespace

/// Keeps the queue of a device filled from the mailboxes of the output.
class OpenAlOutput::Feeder {
public:
    Feeder(OpenAlOutput& output, OpenAlStream& stream)
        : output_(output), stream_(stream), soundscape_(output.settings_.seed, newestKit(output)) {
        soundscape_.setMixer(output.mixer_.value());
        stream.place(output.placement_.value());
    }

    /// False once the device is gone.
    bool fill() {
        stream_.reclaim();
        while (stream_.hasRoom()) {
            feedBlock();
            if (++blocks_ % kConnectedEvery == 0 && !isConnected(stream_.device())) return false;
        }
        if (stream_.ensurePlaying() && std::exchange(started_, true)) recoverFromUnderrun();
        return true;
    }

private:
    void recoverFromUnderrun() {
        ++output_.underruns_;
        constexpr double kBlockSeconds = static_cast<double>(kSoundBlock) / kSoundRate;
        longest_ = std::max(longest_, output_.latency());
        if (longest_ + kBlockSeconds > kMaxLatency) return;
        longest_ += kBlockSeconds;
        stream_.growQueue();
    }

    void feedBlock() {
        const auto lastPoll = std::exchange(polled_, Clock::now());
        staleBlocks_ = output_.state_.refresh() ? 0 : std::min(staleBlocks_ + 1, kStaleBlocks);
        if (output_.mixer_.refresh()) soundscape_.setMixer(output_.mixer_.value());
        if (output_.kit_.refresh()) soundscape_.setKit(output_.kit_.value().kit);
        if (output_.placement_.refresh()) stream_.place(output_.placement_.value());
        soundscape_.render(staleBlocks_ < kStaleBlocks ? output_.state_.value() : stillDrill(), block_);
        if (const NumberedKit& newest = output_.kit_.value(); soundscape_.kit() == newest.kit)
            output_.activeKit_.store(newest.number, std::memory_order_release);
        const double sincePoll = started_ ? std::chrono::duration<double>(Clock::now() - lastPoll).count() : 0.0;
        constexpr double kLimiter = static_cast<double>(Soundscape::kDelay) / kSoundRate;
        output_.latency_.store(sincePoll + stream_.delay() + kLimiter, std::memory_order_relaxed);
        stream_.queue(block_);
        ++output_.playedBlocks_;
    }

    static const SoundKit* newestKit(OpenAlOutput& output) {
        output.kit_.refresh();
        return output.kit_.value().kit;
    }

    // The same counts as before, so that there is neither an impact nor a pull-out when the simulation goes on.
    DrillSoundState stillDrill() const {
        DrillSoundState still;
        still.contactCount = output_.state_.value().contactCount;
        still.pullOutCount = output_.state_.value().pullOutCount;
        return still;
    }

    OpenAlOutput& output_;
    OpenAlStream& stream_;
    Soundscape soundscape_;
    SoundBlock block_{};
    Clock::time_point polled_ = Clock::now();  // time of the last check of the mailboxes
    int staleBlocks_ = 0;
    std::uint64_t blocks_ = 0;
    bool started_ = false;
    double longest_ = 0.0;  // latency with the present queue, s
};

OpenAlOutput::OpenAlOutput(const OpenAlOutputSettings& settings)
    : settings_(settings),
      headphones_(settings.headphones),
      room_(settings.room),
      thread_([this](const std::stop_token& stop) { run(stop); }) {}

// Once the newest kit is played, older ones are not needed any more.
void OpenAlOutput::setKit(std::shared_ptr<const SoundKit> kit) {
    if (kitsSet_ > 0 && activeKit_.load(std::memory_order_acquire) == kitsSet_)
        kits_.erase(kits_.begin(), kits_.end() - 1);
    kit_.write({kit.get(), ++kitsSet_});
    kits_.push_back(std::move(kit));
}

void OpenAlOutput::run(const std::stop_token& stop) {
    askForPriority();
    while (!stop.stop_requested()) {
        if (playOnce(stop)) continue;
        if (stop.stop_requested()) return;
        status_.store(SoundStatus::Silent, std::memory_order_relaxed);
        pause(stop, kRetryAfter);
    }
}

bool OpenAlOutput::playOnce(const std::stop_token& stop) {
    const bool headphones = headphones_.load(std::memory_order_relaxed);
    const bool room = room_.load(std::memory_order_relaxed);
    const std::unique_ptr<OpenAlStream> stream = openDefaultDevice(headphones, room);
    if (stream == nullptr) return false;
    const ThreadContext current(stream->context());
    Feeder feeder(*this, *stream);
    status_.store(SoundStatus::Playing, std::memory_order_relaxed);
    while (!stop.stop_requested() && feeder.fill()) {
        const bool isAsWanted =
            headphones_.load(std::memory_order_relaxed) == headphones && room_.load(std::memory_order_relaxed) == room;
        if (!isAsWanted) return true;
        std::this_thread::sleep_for(kPoll);
    }
    return false;
}

}  // namespace tactooth
