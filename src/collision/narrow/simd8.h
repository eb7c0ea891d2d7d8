// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Eight floats side by side: the only file with vector intrinsics. AVX2, SSE2 and plain C++ give the same bits: every
// operation is a single correctly rounded IEEE operation, and none is fused.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#if !defined(TACTOOTH_SIMD_SCALAR) && defined(__AVX2__)
#define TACTOOTH_SIMD_AVX2
#include <immintrin.h>
#elif !defined(TACTOOTH_SIMD_SCALAR) && defined(__SSE2__)
#define TACTOOTH_SIMD_SSE2
#include <emmintrin.h>
#endif

namespace tactooth {

#if defined(TACTOOTH_SIMD_AVX2)

struct Float8 {
    __m256 lanes;

    static Float8 load(const float* p) { return {_mm256_loadu_ps(p)}; }
    /// Lanes 0-3 from `low`, lanes 4-7 from `high`.
    static Float8 load(const float* low, const float* high) { return {_mm256_loadu2_m128(high, low)}; }
    /// Eight pairs of integers: the first of each pair, and the second.
    static std::array<Float8, 2> loadPairs(const std::int16_t* p) {
        const __m256i pairs = _mm256_loadu_si256(reinterpret_cast<const __m256i*>(p));
        return {Float8{_mm256_cvtepi32_ps(_mm256_srai_epi32(_mm256_slli_epi32(pairs, 16), 16))},
                Float8{_mm256_cvtepi32_ps(_mm256_srai_epi32(pairs, 16))}};
    }
    static Float8 all(float value) { return {_mm256_set1_ps(value)}; }
    void store(float* p) const { _mm256_storeu_ps(p, lanes); }

    friend Float8 operator+(Float8 a, Float8 b) { return {_mm256_add_ps(a.lanes, b.lanes)}; }
    friend Float8 operator-(Float8 a, Float8 b) { return {_mm256_sub_ps(a.lanes, b.lanes)}; }
    friend Float8 operator*(Float8 a, Float8 b) { return {_mm256_mul_ps(a.lanes, b.lanes)}; }
    friend Float8 operator/(Float8 a, Float8 b) { return {_mm256_div_ps(a.lanes, b.lanes)}; }
    friend Float8 min(Float8 a, Float8 b) { return {_mm256_min_ps(a.lanes, b.lanes)}; }
    friend Float8 max(Float8 a, Float8 b) { return {_mm256_max_ps(a.lanes, b.lanes)}; }
    friend Float8 sqrt(Float8 a) { return {_mm256_sqrt_ps(a.lanes)}; }
    /// One bit a lane: a <= b (false where either is NaN).
    friend std::uint32_t lessEqual(Float8 a, Float8 b) {
        return static_cast<std::uint32_t>(_mm256_movemask_ps(_mm256_cmp_ps(a.lanes, b.lanes, _CMP_LE_OQ)));
    }
    /// Lane by lane: a < b ? yes : no.
    friend Float8 whereLess(Float8 a, Float8 b, Float8 yes, Float8 no) {
        return {_mm256_blendv_ps(no.lanes, yes.lanes, _mm256_cmp_ps(a.lanes, b.lanes, _CMP_LT_OQ))};
    }
    /// The least of the lanes.
    friend float lowest(Float8 a) {
        const __m128 four = _mm_min_ps(_mm256_castps256_ps128(a.lanes), _mm256_extractf128_ps(a.lanes, 1));
        const __m128 two = _mm_min_ps(four, _mm_movehl_ps(four, four));
        return _mm_cvtss_f32(_mm_min_ss(two, _mm_shuffle_ps(two, two, 1)));
    }
    /// The greatest of the lanes.
    friend float highest(Float8 a) {
        const __m128 four = _mm_max_ps(_mm256_castps256_ps128(a.lanes), _mm256_extractf128_ps(a.lanes, 1));
        const __m128 two = _mm_max_ps(four, _mm_movehl_ps(four, four));
        return _mm_cvtss_f32(_mm_max_ss(two, _mm_shuffle_ps(two, two, 1)));
    }
    /// Reads four numbers from the address of each lane: returns the first number of all lanes, the second, and so on.
    static std::array<Float8, 4> loadFours(const std::array<const float*, 8>& p) {
        const __m256 a = load(p[0], p[4]).lanes;
        const __m256 b = load(p[1], p[5]).lanes;
        const __m256 c = load(p[2], p[6]).lanes;
        const __m256 d = load(p[3], p[7]).lanes;
        const __m256 lowAb = _mm256_unpacklo_ps(a, b);
        const __m256 lowCd = _mm256_unpacklo_ps(c, d);
        const __m256 highAb = _mm256_unpackhi_ps(a, b);
        const __m256 highCd = _mm256_unpackhi_ps(c, d);
        return {Float8{_mm256_shuffle_ps(lowAb, lowCd, 0x44)}, Float8{_mm256_shuffle_ps(lowAb, lowCd, 0xEE)},
                Float8{_mm256_shuffle_ps(highAb, highCd, 0x44)}, Float8{_mm256_shuffle_ps(highAb, highCd, 0xEE)}};
    }
};

#elif defined(TACTOOTH_SIMD_SSE2)

struct Float8 {
    __m128 low, high;

    static Float8 load(const float* p) { return {_mm_loadu_ps(p), _mm_loadu_ps(p + 4)}; }
    static Float8 load(const float* low, const float* high) { return {_mm_loadu_ps(low), _mm_loadu_ps(high)}; }
    static std::array<Float8, 2> loadPairs(const std::int16_t* p) {
        const __m128i four = _mm_loadu_si128(reinterpret_cast<const __m128i*>(p));
        const __m128i next = _mm_loadu_si128(reinterpret_cast<const __m128i*>(p + 8));
        const auto first = [](__m128i pairs) { return _mm_cvtepi32_ps(_mm_srai_epi32(_mm_slli_epi32(pairs, 16), 16)); };
        const auto second = [](__m128i pairs) { return _mm_cvtepi32_ps(_mm_srai_epi32(pairs, 16)); };
        return {Float8{first(four), first(next)}, Float8{second(four), second(next)}};
    }
    static Float8 all(float value) { return {_mm_set1_ps(value), _mm_set1_ps(value)}; }
    void store(float* p) const { _mm_storeu_ps(p, low), _mm_storeu_ps(p + 4, high); }

    friend Float8 operator+(Float8 a, Float8 b) { return {_mm_add_ps(a.low, b.low), _mm_add_ps(a.high, b.high)}; }
    friend Float8 operator-(Float8 a, Float8 b) { return {_mm_sub_ps(a.low, b.low), _mm_sub_ps(a.high, b.high)}; }
    friend Float8 operator*(Float8 a, Float8 b) { return {_mm_mul_ps(a.low, b.low), _mm_mul_ps(a.high, b.high)}; }
    friend Float8 operator/(Float8 a, Float8 b) { return {_mm_div_ps(a.low, b.low), _mm_div_ps(a.high, b.high)}; }
    friend Float8 min(Float8 a, Float8 b) { return {_mm_min_ps(a.low, b.low), _mm_min_ps(a.high, b.high)}; }
    friend Float8 max(Float8 a, Float8 b) { return {_mm_max_ps(a.low, b.low), _mm_max_ps(a.high, b.high)}; }
    friend Float8 sqrt(Float8 a) { return {_mm_sqrt_ps(a.low), _mm_sqrt_ps(a.high)}; }
    friend std::uint32_t lessEqual(Float8 a, Float8 b) {
        return static_cast<std::uint32_t>(_mm_movemask_ps(_mm_cmple_ps(a.low, b.low))) |
               static_cast<std::uint32_t>(_mm_movemask_ps(_mm_cmple_ps(a.high, b.high))) << 4;
    }
    friend Float8 whereLess(Float8 a, Float8 b, Float8 yes, Float8 no) {
        const auto half = [](__m128 x, __m128 y, __m128 ifLess, __m128 otherwise) {
            const __m128 less = _mm_cmplt_ps(x, y);
            return _mm_or_ps(_mm_and_ps(less, ifLess), _mm_andnot_ps(less, otherwise));
        };
        return {half(a.low, b.low, yes.low, no.low), half(a.high, b.high, yes.high, no.high)};
    }
    friend float lowest(Float8 a) {
        const __m128 four = _mm_min_ps(a.low, a.high);
        const __m128 two = _mm_min_ps(four, _mm_movehl_ps(four, four));
        return _mm_cvtss_f32(_mm_min_ss(two, _mm_shuffle_ps(two, two, 1)));
    }
    friend float highest(Float8 a) {
        const __m128 four = _mm_max_ps(a.low, a.high);
        const __m128 two = _mm_max_ps(four, _mm_movehl_ps(four, four));
        return _mm_cvtss_f32(_mm_max_ss(two, _mm_shuffle_ps(two, two, 1)));
    }
    static std::array<Float8, 4> loadFours(const std::array<const float*, 8>& p) {
        __m128 low[4], high[4];
        for (int i = 0; i < 4; ++i) low[i] = _mm_loadu_ps(p[i]), high[i] = _mm_loadu_ps(p[i + 4]);
        _MM_TRANSPOSE4_PS(low[0], low[1], low[2], low[3]);
        _MM_TRANSPOSE4_PS(high[0], high[1], high[2], high[3]);
        return {Float8{low[0], high[0]}, Float8{low[1], high[1]}, Float8{low[2], high[2]}, Float8{low[3], high[3]}};
    }
};

#else

struct Float8 {
    float lanes[8];

    template <class Operation>
    static Float8 each(Operation operation) {
        Float8 result;
        for (int i = 0; i < 8; ++i) result.lanes[i] = operation(i);
        return result;
    }
    static Float8 load(const float* p) {
        return each([&](int i) { return p[i]; });
    }
    static Float8 load(const float* low, const float* high) {
        return each([&](int i) { return i < 4 ? low[i] : high[i - 4]; });
    }
    static std::array<Float8, 2> loadPairs(const std::int16_t* p) {
        return {each([&](int i) { return static_cast<float>(p[2 * i]); }),
                each([&](int i) { return static_cast<float>(p[2 * i + 1]); })};
    }
    static Float8 all(float value) {
        return each([&](int) { return value; });
    }
    void store(float* p) const { std::copy(lanes, lanes + 8, p); }

    friend Float8 operator+(const Float8& a, const Float8& b) {
        return each([&](int i) { return a.lanes[i] + b.lanes[i]; });
    }
    friend Float8 operator-(const Float8& a, const Float8& b) {
        return each([&](int i) { return a.lanes[i] - b.lanes[i]; });
    }
    friend Float8 operator*(const Float8& a, const Float8& b) {
        return each([&](int i) { return a.lanes[i] * b.lanes[i]; });
    }
    friend Float8 operator/(const Float8& a, const Float8& b) {
        return each([&](int i) { return a.lanes[i] / b.lanes[i]; });
    }
    // Where one operand is NaN, the vector instructions return the second one. So do these.
    friend Float8 min(const Float8& a, const Float8& b) {
        return each([&](int i) { return a.lanes[i] < b.lanes[i] ? a.lanes[i] : b.lanes[i]; });
    }
    friend Float8 max(const Float8& a, const Float8& b) {
        return each([&](int i) { return a.lanes[i] > b.lanes[i] ? a.lanes[i] : b.lanes[i]; });
    }
    friend Float8 sqrt(const Float8& a) {
        return each([&](int i) { return std::sqrt(a.lanes[i]); });
    }
    friend std::uint32_t lessEqual(const Float8& a, const Float8& b) {
        std::uint32_t mask = 0;
        for (int i = 0; i < 8; ++i) mask |= static_cast<std::uint32_t>(a.lanes[i] <= b.lanes[i]) << i;
        return mask;
    }
    friend Float8 whereLess(const Float8& a, const Float8& b, const Float8& yes, const Float8& no) {
        return each([&](int i) { return a.lanes[i] < b.lanes[i] ? yes.lanes[i] : no.lanes[i]; });
    }
    friend float lowest(const Float8& a) { return *std::min_element(a.lanes, a.lanes + 8); }
    friend float highest(const Float8& a) { return *std::max_element(a.lanes, a.lanes + 8); }
    static std::array<Float8, 4> loadFours(const std::array<const float*, 8>& p) {
        std::array<Float8, 4> fours;
        for (int number = 0; number < 4; ++number) fours[number] = each([&](int i) { return p[i][number]; });
        return fours;
    }
};

#endif

/// Eight points or directions.
struct Vec3x8 {
    Float8 x, y, z;

    static Vec3x8 load(const float (*p)[8]) { return {Float8::load(p[0]), Float8::load(p[1]), Float8::load(p[2])}; }
    static Vec3x8 all(float x, float y, float z) { return {Float8::all(x), Float8::all(y), Float8::all(z)}; }
    void store(float (*p)[8]) const { x.store(p[0]), y.store(p[1]), z.store(p[2]); }

    friend Vec3x8 operator+(const Vec3x8& a, const Vec3x8& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
    friend Vec3x8 operator-(const Vec3x8& a, const Vec3x8& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
    friend Vec3x8 operator*(const Vec3x8& a, Float8 scale) { return {a.x * scale, a.y * scale, a.z * scale}; }
    friend Float8 dot(const Vec3x8& a, const Vec3x8& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
    /// Adds the three products in the order in which Eigen does.
    friend Float8 dotAsEigen(const Vec3x8& a, const Vec3x8& b) { return a.x * b.x + (a.y * b.y + a.z * b.z); }
    friend Vec3x8 cross(const Vec3x8& a, const Vec3x8& b) {
        return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
    }
    friend Vec3x8 min(const Vec3x8& a, const Vec3x8& b) { return {min(a.x, b.x), min(a.y, b.y), min(a.z, b.z)}; }
    friend Vec3x8 max(const Vec3x8& a, const Vec3x8& b) { return {max(a.x, b.x), max(a.y, b.y), max(a.z, b.z)}; }
};

}  // namespace tactooth
