// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <utility>

namespace burin {

/// What went wrong. Stable: tests and translations key on it; ui/messages words each one, with its remedy.
/// The comment says what `Error::subject` and `Error::place` hold.
enum class ErrorCode : std::uint16_t {
    // work that was stopped, resources of the machine
    cancelled,     ///< subject: the work
    outOfMemory,   ///< subject: the work; place: what it needs and what is free, where known; detail
    internalFault, ///< a promise of our own code was broken; subject: where
    // files
    fileNotFound,      ///< subject: file
    fileNotReadable,   ///< subject: file; detail: the system's reason
    fileNotWritable,   ///< subject: file; detail: the system's reason
    diskFull,          ///< subject: file
    fileEmpty,         ///< subject: file
    fileFormatUnknown, ///< subject: file
    fileDamaged,       ///< subject: file; place: what part, where known
    // use
    argumentInvalid, ///< subject: the argument; place: its value; detail: what is allowed
    nameUnknown,     ///< subject: the kind ("material", "tool", …); place: the name; detail: names that exist
    notSupported,    ///< subject: what was asked for; place: what this version can do instead
    // CAD import
    importTimedOut,     ///< subject: file; place: the limit with its unit
    importOutOfMemory,  ///< subject: file; place: the limit with its unit
    importCrashed,      ///< subject: file; detail: signal
    modelHasNoSolid,    ///< subject: file; place: what it holds instead
    modelNotWatertight, ///< subject: file; place: number of open edges and the body
    modelTooLarge,      ///< subject: file; place: how far it reaches; detail: how far it may
    meshIncomplete,     ///< subject: file; place: faces without triangles
    // volume and setup
    volumeTooLarge,    ///< subject: size asked for; place: the limit
    volumeOutOfMemory, ///< the reserved memory is used up; subject: bytes reserved
    partOutsideStock,  ///< subject: body; place: by how much, with unit
    stockInvalid,      ///< subject: the parameter; detail: what is allowed
    // tools, materials, machines (resources)
    resourceInvalid, ///< subject: file; place: key; detail: what is wrong
    // devices and haptics
    deviceNotFound,       ///< subject: device
    deviceFault,          ///< subject: device; place: record of what led to it, if any; detail: what it reports
    deviceUnplugged,      ///< subject: device; place: as above
    deviceStopped,        ///< its forces are off for now; subject: device; place: as above; detail: why
    deviceHot,            ///< its motors are hot, so that it is asked for half of its force; subject: device
    deviceNotAllowed,     ///< subject: device; place: the file that the system keeps it under
    deviceIncompatible,   ///< subject: device; place: its protocol; detail: ours
    deviceLibraryMissing, ///< subject: whose devices; place: the library and what it comes with; detail: folders that
                          ///< were looked in
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
    editMisplaced, ///< subject: title of an edit (context "Edit"); place: of the one that it has to come before
    editRepeated,  ///< there can be one in a path; subject: its title
    editUnguarded, ///< subject: title of an edit that may lead the tool into the part; place: of one that relies on its
                   ///< being held out; detail: of one that holds it out
    pathEmpty,     ///< subject: path
    pathGouges,    ///< nothing of it can be made; subject: path; place: where; detail: text of the context "Omission"
    dialectNotFound,    ///< subject: dialect id; detail: ids that exist
    pluginIncompatible, ///< subject: plugin file; place: its interface version; detail: ours
    pluginInvalid,      ///< subject: plugin file; detail
    programSyntax,      ///< subject: file; place: line and column; detail: the word
    programLimit,       ///< subject: what ("feed", "X travel"); place: the value and the limit
    checkFailed,        ///< subject: file or path; place: the findings in short
};

/// How an error ends the command line: its exit status (README.md lists them).
enum class ErrorClass : std::uint8_t {
    checkFailed = 1,
    wrongUse = 2,
    badInput = 3,
    outOfSpaceOrRights = 4,
    cancelled = 5,
    ownFault = 6 ///< of Burin itself
};

/// A record of a fault. Core says which, where and on what; `ui/messages` is the one place that words it.
struct Error {
    ErrorCode code = ErrorCode::internalFault;
    std::string subject; ///< the file, device, path or argument concerned
    std::string place;   ///< "line 118", "pose 4021", a value; empty when there is none
    std::string detail;  ///< English, for the log, and where the code's comment says so for the sentence
};

/// The exit class of an error. Without a default: the compiler asks for the class of a code that is new.
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
    case ErrorCode::dialectNotFound:
    case ErrorCode::deviceNotFound:
    case ErrorCode::volumeTooLarge:
    case ErrorCode::projectIncomplete:
        return ErrorClass::wrongUse;
    case ErrorCode::fileNotWritable:
    case ErrorCode::deviceNotAllowed:
    case ErrorCode::diskFull:
    case ErrorCode::outOfMemory:
    case ErrorCode::volumeOutOfMemory:
    case ErrorCode::recordingOverflow:
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
