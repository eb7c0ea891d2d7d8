// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QImage>
#include <QPainter>
#include <QString>
#include <QStringList>
#include <string>
#include <vector>

namespace tactooth {

/// The paper of PdfPages: A4, one page after the other.
class PageTarget {
public:
    static constexpr double kMargin = 14;    ///< mm, around the printable area
    static constexpr int kResolution = 600;  ///< dots per inch in which the pages are laid out

    PageTarget() = default;
    PageTarget(const PageTarget&) = delete;
    PageTarget& operator=(const PageTarget&) = delete;
    virtual ~PageTarget() = default;
    /// Begins the first page, or ends the one before and begins the next. The origin of the painter is the upper left
    /// corner of the printable area, and its unit is a dot.
    virtual void beginPage(QPainter& painter) = 0;
};

/// Pages A4 that fill from the top. All lengths in mm, from the upper left corner of the printable area.
class PdfPages {
public:
    static constexpr double kWidth = 182, kHeight = 262;  ///< of the printable area, above the footer
    static constexpr QColor kInk{29, 39, 48}, kFaint{85, 99, 111};

    struct Font {
        double points = 9;
        bool isBold = false;
        QColor colour = kInk;
    };
    struct Column {
        double width = 0;
        Qt::Alignment align = Qt::AlignLeft;
    };
    /// A line of a table; a bar as long as `share` of its column may stand in one of them, below its text if it has
    /// one.
    struct Row {
        QStringList cells;
        Font font;
        int barColumn = -1;
        double share = 0;  ///< 0 to 1
        QColor barColour = {};
        double gap = 0.7;  ///< mm above and below the text
    };

    /// `footer`: stands on each page, with its number. The target outlives the pages. `family`: of the font.
    PdfPages(PageTarget& target, const QString& footer, const QString& family = QStringLiteral("Noto Sans"));
    PdfPages(const PdfPages&) = delete;
    PdfPages& operator=(const PdfPages&) = delete;
    ~PdfPages() = default;

    [[nodiscard]] double y() const { return y_; }
    void skip(double height) { y_ += height; }
    void beginPage();
    /// A heading over what takes `following` mm, on the same page as that.
    void heading(const QString& text, double following);
    /// A text of several lines, `width` mm wide at most.
    void paragraph(const QString& text, const Font& font, double width = kWidth);
    /// A text in a box, without moving on.
    void text(const QRectF& box, const QString& text, const Font& font, Qt::Alignment align);
    void frame(const QRectF& box, const QColor& colour);
    void row(const std::vector<Column>& columns, const Row& row);
    /// How much a row or a text that is so wide takes.
    [[nodiscard]] double heightOf(const std::vector<Column>& columns, const Row& row);
    [[nodiscard]] double heightOf(const QString& text, const Font& font, double width = kWidth);
    /// Drawings (SVG) of one size side by side, each with its title below; an empty title takes no room.
    struct Drawing {
        QString title;
        std::string svg;
        double width, height;
    };
    void drawings(const std::vector<Drawing>& drawings);
    /// Pictures of this width, `perRow` side by side, each with its title below.
    void pictures(const std::vector<std::pair<QString, QImage>>& pictures, double width, std::size_t perRow);

private:
    [[nodiscard]] QRectF dots(const QRectF& box) const;
    void use(const Font& font);
    void drawFooter();
    void makeRoom(double height);

    PageTarget& target_;
    QPainter painter_;
    QString footer_, family_;
    double y_ = 0;
    int page_ = 1;
};

}  // namespace tactooth
