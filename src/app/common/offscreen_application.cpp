// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/common/offscreen_application.h"

#include <QApplication>
#include <QBuffer>
#include <QImage>
#include <cstdio>
#include <span>

#include "app/common/messages.h"
#include "geometry/files/atomic_file.h"
#include "geometry/files/file_bytes.h"

namespace tactooth {
namespace {

/// Forwards Qt's messages, except the one about a missing XDG_RUNTIME_DIR, which pictures do not need.
void passOnMessages(QtMsgType, const QMessageLogContext&, const QString& text) {
    if (!text.startsWith("QStandardPaths: XDG_RUNTIME_DIR")) std::fprintf(stderr, "%s\n", qPrintable(text));
}

Expected<void> save(const QImage& image, const char* format, int quality, const std::filesystem::path& path) {
    QByteArray encoded;
    QBuffer buffer(&encoded);
    buffer.open(QIODevice::WriteOnly);
    if (!image.save(&buffer, format, quality)) {
        return unexpected(msg::kPlotTooLarge, displayName(path));
    }
    return writeFile(path, std::as_bytes(std::span(encoded.constData(), static_cast<std::size_t>(encoded.size()))));
}

}  // namespace

OffscreenApplication::OffscreenApplication() {
    if (QCoreApplication::instance() != nullptr) return;
    static int argc = 1;  // Qt keeps references to both
    static char name[] = "tactooth";
    static char* argv[] = {name, nullptr};
    qputenv("QT_QPA_PLATFORM", "offscreen");
    qInstallMessageHandler(passOnMessages);
    application_ = std::make_unique<QApplication>(argc, argv);
}

OffscreenApplication::~OffscreenApplication() = default;

Expected<void> savePng(const QImage& image, const std::filesystem::path& path) { return save(image, "PNG", -1, path); }

Expected<void> saveJpeg(const QImage& image, const std::filesystem::path& path) {
    constexpr int kQuality = 88;  // of 100: no fringes beside the edges of a cavity
    return save(image, "JPG", kQuality, path);
}

}  // namespace tactooth
