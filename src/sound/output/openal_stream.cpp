// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "sound/output/openal_stream.h"

#include <AL/al.h>
#include <AL/alext.h>

#include <algorithm>

#include "geometry/util/assert.h"

namespace tactooth {

namespace {

// alcSetThreadContext, or the process-wide call where an implementation lacks it.
ALCboolean makeCurrent(ALCcontext* context) {
    static const auto perThread =
        reinterpret_cast<PFNALCSETTHREADCONTEXTPROC>(alcGetProcAddress(nullptr, "alcSetThreadContext"));
    return perThread != nullptr ? perThread(context) : alcMakeContextCurrent(context);
}

constexpr int kSpareBlocks = 3;  // 7.5 ms for a thread that wakes up late

// Blocks in one period of the device's mixer.
int blocksTakenAtOnce(ALCdevice* device) {
    ALCint periodsPerSecond = 0;
    alcGetIntegerv(device, ALC_REFRESH, 1, &periodsPerSecond);
    constexpr int kBlocksPerSecond = kSoundRate / kSoundBlock;
    return periodsPerSecond > 0 ? (kBlocksPerSecond + periodsPerSecond - 1) / periodsPerSecond : 1;
}

LPALGETSOURCEDVSOFT latencyQuestion() {
    if (alIsExtensionPresent("AL_SOFT_source_latency") == AL_FALSE) return nullptr;
    return reinterpret_cast<LPALGETSOURCEDVSOFT>(alGetProcAddress("alGetSourcedvSOFT"));
}

}  // namespace

ThreadContext::ThreadContext(ALCcontext* context) { makeCurrent(context); }
ThreadContext::~ThreadContext() { makeCurrent(nullptr); }

std::unique_ptr<OpenAlStream> OpenAlStream::create(ALCdevice* device, const ALCint* attributes, float gain, bool room) {
    if (device == nullptr) return nullptr;
    ALCcontext* context = alcCreateContext(device, attributes);
    if (context == nullptr) {
        alcCloseDevice(device);
        return nullptr;
    }
    std::unique_ptr<OpenAlStream> stream(new OpenAlStream(device, context));
    const ThreadContext current(context);
    if (!stream->makeSources(gain, room)) return nullptr;
    return stream;
}

bool OpenAlStream::makeSources(float gain, bool room) {
    if (alIsExtensionPresent("AL_EXT_FLOAT32") == AL_FALSE) return false;
    offsetAndLatency_ = latencyQuestion();
    alGetError();
    alGenSources(static_cast<ALsizei>(sources_.size()), sources_.data());
    if (room && room_.emplace().surround(sources_)) gain *= RoomReverb::kSourceGain;
    queueLength_ = std::clamp(blocksTakenAtOnce(device_) + kSpareBlocks, 1, kMaxQueue);
    for (std::size_t place = 0; place < sources_.size(); ++place) {
        alGenBuffers(kMaxQueue, buffers_[place].data());
        alSourcef(sources_[place], AL_GAIN, gain);
        alSourcef(sources_[place], AL_ROLLOFF_FACTOR, 0.0f);  // direction only, see SoundPlacement
    }
    free_ = buffers_;
    freeCount_ = kMaxQueue;
    return alGetError() == AL_NO_ERROR;
}

OpenAlStream::~OpenAlStream() {
    if (sources_[0] != 0) {
        const ThreadContext current(context_);
        const auto count = static_cast<ALsizei>(sources_.size());
        alSourceStopv(count, sources_.data());
        alDeleteSources(count, sources_.data());
        room_.reset();
        for (const Buffers& buffers : buffers_) alDeleteBuffers(kMaxQueue, buffers.data());
    }
    alcDestroyContext(context_);
    alcCloseDevice(device_);
}

void OpenAlStream::reclaim() {
    // The mixer may run between two of these queries: all have played the smallest of the answers.
    ALint played = kMaxQueue - freeCount_;
    for (const unsigned source : sources_) {
        ALint own = 0;
        alGetSourcei(source, AL_BUFFERS_PROCESSED, &own);
        played = std::min(played, own);
    }
    for (std::size_t place = 0; place < sources_.size(); ++place) {
        alSourceUnqueueBuffers(sources_[place], played, &free_[place][static_cast<std::size_t>(freeCount_)]);
    }
    freeCount_ += played;
}

void OpenAlStream::queue(const SoundBlock& block) {
    TACTOOTH_ASSERT(freeCount_ > 0);
    --freeCount_;
    for (std::size_t place = 0; place < sources_.size(); ++place) {
        const unsigned buffer = free_[place][static_cast<std::size_t>(freeCount_)];
        alBufferData(buffer, AL_FORMAT_MONO_FLOAT32, block[place].data(), static_cast<ALsizei>(sizeof(block[place])),
                     kSoundRate);
        alSourceQueueBuffers(sources_[place], 1, &buffer);
    }
}

double OpenAlStream::delay() const {
    const double queued = static_cast<double>((kMaxQueue - freeCount_) * kSoundBlock) / kSoundRate;
    if (offsetAndLatency_ == nullptr) return queued;
    std::array<ALdouble, 2> heard{};  // s: position of the mixer in the queue, and the delay to the ear
    offsetAndLatency_(sources_[0], AL_SEC_OFFSET_LATENCY_SOFT, heard.data());
    return queued - heard[0] + heard[1];
}

bool OpenAlStream::ensurePlaying() {
    ALint state = AL_PLAYING;
    alGetSourcei(sources_[0], AL_SOURCE_STATE, &state);
    if (state == AL_PLAYING) return false;
    alSourcePlayv(static_cast<ALsizei>(sources_.size()), sources_.data());
    return true;
}

void OpenAlStream::place(const SoundPlacement& placement) {
    constexpr double kMetresPerMm = 1e-3;
    const Eigen::Vector3f ears = (placement.listenerInWorld.position * kMetresPerMm).cast<float>();
    const Eigen::Vector3f ahead = (placement.listenerInWorld.rotation * -Vec3::UnitZ()).cast<float>();
    const Eigen::Vector3f up = (placement.listenerInWorld.rotation * Vec3::UnitY()).cast<float>();
    const std::array<float, 6> facing{ahead.x(), ahead.y(), ahead.z(), up.x(), up.y(), up.z()};
    const std::array<const Vec3*, kSoundSources> places{&placement.source, &placement.mouth, &placement.suction};
    for (std::size_t place = 0; place < sources_.size(); ++place) {
        const Eigen::Vector3f at = (*places[place] * kMetresPerMm).cast<float>();
        alSource3f(sources_[place], AL_POSITION, at.x(), at.y(), at.z());
    }
    alListener3f(AL_POSITION, ears.x(), ears.y(), ears.z());
    alListenerfv(AL_ORIENTATION, facing.data());
}

}  // namespace tactooth
