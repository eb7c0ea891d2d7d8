// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/panels/plot_export.h"

#include <QBuffer>
#include <QImage>
#include <QPainter>
#include <QSvgGenerator>
#include <QWidget>
#include <array>
#include <span>

#include "app/common/offscreen_application.h"
#include "app/gui/text/messages.h"
#include "session/io/csv_table.h"

namespace tactooth {
namespace {

constexpr std::array<std::string_view, 5> kColumns = {"t", "depth", "speed", "force", "cavity_depth"};

/// The file is written at once: it has some hundred lines, or one picture.
Expected<bool> isDone(const Expected<void>& written) {
    if (!written) return Unexpected{written.error()};
    return true;
}

Expected<bool> writeTable(const TickTrace& trace, const std::filesystem::path& file) {
    auto table = CsvWriter::create(file, kColumns);
    if (!table) return Unexpected{table.error()};
    for (const TickTrace::Point& point : trace.points()) {
        table->row(std::array{point.time, point.depth, point.speed, point.force, point.cavityDepth});
    }
    return isDone(table->commit());
}

QByteArray drawingOf(QWidget& plots) {
    QByteArray text;
    QBuffer buffer(&text);
    QSvgGenerator generator;
    generator.setOutputDevice(&buffer);
    generator.setSize(plots.size());
    generator.setViewBox(plots.rect());
    generator.setTitle("Tactooth");
    QPainter painter(&generator);
    plots.render(&painter);
    painter.end();
    return text;
}

/// At twice the resolution of the screen, for print.
QImage pictureOf(QWidget& plots) {
    constexpr int kFiner = 2;
    QImage image(plots.size() * kFiner, QImage::Format_RGB32);
    image.setDevicePixelRatio(kFiner);
    plots.render(&image);
    return image;
}

}  // namespace

FileWriter::Write plotsExport(const TickTrace& trace, QWidget& plots, const std::filesystem::path& file) {
    const QString ending = QString::fromStdString(file.extension().string()).toLower();
    if (ending == ".csv") return [trace, file](const GoesOn&) { return writeTable(trace, file); };
    if (ending == ".svg") {
        return [text = drawingOf(plots), file](const GoesOn& goesOn) {
            const std::span bytes(text.constData(), static_cast<std::size_t>(text.size()));
            return writeInPieces(file, std::as_bytes(bytes), goesOn);
        };
    }
    if (ending == ".png") {
        return [picture = pictureOf(plots), file](const GoesOn&) { return isDone(savePng(picture, file)); };
    }
    return [file](const GoesOn&) -> Expected<bool> { return unexpected(msg::kPlotFormatUnknown, file.string()); };
}

}  // namespace tactooth
