// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "journal/codec/signing_key.h"

#include <gtest/gtest.h>

#include <random>

#include "geometry/util/byte_text.h"

namespace tactooth {
namespace {

/// RFC 8032, section 7.1, test 1: an empty message.
TEST(SigningKey, AgreesWithTheStandard) {
    const auto key =
        SigningKey::fromSeed(*parseHex("9d61b19deffd5a60ba844af492ec2cc44449c5697b326919703bac031cae7f60"));
    EXPECT_EQ(keyText(key->publicKey()), "d75a980182b10ab7d54bfed3c964073a0ee172f3daa62325af021a68f707511a");
    const SignatureBytes signature = key->sign({});
    const auto half = std::span(signature).first<32>();
    EXPECT_EQ(hexText(half), "e5564300c360ac729086e2cc806e828a84877f1eb8e5d974d873e06522490155");
    EXPECT_TRUE(isSignedBy(key->publicKey(), {}, signature));
    EXPECT_EQ(hexText(key->seed()), "9d61b19deffd5a60ba844af492ec2cc44449c5697b326919703bac031cae7f60");
}

TEST(SigningKey, OnlyItsOwnSignatureOfJustTheseBytesCounts) {
    const auto key = SigningKey::make(), other = SigningKey::make();
    EXPECT_NE(key->publicKey(), other->publicKey());
    std::vector<std::byte> message = bytesOf("a cavity of one millimetre");
    SignatureBytes signature = key->sign(message);
    EXPECT_TRUE(isSignedBy(key->publicKey(), message, signature));
    EXPECT_FALSE(isSignedBy(other->publicKey(), message, signature));
    for (std::byte& byte : message) {
        byte ^= std::byte{1};
        EXPECT_FALSE(isSignedBy(key->publicKey(), message, signature));
        byte ^= std::byte{1};
    }
    for (std::byte& byte : signature) {
        byte ^= std::byte{16};
        EXPECT_FALSE(isSignedBy(key->publicKey(), message, signature));
        byte ^= std::byte{16};
    }
    EXPECT_TRUE(isSignedBy(key->publicKey(), message, signature));
}

TEST(SigningKey, TheTextOfAKeyIsReadBackAndNothingElseIsAKey) {
    const PublicKey key = SigningKey::make()->publicKey();
    const std::string text = keyText(key);
    EXPECT_EQ(text.size(), 64U);
    EXPECT_EQ(parseKey(text), key);
    for (const std::string& wrong : {std::string(), text.substr(1), text + "0", text.substr(1) + "g",
                                     text.substr(2) + ": ", std::string(64, ' '), std::string(64, '\0')}) {
        EXPECT_FALSE(parseKey(wrong)) << wrong;
    }
}

}  // namespace
}  // namespace tactooth
