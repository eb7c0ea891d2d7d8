// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "journal/codec/digest.h"

#include <sodium.h>

#include "geometry/util/assert.h"

namespace tactooth {
namespace {

unsigned char* raw(std::byte* bytes) { return reinterpret_cast<unsigned char*>(bytes); }
const unsigned char* raw(const std::byte* bytes) { return reinterpret_cast<const unsigned char*>(bytes); }

}  // namespace

struct Digester::State {
    crypto_generichash_state blake;
};

Digester::Digester() : state_(std::make_unique<State>()) {
    [[maybe_unused]] const int failure = crypto_generichash_init(&state_->blake, nullptr, 0, sizeof(Digest));
    TACTOOTH_ASSERT(failure == 0);
}
Digester::Digester(Digester&&) noexcept = default;
Digester& Digester::operator=(Digester&&) noexcept = default;
Digester::~Digester() = default;

void Digester::add(std::span<const std::byte> bytes) {
    TACTOOTH_ASSERT(state_ != nullptr);
    crypto_generichash_update(&state_->blake, raw(bytes.data()), bytes.size());
}

Digest Digester::digest() const {
    TACTOOTH_ASSERT(state_ != nullptr);
    State copy = *state_;  // to finish it ends it
    Digest result{};
    crypto_generichash_final(&copy.blake, raw(result.data()), result.size());
    return result;
}

}  // namespace tactooth
