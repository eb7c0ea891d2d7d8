// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/error_words.h"

#include <QCoreApplication>
#include <QRegularExpression>
#include <QStringList>
#include <algorithm>
#include <functional>
#include <iterator>
#include <vector>

namespace tactooth {
namespace {

// %1, %2 ...: a name, a number or a sentence of its own, in the order of the English sentence.
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
    QT_TRANSLATE_NOOP("Error", "%1: cannot be written: its folder does not exist; make the folder first."),
    QT_TRANSLATE_NOOP("Error", "%1: cannot be written: this user may not write into its folder; choose another one."),
    QT_TRANSLATE_NOOP("Error", "%1: cannot be written: %2."),
    QT_TRANSLATE_NOOP("Error", "%1: cannot be written: this is a folder; name a file inside it."),
    QT_TRANSLATE_NOOP("Error", "%1: cannot be written: this is not a regular file; choose another name."),
    QT_TRANSLATE_NOOP("Error", "the plot %1 could not be written: %2."),
    QT_TRANSLATE_NOOP("Error", "the plots cannot be written to %1: end its name in .csv, .svg or .png."),
    QT_TRANSLATE_NOOP("Error", "%1: the folder cannot be read (%2)."),
    QT_TRANSLATE_NOOP("Error", "%1: the folder cannot be made (%2)."),
    QT_TRANSLATE_NOOP("Error", "No space left on device"),
    QT_TRANSLATE_NOOP("Error", "Permission denied"),
    QT_TRANSLATE_NOOP("Error", "Read-only file system"),
    QT_TRANSLATE_NOOP("Error", "Input/output error"),
    // Surfaces.
    QT_TRANSLATE_NOOP("Error", "%1: %2 files cannot be read; export the surface as STL, OBJ or PLY."),
    QT_TRANSLATE_NOOP("Error", "%1: the file holds no triangles; export the surface again."),
    QT_TRANSLATE_NOOP("Error", "%1: the file holds no faces; export the surface again, as triangles."),
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
    QT_TRANSLATE_NOOP("Error", "%1: the surface '%2' has no area."),
    QT_TRANSLATE_NOOP("Error",
                      "%1: %2 edges of the surface '%3' have more than two triangles; mend it in a mesh program."),
    QT_TRANSLATE_NOOP("Error",
                      "%1: the surface '%2' has %3 holes that are too wide to be filled unasked (%4 open edges); ask "
                      "for all holes to be filled, or close it in a mesh program."),
    QT_TRANSLATE_NOOP("Error", "%1: the surface '%2' has no outside (it is twisted); mend it in a mesh program."),
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
                      "the file has format version %1, and this program reads versions 1 and 2; open it with the "
                      "program that saved it."),
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
    QT_TRANSLATE_NOOP("Error", "%1: the archive holds two files of the same name; pack it anew."),
    QT_TRANSLATE_NOOP("Error",
                      "%1: '%2' points out of the case; give paths inside its folder, with '/' and without '..'."),
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
    // What is wrong in a text.
    QT_TRANSLATE_NOOP("Error", "%1, line %2: %3."),
    QT_TRANSLATE_NOOP("Error", "%1, line %2: this is not TOML."),
    QT_TRANSLATE_NOOP("Error", "%1, line %2: this is not TOML; see docs/sound.md for a pattern."),
    QT_TRANSLATE_NOOP("Error", "this is not TOML: %1"),
    QT_TRANSLATE_NOOP("Error", "%1 has no key %2; the keys are %3"),
    QT_TRANSLATE_NOOP("Error", "a case"),
    QT_TRANSLATE_NOOP("Error", "a bur"),
    QT_TRANSLATE_NOOP("Error", "a tooth"),
    QT_TRANSLATE_NOOP("Error", "a body around the teeth"),
    QT_TRANSLATE_NOOP("Error", "an exercise"),
    QT_TRANSLATE_NOOP("Error", "a cavity"),
    QT_TRANSLATE_NOOP("Error", "a stroke"),
    QT_TRANSLATE_NOOP("Error", "a material"),
    QT_TRANSLATE_NOOP("Error", "a recording"),
    QT_TRANSLATE_NOOP("Error", "the key '%1' is missing"),
    QT_TRANSLATE_NOOP("Error", "the key '%1' is missing; this version writes 1"),
    QT_TRANSLATE_NOOP("Error", "%1 must be a text of one line in quotes"),
    QT_TRANSLATE_NOOP("Error", "the key '%1' is empty"),
    QT_TRANSLATE_NOOP("Error", "%1 must be a list of texts"),
    QT_TRANSLATE_NOOP("Error", "%1 must be a list of texts of one line in quotes"),
    QT_TRANSLATE_NOOP("Error", "%1 must be a list of %2 numbers"),
    QT_TRANSLATE_NOOP("Error", "%1 must be a number from %2 to %3"),
    QT_TRANSLATE_NOOP("Error", "%1 must be a whole number from %2 to %3"),
    QT_TRANSLATE_NOOP("Error", "%1 must be true or false"),
    QT_TRANSLATE_NOOP("Error", "%1 must be a list of names and values in braces"),
    QT_TRANSLATE_NOOP("Error", "'%1' must be %2"),
    QT_TRANSLATE_NOOP("Error", "a number from 0 to %1"),
    QT_TRANSLATE_NOOP("Error", "a text in quotes"),
    QT_TRANSLATE_NOOP("Error", "true or false"),
    QT_TRANSLATE_NOOP("Error", "a list"),
    QT_TRANSLATE_NOOP("Error", "a list of %1"),
    QT_TRANSLATE_NOOP("Error", "a table"),
    QT_TRANSLATE_NOOP("Error", "a date or a time"),
    QT_TRANSLATE_NOOP("Error", "not a finite number"),
    QT_TRANSLATE_NOOP("Error", "begin each %1 with a line [[%2]]"),
    // Descriptions of cases, burs, exercises and materials.
    QT_TRANSLATE_NOOP("Error", "%1: the file is too large for a description of a case."),
    QT_TRANSLATE_NOOP("Error", "%1: the file is too large for a bur's description."),
    QT_TRANSLATE_NOOP("Error", "%1: the file is too large for the description of an exercise."),
    QT_TRANSLATE_NOOP("Error", "the case has format %1, which is newer than this program (1); take a newer one"),
    QT_TRANSLATE_NOOP("Error", "there is no [[tooth]]"),
    QT_TRANSLATE_NOOP("Error", "there are too many teeth"),
    QT_TRANSLATE_NOOP("Error", "%1 is no permanent tooth; FDI numbers are 11-18, 21-28, 31-38 and 41-48"),
    QT_TRANSLATE_NOOP("Error", "the name must be short and without slashes"),
    QT_TRANSLATE_NOOP("Error", "the name %1 is given twice"),
    QT_TRANSLATE_NOOP("Error", "%1 points out of the case; give a path inside its folder, with '/' and without '..'"),
    QT_TRANSLATE_NOOP("Error", "there is no material %1; choose enamel, dentin, pulp, caries, restoration or other"),
    QT_TRANSLATE_NOOP(
        "Error",
        "there is no material %1; write enamel, dentin, pulp, caries, amalgam, restoration, composite or other"),
    QT_TRANSLATE_NOOP("Error", "there is no material %1; the materials are %2"),
    QT_TRANSLATE_NOOP("Error", "the rotation must be a quaternion of length 1, w first"),
    QT_TRANSLATE_NOOP("Error", "the position lies more than 1000 mm away; lengths are in mm"),
    QT_TRANSLATE_NOOP("Error", "'material' must be carbide or diamond"),
    QT_TRANSLATE_NOOP("Error", "the surface must lie beside this file or below it, named with '/' and without '..'"),
    QT_TRANSLATE_NOOP("Error", "%1 must lie beside this file or below it, named with '/' and without '..'"),
    QT_TRANSLATE_NOOP("Error", "a built-in tooth brings its own layers"),
    QT_TRANSLATE_NOOP("Error", "'site' must be occlusal, mesial, distal, buccal or lingual"),
    QT_TRANSLATE_NOOP("Error", "a front tooth has no occlusal side; choose another site"),
    QT_TRANSLATE_NOOP("Error", "%1 belongs to a built-in tooth, one by its number"),
    QT_TRANSLATE_NOOP("Error", "there is no bur %1 in the catalogue."),
    QT_TRANSLATE_NOOP("Error",
                      "there is no bur %1 in the catalogue ('tactooth gallery' shows them); a bur of your own is named "
                      "by its file, .stl or .toml"),
    QT_TRANSLATE_NOOP(
        "Error",
        "give the ideal shape either by a file, ideal = \"FILE.stl\", or by what the bur cuts, below a line [cavity]"),
    QT_TRANSLATE_NOOP("Error", "'floor' must be flat, or surface to follow that of the tooth"),
    QT_TRANSLATE_NOOP("Error", "there are no strokes; give at least one, [[cavity.strokes]]"),
    QT_TRANSLATE_NOOP("Error", "there are too many strokes"),
    QT_TRANSLATE_NOOP("Error", "'side' has no direction"),
    QT_TRANSLATE_NOOP("Error",
                      "'side' must be occlusal, buccal, lingual, mesial, distal, or a direction of three numbers"),
    QT_TRANSLATE_NOOP("Error", "this stroke is longer or farther away than any tooth; places are in mm"),
    QT_TRANSLATE_NOOP("Error", "stroke %1 of the cavity goes past the tooth; give places over it, in its frame, mm."),
    QT_TRANSLATE_NOOP("Error",
                      "%1: the surface has holes; an ideal shape is the whole tooth with its cavity, closed ('tactooth "
                      "info' tells where it is open)."),
    QT_TRANSLATE_NOOP("Error", "expected the keys of %1 below a line [%2], but found %3"),
    QT_TRANSLATE_NOOP("Error", "'colour' must be three numbers in brackets (red, green, blue), but is %1"),
    QT_TRANSLATE_NOOP("Error", "%1 must be a number %2, but is %3"),
    QT_TRANSLATE_NOOP("Error", "from 0 to 1"),
    QT_TRANSLATE_NOOP("Error", "of 0 or more"),
    // Sounds.
    QT_TRANSLATE_NOOP("Error", "there is no part %1; the parts are %2"),
    QT_TRANSLATE_NOOP("Error", "motor, cutting, water and suction"),
    QT_TRANSLATE_NOOP("Error", "file, speed_rpm and gain_db"),
    QT_TRANSLATE_NOOP("Error", "'cutting' needs a material: write [cutting.enamel]"),
    QT_TRANSLATE_NOOP("Error", "%1 must be a table with the keys %2"),
    QT_TRANSLATE_NOOP("Error", "%1 has no recording; add file = \"NAME.wav\""),
    QT_TRANSLATE_NOOP("Error",
                      "%1 needs the speed of the bur when it was recorded, whose pitch it follows; add speed_rpm = "
                      "400000 or what it was"),
    QT_TRANSLATE_NOOP("Error", "'file' must be a name in quotes"),
    QT_TRANSLATE_NOOP("Error",
                      "%1: the recording has %2 samples a second, but 4000 to 192000 are needed; save it at 48000."),
    QT_TRANSLATE_NOOP("Error", "%1: the recording lasts %2 s, but a loop needs 0.05 to 30 s; cut out a steady piece."),
    QT_TRANSLATE_NOOP("Error", "%1: sample %2 is not a finite number; save the recording again."),
    QT_TRANSLATE_NOOP("Error", "%1: the recording is silent or far too loud to be one; record it again."),
    QT_TRANSLATE_NOOP("Error", "%1: this is neither WAV, FLAC nor Ogg; save the recording as one of these."),
    QT_TRANSLATE_NOOP("Error", "%1: the recording has %2 channels, but 1 to 8 are expected; save it with one."),
    QT_TRANSLATE_NOOP("Error", "%1: the recording lasts longer than the 30 s of a loop; cut out a steady piece."),
    QT_TRANSLATE_NOOP("Error", "%1: the file is shorter than it says; it was cut off, so copy or record it again."),
    QT_TRANSLATE_NOOP("Error", "%1: the file breaks off or is damaged (%2); copy or record it again."),
    QT_TRANSLATE_NOOP("Error", "%1: this is not a recording that can be read (%2); save it as WAV, FLAC or Ogg."),
    // Ways of a tool.
    QT_TRANSLATE_NOOP("Error", "%1: there is no line that names the columns; begin the file with %2."),
    QT_TRANSLATE_NOOP("Error", "%1: there are no rows below the names of the columns; add at least one."),
    QT_TRANSLATE_NOOP("Error", "the column '%1' is missing; expected the columns %2, separated by commas"),
    QT_TRANSLATE_NOOP("Error", "the column '%1' is named twice; remove one of the two"),
    QT_TRANSLATE_NOOP("Error", "expected %1 fields, one for each named column, but found %2"),
    QT_TRANSLATE_NOOP("Error", "column '%1': expected a finite number with '.' as decimal point, but found %2"),
    QT_TRANSLATE_NOOP("Error",
                      "%1: the quaternion qw,qx,qy,qz must have length 1, but its length is %2; write 1,0,0,0 for a "
                      "tool that is not turned."),
    QT_TRANSLATE_NOOP("Error", "%1: time runs backwards (t is less than in the row above); sort the rows by t."),
    // Devices.
    QT_TRANSLATE_NOOP(
        "Error", "%1: Tactooth knows no device %2; the usual one takes its place, choose another in the panel Hand."),
    QT_TRANSLATE_NOOP("Error",
                      "%1 takes %2, pen:NAME, inverse3:ID or gamepad:NAME for one of several, or replay:FILE.csv, not "
                      "'%3'; 'tactooth devices' shows what is there."),
    QT_TRANSLATE_NOOP("Error",
                      "the pedal '%1' is none: it is axis:N or button:N of a joystick (N from 0 to 31), with :NAME of "
                      "the joystick behind it if there are several."),
    QT_TRANSLATE_NOOP("Error",
                      "There is no gamepad%1: plug one in or switch it on, and see that you may read /dev/input."),
    QT_TRANSLATE_NOOP("Error", " named '%1'"),
    QT_TRANSLATE_NOOP("Error", "Joysticks cannot be read (%1)."),
    QT_TRANSLATE_NOOP("Error", "A gamepad steers already; there is one for each program."),
    QT_TRANSLATE_NOOP("Error", "A SpaceMouse steers already; there is one for each program."),
    QT_TRANSLATE_NOOP("Error",
                      "The SpaceMouse's driver does not run: install spacenavd, start it (sudo systemctl start "
                      "spacenavd) and plug the SpaceMouse in."),
    QT_TRANSLATE_NOOP("Error", "OpenHaptics, %1: %2"),
    QT_TRANSLATE_NOOP("Error", "the default device"),
    QT_TRANSLATE_NOOP("Error", "the device '%1'"),
    QT_TRANSLATE_NOOP("Error", "OpenHaptics knows no device for %1: look its name up in the vendor's setup program."),
    QT_TRANSLATE_NOOP("Error",
                      "OpenHaptics knows no device for %1: choose one that is set up (%2), or set it up in the "
                      "vendor's setup program."),
    QT_TRANSLATE_NOOP("Error", "OpenHaptics: four devices are in use already; close one of them."),
    QT_TRANSLATE_NOOP(
        "Error",
        "%1 cannot be loaded (%2): install the device's driver and OpenHaptics, or set TACTOOTH_LIBHD to the library."),
    QT_TRANSLATE_NOOP("Error", "%1 has no function %2: it is another version; install OpenHaptics 3.4 or newer."),
    QT_TRANSLATE_NOOP("Error",
                      "The Haply Inverse Service does not answer at %1: install and start it, or set TACTOOTH_HAPLY to "
                      "where it listens."),
    QT_TRANSLATE_NOOP("Error",
                      "What answers at %1 is not the Haply Inverse Service: end that program, or set TACTOOTH_HAPLY to "
                      "where the service listens."),
    QT_TRANSLATE_NOOP("Error", "%1 is broken, %2: install the device's driver anew; Tactooth leaves it alone."),
    QT_TRANSLATE_NOOP("Error", "it crashes (%1)"),
    QT_TRANSLATE_NOOP("Error", "it does not return"),
    QT_TRANSLATE_NOOP("Error", "it ends the program that uses it"),
    QT_TRANSLATE_NOOP("Error", "The Haply Inverse Service finds no Inverse3: check its cable and power supply."),
    QT_TRANSLATE_NOOP("Error", "The Haply Inverse Service knows no Inverse3 '%1': it finds %2."),
    // Troubles of a device that steers.
    QT_TRANSLATE_NOOP("Error", "The motors are warm: rest the pen for a minute; until then the force is weaker."),
    QT_TRANSLATE_NOOP("Error", "The driver has cut a force that was too strong; press more gently."),
    QT_TRANSLATE_NOOP("Error",
                      "The driver has cut a force that rose too fast; move the pen more slowly into the tooth."),
    QT_TRANSLATE_NOOP("Error", "The pen was moved faster than its driver allows; the force comes back by itself."),
    QT_TRANSLATE_NOOP("Error", "The driver reports a force error: switch the device off and on again."),
    QT_TRANSLATE_NOOP("Error",
                      "The device reports a fault: check its power supply and cable, then switch it off and on again."),
    QT_TRANSLATE_NOOP("Error", "The device is in use: close the other program that holds it."),
    QT_TRANSLATE_NOOP("Error",
                      "The device does not answer: check its cable and power supply; it is tried again every second."),
    QT_TRANSLATE_NOOP("Error", "The device is not set up: run the vendor's setup program and pair it."),
    QT_TRANSLATE_NOOP("Error", "The driver's timer does not run: start the vendor's service, or restart the computer."),
    QT_TRANSLATE_NOOP("Error", "The driver takes no more work: close other programs that use the device."),
    QT_TRANSLATE_NOOP("Error", "The vendor's library finds no licence: install OpenHaptics with its licence."),
    QT_TRANSLATE_NOOP("Error",
                      "The device's driver reports an error: switch the device off and on again and restart Tactooth."),
    QT_TRANSLATE_NOOP("Error", "Put the pen into its inkwell for a moment, so that the device learns where it is."),
    QT_TRANSLATE_NOOP(
        "Error",
        "The device has stopped answering: check its cable and power supply; the session goes on when it is back."),
    QT_TRANSLATE_NOOP("Error", "The gamepad has been unplugged: plug it in again, and the session goes on."),
    QT_TRANSLATE_NOOP("Error",
                      "The SpaceMouse's driver has stopped: start it again (sudo systemctl start spacenavd), and the "
                      "session goes on."),
    QT_TRANSLATE_NOOP(
        "Error", "The Haply Inverse Service answers too slowly: close other programs that keep this machine busy."),
    QT_TRANSLATE_NOOP(
        "Error",
        "The Haply Inverse Service has closed the connection: start it again; it is tried again every second."),
    QT_TRANSLATE_NOOP("Error",
                      "The Haply Inverse Service has stopped answering: restart it; it is tried again every second."),
    QT_TRANSLATE_NOOP(
        "Error",
        "The Haply Inverse Service sends what is no message: restart it; if that does not help, install it anew."),
    QT_TRANSLATE_NOOP("Error", "The Haply Inverse Service speaks another version of its language: install version 3."),
    QT_TRANSLATE_NOOP("Error",
                      "The Haply Inverse Service tells places that are not in metres: install version 3 of it."),
    QT_TRANSLATE_NOOP("Error",
                      "The Inverse3 does not know where it is: put its arms into their rest position and switch it off "
                      "and on again."),
    QT_TRANSLATE_NOOP("Error",
                      "The Inverse3 is gone: check its cable and power supply; the session goes on when it is back."),
    QT_TRANSLATE_NOOP("Error", "The Inverse3 has no power: plug in its power supply."),
    QT_TRANSLATE_NOOP("Error",
                      "The Inverse3 is not calibrated: hold its arms in their rest position until its light stays on."),
    QT_TRANSLATE_NOOP("Error", "The Inverse3 is not ready: wait for its light, or switch it off and on again."),
    QT_TRANSLATE_NOOP("Error", "The VerseGrip is asleep: press one of its buttons."),
    QT_TRANSLATE_NOOP("Error",
                      "The device tells a place that is no number: switch it off and on again if this comes again."),
    QT_TRANSLATE_NOOP("Error",
                      "The device's place has jumped: check its cable, and let it calibrate if this comes again."),
};

/// One of kErrors, ready to be looked for.
struct Known {
    const char* text;
    QRegularExpression pattern;
    qsizetype letters;  // outside of its parts
};

/// A sentence may be a part of another one, which has a full stop of its own.
QString withoutStop(const QString& sentence) {
    const QString stop = QCoreApplication::translate("Error", ".");
    return sentence.endsWith(stop) ? sentence.chopped(stop.size()) : sentence;
}

Known knownOf(const char* text) {
    const QString sentence = QString::fromUtf8(text);
    QStringList between = (sentence.endsWith('.') ? sentence.chopped(1) : sentence).split(QRegularExpression("%\\d"));
    const qsizetype letters = between.join("").size();
    for (QString& words : between) words = QRegularExpression::escape(words);
    return {text,
            QRegularExpression(QRegularExpression::anchoredPattern(between.join("(.*?)")),
                               QRegularExpression::DotMatchesEverythingOption),
            letters};
}

/// Those that say most come first: what fits them fits many a shorter one as well.
const std::vector<Known>& known() {
    static const std::vector<Known> all = [] {
        std::vector<Known> made;
        std::ranges::transform(kErrors, std::back_inserter(made), knownOf);
        std::ranges::stable_sort(made, std::ranges::greater(), &Known::letters);
        return made;
    }();
    return all;
}

QString filled(const QString& sentence, const QStringList& parts) {
    QString result;
    for (qsizetype at = 0; at < sentence.size(); ++at) {
        const bool isPlace = sentence[at] == '%' && at + 1 < sentence.size() && sentence[at + 1].isDigit();
        result += isPlace ? parts.value(sentence[++at].digitValue() - 1) : QString(sentence[at]);
    }
    return result;
}

/// `sentence`, which is without its full stop, in the language of the window.
QString inWords(const QString& sentence) {
    for (const Known& each : known()) {
        const QRegularExpressionMatch match = each.pattern.match(sentence);
        if (!match.hasMatch()) continue;
        QStringList parts = match.capturedTexts().mid(1);
        for (QString& part : parts) part = inWords(part);
        return filled(withoutStop(QCoreApplication::translate("Error", each.text)), parts);
    }
    // Perhaps a sentence behind the name of what it is about.
    const qsizetype colon = sentence.indexOf(": ");
    if (colon < 0) return sentence;
    const QString behind = sentence.mid(colon + 2), words = inWords(behind);
    if (words == behind) return sentence;
    return filled(QCoreApplication::translate("Error", "%1: %2"), {inWords(sentence.left(colon)), words});
}

}  // namespace

std::span<const char* const> knownErrors() { return kErrors; }

QString errorInWords(std::string_view message) {
    const QString whole = QString::fromUtf8(message.data(), static_cast<qsizetype>(message.size()));
    if (!whole.endsWith('.')) return inWords(whole);
    const QString sentence = whole.chopped(1);
    const QString words = inWords(sentence);
    return words == sentence ? whole : words + QCoreApplication::translate("Error", ".");
}

}  // namespace tactooth
