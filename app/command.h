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

/// What every command of the command line gets: where its answer and its messages go, and the wish to stop it.
/// One object a run; the main thread alone, but for `progress()`.
class CommandContext {
public:
    CommandContext();
    ~CommandContext();
    CommandContext(const CommandContext&) = delete;
    CommandContext& operator=(const CommandContext&) = delete;

    bool json = false; ///< one JSON object on standard output instead of text
    std::string setup; ///< that --setup asked for; empty: the first

    /// Cancelled by SIGINT and SIGTERM. Work that does not look at it, or that waits for a pipe, is ended all the same
    /// in less than a second, as by a kill: what was recorded is on the disk, and no output is left half written.
    Progress& progress() noexcept;
    /// Begins a stage of work, named on a terminal together with its progress.
    void stage(TextId title);
    /// The answer: `object` with --json, `text` without.
    void answer(const nlohmann::json& object, const std::string& text);
    /// A line on standard error.
    void message(const std::string& text);
    /// Words an error on standard error, as {"error": …} with --json, and returns the exit status.
    /// @param standing says in the same sentence what was kept in spite of it; empty: nothing was changed
    int fail(const Error& error, const QString& standing = {});

private:
    class ProgressLine;
    class Ender;
    std::unique_ptr<Ender> ender_;
    std::unique_ptr<ProgressLine> line_;
};

/// Says which of the outputs of a command that failed are new all the same, as a disk that refuses everything lets none
/// be taken back; empty: none. For `fail`.
QString standingOutputs(std::span<const StagedFile> outputs);

/// Says under what name the file of an earlier version of Burin stands beside the one that was just saved.
void tellKeptEarlier(CommandContext& context, const Project& project);

/// Adds one subcommand; its callback stores the exit status.
using Register = void (*)(CommandParser program, CommandContext& context, int& status);
void registerImport(CommandParser program, CommandContext& context, int& status);
void registerEmbed(CommandParser program, CommandContext& context, int& status);
void registerSetup(CommandParser program, CommandContext& context, int& status);
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
