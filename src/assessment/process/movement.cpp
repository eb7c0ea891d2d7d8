// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "assessment/process/movement.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <unsupported/Eigen/FFT>
#include <utility>

#include "geometry/util/assert.h"

namespace tactooth {
namespace {

/// |FFT| of the samples, filled up with zeros to `size`, from frequency 0 to half of the rate.
std::vector<double> amplitudes(std::span<const double> samples, std::size_t size) {
    std::vector<double> padded(samples.begin(), samples.end());
    padded.resize(size);
    std::vector<std::complex<double>> spectrum;
    Eigen::FFT<double> transform;
    transform.SetFlag(Eigen::FFT<double>::HalfSpectrum);
    transform.fwd(spectrum, padded);
    std::vector<double> result;
    for (const std::complex<double>& each : spectrum) result.push_back(std::abs(each));
    return result;
}

/// The power of two that is `levels` doublings above the least one that holds `count`.
std::size_t powerOfTwo(std::size_t count, int levels) {
    std::size_t size = 1;
    while (size < count) size *= 2;
    return size << levels;
}

/// A recursive filter of second order.
struct Biquad {
    double b0, b1, b2, a1, a2;

    static Biquad butterworth(double rate, double cutoff) {
        const double k = std::tan(std::numbers::pi * cutoff / rate);
        const double scale = 1 / (1 + std::numbers::sqrt2 * k + k * k);
        return {k * k * scale, 2 * k * k * scale, k * k * scale, 2 * (k * k - 1) * scale,
                (1 - std::numbers::sqrt2 * k + k * k) * scale};
    }
    /// In place, from the state in which the first sample has always been there.
    void run(std::vector<double>& samples) const {
        const double first = samples.front();
        double x1 = first, x2 = first, y1 = first, y2 = first;
        for (double& sample : samples) {
            const double y = b0 * sample + b1 * x1 + b2 * x2 - a1 * y1 - a2 * y2;
            x2 = std::exchange(x1, sample);
            y2 = std::exchange(y1, y);
            sample = y;
        }
    }
};

}  // namespace

std::optional<double> spectralArcLength(std::span<const double> speed, double rate) {
    constexpr double kHighest = 10, kLeast = 0.05;  // Hz; of the largest amplitude
    if (speed.size() < 4) return std::nullopt;
    const std::size_t size = powerOfTwo(speed.size(), 4);
    std::vector<double> amplitude = amplitudes(speed, size);
    const double largest = *std::ranges::max_element(amplitude);
    if (!(largest > 0)) return std::nullopt;
    for (double& each : amplitude) each /= largest;
    const auto highest = static_cast<std::size_t>(std::floor(kHighest / rate * static_cast<double>(size)));
    amplitude.resize(std::min(amplitude.size(), highest + 1));
    const auto isLarge = [](double each) { return each >= kLeast; };
    const auto first = std::ranges::find_if(amplitude, isLarge);
    const auto last = std::find_if(amplitude.rbegin(), amplitude.rend(), isLarge).base();
    if (last - first < 2) return std::nullopt;
    const double step = 1 / static_cast<double>(last - first - 1);
    double length = 0;
    for (auto each = first; each + 1 != last; ++each) length += std::hypot(step, each[1] - each[0]);
    return -length;
}

std::optional<double> logDimensionlessJerk(std::span<const double> speed, double rate) {
    if (speed.size() < 4) return std::nullopt;
    double peak = 0, squares = 0;
    for (const double each : speed) peak = std::max(peak, std::abs(each));
    for (std::size_t i = 1; i + 1 < speed.size(); ++i) {
        const double jerk = (speed[i + 1] - 2 * speed[i] + speed[i - 1]) * rate * rate;
        squares += jerk * jerk;
    }
    const double duration = static_cast<double>(speed.size()) / rate;
    const double jerk = peak > 0 ? duration * duration * duration / (peak * peak) * squares / rate : 0;
    if (!(jerk > 0)) return std::nullopt;
    return -std::log(jerk);
}

std::optional<double> frequency95(std::span<const double> speed, double rate) {
    constexpr double kShare = 0.95;
    if (speed.size() < 4) return std::nullopt;
    double mean = 0;
    for (const double each : speed) mean += each / static_cast<double>(speed.size());
    std::vector<double> swing;
    for (const double each : speed) swing.push_back(each - mean);
    const std::size_t size = powerOfTwo(speed.size(), 2);
    const std::vector<double> amplitude = amplitudes(swing, size);
    double power = 0;
    for (const double each : amplitude) power += each * each;
    if (!(power > 0)) return std::nullopt;
    double below = 0;
    std::size_t bin = 0;
    while (bin + 1 < amplitude.size()) {
        below += amplitude[bin] * amplitude[bin];
        if (below >= kShare * power) break;
        ++bin;
    }
    return static_cast<double>(bin) * rate / static_cast<double>(size);
}

std::vector<double> lowPassed(std::span<const double> samples, double rate, double cutoff) {
    TACTOOTH_ASSERT(cutoff < rate / 2);
    if (samples.size() < 2) return {samples.begin(), samples.end()};
    const auto settling = static_cast<std::size_t>(3 * rate / cutoff);
    const std::size_t around = std::min(samples.size() - 1, settling);
    std::vector<double> extended;
    extended.reserve(samples.size() + 2 * around);
    for (std::size_t i = around; i > 0; --i) extended.push_back(2 * samples.front() - samples[i]);
    extended.insert(extended.end(), samples.begin(), samples.end());
    for (std::size_t i = 1; i <= around; ++i) extended.push_back(2 * samples.back() - samples[samples.size() - 1 - i]);
    const Biquad filter = Biquad::butterworth(rate, cutoff);
    for (int direction = 0; direction < 2; ++direction) {
        filter.run(extended);
        std::ranges::reverse(extended);
    }
    const auto first = extended.begin() + static_cast<std::ptrdiff_t>(around);
    return {first, first + static_cast<std::ptrdiff_t>(samples.size())};
}

}  // namespace tactooth
