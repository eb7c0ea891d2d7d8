// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/icons/line_icon.h"

#include <QApplication>
#include <QFile>
#include <QIconEngine>
#include <QPainter>
#include <QPalette>
#include <QSvgRenderer>
#include <utility>

#include "geometry/util/assert.h"

namespace tactooth {
namespace {

QByteArray drawing(const QString& name) {
    QFile file(":/" + name + ".svg");
    const bool isThere = file.open(QIODevice::ReadOnly);
    TACTOOTH_ASSERT(isThere);
    return isThere ? file.readAll() : QByteArray();
}

/// Draws with the palette of the moment, so that an icon outlives a change of the colours.
class LineIconEngine final : public QIconEngine {
public:
    explicit LineIconEngine(QByteArray lines) : lines_(std::move(lines)) {}

    void paint(QPainter* painter, const QRect& place, QIcon::Mode mode, QIcon::State) override {
        const QPalette::ColorGroup group = mode == QIcon::Disabled ? QPalette::Disabled : QPalette::Active;
        const QColor colour = QApplication::palette().color(group, QPalette::ButtonText);
        QSvgRenderer renderer(QByteArray(lines_).replace("#000000", colour.name().toLatin1()));
        renderer.setAspectRatioMode(Qt::KeepAspectRatio);
        renderer.render(painter, place);
    }
    QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override {
        QPixmap picture(size);
        picture.fill(Qt::transparent);
        QPainter painter(&picture);
        paint(&painter, {QPoint(0, 0), size}, mode, state);
        return picture;
    }
    [[nodiscard]] QIconEngine* clone() const override { return new LineIconEngine(lines_); }

private:
    QByteArray lines_;  // SVG, drawn in black
};

}  // namespace

QIcon lineIcon(const char* name) { return QIcon(new LineIconEngine(drawing(QString("icons/") + name))); }

void setLineIcon(QAction& action, const char* name) {
    action.setIcon(lineIcon(name));
    action.setIconVisibleInMenu(!action.isCheckable());
}

/// As pixels, which every desktop takes.
QIcon programIcon() {
    QSvgRenderer renderer(drawing("tactooth"));
    QIcon icon;
    for (const int size : {16, 24, 32, 48, 64, 128, 256}) {
        QPixmap picture(size, size);
        picture.fill(Qt::transparent);
        QPainter painter(&picture);
        renderer.render(&painter);
        painter.end();
        icon.addPixmap(picture);
    }
    return icon;
}

}  // namespace tactooth
