// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "journal/codec/signing_key.h"

#include <sodium.h>

#include "geometry/util/assert.h"

namespace tactooth {
namespace {

unsigned char* raw(std::byte* bytes) { return reinterpret_cast<unsigned char*>(bytes); }
const unsigned char* raw(const std::byte* bytes) { return reinterpret_cast<const unsigned char*>(bytes); }

static_assert(sizeof(SignatureBytes) == crypto_sign_BYTES && sizeof(KeySeed) == crypto_sign_SEEDBYTES);
static_assert(sizeof(PublicKey) == crypto_sign_PUBLICKEYBYTES && crypto_sign_SECRETKEYBYTES == 64);

/// Chooses the fastest code for this processor, and opens the source of random numbers. More than one call is allowed.
void begin() {
    [[maybe_unused]] const int failure = sodium_init();
    TACTOOTH_ASSERT(failure >= 0);
}

}  // namespace

void wipe(std::span<std::byte> secret) { sodium_memzero(secret.data(), secret.size()); }

std::string hexText(std::span<const std::byte, 32> bytes) {
    std::string text(2 * bytes.size() + 1, '\0');  // with the end mark
    sodium_bin2hex(text.data(), text.size(), raw(bytes.data()), bytes.size());
    text.pop_back();
    return text;
}

std::optional<std::array<std::byte, 32>> parseHex(std::string_view text) {
    std::array<std::byte, 32> bytes{};
    if (text.size() != 2 * bytes.size()) return std::nullopt;
    std::size_t count = 0;
    const int failure =
        sodium_hex2bin(raw(bytes.data()), bytes.size(), text.data(), text.size(), nullptr, &count, nullptr);
    if (failure != 0 || count != bytes.size()) return std::nullopt;
    return bytes;
}

std::optional<PublicKey> parseKey(std::string_view text) {
    const auto bytes = parseHex(text);
    return bytes ? std::optional(PublicKey{*bytes}) : std::nullopt;
}

bool isSignedBy(const PublicKey& key, std::span<const std::byte> message, const SignatureBytes& signature) {
    begin();
    return crypto_sign_verify_detached(raw(signature.data()), raw(message.data()), message.size(),
                                       raw(key.bytes.data())) == 0;
}

std::shared_ptr<const SigningKey> SigningKey::make() {
    begin();
    KeySeed seed{};
    randombytes_buf(seed.data(), seed.size());
    auto key = fromSeed(seed);
    wipe(seed);
    return key;
}

std::shared_ptr<const SigningKey> SigningKey::fromSeed(const KeySeed& seed) {
    begin();
    std::shared_ptr<SigningKey> key(new SigningKey);
    [[maybe_unused]] const int failure =
        crypto_sign_seed_keypair(raw(key->public_.bytes.data()), raw(key->secret_.data()), raw(seed.data()));
    TACTOOTH_ASSERT(failure == 0);
    return key;
}

SigningKey::~SigningKey() { wipe(secret_); }

KeySeed SigningKey::seed() const {
    KeySeed seed{};
    crypto_sign_ed25519_sk_to_seed(raw(seed.data()), raw(secret_.data()));
    return seed;
}

SignatureBytes SigningKey::sign(std::span<const std::byte> message) const {
    SignatureBytes signature{};
    crypto_sign_detached(raw(signature.data()), nullptr, raw(message.data()), message.size(), raw(secret_.data()));
    return signature;
}

}  // namespace tactooth
