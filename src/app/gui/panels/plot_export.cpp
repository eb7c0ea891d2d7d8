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
#include "geometry/files/atomic_file.h"
#include "session/io/csv_table.h"

namespace tactooth {
namespace {

constexpr std::array<std::string_view, 5> kColumns = {"t", "depth", "speed", "force", "cavity_depth"};

Expected<void> writeTable(const TickTrace& trace, const std::filesystem::path& file) {
    auto table = CsvWriter::create(file, kColumns);
    if (!table) return Unexpected{table.error()};
    for (const TickTrace::Point& point : trace.points()) {
        table->row(std::array{point.time, point.depth, point.speed, point.force, point.cavityDepth});
    }
    return table->commit();
}

Expected<void> writeDrawing(QWidget& plots, const std::filesystem::path& file) {
    QByteArray text;
    QBuffer buffer(&text);
    QSvgGenerator generator;
    generator.setOutputDevice(&buffer);
    generator.setSize(plots.size());
    generator.setViewBox(plots.rect());
    generator.setTitle("Tactooth");
    {
        QPainter painter(&generator);
        plots.render(&painter);
    }
    return writeFile(file, std::as_bytes(std::span(text.constData(), static_cast<std::size_t>(text.size()))));
}

/// At twice the resolution of the screen, for print.
Expected<void> writePicture(QWidget& plots, const std::filesystem::path& file) {
    constexpr int kFiner = 2;
    QImage image(plots.size() * kFiner, QImage::Format_RGB32);
    image.setDevicePixelRatio(kFiner);
    plots.render(&image);
    return savePng(image, file);
}

}  // namespace

Expected<void> exportPlots(const TickTrace& trace, QWidget& plots, const std::filesystem::path& file) {
    const QString ending = QString::fromStdString(file.extension().string()).toLower();
    if (ending == ".csv") return writeTable(trace, file);
    if (ending == ".svg") return writeDrawing(plots, file);
    if (ending == ".png") return writePicture(plots, file);
    return unexpected(msg::kPlotFormatUnknown, file.string());
}

}  // namespace tactooth
