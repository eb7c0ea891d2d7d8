// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QImage>
#include <QScrollArea>
#include <QTimer>
#include <functional>
#include <vector>

namespace tactooth {

/// Pages of paper one below the other, as wide as the view, or larger. Arrow and page keys scroll, Ctrl and the wheel
/// enlarge.
class ReportPagesView final : public QScrollArea {
    Q_OBJECT

public:
    /// The pages, so many pixels wide.
    using Source = std::function<std::vector<QImage>(int width)>;
    explicit ReportPagesView(Source source, QWidget* parent = nullptr);

    [[nodiscard]] std::size_t pages() const { return pages_.size(); }
    /// 1: as wide as the view.
    [[nodiscard]] double zoom() const { return zoom_; }
    void zoomIn() { setZoom(zoom_ * kStep); }
    void zoomOut() { setZoom(zoom_ / kStep); }
    void fitWidth() { setZoom(1); }

protected:
    void resizeEvent(QResizeEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;

private:
    class Paper;
    static constexpr double kStep = 1.25;

    void setZoom(double zoom);
    void draw();

    Source source_;
    Paper* paper_;
    std::vector<QImage> pages_;
    QTimer later_;
    double zoom_ = 1;
    int drawnWidth_ = 0;  // pixels of the screen
};

}  // namespace tactooth
