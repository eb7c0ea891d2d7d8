// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "assessment/report/report_section.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "assessment/messages.h"
#include "assessment/preparation/place_name.h"
#include "assessment/report/messages.h"
#include "assessment/report/svg_text.h"
#include "collision/bvh/closest_point.h"

namespace tactooth {
namespace {

constexpr double kAround = 1.2;     // mm of the tooth around the preparation
constexpr double kLeastHalf = 2.5;  // mm: half of the least width
constexpr double kAspect = 0.55;    // height to width
constexpr double kLegend = 8.5;     // mm below a drawing, on paper

/// The direction in words: "mesial".
std::string nameOf(const Vec3& direction, double mesialX, Language language) {
    if (std::abs(direction.z()) > 0.8) {
        return std::string((direction.z() > 0 ? msg::kPlaceOcclusal : msg::kPlaceGingival).in(language));
    }
    const DentalDirections fromAbove(Vec3::UnitZ(), mesialX);
    return std::string(placeName(5 * direction, Vec3::Zero(), fromAbove).in(language));
}

/// Whether a section shows how far `place` lies from the ideal surface. A section along a wall does not.
bool isSeenIn(const SectionPlane& plane, const Vec3& place, const SurfacePart& ideal) {
    const auto nearest = closestPoint(ideal, place);
    constexpr double kAcross = 0.5;  // cosine
    if (!nearest || !(nearest->distance > 0)) return false;
    return std::abs((nearest->point - place).dot(plane.normal())) < kAcross * nearest->distance;
}

ReportSection sectionIn(const SectionPlane& plane, const Preparation& preparation, const CutSurfaces& surfaces,
                        Language language) {
    ReportSection section;
    section.left = nameOf(-plane.right, preparation.mesialX, language);
    section.right = nameOf(plane.right, preparation.mesialX, language);
    Eigen::AlignedBox2d box;
    for (const TriangleMesh* mesh : {&surfaces.cut.mesh, &surfaces.idealCut.mesh}) {
        for (const SectionLine& line : planeSection(*mesh, plane)) {
            for (const Vec2& point : line.points) box.extend(point);
        }
    }
    if (box.isEmpty()) box.extend(Vec2(Vec2::Zero()));
    const Vec2 middle = box.center();
    Vec2 half = (box.sizes().array() / 2 + kAround).matrix();
    half.x() = std::max({half.x(), half.y() / kAspect, kLeastHalf});
    half.y() = kAspect * half.x();
    section.box = {middle - half, middle + half};
    const auto add = [&](const SurfacePart& part, std::vector<SectionLine>& lines) {
        for (SectionLine& line : planeSection(part.mesh(), plane)) lines.push_back(std::move(line));
    };
    add(*preparation.original, section.uncut);
    add(*preparation.prepared, section.prepared);
    add(*preparation.ideal, section.ideal);
    for (const auto& pulp : preparation.pulps) add(*pulp, section.pulp);
    return section;
}

/// Draws lines in mm on paper.
class Drawing {
public:
    Drawing(const ReportSection& section, double width) : section_(section), scale_(width / section.box.sizes().x()) {}

    /// What the lines enclose.
    [[nodiscard]] std::string filled(const std::vector<SectionLine>& lines, std::string_view colour) const {
        std::string path;
        for (const SectionLine& line : lines) {
            if (line.closed) path += pathOf({clipped(line.points, section_.box), true});
        }
        return fmt::format("<path d=\"{}\" fill=\"{}\" fill-rule=\"evenodd\" stroke=\"none\"/>\n", path, colour);
    }
    [[nodiscard]] std::string drawn(const std::vector<SectionLine>& lines, std::string_view style) const {
        std::string path;
        for (const SectionLine& line : lines) {
            for (const SectionLine& piece : piecesWithin(line, section_.box)) path += pathOf(piece);
        }
        return fmt::format("<path d=\"{}\" fill=\"none\" {}/>\n", path, style);
    }
    [[nodiscard]] double onPaper(double mm) const { return scale_ * mm; }

private:
    [[nodiscard]] std::string pathOf(const SectionLine& line) const {
        std::string path;
        for (std::size_t i = 0; i < line.points.size(); ++i) {
            const Vec2 from = line.points[i] - section_.box.min();
            const double x = scale_ * from.x(), y = scale_ * (section_.box.sizes().y() - from.y());
            path += fmt::format("{}{:.2f} {:.2f}", i == 0 ? "M" : "L", x, y);
        }
        return path.empty() || !line.closed ? path : path + "Z";
    }

    const ReportSection& section_;
    double scale_;  // paper to tooth
};

constexpr std::string_view kUncut = "stroke=\"#7b8894\" stroke-width=\"0.25\" stroke-dasharray=\"0.9 0.7\"";
constexpr std::string_view kPrepared = "stroke=\"#1d2730\" stroke-width=\"0.35\"";
constexpr std::string_view kIdeal = "stroke=\"#1c66b8\" stroke-width=\"0.35\"";
constexpr std::string_view kPulp = "stroke=\"#b23a24\" stroke-width=\"0.25\"";

/// What the lines mean, from `x` on.
std::string legend(double y, bool hasPulp, Language language) {
    std::string legend;
    double x = 0;
    const auto add = [&](std::string_view style, const MessageText& words, double width) {
        legend += svgLine(x, y - 0.9, x + 5, y - 0.9, style);
        legend += svgText(x + 6, y, "start", words.in(language));
        x += width;
    };
    add(kPrepared, msg::kLinePrepared, 21);
    add(kIdeal, msg::kLineIdeal, 16);
    add(kUncut, msg::kLineUncut, 17);
    if (hasPulp) add(kPulp, msg::kLinePulp, 15);
    return legend;
}

}  // namespace

std::vector<ReportSection> reportSections(const Preparation& preparation, const CutSurfaces& surfaces,
                                          const std::optional<Vec3>& worst, Language language) {
    const DentalDirections to(preparation.axis, preparation.mesialX);
    const Vec3 along = to.hasMesial ? to.mesial : to.buccal;
    std::vector<ReportSection> sections;
    for (const Vec3& right : {along, Vec3(preparation.axis.cross(along))}) {
        SectionPlane plane{surfaces.middle, right, preparation.axis};
        if (worst && isSeenIn(plane, *worst, *preparation.ideal)) plane.origin = *worst;
        sections.push_back(sectionIn(plane, preparation, surfaces, language));
        ReportSection& section = sections.back();
        Message title(msg::kSectionFromTo, section.left, section.right);
        if (plane.origin != surfaces.middle) title = Message(msg::kSectionAtError, title);
        section.title = title.in(language);
    }
    return sections;
}

double sectionHeight(const ReportSection& section, double width) {
    return width * section.box.sizes().y() / section.box.sizes().x() + kLegend;
}

std::string sectionSvg(const ReportSection& section, double width, Language language) {
    const Drawing drawing(section, width);
    const double height = sectionHeight(section, width), bottom = height - kLegend;
    std::string svg = svgHead(width, height);
    svg += drawing.filled(section.prepared, "#f4ecd9") + drawing.filled(section.pulp, "#f3d9d4");
    svg += drawing.drawn(section.uncut, kUncut) + drawing.drawn(section.pulp, kPulp);
    svg += drawing.drawn(section.prepared, kPrepared) + drawing.drawn(section.ideal, kIdeal);
    const double row = bottom + 3.4, scaleBar = drawing.onPaper(1), middle = width / 2;
    svg += svgText(0, row, "start", section.left) + svgText(width, row, "end", section.right);
    svg += svgLine(middle - scaleBar, row - 0.9, middle, row - 0.9, "stroke=\"#1d2730\" stroke-width=\"0.5\"");
    svg += svgText(middle + 1, row, "start", "1 mm") + legend(row + 4, !section.pulp.empty(), language);
    return svg + "</svg>\n";
}

}  // namespace tactooth
