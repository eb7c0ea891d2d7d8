// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/text/import_note_translation.h"

#include <QCoreApplication>
#include <algorithm>
#include <iterator>
#include <string_view>

#include "app/gui/text/term_translation.h"

namespace tactooth {
namespace {

constexpr const char* kImportNotes[] = {
    QT_TRANSLATE_NOOP("Remarks",
                      "Units taken as %1, because the longest side would be %2 mm, as that of a whole tooth."),
    QT_TRANSLATE_NOOP("Remarks", "Units taken as %1, because the longest side would be %2 mm, as that of a crown."),
    QT_TRANSLATE_NOOP(
        "Remarks",
        "No unit of length makes this a tooth (longest side %1): scaled by %2 to the %3 mm of an average tooth."),
    QT_TRANSLATE_NOOP("Remarks", "There is one layer: its surface is the tooth's."),
    QT_TRANSLATE_NOOP("Remarks",
                      "The outer surface was welded from the layers: vertices within %1 mm became one, and faces in "
                      "common fell away."),
    QT_TRANSLATE_NOOP("Remarks",
                      "The layers do not fit within %1 mm: the outer surface was made anew around all of them, with "
                      "triangles of %2 mm."),
    QT_TRANSLATE_NOOP("Remarks", "The surface is about as long as wide: +z of the file is taken as the crown's side."),
    QT_TRANSLATE_NOOP("Remarks", "The crown is where the enamel is."),
    QT_TRANSLATE_NOOP("Remarks", "The thicker end of the long axis is taken as the crown."),
    QT_TRANSLATE_NOOP("Remarks", "The cheek's side is the one that looks away from the middle of the arch."),
    QT_TRANSLATE_NOOP("Remarks",
                      "It stands crown up as it came (%1 degrees from +z): its axes are kept, with the cheek at +y."),
    QT_TRANSLATE_NOOP("Remarks",
                      "Turned by %1 degrees to stand crown up; the cheek's side cannot be seen from one surface and is "
                      "taken to be +y of the file."),
    QT_TRANSLATE_NOOP("Remarks", "Turned upside down, as chosen."),
    QT_TRANSLATE_NOOP("Remarks", "Turned by %1 degrees about the long axis, as chosen."),
    QT_TRANSLATE_NOOP("Remarks", "Scaled by %1, as chosen: the longest side is %2 mm."),
    QT_TRANSLATE_NOOP("Remarks", "%1: %2 empty or doubled triangles were dropped."),
    QT_TRANSLATE_NOOP("Remarks", "%1: %2 corners that differ in their last digits were welded, within %3 mm."),
    QT_TRANSLATE_NOOP("Remarks", "%1: %2 triangles that are stored twice, or lie back to back, were dropped."),
    QT_TRANSLATE_NOOP("Remarks", "%1: %2 specks beside the surface were dropped."),
    QT_TRANSLATE_NOOP("Remarks", "%1: %2 triangles were turned, so that all look at the outside."),
    QT_TRANSLATE_NOOP("Remarks", "%1: %2 shells lie within another one and are taken as the walls of hollows."),
    QT_TRANSLATE_NOOP("Remarks", "%1: %2 triangles cross others by %3 mm at most; they are left as they are."),
    QT_TRANSLATE_NOOP("Remarks", "%1: %2 crumbs beside the surface were dropped."),
    QT_TRANSLATE_NOOP("Remarks", "%1: %2 triangles were turned to look outward."),
    QT_TRANSLATE_NOOP("Remarks", "%1: %2 holes were filled, the largest with a rim of %3 mm."),
    QT_TRANSLATE_NOOP("Remarks", "%1: closed and sound as it came, %2 triangles."),
    QT_TRANSLATE_NOOP("Remarks", "%1: consists of %2 separate shells."),
    QT_TRANSLATE_NOOP("Remarks", "%1: line %2 was not understood and passed over; it begins with %3."),
    QT_TRANSLATE_NOOP("Remarks",
                      "%1: %2 lines were not understood and passed over; the first is line %3, which begins with %4."),
    QT_TRANSLATE_NOOP("Remarks",
                      "%1: the surface lies too far from zero for single precision: %2, %3, %4 were subtracted from "
                      "its coordinates before they were rounded."),
    QT_TRANSLATE_NOOP("Remarks", "The whole tooth is taken as enamel, as chosen."),
    QT_TRANSLATE_NOOP("Remarks", "No enamel is given: what no other layer holds is taken as enamel."),
    QT_TRANSLATE_NOOP("Remarks",
                      "Only the outer surface is known: enamel and dentin are a model, with enamel up to %1 mm thick "
                      "that thins to nothing at the neck. They are no measurement of this tooth."),
    QT_TRANSLATE_NOOP("Remarks", "The pulp is a model, too: a chamber at the neck and a canal down each root."),
    QT_TRANSLATE_NOOP("Remarks", "There is no room for a pulp: the tooth has none."),
    QT_TRANSLATE_NOOP("Remarks", "The surface encloses a hollow: it is taken as the pulp space, which is empty."),
    QT_TRANSLATE_NOOP(
        "Remarks",
        "The material '%1' of this tooth is not known here: it is felt, cut, seen and heard as bone. Give "
        "the file of its materials (--materials)."),
};

}  // namespace

bool isKnown(const ImportNote& importNote) {
    return std::any_of(std::begin(kImportNotes), std::end(kImportNotes),
                       [&](const char* each) { return std::string_view(each) == importNote.text; });
}

QString translated(const ImportNote& importNote) {
    QString sentence = QCoreApplication::translate("Remarks", importNote.text);
    int place = 1;
    for (const std::string& value : importNote.values) {
        sentence.replace("%" + QString::number(place++), translated(std::string_view(value)));
    }
    return sentence;
}

}  // namespace tactooth
