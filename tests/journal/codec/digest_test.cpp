// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "journal/codec/digest.h"

#include <gtest/gtest.h>

#include "geometry/util/byte_text.h"
#include "journal/codec/signing_key.h"

namespace tactooth {
namespace {

/// Of RFC 7693's algorithm, by another implementation (Python's hashlib).
TEST(Digester, AgreesWithAnotherImplementation) {
    Digester digester;
    EXPECT_EQ(hexText(digester.digest()), "0e5751c026e543b2e8ab2eb06099daa1d1e5df47778f7787faab45cdf12fe3a8");
    digester.add(asBytes("abc"));
    EXPECT_EQ(hexText(digester.digest()), "bddd813c634239723171ef3fee98579b94964e3bb1cb3e427262c8c068d52319");
}

TEST(Digester, GoesOnAfterADigestWasTaken) {
    Digester inPieces, atOnce;
    for (const char* piece : {"to", "", "oth", " and bur"}) {
        inPieces.add(asBytes(piece));
        (void)inPieces.digest();
    }
    atOnce.add(asBytes("tooth and bur"));
    EXPECT_EQ(inPieces.digest(), atOnce.digest());
}

}  // namespace
}  // namespace tactooth
