// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/text.h"
#include "core/document/database.h"

#include <array>
#include <span>

namespace burin {

/// "Brin" in the application id of the SQLite header, by which the `file` command and Burin recognise a project.
inline constexpr std::int32_t projectApplicationId = 0x4272696E;

/// One step of the format, from `user_version` `from` to the next. It works on the stored form: tables, not classes.
struct Migration {
    int from = 0;
    TextId title; ///< one sentence for the user
    Result<void> (*apply)(Database& file) = nullptr;
};

/// In order; the first starts from version 1. Every released version has a test project in tests/fixtures/projects.
Result<void> addUndoneIntervals(Database& file); // schema.cpp
Result<void> addSurroundings(Database& file);
Result<void> addSetups(Database& file);
Result<void> addRoles(Database& file);
Result<void> addStockVolumes(Database& file);
Result<void> addPlacements(Database& file);
Result<void> addProgramZero(Database& file);
Result<void> addPassRequests(Database& file);
Result<void> addTime(Database& file);
Result<void> addStatedFeeds(Database& file);
Result<void> addTorque(Database& file);
Result<void> addStatedCoolant(Database& file);
inline constexpr std::array projectMigrations{
    Migration{1, BURIN_TEXT("Migration", "Strokes of a take can be undone."), addUndoneIntervals},
    Migration{2, BURIN_TEXT("Migration", "Fixtures, the tool axis and guides are kept."), addSurroundings},
    Migration{3, BURIN_TEXT("Migration", "A job may have several setups."), addSetups},
    Migration{4, BURIN_TEXT("Migration", "Bodies have roles, and the stock a form and layers."), addRoles},
    Migration{5, BURIN_TEXT("Migration", "The stock may come from a file."), addStockVolumes},
    Migration{6, BURIN_TEXT("Migration", "The part can be rotated, and each setup has its own program."),
              addPlacements},
    Migration{7, BURIN_TEXT("Migration", "Program zero and its work offset can be chosen."), addProgramZero},
    Migration{8, BURIN_TEXT("Migration", "Paths can be computed, and keep what was asked for."), addPassRequests},
    Migration{9, BURIN_TEXT("Migration", "Takes can be switched off from a moment on, and the workpiece is kept."),
              addTime},
    Migration{10, BURIN_TEXT("Migration", "Paths can be made of programs, and keep their feeds."), addStatedFeeds},
    Migration{11, BURIN_TEXT("Migration", "Recordings keep the torque that a device gave."), addTorque},
    Migration{12, BURIN_TEXT("Migration", "Paths of programs keep the coolant of each move."), addStatedCoolant},
};
inline constexpr int projectVersion = static_cast<int>(projectMigrations.size()) + 1;

/// Creates the tables of the current version in an empty database.
Result<void> createSchema(Database& file);

/// Checks that a database is a project which this version can read. Errors: projectNotBurin, fileFromNewerBurin,
/// fileDamaged.
Result<void> checkIdentity(Database& file, int newest = projectVersion);

/// Checks that a project has exactly the tables of its version, without indices over expressions or computed columns,
/// which could make any query endless. Call it before any other query. Views and triggers are switched off
/// (Database::open) and are allowed.
/// Errors: fileDamaged.
Result<void> checkSchema(Database& file);

/// Applies the missing steps; all of them or none. Errors: as `checkIdentity`, and those of the steps.
Result<void> upgrade(Database& file, std::span<const Migration> migrations = projectMigrations);

} // namespace burin
