// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/document/project_step.h"

#include "core/document/project.h"
#include "tests/core/document/processes.h"
#include "tests/core/document/project_rows.h"
#include "tests/core/document/sample_project.h"
#include "tests/test_program.h"

#include <QTemporaryDir>
#include <QtTest>

#include <filesystem>
#include <functional>
#include <iterator>
#include <memory>
#include <random>

namespace burin::tst_project_step {

namespace fs = std::filesystem;

namespace {

using Step = std::shared_ptr<const ProjectStep>;

/// Makes a change as a step.
Result<Step> stepOf(Project& project, const std::function<Result<void>(Project&)>& change) {
    if (Result<void> begun = project.beginStep(); !begun) return std::move(begun).error();
    if (Result<void> done = change(project); !done) return std::move(done).error();
    return project.endStep();
}

template <class T>
Result<void> nothingFrom(const Result<T>& done) {
    return done ? Result<void>() : Result<void>(done.error());
}

/// One change of each part of a project; some of them are the same value again, or do not succeed.
std::vector<std::function<Result<void>(Project&)>> changes(std::mt19937& random) {
    const auto pick = [&random](int most) { return static_cast<int>(random() % static_cast<unsigned>(most)); };
    const int number = pick(1000);
    return {
        [number](Project& p) { return p.setModel(fixture::modelNamed("part " + std::to_string(number))); },
        [number](Project& p) {
            Setup setup = fixture::setup();
            setup.voxel = 0.1 * (1 + number % 7);
            return p.setSetup(setup);
        },
        [](Project& p) { return p.setMaterials(fixture::materials()); },
        [number](Project& p) {
            Tool tool = fixture::tool();
            tool.id = "tool-" + std::to_string(number % 3);
            tool.name = std::to_string(number);
            return p.setTool(tool);
        },
        [number](Project& p) {
            std::vector<Obstacle> obstacles = fixture::obstacles();
            obstacles.resize(static_cast<std::size_t>(number) % (obstacles.size() + 1));
            return p.setObstacles(obstacles);
        },
        [](Project& p) { return p.setGuides(fixture::guides()); },
        [](Project& p) { return p.setAxisMode(fixture::axisMode()); },
        [](Project& p) { return p.setTravelPlacement(fixture::travelPlacement()); },
        [number](Project& p) {
            return p.setProgramTarget({"machine-" + std::to_string(number), {}, NcUnits::millimetre});
        },
        [number](Project& p) { return nothingFrom(p.addSetup("setup " + std::to_string(number))); },
        [](Project& p) -> Result<void> {
            const Result<std::vector<SetupName>> setups = p.setups();
            if (!setups || setups->size() < 2) return {};
            return p.removeSetup(setups->back().id);
        },
        [number](Project& p) { return p.nameSetup(setupInUse, std::to_string(number)); },
        [](Project& p) { return nothingFrom(p.addGenerated(fixture::generatedMoves())); },
        [](Project& p) { return p.setProgramDraft("G0 X1"); },
    };
}

} // namespace

class TestProjectStep : public QObject {
    Q_OBJECT
private slots:
    void init() {
        folder_ = std::make_unique<QTemporaryDir>();
        file_ = folder_->filePath("p.burin").toStdString();
        Result<Project> project = Project::create(file_);
        QVERIFY(project);
        project_.emplace(std::move(*project));
    }
    void cleanup() { project_.reset(); }

    /// Random changes; then back to the first state and forward to the last one, compared row by row.
    void everyStateComesBack_data() {
        QTest::addColumn<unsigned>("seed");
        for (const unsigned seed : {1U, 2U, 3U, 4U}) QTest::newRow(qPrintable(QString::number(seed))) << seed;
    }
    void everyStateComesBack() {
        QFETCH(unsigned, seed);
        std::mt19937 random(seed);
        std::vector<std::vector<std::string>> states{rows()};
        std::vector<Step> steps;
        std::vector<std::int64_t> digests{*project_->jobDigest()};
        for (int i = 0; i < 25; ++i) {
            const auto all = changes(random);
            const Result<Step> step = stepOf(*project_, all[random() % all.size()]);
            QVERIFY(step);
            if (!*step) {
                QCOMPARE(fixture::difference(states.back(), rows()), std::string());
                continue;
            }
            steps.push_back(*step);
            states.push_back(rows());
            digests.push_back(*project_->jobDigest());
        }
        for (int round = 0; round < 2; ++round) {
            for (std::size_t i = steps.size(); i-- > 0;) {
                const Result<Step> turned = project_->revert(*steps[i]);
                QVERIFY(turned && *turned);
                steps[i] = *turned;
                QCOMPARE(fixture::difference(states[i], rows()), std::string());
                QCOMPARE(*project_->jobDigest(), digests[i]);
            }
            for (std::size_t i = 0; i < steps.size(); ++i) {
                const Result<Step> turned = project_->revert(*steps[i]);
                QVERIFY(turned && *turned);
                steps[i] = *turned;
                QCOMPARE(fixture::difference(states[i + 1], rows()), std::string());
                QCOMPARE(*project_->jobDigest(), digests[i + 1]);
            }
        }
    }

    /// A setup that is undone takes with it what was stored in it since; its takes are hidden, and all of that comes
    /// back.
    void whatBelongsToASetupGoesWithIt() {
        SetupId second = firstSetup;
        const Result<Step> added = stepOf(*project_, [&](Project& p) -> Result<void> {
            const Result<SetupId> id = p.addSetup("second");
            if (id) second = *id;
            return nothingFrom(id);
        });
        QVERIFY(added && *added);
        QVERIFY(project_->setObstacles(fixture::obstacles(), second));
        TakeInfo info = fixture::takeInfo("first");
        info.setup = second;
        {
            Result<Project::TakeWriter> take = project_->beginTake(info);
            QVERIFY(take && take->append(fixture::handSamples(0, 200)) && take->finish());
        }
        const std::vector<std::string> before = rows();
        const Result<Step> back = project_->revert(**added);
        QVERIFY(back && *back);
        QCOMPARE(project_->setups()->size(), std::size_t{1});
        for (const std::string& row : rows())
            QVERIFY2(!row.starts_with("obstacle") && !row.starts_with("take"), row.c_str());
        const Result<Step> forth = project_->revert(**back);
        QVERIFY(forth && *forth);
        QCOMPARE(fixture::difference(before, rows()), std::string());
        QVERIFY(project_->revert(**forth));
        QVERIFY(project_->save());
        project_.reset();
        Result<Project> again = Project::open(file_); // which deletes hidden takes
        QVERIFY(again && again->setups()->size() == 1 && again->takes(second)->empty());
    }

    /// A long step is in a nameless file of the project's folder, not in memory.
    void aLongStepIsOnTheDisk() {
        Model model = fixture::modelNamed("large");
        std::mt19937 random(1);
        model.brep.resize(4 * ProjectStep::mostInMemory);
        for (char& byte : model.brep) byte = static_cast<char>(random());
        const std::vector<std::string> before = rows();
        const Result<Step> step = stepOf(*project_, [&](Project& p) { return p.setModel(model); });
        QVERIFY(step && *step && !(*step)->inMemory() && (*step)->size() > model.brep.size());
        const Result<Step> small = stepOf(*project_, [](Project& p) { return p.setTool(fixture::tool()); });
        QVERIFY(small && *small && (*small)->inMemory());
        QCOMPARE(QDir(folder_->path()).entryList(QDir::Files | QDir::Hidden).filter(QStringLiteral(".part")).size(), 0);
        QVERIFY(project_->revert(**small));
        const Result<Step> turned = project_->revert(**step);
        QVERIFY(turned && !(*turned)->inMemory());
        QCOMPARE(fixture::difference(before, rows()), std::string());
        QVERIFY(project_->revert(**turned));
        QVERIFY(project_->model()->brep == model.brep);
    }

    /// Many long steps share one descriptor; what one of them holds stays as others come and go.
    void longStepsShareADescriptor() {
        const auto descriptors = [] {
            return std::distance(fs::directory_iterator("/proc/self/fd"), fs::directory_iterator());
        };
        const auto before = descriptors();
        const auto byteOf = [](std::size_t step, std::uint64_t at) { return static_cast<char>(step * 31 + at / 1000); };
        std::vector<std::unique_ptr<ProjectStep>> steps;
        const auto append = [&](std::size_t step, std::size_t count) {
            std::string bytes(count, '\0');
            for (std::size_t i = 0; i < count; ++i) bytes[i] = byteOf(step, steps[step]->size() + i);
            steps[step]->append(bytes);
        };
        for (std::size_t i = 0; i < 40; ++i) {
            steps.push_back(std::make_unique<ProjectStep>(file_));
            append(i, ProjectStep::mostInMemory + 1);
            if (i > 0) append(i - 1, 5000); // in turns
        }
        QVERIFY(!steps.front()->inMemory());
        QVERIFY(descriptors() <= before + 1);
        for (std::size_t i = 0; i < steps.size(); i += 2) steps[i].reset();
        append(1, 7000);
        for (std::size_t i = 1; i < steps.size(); i += 2) {
            std::string all(steps[i]->size(), '\0');
            QCOMPARE(steps[i]->read(0, all), all.size());
            for (std::size_t at = 0; at < all.size(); ++at) QVERIFY(all[at] == byteOf(i, at));
            std::string part(9000, '\0');
            QCOMPARE(steps[i]->read(200'000, part), part.size());
            QVERIFY(part.front() == byteOf(i, 200'000) && part.back() == byteOf(i, 208'999));
        }
        steps.clear();
        QCOMPARE(descriptors(), before);
    }

    /// What was changed since by other means is overwritten, or left alone where the step did not touch it.
    void laterChangesDoNotStopIt() {
        QVERIFY(project_->setTool(fixture::tool()) && project_->setProgramDraft("first"));
        const Result<Step> step = stepOf(*project_, [](Project& p) { return p.setProgramDraft("second"); });
        QVERIFY(step && *step);
        QVERIFY(project_->setProgramDraft("third") && project_->nameSetup(setupInUse, "named"));
        QVERIFY(project_->revert(**step));
        QCOMPARE(*project_->programDraft(), std::string("first"));
        QCOMPARE(project_->setups()->front().name, std::string("named"));
        QVERIFY(*project_->unsaved());
    }

    /// Killed right after an undo, the project is recovered in the state that the undo led to.
    void aKillLeavesTheStateReached() {
        project_.reset();
        const fs::path file = folder_->filePath("killed.burin").toStdString();
        const int ended = fixture::inAnotherProcess([&file] {
            Result<Project> project = Project::create(file);
            if (!project || !project->setModel(fixture::modelNamed("first"))) return 1;
            const Result<Step> step =
                stepOf(*project, [](Project& p) { return p.setModel(fixture::modelNamed("second")); });
            if (!step || !*step || !project->revert(**step)) return 2;
            return ::raise(SIGKILL);
        });
        QCOMPARE(ended, -1);
        const Result<Project> again = Project::open(file);
        QVERIFY(again && again->recovered());
        QCOMPARE(fixture::nameIn(*again), std::string("first"));
    }

private:
    std::vector<std::string> rows() const { return fixture::rowsOf(file_); }

    std::unique_ptr<QTemporaryDir> folder_;
    fs::path file_;
    std::optional<Project> project_;
};

BURIN_TEST(TestProjectStep, NoApplication)

} // namespace burin::tst_project_step

#include "tst_project_step.moc"
