// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "tooth/volume/field_change.h"

#include <bit>

#include "geometry/util/assert.h"

namespace tactooth {
namespace {

// Numbers are compared by their bits, so that 0 and -0 differ.
std::uint32_t bitsOf(float value) { return std::bit_cast<std::uint32_t>(value); }

bool isSame(const CutField& a, const CutField& b, int node) {
    if (bitsOf(a.cut[node]) != bitsOf(b.cut[node]) || !(a.cutNormal[node] == b.cutNormal[node])) return false;
    for (int axis = 0; axis < 3; ++axis) {
        const HermiteSample& left = a.boundary[axis][node];
        const HermiteSample& right = b.boundary[axis][node];
        if (bitsOf(left.place) != bitsOf(right.place) || !(left.normal == right.normal)) return false;
    }
    return true;
}

}  // namespace

FieldChange FieldChange::between(const CutField& from, const CutField& to, double spacing) {
    const CutField untouched = CutField::untouched(spacing);
    FieldChange change;
    change.isCut_ = to.isCut;
    for (int node = 0; node < kBrickNodes; ++node) {
        if (isSame(from, to, node)) continue;
        change.changed_.set(node);
        if (isSame(to, untouched, node)) {
            change.untouched_.set(node);
            continue;
        }
        change.values_.push_back(
            {to.cut[node], to.cutNormal[node], {to.boundary[0][node], to.boundary[1][node], to.boundary[2][node]}});
    }
    change.values_.shrink_to_fit();
    return change;
}

void FieldChange::apply(CutField& field, double spacing) const {
    const CutField untouched = CutField::untouched(spacing);
    field.isCut = isCut_;
    auto value = values_.begin();
    for (int node = 0; node < kBrickNodes; ++node) {
        if (!changed_[node]) continue;
        const bool isUntouched = untouched_[node];
        TACTOOTH_ASSERT(isUntouched || value != values_.end());
        field.cut[node] = isUntouched ? untouched.cut[node] : value->cut;
        field.cutNormal[node] = isUntouched ? untouched.cutNormal[node] : value->cutNormal;
        for (int axis = 0; axis < 3; ++axis) {
            field.boundary[axis][node] = isUntouched ? untouched.boundary[axis][node] : value->boundary[axis];
        }
        if (!isUntouched) ++value;
    }
    TACTOOTH_ASSERT(value == values_.end());
}

}  // namespace tactooth
