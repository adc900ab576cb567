// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <utility>

namespace burin {

/// What went wrong. Stable: tests and translations use it as a key; ui/messages words each one, with its remedy. The
/// comment states the contents of `Error::subject` and `Error::place`.
enum class ErrorCode : std::uint16_t {
    // interrupted work, resources of the machine
    cancelled,     ///< subject: the work
    outOfMemory,   ///< subject: the work; place: needed and available memory, if known; detail
    internalFault, ///< an internal invariant was violated; subject: where
    // files
    fileNotFound,      ///< subject: file
    fileNotReadable,   ///< subject: file; detail: the system's reason
    fileNotWritable,   ///< subject: file; detail: the system's reason
    diskFull,          ///< subject: file
    fileEmpty,         ///< subject: file
    fileFormatUnknown, ///< subject: file
    fileDamaged,       ///< subject: file; place: the damaged part, if known
    // use
    argumentInvalid, ///< subject: the argument; place: its value; detail: what is allowed
    nameUnknown,     ///< subject: the kind ("material", "tool", …); place: the name; detail: names that exist
    notSupported,    ///< subject: what was requested; place: what this version can do instead
    // CAD import
    importTimedOut,     ///< subject: file; place: the limit with its unit
    importOutOfMemory,  ///< subject: file; place: the limit with its unit
    importCrashed,      ///< subject: file; detail: signal
    modelHasNoSolid,    ///< subject: file; place: what it contains instead
    modelNotWatertight, ///< subject: file; place: number of open edges and the body
    modelTooLarge,      ///< subject: file; place: its extent; detail: the largest allowed one
    meshIncomplete,     ///< subject: file; place: faces without triangles
    // volume and setup
    volumeTooLarge,    ///< subject: requested size; place: the limit
    volumeOutOfMemory, ///< the reserved memory is used up; subject: bytes reserved
    partOutsideStock,  ///< subject: body; place: by how much, with unit
    stockInvalid,      ///< subject: the parameter; detail: what is allowed
    fixtureInStock,    ///< subject: fixture; place: how deep, with unit
    // tools, materials, machines (resources)
    resourceInvalid, ///< subject: file; place: key; detail: what is wrong
    // devices and haptics
    deviceNotFound,       ///< subject: device
    deviceFault,          ///< subject: device; place: record of the events before it, if any; detail: what it reports
    deviceUnplugged,      ///< subject: device; place: as above
    deviceStopped,        ///< its forces are off for now; subject: device; place: as above; detail: why
    deviceHot,            ///< its motors are hot, so that its force is limited to half; subject: device
    deviceNotAllowed,     ///< subject: device; place: the device file of the system
    deviceAssistDenied,   ///< it can be read, but not written, so that it shows no forces; subject, place: as above
    deviceIncompatible,   ///< subject: device; place: its protocol; detail: ours
    deviceLibraryMissing, ///< subject: vendor of the devices; place: the library and where it comes from; detail:
                          ///< folders that were searched
    deviceLibraryUnfit,   ///< subject: file; place: a function that
                          ///< is missing, or its version; detail:
                          ///< what Burin needs
    traceInvalid,         ///< subject: file; place: line
    // project
    projectNotBurin,    ///< subject: file
    fileFromNewerBurin, ///< subject: file; detail: its version
    projectInUse,       ///< subject: file; detail: by whom
    projectIncomplete, ///< subject: what is missing ("embedded stock", "recording", …); place: the command that makes
                       ///< it
    recordingOverflow, ///< the disk could not keep up; subject: samples kept
    // path, NC, verification
    editMisplaced,   ///< subject: title of an edit (context "Edit"); place: title of the edit that it has to precede
    editRepeated,    ///< a path may contain only one; subject: its title
    editUnguarded,   ///< subject: title of an edit that may lead the tool into the part; place: title of one that needs
                     ///< the path to be kept out of it; detail: title of one that does so
    pathEmpty,       ///< subject: path
    pathGouges,      ///< all of it had to be left out; subject: path; place: where; detail: text of "Omission"
    dialectNotFound, ///< subject: dialect id; detail: ids that exist
    pluginIncompatible, ///< subject: plugin file; place: its interface version; detail: ours
    pluginInvalid,      ///< subject: plugin file; detail
    programSyntax,      ///< subject: file; place: line and column; detail: the word
    programLimit,       ///< subject: the quantity ("feed", "X travel"); place: the value and the limit
    checkFailed,        ///< subject: file or path; place: summary of the findings
    // sessions
    traceEnded, ///< a trace can't be written; milling goes on without it; subject: file; detail: why
};

/// The class of an error, which is the exit status of the command line (README.md lists them).
enum class ErrorClass : std::uint8_t {
    checkFailed = 1,
    wrongUse = 2,
    badInput = 3,
    outOfSpaceOrRights = 4,
    cancelled = 5,
    ownFault = 6 ///< in Burin itself
};

/// A record of a fault: its code, the object and the location; it is worded by `ui/messages` only.
struct Error {
    ErrorCode code = ErrorCode::internalFault;
    std::string subject; ///< the file, device, path or argument concerned
    std::string place;   ///< "line 118", "pose 4021", a value; empty if there is none
    std::string detail;  ///< English, for the log, and for the sentence where the comment of the code says so
};

/// The class of an error. There is no default, so that the compiler asks for the class of a new code.
constexpr ErrorClass errorClass(ErrorCode code) noexcept {
    switch (code) {
    case ErrorCode::cancelled:
        return ErrorClass::cancelled;
    case ErrorCode::argumentInvalid:
    case ErrorCode::nameUnknown:
    case ErrorCode::notSupported:
    case ErrorCode::editMisplaced:
    case ErrorCode::editRepeated:
    case ErrorCode::editUnguarded:
    case ErrorCode::stockInvalid:
    case ErrorCode::partOutsideStock:
    case ErrorCode::fixtureInStock:
    case ErrorCode::dialectNotFound:
    case ErrorCode::deviceNotFound:
    case ErrorCode::volumeTooLarge:
    case ErrorCode::projectIncomplete:
        return ErrorClass::wrongUse;
    case ErrorCode::fileNotWritable:
    case ErrorCode::deviceNotAllowed:
    case ErrorCode::deviceAssistDenied:
    case ErrorCode::diskFull:
    case ErrorCode::outOfMemory:
    case ErrorCode::volumeOutOfMemory:
    case ErrorCode::recordingOverflow:
    case ErrorCode::traceEnded:
    case ErrorCode::projectInUse:
        return ErrorClass::outOfSpaceOrRights;
    case ErrorCode::pathGouges:
    case ErrorCode::pathEmpty:
    case ErrorCode::programLimit:
    case ErrorCode::checkFailed:
        return ErrorClass::checkFailed;
    case ErrorCode::fileNotFound:
    case ErrorCode::fileNotReadable:
    case ErrorCode::fileEmpty:
    case ErrorCode::fileFormatUnknown:
    case ErrorCode::fileDamaged:
    case ErrorCode::importTimedOut:
    case ErrorCode::importOutOfMemory:
    case ErrorCode::importCrashed:
    case ErrorCode::modelHasNoSolid:
    case ErrorCode::modelNotWatertight:
    case ErrorCode::modelTooLarge:
    case ErrorCode::meshIncomplete:
    case ErrorCode::resourceInvalid:
    case ErrorCode::deviceFault:
    case ErrorCode::deviceUnplugged:
    case ErrorCode::deviceStopped:
    case ErrorCode::deviceHot:
    case ErrorCode::deviceIncompatible:
    case ErrorCode::deviceLibraryMissing:
    case ErrorCode::deviceLibraryUnfit:
    case ErrorCode::traceInvalid:
    case ErrorCode::projectNotBurin:
    case ErrorCode::fileFromNewerBurin:
    case ErrorCode::pluginIncompatible:
    case ErrorCode::pluginInvalid:
    case ErrorCode::programSyntax:
        return ErrorClass::badInput;
    case ErrorCode::internalFault:
        return ErrorClass::ownFault;
    }
    return ErrorClass::ownFault;
}

} // namespace burin
