// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/messages/messages.h"

#include "core/base/available_memory.h"
#include "ui/messages/details.h"
#include "ui/messages/subjects.h"
#include "ui/messages/undo_detail.h"

#include <QCoreApplication>
#include <QDir>

namespace burin {

namespace {

QString given(const std::string& text) {
    return text.empty() ? Messages::tr("no details are known") : QString::fromStdString(text);
}

QString givenDetail(const std::string& text) {
    return text.empty() ? given(text) : detailText(text);
}

/// The title of a kind of edit, as marked by core.
QString editTitle(const std::string& title) {
    return title.empty() ? given(title) : QCoreApplication::translate("Edit", title.c_str());
}

} // namespace

QString Messages::withRecord(const QString& sentence, const Error& error) {
    if (error.place.empty()) return sentence;
    return sentence.chopped(1) + tr(" (details are in \"%1\").").arg(QString::fromStdString(error.place));
}

// No default: the compiler reports every code without a sentence.
QString Messages::sentence(const Error& error) {
    const QString file = QDir::toNativeSeparators(QString::fromStdString(error.subject));
    const QString subject = subjectText(error.subject);
    // Text typed or named by a user is not translated.
    const bool named = error.code == ErrorCode::nameUnknown;
    const bool typed = named || error.code == ErrorCode::argumentInvalid;
    const QString place = typed ? given(error.place) : givenDetail(error.place);
    const QString detail = named ? given(error.detail) : givenDetail(error.detail);
    switch (error.code) {
    case ErrorCode::cancelled:
        if (error.detail == undoUnderWayDetail)
            return tr("\"%1\" was not done, because an undo or redo is still under way; do it again in a moment.")
                .arg(subject);
        return tr("\"%1\" was cancelled; start it again to finish it.").arg(subject);
    case ErrorCode::outOfMemory:
        if (error.detail == fewerTakes)
            return tr("There is not enough memory for \"%1\" (needed and free: %2); make a path of fewer or shorter "
                      "takes, "
                      "or close other programs.")
                .arg(subject, place);
        return error.place.empty()
                   ? tr("There is not enough memory for \"%1\"; close other programs or choose larger voxels.")
                         .arg(subject)
                   : tr("There is not enough memory for \"%1\" (needed and free: %2); close other programs or choose "
                        "larger voxels.")
                         .arg(subject, place);
    case ErrorCode::internalFault:
        return tr("Internal error in \"%1\" (%2); save your work under another name and report this.")
            .arg(subject, detail);
    case ErrorCode::fileNotFound:
        return tr("\"%1\" does not exist; check its name and its folder.").arg(file);
    case ErrorCode::fileNotReadable:
        return tr("\"%1\" can't be read (%2); check that it is the right one and that you have permission to read it.")
            .arg(file, detail);
    case ErrorCode::fileNotWritable:
        return tr("\"%1\" can't be written (%2); check the permissions of the file and its folder or choose another "
                  "location.")
            .arg(file, detail);
    case ErrorCode::diskFull:
        return tr("The disk is full, so \"%1\" was not written; make room and try again.").arg(file);
    case ErrorCode::fileEmpty:
        return tr("\"%1\" is empty; export or copy it again.").arg(file);
    case ErrorCode::fileFormatUnknown:
        return tr("\"%1\" has no format that Burin reads; export it in another one, a model as STEP.").arg(file);
    case ErrorCode::fileDamaged:
        if (error.place.empty()) return tr("\"%1\" is damaged; use a backup, or export or copy it again.").arg(file);
        return tr("\"%1\" is damaged (%2); use a backup, or export or copy it again.").arg(file, place);
    case ErrorCode::argumentInvalid:
        if (error.place.empty()) return tr("The value of \"%1\" can't be used; allowed is: %2.").arg(subject, detail);
        return tr("The value \"%2\" of \"%1\" can't be used; allowed is: %3.").arg(subject, place, detail);
    case ErrorCode::nameUnknown:
        if (error.detail.empty()) return tr("No %1 is called \"%2\"; check the name.").arg(subject, place);
        return tr("No %1 is called \"%2\"; choose one of these: %3.").arg(subject, place, detail);
    case ErrorCode::notSupported:
        if (error.place.empty()) return tr("This version does not support \"%1\"; do without it.").arg(subject);
        return tr("This version does not support \"%1\"; use \"%2\" instead.").arg(subject, place);
    case ErrorCode::importTimedOut:
        return (error.detail.empty()
                    ? tr("Reading \"%1\" took more than %2 of processor time and was stopped; simplify the model or "
                         "allow more time.")
                    : tr("Reading \"%1\" took longer than %2 and was stopped; simplify the model or allow more time."))
            .arg(file, place);
    case ErrorCode::importOutOfMemory:
        return tr("Reading \"%1\" took more memory than %2 and was stopped; simplify the model or allow more memory.")
            .arg(file, place);
    case ErrorCode::importCrashed:
        return tr("The CAD reader failed on \"%1\" (%2); export the model again, if possible as STEP.")
            .arg(file, detail);
    case ErrorCode::modelHasNoSolid:
        if (!error.detail.empty())
            return tr("The parts of \"%1\" are in other files that are not in its folder (%2); copy them there, or "
                      "export the assembly as one file.")
                .arg(file, detail);
        return tr("\"%1\" contains no solid, but: %2; export a closed solid.").arg(file, place);
    case ErrorCode::modelNotWatertight:
        return tr("The surface of \"%1\" is open (%2); close it in your CAD program and export it again.")
            .arg(file, place);
    case ErrorCode::modelTooLarge:
        return tr("\"%1\" reaches %2 from its origin, and a part may reach %3; choose its unit, or export it again.")
            .arg(file, place, detail);
    case ErrorCode::meshIncomplete:
        return tr("Some faces of \"%1\" can't be meshed (%2); repair them in your CAD program and export it again.")
            .arg(file, place);
    case ErrorCode::volumeTooLarge:
        return tr("A stock of %1 is too large for the limit of %2; choose larger voxels or a smaller stock.")
            .arg(subject, place);
    case ErrorCode::volumeOutOfMemory:
        return tr("The memory reserved for the workpiece (%1 bytes) is used up; save, and go on with larger voxels.")
            .arg(subject);
    case ErrorCode::partOutsideStock:
        return tr("\"%1\" reaches out of the stock (%2); enlarge the stock or its margin.").arg(subject, place);
    case ErrorCode::stockInvalid:
        return tr("The stock's \"%1\" can't be used; allowed is: %2.").arg(subject, detail);
    case ErrorCode::fixtureInStock:
        return tr("\"%1\" would be %2 deep in the stock; move it, or change its sizes.").arg(subject, place);
    case ErrorCode::resourceInvalid:
        if (error.place.empty()) return tr("\"%1\" can't be used (%2); correct the file.").arg(file, detail);
        return tr("\"%1\" can't be used because of \"%2\" (%3); correct the file.").arg(file, place, detail);
    case ErrorCode::deviceNotFound:
        return tr("The device \"%1\" was not found; check its cable and its driver.").arg(subject);
    case ErrorCode::deviceFault:
        return withRecord(tr("The device \"%1\" reports a fault (%2); its forces are off until you connect it again.")
                              .arg(subject, error.detail.empty() ? detail : deviceReasonText(error.detail)),
                          error);
    case ErrorCode::deviceUnplugged:
        return withRecord(
            tr("The device \"%1\" was unplugged, so its forces are off; plug it in again to go on.").arg(subject),
            error);
    case ErrorCode::deviceStopped:
        return withRecord(tr("The device \"%1\" has its forces off for now (%2); they fade in again when that is over.")
                              .arg(subject, error.detail.empty() ? detail : deviceReasonText(error.detail)),
                          error);
    case ErrorCode::deviceHot:
        return tr("The motors of \"%1\" are hot, so its forces go down to half; press less until they have cooled.")
            .arg(subject);
    case ErrorCode::deviceNotAllowed:
        return tr("You have no permission to use the device \"%1\" (%2); install Burin's udev rule and plug it in "
                  "again.")
            .arg(subject, place);
    case ErrorCode::deviceAssistDenied:
        return tr("\"%1\" moves the tool, but neither vibrates nor pushes, as you have no permission to write to it "
                  "(%2); install Burin's udev rule and plug it in again.")
            .arg(subject, place);
    case ErrorCode::deviceIncompatible:
        return tr("The device \"%1\" speaks version %2 of its protocol, but this Burin needs %3; update its firmware.")
            .arg(subject, place, detail);
    case ErrorCode::deviceLibraryMissing:
        return tr("The devices of %1 need %2, which is in none of these folders: %3; install it.")
            .arg(subject, place, detail);
    case ErrorCode::deviceLibraryUnfit:
        return tr("The library \"%1\" can't be used (%2); install %3.").arg(file, place, detail);
    case ErrorCode::traceInvalid:
        return tr("The trace \"%1\" can't be used (%2); correct it or record it again.").arg(file, place);
    case ErrorCode::traceEnded:
        return tr("The trace \"%1\" could not be written (%2) and was discarded; milling goes on without it.")
            .arg(file, detail);
    case ErrorCode::projectNotBurin:
        return tr("\"%1\" is not a Burin project; choose a file that Burin saved.").arg(file);
    case ErrorCode::fileFromNewerBurin:
        return tr("\"%1\" was saved by a newer Burin (format %2); update Burin to open it.").arg(file, detail);
    case ErrorCode::projectInUse:
        return tr("\"%1\" is open in another program (%2); close it there first.").arg(file, ownerText(error.detail));
    case ErrorCode::projectIncomplete:
        return tr("The project lacks \"%1\"; supply it with \"%2\".").arg(subject, place);
    case ErrorCode::recordingOverflow:
        return tr("The disk could not keep up, so the recording ended after %1 samples; use a faster disk.")
            .arg(subject);
    case ErrorCode::pathEmpty:
        if (!error.detail.empty()) return tr("\"%1\" has no moves: %2.").arg(subject, detail);
        return tr("The path \"%1\" contains no move; add a take that cuts, or switch off the edit that drops "
                  "everything.")
            .arg(subject);
    case ErrorCode::editMisplaced:
        return tr("\"%1\" has to come before \"%2\" in the list of edits; move it there.")
            .arg(editTitle(error.subject), editTitle(error.place));
    case ErrorCode::editRepeated:
        return tr("A path can have only one \"%1\"; delete the other one.").arg(editTitle(error.subject));
    case ErrorCode::editUnguarded:
        return tr("\"%1\" may lead the tool into the part; put \"%2\" between it and \"%3\".")
            .arg(editTitle(error.subject), editTitle(error.detail), editTitle(error.place));
    case ErrorCode::pathGouges:
        return tr("No part of the path \"%1\" can be milled (%2); %3.")
            .arg(subject, place,
                 error.detail.empty() ? tr("look at what its edits leave out")
                                      : QCoreApplication::translate("Omission", error.detail.c_str()));
    case ErrorCode::dialectNotFound:
        return tr("No dialect is called \"%1\"; choose one of these: %2.").arg(subject, detail);
    case ErrorCode::pluginIncompatible:
        return tr("The plugin \"%1\" has interface version %2, but this Burin needs %3; install the one made for it.")
            .arg(file, place, detail);
    case ErrorCode::pluginInvalid:
        return tr("The plugin \"%1\" can't be loaded (%2); install it again.").arg(file, detail);
    case ErrorCode::programSyntax:
        return tr("The program \"%1\" can't be understood at %2 (%3); correct it there.").arg(file, place, detail);
    case ErrorCode::programLimit:
        return tr("The machine's limit of \"%1\" is exceeded (%2); change the path or choose another machine.")
            .arg(subject, place);
    case ErrorCode::checkFailed:
        if (error.subject == "tool axis")
            return tr("The tool can't be tilted like this (%1); tilt it less, or on another part of the path.")
                .arg(place);
        return tr("\"%1\" did not pass the check (%2); correct the path and check it again.").arg(file, place);
    }
    return tr("An unknown fault occurred in \"%1\"; report this.").arg(subject); // not a valid code
}

QString Messages::resourceName(const std::string& name) {
    for (std::size_t end = name.size(); end != std::string::npos && end > 0; end = name.rfind(" (", end - 1)) {
        const std::string known = name.substr(0, end);
        const QString worded = QCoreApplication::translate("Resource", known.c_str());
        if (worded != QString::fromStdString(known)) return worded + QString::fromStdString(name.substr(end));
    }
    return QString::fromStdString(name);
}

QString Messages::text(TextId id) {
    return QCoreApplication::translate(id.context, id.text);
}

} // namespace burin
