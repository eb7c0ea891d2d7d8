// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "sound/openal_stream.h"

#include <AL/al.h>
#include <AL/alext.h>

#include <algorithm>
#include <cassert>

namespace tactooth {

namespace {

// alcSetThreadContext, or the process-wide call where an implementation lacks it.
ALCboolean makeCurrent(ALCcontext* context) {
    static const auto perThread =
        reinterpret_cast<PFNALCSETTHREADCONTEXTPROC>(alcGetProcAddress(nullptr, "alcSetThreadContext"));
    return perThread != nullptr ? perThread(context) : alcMakeContextCurrent(context);
}

constexpr int kSpareBlocks = 3;  // 15 ms

// Blocks in one period of the device's mixer.
int blocksTakenAtOnce(ALCdevice* device) {
    ALCint periodsPerSecond = 0;
    alcGetIntegerv(device, ALC_REFRESH, 1, &periodsPerSecond);
    constexpr int kBlocksPerSecond = kSoundRate / kSoundBlock;
    return periodsPerSecond > 0 ? (kBlocksPerSecond + periodsPerSecond - 1) / periodsPerSecond : 1;
}

}  // namespace

ThreadContext::ThreadContext(ALCcontext* context) { makeCurrent(context); }
ThreadContext::~ThreadContext() { makeCurrent(nullptr); }

std::unique_ptr<OpenAlStream> OpenAlStream::create(ALCdevice* device, const ALCint* attributes, float gain) {
    if (device == nullptr) return nullptr;
    ALCcontext* context = alcCreateContext(device, attributes);
    if (context == nullptr) {
        alcCloseDevice(device);
        return nullptr;
    }
    std::unique_ptr<OpenAlStream> stream(new OpenAlStream(device, context));
    const ThreadContext current(context);
    if (!stream->makeSource(gain)) return nullptr;
    return stream;
}

bool OpenAlStream::makeSource(float gain) {
    if (alIsExtensionPresent("AL_EXT_FLOAT32") == AL_FALSE) return false;
    alGetError();
    alGenSources(1, &source_);
    queueLength_ = std::clamp(blocksTakenAtOnce(device_) + kSpareBlocks, 1, kLongestQueue);
    alGenBuffers(queueLength_, buffers_.data());
    free_ = buffers_;
    freeCount_ = queueLength_;
    alSourcef(source_, AL_GAIN, gain);
    alSourcef(source_, AL_ROLLOFF_FACTOR, 0.0f);  // direction only, see SoundPlacement
    return alGetError() == AL_NO_ERROR;
}

OpenAlStream::~OpenAlStream() {
    {
        const ThreadContext current(context_);
        if (source_ != 0) {
            alSourceStop(source_);
            alDeleteSources(1, &source_);
            alDeleteBuffers(queueLength_, buffers_.data());
        }
    }
    alcDestroyContext(context_);
    alcCloseDevice(device_);
}

void OpenAlStream::reclaim() {
    ALint played = 0;
    alGetSourcei(source_, AL_BUFFERS_PROCESSED, &played);
    for (; played > 0 && freeCount_ < queueLength_; --played) alSourceUnqueueBuffers(source_, 1, &free_[freeCount_++]);
}

void OpenAlStream::queue(std::span<const float> mono) {
    assert(freeCount_ > 0);
    const unsigned buffer = free_[--freeCount_];
    alBufferData(buffer, AL_FORMAT_MONO_FLOAT32, mono.data(), static_cast<ALsizei>(mono.size_bytes()), kSoundRate);
    alSourceQueueBuffers(source_, 1, &buffer);
}

bool OpenAlStream::ensurePlaying() {
    ALint state = AL_PLAYING;
    alGetSourcei(source_, AL_SOURCE_STATE, &state);
    if (state == AL_PLAYING) return false;
    alSourcePlay(source_);
    return true;
}

void OpenAlStream::place(const SoundPlacement& placement) {
    constexpr double kMetresPerMm = 1e-3;
    const Eigen::Vector3f source = (placement.source * kMetresPerMm).cast<float>();
    const Eigen::Vector3f ears = (placement.listenerInWorld.position * kMetresPerMm).cast<float>();
    const Eigen::Vector3f ahead = (placement.listenerInWorld.rotation * -Vec3::UnitZ()).cast<float>();
    const Eigen::Vector3f up = (placement.listenerInWorld.rotation * Vec3::UnitY()).cast<float>();
    const std::array<float, 6> facing{ahead.x(), ahead.y(), ahead.z(), up.x(), up.y(), up.z()};
    alSource3f(source_, AL_POSITION, source.x(), source.y(), source.z());
    alListener3f(AL_POSITION, ears.x(), ears.y(), ears.z());
    alListenerfv(AL_ORIENTATION, facing.data());
}

}  // namespace tactooth
