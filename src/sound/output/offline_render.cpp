// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "sound/output/offline_render.h"

#include <AL/alc.h>
#include <AL/alext.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "sound/files/messages.h"
#include "sound/output/openal_stream.h"

namespace tactooth {

namespace {

/// The entry points of the loopback device; all null where the implementation has none.
struct LoopbackFunctions {
    LPALCLOOPBACKOPENDEVICESOFT open = nullptr;
    LPALCRENDERSAMPLESSOFT render = nullptr;
};

LoopbackFunctions loopbackFunctions() {
    if (alcIsExtensionPresent(nullptr, "ALC_SOFT_loopback") != ALC_TRUE) return {};
    return {reinterpret_cast<LPALCLOOPBACKOPENDEVICESOFT>(alcGetProcAddress(nullptr, "alcLoopbackOpenDeviceSOFT")),
            reinterpret_cast<LPALCRENDERSAMPLESSOFT>(alcGetProcAddress(nullptr, "alcRenderSamplesSOFT"))};
}

std::unique_ptr<OpenAlStream> openLoopback(const LoopbackFunctions& loopback, bool headphones, bool room) {
    if (loopback.open == nullptr || loopback.render == nullptr) return nullptr;
    const std::array<ALCint, 11> attributes{ALC_FREQUENCY,
                                            kSoundRate,
                                            ALC_FORMAT_CHANNELS_SOFT,
                                            ALC_STEREO_SOFT,
                                            ALC_FORMAT_TYPE_SOFT,
                                            ALC_FLOAT_SOFT,
                                            ALC_HRTF_SOFT,
                                            headphones ? ALC_TRUE : ALC_FALSE,
                                            ALC_OUTPUT_LIMITER_SOFT,
                                            room ? ALC_TRUE : ALC_FALSE,  // as live
                                            0};
    return OpenAlStream::create(loopback.open(nullptr), attributes.data(), headphones ? kHeadphoneGain : 1.0f, room);
}

/// A room never quite falls silent; far below a step of 16 bits its sound is digital silence, as it is without a room.
void dropInaudible(float& sample) {
    constexpr float kInaudible = 1e-7f;  // -140 dB of full scale
    if (std::abs(sample) < kInaudible) sample = 0;
}

/// Reads a track forwards: the state at any later time.
class TrackReader {
public:
    explicit TrackReader(std::span<const TimedSoundState> track) : track_(track) {}

    TimedSoundState at(double time) {
        while (next_ < track_.size() && track_[next_].time <= time) ++next_;
        if (next_ == 0) return track_.front();
        const TimedSoundState& before = track_[next_ - 1];
        return next_ == track_.size() ? before : between(before, track_[next_], time);
    }

private:
    static TimedSoundState between(const TimedSoundState& a, const TimedSoundState& b, double time) {
        const double share = (time - a.time) / (b.time - a.time);
        TimedSoundState now = a;
        now.time = time;
        now.state.speedRpm = std::lerp(a.state.speedRpm, b.state.speedRpm, share);
        now.state.pedal = std::lerp(a.state.pedal, b.state.pedal, share);
        now.state.load = std::lerp(a.state.load, b.state.load, share);
        now.state.removalPower = std::lerp(a.state.removalPower, b.state.removalPower, share);
        now.state.water = std::lerp(a.state.water, b.state.water, share);
        now.state.suction = std::lerp(a.state.suction, b.state.suction, share);
        now.placement.source += share * (b.placement.source - a.placement.source);
        return now;
    }

    std::span<const TimedSoundState> track_;
    std::size_t next_ = 0;
};

Expected<void> check(std::span<const TimedSoundState> track, double seconds) {
    if (!(seconds > 0.0 && seconds <= kMaxSoundLength)) {
        return unexpected(msg::kSoundLength, static_cast<int>(kMaxSoundLength), std::to_string(seconds));
    }
    if (track.empty()) return unexpected(msg::kSoundOfNothing);
    for (std::size_t i = 0; i < track.size(); ++i) {
        const bool ascends = i == 0 || track[i].time >= track[i - 1].time;
        if (std::isfinite(track[i].time) && ascends) continue;
        return unexpected(msg::kSoundBackwards, i + 1, std::to_string(track[i].time));
    }
    return {};
}

}  // namespace

std::size_t framesOf(double seconds) { return static_cast<std::size_t>(std::llround(seconds * kSoundRate)); }

Expected<void> renderInChunks(std::span<const TimedSoundState> track, double seconds, const OfflineSettings& settings,
                              const SampleSink& sink) {
    if (Expected<void> checked = check(track, seconds); !checked) return checked;
    const LoopbackFunctions loopback = loopbackFunctions();
    const std::unique_ptr<OpenAlStream> stream = openLoopback(loopback, settings.headphones, settings.room);
    if (stream == nullptr) {
        return unexpected(msg::kNoLoopback);
    }

    const ThreadContext current(stream->context());
    Soundscape soundscape(settings.seed, settings.kit.get());
    soundscape.setMixer(settings.mixer);
    TrackReader reader(track);
    // The output lags by the delay: that many samples are dropped before the first frame.
    const std::size_t first = Soundscape::kDelay, end = first + framesOf(seconds);
    std::array<float, 2 * kSoundBlock> stereo{};
    SoundBlock block;
    for (std::size_t frame = 0; frame < end; frame += kSoundBlock) {
        const TimedSoundState now = reader.at(static_cast<double>(frame + kSoundBlock) / kSoundRate);
        soundscape.render(now.state, block);
        stream->place(now.placement);
        stream->reclaim();
        stream->queue(block);
        stream->ensurePlaying();
        loopback.render(stream->device(), stereo.data(), kSoundBlock);
        std::ranges::for_each(stereo, dropInaudible);
        const std::size_t from = std::clamp<std::size_t>(first, frame, frame + kSoundBlock) - frame;
        const std::size_t to = std::min<std::size_t>(end - frame, kSoundBlock);
        if (from < to) sink(std::span<const float>(stereo).subspan(2 * from, 2 * (to - from)));
    }
    return {};
}

Expected<StereoSamples> renderOffline(std::span<const TimedSoundState> track, double seconds,
                                      const OfflineSettings& settings) {
    StereoSamples all;
    const auto keep = [&](std::span<const float> stereo) { all.insert(all.end(), stereo.begin(), stereo.end()); };
    if (const auto done = renderInChunks(track, seconds, settings, keep); !done) return Unexpected{done.error()};
    return all;
}

}  // namespace tactooth
