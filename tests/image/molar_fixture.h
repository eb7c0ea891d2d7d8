// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "image/pictures_fixture.h"
#include "instruments/builtin_tooth.h"
#include "tooth/model/layered_tooth.h"

namespace tactooth::test {

/// Pictures of the built-in molar with its layers, as a tooth that can be cut. The molar is made once.
class MolarPictures : public Pictures {
protected:
    static void SetUpTestSuite() {
        Pictures::SetUpTestSuite();
        const BuiltinTooth molar = makeBuiltinTooth(BuiltinToothKind::LowerFirstMolar, 8000);
        auto layered = LayeredTooth::make(molar.outer, layersOf(molar));
        ASSERT_TRUE(layered) << layered.error().message();
        tooth_ = std::make_shared<const LayeredTooth>(std::move(*layered));
        mesialX_ = mesialX(molar.fdi);
    }
    static void TearDownTestSuite() {
        tooth_.reset();
        Pictures::TearDownTestSuite();
    }

    static inline std::shared_ptr<const LayeredTooth> tooth_;
    static inline double mesialX_ = 1;
};

}  // namespace tactooth::test
