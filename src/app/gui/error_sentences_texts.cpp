// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QCoreApplication>

#include "app/gui/error_sentences.h"

namespace tactooth {
namespace {

constexpr const char* kErrors[] = {
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
    QT_TRANSLATE_NOOP("Error", "%1 has control characters in its name; give the file another one"),
    QT_TRANSLATE_NOOP("Error", "%1 is longer than 1000 bytes; give the file a shorter name"),
    QT_TRANSLATE_NOOP("Error", "%1 names no file; give a path inside the case's folder"),
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
    QT_TRANSLATE_NOOP("Error",
                      "the column '%1' is missing; expected the columns %2, separated by commas, but found %3"),
    QT_TRANSLATE_NOOP("Error", "a cell in quotes must end with its line, and nothing but a separator may follow it"),
    QT_TRANSLATE_NOOP("Error", "the column '%1' is named twice; remove one of the two"),
    QT_TRANSLATE_NOOP("Error", "expected %1 fields, one for each named column, but found %2"),
    QT_TRANSLATE_NOOP("Error", "column '%1': expected a finite number with '.' as decimal point, but found %2"),
    QT_TRANSLATE_NOOP("Error",
                      "%1: the quaternion qw,qx,qy,qz must have length 1, but its length is %2; write 1,0,0,0 for a "
                      "tool that is not turned."),
    QT_TRANSLATE_NOOP("Error", "%1: time runs backwards (t is less than in the row above); sort the rows by t."),
};

}  // namespace

std::span<const char* const> textErrors() { return kErrors; }

}  // namespace tactooth
