// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/util/exact_sign.h"

#include <array>
#include <cmath>

#include "geometry/util/assert.h"

// J. R. Shewchuk, "Adaptive Precision Floating-Point Arithmetic and Fast Robust Geometric Predicates", 1997: a number
// is kept exactly as a sum of doubles that do not overlap. Ours has two stages only: a filter in double precision, then
// the exact sum, which about one call in a thousand needs.

namespace tactooth {
namespace {

/// a + b = high + low, exactly (D. Knuth).
struct TwoTerms {
    double high, low;
};
TwoTerms exactSum(double a, double b) {
    const double high = a + b;
    const double part = high - a;
    return {high, (a - (high - part)) + (b - part)};
}
TwoTerms exactProduct(double a, double b) {
    const double high = a * b;
    return {high, std::fma(a, b, -high)};
}

/// An exact sum of doubles. Its sign is that of its largest term.
class ExactSum {
public:
    void add(double value) {
        int kept = 0;
        double carried = value;
        for (int i = 0; i < size_; ++i) {
            const auto [high, low] = exactSum(carried, terms_[i]);
            carried = high;
            if (low != 0) terms_[kept++] = low;
        }
        TACTOOTH_ASSERT(kept < static_cast<int>(terms_.size()));
        if (carried != 0) terms_[kept++] = carried;
        size_ = kept;
    }
    [[nodiscard]] int sign() const { return size_ == 0 ? 0 : terms_[size_ - 1] > 0 ? 1 : -1; }

private:
    // Six products of three two-term factors give 6 * 8 * 4 = 192 addends; each adds at most one term.
    std::array<double, 200> terms_;
    int size_ = 0;
};

using ExactVector = std::array<TwoTerms, 3>;

ExactVector difference(const Vec3f& a, const Vec3f& b) {
    ExactVector result;
    for (int axis = 0; axis < 3; ++axis) result[axis] = exactSum(a[axis], -double{b[axis]});
    return result;
}

void addProduct(ExactSum& sum, const TwoTerms& a, const TwoTerms& b, double sign) {
    for (const double x : {a.high, a.low}) {
        for (const double y : {b.high, b.low}) {
            if (x == 0 || y == 0) continue;
            const auto [high, low] = exactProduct(x, y);
            sum.add(sign * high);
            sum.add(sign * low);
        }
    }
}

void addProduct(ExactSum& sum, const TwoTerms& a, const TwoTerms& b, const TwoTerms& c, double sign) {
    for (const double x : {a.high, a.low}) {
        for (const double y : {b.high, b.low}) {
            if (x == 0 || y == 0) continue;
            const auto [high, low] = exactProduct(x, y);
            addProduct(sum, {high, low}, c, sign);
        }
    }
}

}  // namespace

int ExactPlane::exactSideOf(const Vec3f& d) const {
    const ExactVector u = difference(corner_[1], corner_[0]);
    const ExactVector v = difference(corner_[2], corner_[0]);
    const ExactVector w = difference(d, corner_[0]);
    ExactSum sum;
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3;
        const int k = (i + 2) % 3;
        addProduct(sum, u[i], v[j], w[k], 1);
        addProduct(sum, u[i], v[k], w[j], -1);
    }
    return sum.sign();
}

int crossProductSign(const Vec3f& a, const Vec3f& b, const Vec3f& c, const Vec3f& d, int axis) {
    TACTOOTH_ASSERT(axis >= 0 && axis < 3);
    const ExactVector u = difference(b, a);
    const ExactVector v = difference(d, c);
    const int j = (axis + 1) % 3;
    const int k = (axis + 2) % 3;
    ExactSum sum;
    addProduct(sum, u[j], v[k], 1);
    addProduct(sum, u[k], v[j], -1);
    return sum.sign();
}

}  // namespace tactooth
