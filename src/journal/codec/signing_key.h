// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace tactooth {

// Signatures by Ed25519 (RFC 8032), computed by libsodium.

using SignatureBytes = std::array<std::byte, 64>;
/// The secret from which a key pair follows.
using KeySeed = std::array<std::byte, 32>;

/// The half of a key pair that anybody may know: it checks signatures.
struct PublicKey {
    std::array<std::byte, 32> bytes{};
    [[nodiscard]] bool operator==(const PublicKey&) const = default;
};

/// 64 hexadecimal digits, in small letters.
[[nodiscard]] std::string hexText(std::span<const std::byte, 32> bytes);
[[nodiscard]] inline std::string keyText(const PublicKey& key) { return hexText(key.bytes); }
/// Nothing for anything but 64 hexadecimal digits.
[[nodiscard]] std::optional<std::array<std::byte, 32>> parseHex(std::string_view text);
[[nodiscard]] std::optional<PublicKey> parseKey(std::string_view text);

/// Whether the owner of the key has signed just these bytes.
[[nodiscard]] bool isSignedBy(const PublicKey& key, std::span<const std::byte> message,
                              const SignatureBytes& signature);

/// A key pair. Its secret half is wiped from memory with it. Any thread may use the const functions.
class SigningKey {
public:
    /// Another one each time, from the random numbers of the system.
    [[nodiscard]] static std::shared_ptr<const SigningKey> make();
    [[nodiscard]] static std::shared_ptr<const SigningKey> fromSeed(const KeySeed& seed);
    ~SigningKey();
    SigningKey(const SigningKey&) = delete;
    SigningKey& operator=(const SigningKey&) = delete;

    [[nodiscard]] const PublicKey& publicKey() const { return public_; }
    /// Secret. The caller wipes its copy (wipe).
    [[nodiscard]] KeySeed seed() const;
    [[nodiscard]] SignatureBytes sign(std::span<const std::byte> message) const;

private:
    SigningKey() = default;

    PublicKey public_;
    std::array<std::byte, 64> secret_{};
};

/// Overwrites a secret, in a way that no compiler leaves out.
void wipe(std::span<std::byte> secret);

}  // namespace tactooth
