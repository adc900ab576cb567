// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/command_line.h"
#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/base/staged_file.h"

#include <QString>
#include <nlohmann/json.hpp>

#include <memory>
#include <span>
#include <string>

namespace burin {

class Project;

/// The context of every command of the command line: output of its answer and messages, and requests to stop it. One
/// object per run; main thread only, except `progress()`.
class CommandContext {
public:
    CommandContext();
    ~CommandContext();
    CommandContext(const CommandContext&) = delete;
    CommandContext& operator=(const CommandContext&) = delete;

    bool json = false; ///< one JSON object on standard output instead of text
    std::string setup; ///< argument of --setup; empty: the first

    /// Cancelled by SIGINT and SIGTERM. Work that ignores the cancellation, or that waits for a pipe, is killed in less
    /// than a second: recorded data are on the disk, and no output is left half written.
    Progress& progress() noexcept;
    /// Begins a stage of work, whose name and progress are shown on a terminal.
    void stage(TextId title);
    /// Outputs the answer: `object` with --json, otherwise `text`.
    void answer(const nlohmann::json& object, const std::string& text);
    /// Writes a line to standard error.
    void message(const std::string& text);
    /// Reports an error on standard error, as {"error": …} with --json, and returns the exit status.
    /// @param standing states in the same sentence what was kept despite the error; empty: nothing was changed
    int fail(const Error& error, const QString& standing = {});

private:
    class ProgressLine;
    class Ender;
    std::unique_ptr<Ender> ender_;
    std::unique_ptr<ProgressLine> line_;
};

/// States which outputs of a failed command were replaced nevertheless, because the disk refused to restore the
/// previous files; empty if there are none. For `fail`.
QString standingOutputs(std::span<const StagedFile> outputs);

/// Reports the name under which the file of an earlier version of Burin was kept next to the one that was just saved.
void tellKeptEarlier(CommandContext& context, const Project& project);

/// Adds one subcommand; its callback stores the exit status.
using Register = void (*)(CommandParser program, CommandContext& context, int& status);
void registerImport(CommandParser program, CommandContext& context, int& status);
void registerEmbed(CommandParser program, CommandContext& context, int& status);
void registerSetup(CommandParser program, CommandContext& context, int& status);
void registerFixtures(CommandParser program, CommandContext& context, int& status);
void registerMill(CommandParser program, CommandContext& context, int& status);
void registerPath(CommandParser program, CommandContext& context, int& status);
void registerPost(CommandParser program, CommandContext& context, int& status);
void registerVerify(CommandParser program, CommandContext& context, int& status);
void registerTake(CommandParser program, CommandContext& context, int& status);
void registerVolume(CommandParser program, CommandContext& context, int& status);
void registerInfo(CommandParser program, CommandContext& context, int& status);
void registerDevices(CommandParser program, CommandContext& context, int& status);
void registerMachines(CommandParser program, CommandContext& context, int& status);
void registerMaterials(CommandParser program, CommandContext& context, int& status);
void registerTools(CommandParser program, CommandContext& context, int& status);
void registerCalibrate(CommandParser program, CommandContext& context, int& status);
void registerDemo(CommandParser program, CommandContext& context, int& status);
void registerMeasure(CommandParser program, CommandContext& context, int& status);
void registerPicture(CommandParser program, CommandContext& context, int& status);
void registerSheet(CommandParser program, CommandContext& context, int& status);
void registerBench(CommandParser program, CommandContext& context, int& status);

/// Declares --json for a subcommand.
void addJsonFlag(CommandParser command, CommandContext& context);

} // namespace burin
