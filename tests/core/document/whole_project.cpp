// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/core/document/sample_project.h"

namespace burin::fixture {

namespace {

/// Every kind of edit, none with its default parameters.
std::vector<Edit> edits() {
    return {{DropAirCuts{2.5}, true},
            {DropDwells{0.7, 0.2}, false},
            {Smooth{4.5, 1.0 / 64.0}, true},
            {HoldOut{0.006, 0.125}, true},
            {Simplify{0.004}, true},
            {Link{6.5, 1.25}, true},
            {SetFeed{}, true}};
}

StoredPath path(const std::vector<std::int64_t>& takes) {
    return {0, "Schlichten", sourcesOf(takes), edits(), firstSetup};
}

StoredProgram program() {
    return {"mouse", "linuxcnc", "example-3-axis", "%\nG21 (¼ Stück)\nM2\n", R"({"gouge_max_mm": 0.004})", firstSetup};
}

bool same(const StoredPath& one, const StoredPath& other) {
    if (one.name != other.name || one.sources != other.sources || one.edits.size() != other.edits.size()) return false;
    for (std::size_t i = 0; i < one.edits.size(); ++i)
        if (toJson(one.edits[i]) != toJson(other.edits[i]) || one.edits[i].enabled != other.edits[i].enabled)
            return false;
    return true;
}

bool same(const StoredProgram& one, const StoredProgram& other) {
    return one.name == other.name && one.dialect == other.dialect && one.machine == other.machine &&
           one.text == other.text && one.reportJson == other.reportJson;
}

/// Whether it contains the fixtures, limits and haptic guides, since version 3.
bool holdsSurroundings(const Project& project, int version) {
    const Result<std::vector<Obstacle>> stored = project.obstacles();
    const Result<AxisMode> axis = project.axisMode();
    const Result<TravelPlacement> travel = project.travelPlacement();
    const Result<KeptGuides> kept = project.guides();
    if (!stored || !axis || !travel || !kept) return false;
    if (version < 3)
        return stored->empty() && !axis->free && axis->direction == glm::dvec3(0.0, 0.0, 1.0) &&
               *travel == TravelPlacement{} && identical(*kept, KeptGuides{});
    return *stored == obstacles() && axis->free == axisMode().free && axis->direction == axisMode().direction &&
           *travel == travelPlacement() && identical(*kept, guides());
}

bool storeSurroundings(Project& project) {
    return project.setObstacles(obstacles()) && project.setAxisMode(axisMode()) &&
           project.setTravelPlacement(travelPlacement()) && project.setGuides(guides());
}

/// A second clamping with a stock, a fixture, a machine, a path and a program of its own, since version 4.
bool storeSecondSetup(Project& project) {
    const Result<SetupId> second = project.addSetup("Rückseite");
    if (!second) return false;
    Setup turned = setup();
    turned.voxel *= 0.5;
    GeneratedMoves planned = generatedMoves();
    planned.info.setup = *second;
    const Result<std::int64_t> made = project.addGenerated(planned);
    if (!made) return false;
    const StoredPath back{0, "Planen", {{*made}}, edits(), *second};
    StoredProgram posted = program();
    posted.setup = *second;
    return project.setSetup(turned, *second) && project.setObstacles({obstacles().front()}, *second) &&
           project.setProgramTarget({"shapeoko-like", "grbl", NcUnits::inch}, *second) && project.addPath(back) &&
           project.addProgram(posted);
}

/// Whether it contains what storeSecondSetup stored, or, before version 4, a single setup.
bool holdsSetups(const Project& project, int version) {
    const Result<std::vector<SetupName>> setups = project.setups();
    const Result<std::vector<StoredPath>> paths = project.paths();
    const Result<std::vector<StoredProgram>> programs = project.programs();
    if (!setups || !paths || !programs || setups->front().id != firstSetup || !setups->front().name.empty())
        return false;
    if (paths->size() != 1 || programs->size() != 1) return false;
    if (paths->front().setup != firstSetup || programs->front().setup != firstSetup) return false;
    if (version < 4) return setups->size() == 1;
    if (setups->size() != 2) return false;
    const SetupId second = setups->back().id;
    const Result<std::vector<StoredPath>> ofSecond = project.paths(second);
    const Result<std::vector<StoredProgram>> postedThere = project.programs(second);
    if (!ofSecond || ofSecond->size() != 1 || !postedThere || postedThere->size() != 1) return false;
    const Result<Setup> turned = project.setup(second);
    const Result<std::vector<Obstacle>> stored = project.obstacles(second);
    const Result<ProgramTarget> target = project.programTarget(second);
    const Result<GeneratedMoves> planned = project.generatedMoves(ofSecond->front().sources.front().id);
    if (!planned || planned->info.setup != second || !identical(*planned, generatedMoves(version))) return false;
    return setups->back().name == "Rückseite" && turned && turned->voxel == 0.5 * setup().voxel && stored &&
           *stored == std::vector<Obstacle>{obstacles().front()} && target && target->machine == "shapeoko-like" &&
           ofSecond->front().setup == second && postedThere->front().setup == second;
}

KeptWorkpiece keptWorkpiece(std::int64_t take) {
    return {{take, 200}, {{take, 3}}, "what stood there"};
}

std::vector<TimeMarker> markers(std::int64_t take) {
    return {{{take, 0}, "Anfang"}, {{take, 250}, "Rippe 2"}};
}

/// Whether it contains the workpiece that is kept since version 10, and the markers.
bool holdsKept(const Project& project, int version) {
    const Result<std::vector<TakeMoment>> moments = project.keptMoments();
    const Result<std::vector<TimeMarker>> marked = project.markers();
    if (version < 10) return moments && moments->empty() && marked && marked->empty();
    if (!moments || moments->size() != 1) return false;
    const KeptWorkpiece original = keptWorkpiece(moments->front().take);
    const Result<KeptWorkpiece> kept = project.keptWorkpiece(moments->front());
    return marked && *marked == markers(original.at.take) && kept && kept->at == original.at &&
           kept->strokes == original.strokes && kept->volume == original.volume;
}

/// The samples of its first take, since version 12 with the torque of a device.
std::vector<Sample> takeSamples(std::size_t first, std::size_t count, int version) {
    std::vector<Sample> samples = handSamples(first, count);
    if (version >= 12)
        for (Sample& sample : samples) sample.torque = {0.25 * sample.force.y, -0.1 * sample.force.z, 1.0 / 3.0};
    return samples;
}

bool holdsTakes(const Project& project, int version) {
    const Result<std::vector<TakeInfo>> takes = project.takes();
    if (!takes || takes->size() != 2) return false;
    const TakeInfo& first = takes->front();
    const TakeInfo original = takeInfo("Schruppen");
    const Result<Take> take = project.take(first.id);
    std::vector<SampleRange> undone;
    if (version >= 2) undone.push_back(undoneInFixture);
    if (version >= 10) undone.push_back(offInFixture);
    std::uint64_t count = 0;
    for (const SampleRange& range : undone) count += range.count;
    if (first.undoneCount != count || !holdsKept(project, version)) return false;
    return take && take->undone == undone && identical(take->samples, takeSamples(0, 500, version)) &&
           first.name == original.name && first.toolId == original.toolId && first.allowance == original.allowance &&
           first.tickPeriod == original.tickPeriod && first.startedUnixTime == original.startedUnixTime &&
           first.materials == (version < 4 ? std::vector<std::string>{} : original.materials) &&
           first.stylus == original.stylus && first.sampleCount == 500 && first.complete && !takes->back().complete;
}

bool holdsResources(const Project& project) {
    const Result<std::vector<Property>> stored = project.materials();
    const Result<std::vector<Tool>> tools = project.tools();
    if (!stored || stored->size() != 2 || !tools || tools->size() != 1) return false;
    for (std::size_t i = 0; i < stored->size(); ++i)
        if (toJson((*stored)[i]) != toJson(materials()[i])) return false;
    return toJson(tools->front()) == toJson(tool());
}

} // namespace

bool fillProject(const std::filesystem::path& file) {
    Result<Project> project = Project::create(file);
    if (!project || !project->setModel(model()) || !project->setSetup(setup()) || !project->setMaterials(materials()) ||
        !project->setTool(tool()) || !storeSurroundings(*project))
        return false;
    Result<Project::TakeWriter> writer = project->beginTake(takeInfo("Schruppen"));
    for (std::size_t first = 0; first < 500; first += 50)
        if (!writer || !writer->append(takeSamples(first, 50, 12))) return false;
    if (!project->undoInterval(writer->id(), undoneInFixture)) return false;
    if (!writer->finish() || !project->beginTake(takeInfo("broken off"))) return false;
    if (!project->setSwitchedOff(writer->id(), std::span(&offInFixture, 1))) return false;
    return project->addPath(path({writer->id()})) && project->addProgram(program()) && storeSecondSetup(*project) &&
           project->setMarkers(markers(writer->id())) &&
           project->keepWorkpiece(keptWorkpiece(writer->id()), *project->recordedState()) && project->save();
}

bool holdsFixture(const Project& project, int version) {
    const Result<Model> storedModel = project.model();
    const Result<Setup> storedSetup = project.setup();
    if (!storedModel || !identical(*storedModel, model()) || !storedSetup || !identical(*storedSetup, setup(version)))
        return false;
    const Result<std::vector<StoredPath>> paths = project.paths();
    const Result<std::vector<StoredProgram>> programs = project.programs();
    return holdsTakes(project, version) && holdsResources(project) && holdsSurroundings(project, version) &&
           holdsSetups(project, version) && same(paths->front(), path({project.takes()->front().id})) &&
           same(programs->front(), program());
}

} // namespace burin::fixture
