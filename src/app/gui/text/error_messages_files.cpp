// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QCoreApplication>

#include "app/gui/text/error_messages.h"

namespace tactooth {
namespace {

constexpr const char* kErrors[] = {
    // Files and folders.
    QT_TRANSLATE_NOOP("Error", "%1: there is no such file; check the name and the folder."),
    QT_TRANSLATE_NOOP("Error", "%1: this user may not read the file; change its permissions."),
    QT_TRANSLATE_NOOP("Error", "%1: the file cannot be opened: %2."),
    QT_TRANSLATE_NOOP("Error", "%1: reading stopped: %2."),
    QT_TRANSLATE_NOOP("Error", "%1: this is a folder; name a file inside it."),
    QT_TRANSLATE_NOOP("Error", "%1: this is not a regular file (a device or a pipe); name a file on disk."),
    QT_TRANSLATE_NOOP("Error", "%1: the file is empty; export or copy it again."),
    QT_TRANSLATE_NOOP("Error", "%1: the file (%2 bytes) does not fit into memory."),
    QT_TRANSLATE_NOOP(
        "Error",
        "%1 reaches %2 mm from its origin, farther than anything can be felt or cut (1 km): look for a stray "
        "corner, or check the unit"),
    QT_TRANSLATE_NOOP("Error", "the surface"),
    QT_TRANSLATE_NOOP("Error", "the surface of %1"),
    QT_TRANSLATE_NOOP(
        "Error",
        "%1: the file holds %2 bytes, and at most %3 are read of such a file; choose another or a smaller one."),
    QT_TRANSLATE_NOOP("Error",
                      "row %1 of the table has a number that is not finite, so nothing is written; check size and unit "
                      "of the surfaces."),
    QT_TRANSLATE_NOOP("Error",
                      "%1: the tool is farther than 10 m from the tooth's origin; x,y,z are in mm, so check the unit."),
    QT_TRANSLATE_NOOP("Error", "%1: t is beyond any clock's seconds; t is in s, so check the unit."),
    QT_TRANSLATE_NOOP("Error", "%1: cannot be written: its folder does not exist; make the folder first."),
    QT_TRANSLATE_NOOP("Error", "%1: cannot be written: this user may not write into its folder; choose another one."),
    QT_TRANSLATE_NOOP("Error", "%1: cannot be written: %2."),
    QT_TRANSLATE_NOOP("Error", "%1: cannot be written: this is a folder; name a file inside it."),
    QT_TRANSLATE_NOOP("Error", "%1: cannot be written: this is not a regular file; choose another name."),
    QT_TRANSLATE_NOOP("Error", "the plot %1 could not be drawn: it does not fit into memory."),
    QT_TRANSLATE_NOOP("Error", "the plots cannot be written to %1: end its name in .csv, .svg or .png."),
    QT_TRANSLATE_NOOP("Error", "%1: the folder cannot be read (%2)."),
    QT_TRANSLATE_NOOP("Error", "%1: the folder cannot be made (%2)."),
    QT_TRANSLATE_NOOP("Error", "No space left on device"),
    QT_TRANSLATE_NOOP("Error", "File too large"),
    QT_TRANSLATE_NOOP("Error", "Disk quota exceeded"),
    QT_TRANSLATE_NOOP("Error", "Permission denied"),
    QT_TRANSLATE_NOOP("Error", "Read-only file system"),
    QT_TRANSLATE_NOOP("Error", "Input/output error"),
    // Surfaces.
    QT_TRANSLATE_NOOP("Error", "%1: %2 files cannot be read; export the surface as STL, OBJ or PLY."),
    QT_TRANSLATE_NOOP("Error", "%1: the file holds no triangles; export the surface again."),
    QT_TRANSLATE_NOOP("Error", "%1: the file holds no faces; export the surface again, as triangles."),
    QT_TRANSLATE_NOOP("Error",
                      "%1: the surface lies too far from zero for single precision, in which its place is needed; move "
                      "it near to zero, or make a case of it with 'tactooth case new'."),
    QT_TRANSLATE_NOOP("Error", "%1: this is text in UTF-16; save it as UTF-8."),
    QT_TRANSLATE_NOOP(
        "Error",
        "%1: triangle %2 (byte %3) has a corner that is not a finite number; repair or export the surface again."),
    QT_TRANSLATE_NOOP("Error", "%1: this is %2, not an STL surface; export the surface as STL."),
    QT_TRANSLATE_NOOP("Error", "a PLY mesh"),
    QT_TRANSLATE_NOOP("Error", "a ZIP archive"),
    QT_TRANSLATE_NOOP("Error", "a gzip archive"),
    QT_TRANSLATE_NOOP("Error", "a PNG picture"),
    QT_TRANSLATE_NOOP("Error", "an OFF mesh"),
    QT_TRANSLATE_NOOP("Error", "a JPEG picture"),
    QT_TRANSLATE_NOOP("Error", "a PDF document"),
    QT_TRANSLATE_NOOP("Error", "a program"),
    QT_TRANSLATE_NOOP("Error", "a DICOM image"),
    QT_TRANSLATE_NOOP("Error", "a Mac's notes on a file of this name"),
    QT_TRANSLATE_NOOP("Error", "text that does not begin with 'solid'"),
    QT_TRANSLATE_NOOP("Error", "unknown binary data"),
    QT_TRANSLATE_NOOP(
        "Error",
        "%1: its header announces %2 triangles, which take %3 bytes, but the file has %4; export or copy it again."),
    QT_TRANSLATE_NOOP("Error", "the file is cut short or its count is wrong"),
    QT_TRANSLATE_NOOP("Error", "the file is longer than its triangle count says"),
    QT_TRANSLATE_NOOP("Error",
                      "%1: the file is too short for an STL surface: it has %2 bytes and a binary one needs at least "
                      "%3; export or copy it again."),
    QT_TRANSLATE_NOOP("Error", "%1, line %2: %3, but %4; repair or export the surface again."),
    QT_TRANSLATE_NOOP("Error", "expected 'solid' or the end of the file"),
    QT_TRANSLATE_NOOP("Error", "expected 'facet' or 'endsolid'"),
    QT_TRANSLATE_NOOP("Error", "expected the facet's normal"),
    QT_TRANSLATE_NOOP("Error", "expected a coordinate (a number with '.' as decimal point)"),
    QT_TRANSLATE_NOOP("Error", "expected a finite coordinate"),
    QT_TRANSLATE_NOOP("Error", "expected '%1'"),
    QT_TRANSLATE_NOOP("Error", "found %1"),
    QT_TRANSLATE_NOOP("Error", "the file ends: it is cut short"),
    QT_TRANSLATE_NOOP("Error", "%1, line %2: %3; repair or export the surface again."),
    QT_TRANSLATE_NOOP("Error", "expected a finite coordinate, but found %1"),
    QT_TRANSLATE_NOOP("Error", "expected the number of a vertex that the file has given above, but found %1"),
    QT_TRANSLATE_NOOP("Error", "expected a face of three corners or more"),
    QT_TRANSLATE_NOOP("Error", "%1: the PLY header names no format; export the surface again."),
    QT_TRANSLATE_NOOP("Error", "%1, line %2: expected a line of a PLY header, but found %3; export the surface again."),
    QT_TRANSLATE_NOOP("Error", "%1: the PLY header has no end: the file is cut short; export the surface again."),
    QT_TRANSLATE_NOOP("Error", "%1: %2; export the surface again."),
    QT_TRANSLATE_NOOP("Error", "the file holds no faces"),
    QT_TRANSLATE_NOOP("Error", "the outline of the face crosses itself"),
    QT_TRANSLATE_NOOP("Error", "the face has too many corners to be split into triangles"),
    QT_TRANSLATE_NOOP("Error", "the file is cut short, or holds what is no number"),
    QT_TRANSLATE_NOOP("Error", "x, y and z are not three finite numbers"),
    QT_TRANSLATE_NOOP("Error", "the file is cut short"),
    QT_TRANSLATE_NOOP("Error", "a list is longer than the file"),
    QT_TRANSLATE_NOOP("Error", "a corner names a vertex that the file does not have"),
    // Scans.
    QT_TRANSLATE_NOOP(
        "Error",
        "%1: the tooth has this surface already; drop the files of one tooth, its layers named as in L6_enamel.stl."),
    QT_TRANSLATE_NOOP("Error", "%1: there is no surface."),
    QT_TRANSLATE_NOOP("Error",
                      "the layers give no closed surface together; give the tooth's outer surface as a file, too"),
    QT_TRANSLATE_NOOP("Error",
                      "%1: the surface '%2' has %3 holes that are too wide to be filled unasked (%4 open edges); ask "
                      "for all holes to be filled, or close it in a mesh program."),
    // What is no solid.
    QT_TRANSLATE_NOOP("Error", "%1 is open (%2 edges without a neighbour), so it has no inside: close its holes first"),
    QT_TRANSLATE_NOOP("Error", "%1 holds no room: give a closed surface with triangles that have an area"),
    QT_TRANSLATE_NOOP("Error", "%1 is twisted: it has no outside; mend it in a mesh program"),
    QT_TRANSLATE_NOOP("Error",
                      "%1 has parts that reach into each other by %2 mm (%3 triangles cross), so what is inside is "
                      "unclear: unite them in a mesh program"),
    QT_TRANSLATE_NOOP("Error", "%1 bounds no body: its triangles cross each other nearly everywhere; export it again"),
    QT_TRANSLATE_NOOP("Error", "the surface '%1'"),
    QT_TRANSLATE_NOOP("Error", "the ideal shape, the whole tooth with its cavity,"),
    QT_TRANSLATE_NOOP("Error",
                      "%1: the surface '%2' cannot be closed (%3 open edges): walls meet inside it, or pieces hang "
                      "together with nothing; close it in a mesh program."),
    QT_TRANSLATE_NOOP(
        "Error",
        "%1: the surface '%2' crosses itself by %3 mm once its %4 holes are filled; close it in a mesh program."),
    // Teeth and burs.
    QT_TRANSLATE_NOOP("Error", "the surface of %1 holds no triangle: give a closed STL surface"),
    QT_TRANSLATE_NOOP(
        "Error",
        "the surface of %1 is open (%2 edges without a neighbour), so it has no inside to cut: close its holes first"),
    QT_TRANSLATE_NOOP(
        "Error",
        "the surface of %1 is inside out (its normals point inward): reverse the order of its triangles' corners"),
    QT_TRANSLATE_NOOP("Error", "%1 lies outside the tooth: give all layers in the frame of the outer surface"),
    QT_TRANSLATE_NOOP("Error", "%1 is given twice: give each layer of a tooth its own name"),
    QT_TRANSLATE_NOOP("Error", "layer '%1'"),
    QT_TRANSLATE_NOOP("Error", "the tooth"),
    QT_TRANSLATE_NOOP("Error",
                      "the tool's surface has no extent along its axis (z of the tool frame): give the bur's closed "
                      "STL with its tip at the origin and its shaft along +z"),
    QT_TRANSLATE_NOOP("Error", "%1, byte %2: %3"),
    QT_TRANSLATE_NOOP("Error", "the file is cut short; save the tooth again or use a complete copy."),
    QT_TRANSLATE_NOOP("Error", "this is no saved tooth; choose a file that Tactooth has saved."),
    QT_TRANSLATE_NOOP("Error",
                      "the file has format version %1, and this program reads versions 1 to 3; open it with the "
                      "program that saved it."),
    QT_TRANSLATE_NOOP("Error",
                      "the tooth has more materials than this program can hold beside its own (%1); take materials out "
                      "of the file of --materials."),
    QT_TRANSLATE_NOOP("Error", "there is more in the file than the tooth; use an undamaged copy."),
    QT_TRANSLATE_NOOP("Error", "the file is damaged; use another copy of it."),
    QT_TRANSLATE_NOOP("Error", "%1: a saved tooth has its own layers; give no others."),
    QT_TRANSLATE_NOOP("Error", "%1: a saved tooth keeps the spacing that it was cut with, %2 um; give no other."),
    QT_TRANSLATE_NOOP("Error",
                      "%1 crosses itself at each of the %2 finenesses that were tried; ask for another number of "
                      "triangles or another seed."),
    QT_TRANSLATE_NOOP("Error", "%1 gum of the mouth with seed %2 and %3 triangles a tooth"),
    QT_TRANSLATE_NOOP("Error", "The upper"),
    QT_TRANSLATE_NOOP("Error", "The lower"),
    // Cases.
    QT_TRANSLATE_NOOP("Error",
                      "%1 claims to hold %2 bytes, more than the %3 that a case may; it is damaged or not meant well."),
    QT_TRANSLATE_NOOP("Error", "%1: the folder holds more than %2 files; give a case a folder of its own."),
    QT_TRANSLATE_NOOP("Error",
                      "%1: the archive holds a file named '%2', which points out of it; it is not meant well."),
    QT_TRANSLATE_NOOP("Error",
                      "%1: the archive holds a file named '%2', which has control characters in its name; give it "
                      "another one and pack anew."),
    QT_TRANSLATE_NOOP("Error",
                      "%1: the archive holds a file named '%2', whose name is longer than 1000 bytes; give it a "
                      "shorter one and pack anew."),
    QT_TRANSLATE_NOOP("Error", "%1: the archive holds several cases, in %2 and %3; pack each on its own."),
    QT_TRANSLATE_NOOP("Error", "%1: the archive holds two files of the same name; pack it anew."),
    QT_TRANSLATE_NOOP("Error", "%1: there is no such file in the case."),
    QT_TRANSLATE_NOOP("Error", "%1: the link leads out of the case's folder; put a copy there instead."),
    QT_TRANSLATE_NOOP("Error", "%1: a case has its own layers; give no others."),
    QT_TRANSLATE_NOOP("Error", "%1: this is one tooth; a tooth can be chosen in a case only."),
    QT_TRANSLATE_NOOP("Error", "%1: there is something already; give a new folder, or a name that ends in %2."),
    QT_TRANSLATE_NOOP("Error", "%1: there is no tooth '%2' in this case; it has %3."),
    QT_TRANSLATE_NOOP("Error", "%1: the archive's list is damaged."),
    QT_TRANSLATE_NOOP("Error", "%1: the file is locked with a password; pack the case without one."),
    QT_TRANSLATE_NOOP("Error", "%1: the file is packed in an unusual way; pack the case with 'tactooth case pack'."),
    QT_TRANSLATE_NOOP("Error",
                      "%1: the file claims to unpack from %2 to %3 bytes, more than any surface does; the archive is "
                      "damaged or not meant well."),
    QT_TRANSLATE_NOOP("Error", "%1: this is no zip archive that can be read (%2)."),
    QT_TRANSLATE_NOOP("Error", "%1: the archive holds %2 files, more than the %3 that a case may."),
    QT_TRANSLATE_NOOP("Error", "%1: the archive claims to hold %2 bytes, more than the %3 that a case may."),
    QT_TRANSLATE_NOOP("Error", "%1: there is no such file in the archive."),
    QT_TRANSLATE_NOOP("Error", "%1: the file is damaged inside the archive."),
    QT_TRANSLATE_NOOP("Error", "%1: the file is not what the archive's list says; it is damaged."),
    QT_TRANSLATE_NOOP("Error", "the case could not be packed: there is not enough memory."),
};

}  // namespace

std::span<const char* const> fileErrors() { return kErrors; }

}  // namespace tactooth
