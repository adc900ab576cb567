// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/filled.h"
#include "core/base/text.h"

#include <array>
#include <initializer_list>
#include <string>
#include <string_view>

namespace burin::import_notes {

// The notes that an import may add. %1 … %3 stand for names and numbers. Projects store the filled English text, and
// the user interface looks it up here again, so a text that was ever released must not change.

inline constexpr TextId unitConverted = BURIN_TEXT("ImportNote", "Lengths in %1 were converted: 1 %2 = %3 mm.");
inline constexpr TextId unitReplaced =
    BURIN_TEXT("ImportNote", "The file states the unit %1 (%2 mm); 1 unit = %3 mm was used instead.");
inline constexpr TextId unitsMixed =
    BURIN_TEXT("ImportNote", "The file mixes %1 length units; each part was converted by its own.");
inline constexpr TextId brepWithoutUnit =
    BURIN_TEXT("ImportNote", "A BREP file states no unit; millimetres were taken.");
inline constexpr TextId stlWithoutUnit =
    BURIN_TEXT("ImportNote", "An STL file states no unit; 1 unit = %1 mm was taken.");
inline constexpr TextId fileWithoutUnit =
    BURIN_TEXT("ImportNote", "The file states no unit; 1 unit = %1 mm was assumed.");
inline constexpr TextId coloursLeftOut =
    BURIN_TEXT("ImportNote", "Colours are stored in another file, %1, and were not imported.");
inline constexpr TextId sizeDoubtful =
    BURIN_TEXT("ImportNote", "The part is %1 mm long: perhaps its unit is another one.");
inline constexpr TextId repaired = BURIN_TEXT("ImportNote", "%1 was invalid and was repaired.");
inline constexpr TextId notRepaired = BURIN_TEXT("ImportNote", "%1 is not fully valid, even after repair.");
inline constexpr TextId solidOpen = BURIN_TEXT("ImportNote", "%1 does not close, so its inside is not certain.");
inline constexpr TextId solidEmpty = BURIN_TEXT("ImportNote", "%1 has no faces and was left out.");
inline constexpr TextId insideOut = BURIN_TEXT("ImportNote", "%1 was inside out and was turned.");
inline constexpr TextId faceSewn = BURIN_TEXT("ImportNote", "1 loose face was sewn to a solid.");
inline constexpr TextId facesSewn = BURIN_TEXT("ImportNote", "%1 loose faces were sewn to a solid.");
inline constexpr TextId faceLeftOut = BURIN_TEXT("ImportNote", "1 face outside of every solid was left out.");
inline constexpr TextId facesLeftOut = BURIN_TEXT("ImportNote", "%1 faces outside of every solid were left out.");
inline constexpr TextId curvesLeftOut = BURIN_TEXT("ImportNote", "Curves outside of every solid were left out.");
inline constexpr TextId facesFilled =
    BURIN_TEXT("ImportNote", "%1: %2 plane faces that the mesher left incomplete were filled.");
inline constexpr TextId meshOpen =
    BURIN_TEXT("ImportNote", "%1 is not closed: %2 open edges. Its inside is not certain.");
inline constexpr TextId meshVolumeDiffers =
    BURIN_TEXT("ImportNote", "%1: its mesh encloses %2 mm³, its exact surface %3 mm³.");
inline constexpr TextId facesApart =
    BURIN_TEXT("ImportNote", "%1: its faces meet with gaps of up to %2 mm; there the mesh may be off by as much.");
inline constexpr TextId trianglesTurned = BURIN_TEXT("ImportNote", "%1: %2 triangles were turned.");
inline constexpr TextId stlOpen =
    BURIN_TEXT("ImportNote", "%1 is not closed: %2 open edges. Its inside and volume are not certain.");
inline constexpr TextId piecesApart = BURIN_TEXT("ImportNote", "%1 consists of %2 pieces that are not connected. Where "
                                                               "they overlap, its volume counts twice.");
inline constexpr TextId restLeftOut = BURIN_TEXT("ImportNote", "Data after the last triangle was left out.");
inline constexpr TextId endMissing =
    BURIN_TEXT("ImportNote", "The file ends without \"endsolid\"; what was read of it is complete.");
/// The wording of earlier versions.
inline constexpr TextId endMissingBefore =
    BURIN_TEXT("ImportNote", "The file ends without \"endsolid\"; what was read of it is whole.");
inline constexpr TextId noVolume = BURIN_TEXT("ImportNote", "%1 has no volume, so nothing of it can be protected.");
inline constexpr TextId partsMissing =
    BURIN_TEXT("ImportNote", "Parts are missing because they are in other files: %1. Copy those files into the folder "
                             "of the model and import it again.");
/// The wording of earlier versions, which drew each body in one colour.
inline constexpr TextId faceColourLeftOut = BURIN_TEXT(
    "ImportNote", "1 face has a colour of its own, which is not shown; Burin shows each body in one colour.");
inline constexpr TextId faceColoursLeftOut = BURIN_TEXT(
    "ImportNote", "%1 faces have colours of their own, which are not shown; Burin shows each body in one colour.");
/// The data of a file that a body does not keep.
inline constexpr TextId repairedFaceColourLost =
    BURIN_TEXT("ImportNote", "The colour of 1 face was lost when the face was repaired.");
inline constexpr TextId repairedFaceColoursLost =
    BURIN_TEXT("ImportNote", "The colours of %1 faces were lost when these faces were repaired.");
inline constexpr TextId transparencyLeftOut = BURIN_TEXT("ImportNote", "The transparency of colours was not imported.");
inline constexpr TextId layersLeftOut = BURIN_TEXT("ImportNote", "Layers were not imported (number of layers: %1).");
inline constexpr TextId annotationsLeftOut = BURIN_TEXT(
    "ImportNote", "Dimensions, tolerances and other annotations (PMI) were not imported (number of entries: %1).");

inline constexpr std::array all{unitConverted,
                                unitsMixed,
                                brepWithoutUnit,
                                stlWithoutUnit,
                                sizeDoubtful,
                                repaired,
                                notRepaired,
                                solidOpen,
                                insideOut,
                                faceSewn,
                                facesSewn,
                                faceLeftOut,
                                facesLeftOut,
                                curvesLeftOut,
                                facesFilled,
                                meshOpen,
                                meshVolumeDiffers,
                                facesApart,
                                trianglesTurned,
                                stlOpen,
                                piecesApart,
                                fileWithoutUnit,
                                coloursLeftOut,
                                restLeftOut,
                                endMissing,
                                endMissingBefore,
                                noVolume,
                                partsMissing,
                                solidEmpty,
                                unitReplaced,
                                faceColourLeftOut,
                                faceColoursLeftOut,
                                transparencyLeftOut,
                                layersLeftOut,
                                annotationsLeftOut,
                                repairedFaceColourLost,
                                repairedFaceColoursLost};

/// Names given to bodies, assemblies and solids that have none in the file; %1: a number from 1.
inline constexpr TextId unnamedBody = BURIN_TEXT("ImportNote", "Body %1");
inline constexpr TextId unnamedAssembly = BURIN_TEXT("ImportNote", "Assembly %1");
inline constexpr TextId unnamedSolid = BURIN_TEXT("ImportNote", "Solid %1");

/// Returns the English text with the first value for %1 and so on; at most nine values.
inline std::string fill(TextId note, std::initializer_list<std::string> values) {
    return filled(note.text, std::span(values.begin(), values.size()));
}

} // namespace burin::import_notes
