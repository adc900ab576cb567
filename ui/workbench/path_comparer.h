// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/path/path_comparison.h"
#include "ui/workbench/path_controller.h"

#include <memory>
#include <optional>
#include <vector>

namespace burin {

/// What the path in force is compared with.
struct PathVersion {
    enum class Kind {
        recorded,    ///< the same path without its edits
        withoutEdit, ///< the same path without one of its edits
        path         ///< another path of the setup
    };
    Kind kind = Kind::recorded;
    std::size_t edit = 0;  ///< index of the edit, for Kind::withoutEdit
    std::int64_t path = 0; ///< id of the other path, for Kind::path
    friend bool operator==(const PathVersion&, const PathVersion&) = default;
};

/// The path in force and the version that it was compared with.
struct ComparedPaths {
    std::shared_ptr<const EvaluatedPath> first, second; ///< never null
    PathDifference values;
};

/// Compares the path in force with another version of it or with another path, in the background, and repeats the
/// comparison whenever either path changes. Never changes the project.
class PathComparer final : public Controller {
    Q_OBJECT
public:
    PathComparer(const Desk& desk, const WorkpieceController& workpiece, const PathController& path, QObject* parent);

    /// Whether there is a path to compare.
    bool possible() const { return path_.stored() != nullptr && path_.evaluated(); }
    /// Starts with a comparison with the recording. If open, repeats a comparison that failed or was cancelled.
    void open();
    void close();
    bool isOpen() const noexcept { return open_; }
    /// Everything that the path in force can be compared with.
    std::vector<PathVersion> versions() const;
    const PathVersion& version() const noexcept { return version_; }
    void choose(const PathVersion& version);
    double tolerance() const noexcept { return tolerance_; } ///< mm
    void setTolerance(double tolerance);
    /// The comparison of the path in force with the chosen version at the chosen tolerance; null if not open or not
    /// computed.
    std::shared_ptr<const ComparedPaths> compared() const;
    /// The path of the chosen version, known even if `compared` is not after a change of the tolerance; null if not
    /// known.
    std::shared_ptr<const EvaluatedPath> other() const;
    std::optional<Error> problem() const { return compared_ ? std::nullopt : problem_; } ///< why there is no comparison
    bool busy() const noexcept { return asked_.has_value(); }

private:
    struct Question {
        std::shared_ptr<const EvaluatedPath> first, base; ///< base: the job's path with the tool of the other version
        PathVersion version;
        double tolerance = 0.0;
        bool operator==(const Question&) const = default;
        bool isOfSamePaths(const Question& other) const {
            return first == other.first && base == other.base && version == other.version;
        }
    };
    struct Matter;
    const StoredPath* jobPathOf(const PathVersion& version) const;
    StoredPath storedOf(const PathVersion& version) const;
    void goOn();
    void gather(const Question& question);
    void run(const Question& question, std::shared_ptr<const EvaluatedPath> second, std::shared_ptr<Matter> matter);
    void answer(const Question& question, std::shared_ptr<const ComparedPaths> compared, std::optional<Error> problem);

    const WorkpieceController& workpiece_;
    const PathController& path_;
    bool open_ = false;
    PathVersion version_;
    double tolerance_ = usualComparedTolerance; ///< mm
    std::optional<Question> asked_, answered_;
    std::shared_ptr<const ComparedPaths> compared_; ///< answer to `answered_`; null if there is a problem
    std::optional<Error> problem_;
};

} // namespace burin
