// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/common/images/spectrogram_image.h"

#include <QImage>
#include <QPainter>
#include <algorithm>
#include <array>
#include <cmath>

#include "app/common/offscreen_application.h"
#include "sound/files/sound_format.h"

namespace tactooth {
namespace {

constexpr int kPlotWidth = static_cast<int>(kSpectrogramTimes), kPlotHeight = 512;  // pixels; a frequency per row
constexpr int kLeft = 70, kTop = 36, kBottom = 56, kLegend = 110;
constexpr float kLoudest = -20.0f, kFaintest = -100.0f;  // dB: black below kFaintest

/// From black over violet, red and yellow to white: louder is brighter, also in greyscale.
QColor colourOf(float level) {
    constexpr std::array<std::array<float, 3>, 6> kSteps{
        {{0, 0, 0}, {50, 15, 110}, {140, 35, 110}, {220, 80, 55}, {250, 170, 30}, {252, 255, 220}}};
    const float share = std::clamp((level - kFaintest) / (kLoudest - kFaintest), 0.0f, 1.0f);
    const float place = share * (kSteps.size() - 1);
    const auto step = std::min(static_cast<std::size_t>(place), kSteps.size() - 2);
    const float rest = place - static_cast<float>(step);
    const auto channel = [&](std::size_t i) {
        return static_cast<int>(std::lround(std::lerp(kSteps[step][i], kSteps[step + 1][i], rest)));
    };
    return {channel(0), channel(1), channel(2)};
}

QImage plotOf(const Spectrogram& spectrogram) {
    QImage plot(kPlotWidth, kPlotHeight, QImage::Format_RGB32);
    for (int x = 0; x < kPlotWidth; ++x) {
        for (int y = 0; y < kPlotHeight; ++y) {
            const auto bin = static_cast<std::size_t>(kPlotHeight - 1 - y) * spectrogram.bins / kPlotHeight;
            plot.setPixelColor(x, y, colourOf(spectrogram.at(static_cast<std::size_t>(x), bin)));
        }
    }
    return plot;
}

/// A round number (1, 2 or 5 times a power of ten) that divides `length` into four to ten parts.
double roundStep(double length) {
    const double power = std::pow(10, std::floor(std::log10(length / 4)));
    const double parts = length / 4 / power;
    return (parts >= 5 ? 5 : parts >= 2 ? 2 : 1) * power;
}

void drawTimes(QPainter& painter, double seconds) {
    const int bottom = kTop + kPlotHeight;
    const double step = roundStep(seconds);
    for (int i = 0; i * step <= seconds * 1.000001; ++i) {
        const int x = kLeft + static_cast<int>(std::lround(i * step / seconds * kPlotWidth));
        painter.drawLine(x, bottom, x, bottom + 5);
        painter.drawText(QRect(x - 40, bottom + 6, 80, 20), Qt::AlignHCenter, QString::number(i * step, 'g', 6));
    }
    painter.drawText(QRect(kLeft, bottom + 28, kPlotWidth, 22), Qt::AlignHCenter, "time, s");
}

void drawFrequencies(QPainter& painter) {
    constexpr int kKilohertz = kSoundRate / 2000;
    for (int kilohertz = 0; kilohertz <= kKilohertz; kilohertz += 4) {
        const int y = kTop + kPlotHeight - kilohertz * kPlotHeight / kKilohertz;
        painter.drawLine(kLeft - 5, y, kLeft, y);
        painter.drawText(QRect(0, y - 10, kLeft - 9, 20), Qt::AlignRight | Qt::AlignVCenter,
                         QString::number(kilohertz));
    }
    painter.drawText(QRect(6, 8, 300, 20), Qt::AlignLeft, "frequency, kHz");
}

void drawLegend(QPainter& painter) {
    const int x = kLeft + kPlotWidth + 24;
    const auto yOf = [](float level) {
        return kTop + static_cast<int>((kLoudest - level) / (kLoudest - kFaintest) * kPlotHeight);
    };
    for (int y = kTop; y < kTop + kPlotHeight; ++y) {
        const float share = static_cast<float>(y - kTop) / kPlotHeight;
        painter.fillRect(x, y, 16, 1, colourOf(std::lerp(kLoudest, kFaintest, share)));
    }
    for (float level = kLoudest; level >= kFaintest; level -= 20.0f) {
        painter.drawText(QRect(x + 22, yOf(level) - 10, 60, 20), Qt::AlignLeft | Qt::AlignVCenter,
                         QString::number(static_cast<double>(level)));
    }
    painter.drawText(QRect(x - 10, 8, 100, 20), Qt::AlignLeft, "dB of full scale");
}

}  // namespace

Expected<void> writeSpectrogram(const std::filesystem::path& path, const Spectrogram& spectrogram, double seconds) {
    const OffscreenApplication application;
    QImage image(kLeft + kPlotWidth + kLegend, kTop + kPlotHeight + kBottom, QImage::Format_RGB32);
    image.fill(Qt::white);
    QPainter painter(&image);
    painter.setRenderHint(QPainter::TextAntialiasing);
    painter.drawImage(kLeft, kTop, plotOf(spectrogram));
    drawTimes(painter, seconds);
    drawFrequencies(painter);
    drawLegend(painter);
    painter.end();
    return savePng(image, path);
}

}  // namespace tactooth
