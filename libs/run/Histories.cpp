#include "run/Histories.h"

#include "base/Format.h"
#include "io/RunMark.h"
#include "mesh/Vector.h"
#include "model/CaseReader.h"
#include "solver/contact/Penalties.h"

#include <algorithm>

namespace fpm {

namespace {

/// A column of a history and what it is measured in.
struct Column {
    std::string name;
    Quantity quantity;
};

void addVector(std::vector<Column>& columns, const std::string& letter, Quantity quantity)
{
    for (const char* axis : {"x", "y", "z"}) columns.push_back({letter + axis, quantity});
}

std::vector<Column> energyColumns()
{
    std::vector<Column> columns{{"time", Quantity::time}};
    for (const char* name :
         {"kinetic", "internal", "plastic", "hourglass", "bulkViscosity", "contact", "friction",
          "contactDamping", "damping", "external", "total"})
        columns.push_back({name, Quantity::energy});
    columns.push_back({"balance", Quantity::none});
    columns.push_back({"kineticShare", Quantity::none});
    return columns;
}

std::vector<Column> contactColumns()
{
    std::vector<Column> columns{{"time", Quantity::time}};
    addVector(columns, "f", Quantity::force);
    columns.push_back({"active", Quantity::none});
    columns.push_back({"maxDepth", Quantity::length});
    columns.push_back({"meanDepth", Quantity::length});
    return columns;
}

std::vector<Column> reactionColumns()
{
    std::vector<Column> columns{{"time", Quantity::time}, {"travel", Quantity::length}};
    addVector(columns, "f", Quantity::force);
    return columns;
}

/// Displacement and velocity of the centre, angular velocity in global axes and in axes that turn
/// with the body, force and moment of contact and loads.
std::vector<Column> rigidBodyColumns()
{
    std::vector<Column> columns{{"time", Quantity::time}};
    addVector(columns, "u", Quantity::length);
    addVector(columns, "v", Quantity::velocity);
    addVector(columns, "w", Quantity::spin);
    addVector(columns, "bodyW", Quantity::spin);
    addVector(columns, "f", Quantity::force);
    addVector(columns, "m", Quantity::moment);
    return columns;
}

std::vector<Column> partColumns()
{
    std::vector<Column> columns{{"time", Quantity::time}};
    addVector(columns, "c", Quantity::length);
    addVector(columns, "p", Quantity::momentum);
    addVector(columns, "l", Quantity::angularMomentum);
    columns.push_back({"kinetic", Quantity::energy});
    return columns;
}

/// A field of a point: number in NodeValues, the letter of its components, what it is.
struct PointField {
    int number;
    std::string letter;
    Quantity quantity;
};

PointField fieldQuantity(const std::string& field)
{
    if (field == "velocity") return {1, "v", Quantity::velocity};
    if (field == "acceleration") return {2, "a", Quantity::acceleration};
    return {0, "u", Quantity::length};
}

std::vector<Column> pointColumns(const PointField& field)
{
    std::vector<Column> columns{{"time", Quantity::time}};
    addVector(columns, field.letter, field.quantity);
    return columns;
}

/// What moves the condition or surface of a reaction; value 0 where it is held.
Condition driveOf(const History& history, const Model& model, std::vector<double>& rows)
{
    if (history.surface >= 0) {
        const RigidSurface& surface = model.rigidSurfaces[std::size_t(history.surface)];
        return surfaceMotion(surface, rows);
    }
    return conditionOf(model.boundaryConditions[std::size_t(history.condition)], rows);
}

} // namespace

std::vector<HistoryTable> tablesOf(const History& history, const Model& model)
{
    std::vector<HistoryTable> tables;
    const auto add = [&](const std::string& name, const std::vector<Column>& columns) {
        HistoryTable& table = tables.emplace_back(HistoryTable{name, {}, {}});
        for (const Column& column : columns) {
            table.columns.push_back(column.name);
            table.units.push_back(unitOf(column.quantity, model.units));
        }
    };
    switch (history.kind) {
    case History::Kind::energies:
        add("energies", energyColumns());
        break;
    case History::Kind::contactForces:
        for (const ContactPair& pair : model.contactPairs) add(pair.name, contactColumns());
        break;
    case History::Kind::point:
        for (const std::string& field : history.fields)
            add(field, pointColumns(fieldQuantity(field)));
        break;
    case History::Kind::reaction:
        add("reaction", reactionColumns());
        break;
    case History::Kind::rigidBody:
        add("rigidBody", rigidBodyColumns());
        break;
    case History::Kind::part:
        add("part", partColumns());
        break;
    }
    return tables;
}

void keep(Archive& archive, std::vector<HistoryMark>& marks)
{
    archive.list(marks, [](Archive& each, HistoryMark& mark) {
        each(mark.file);
        each(mark.bytes);
    });
}

namespace {

/// A file that goes on, or begins.
std::unique_ptr<HistoryFile> opened(const OutputFolder& output,
                                    const std::string& file,
                                    const HistoryTable& table,
                                    const std::vector<std::string>& notes,
                                    const std::vector<HistoryMark>& stored,
                                    Log& log)
{
    const auto mark = std::ranges::find(stored, file, &HistoryMark::file);
    if (mark != stored.end()) {
        try {
            return std::make_unique<HistoryFile>(
                HistoryFile::resume(output, file, table.columns, notes, mark->bytes));
        } catch (const Error& error) {
            if (error.code() != ExitCode::checkpoint) throw;
            log.warning(format("{}: its rows begin anew here: {}", file, error.what()));
        }
    }
    return std::make_unique<HistoryFile>(output, file, table.columns, notes);
}

} // namespace

Histories::Histories(const OutputFolder& output,
                     const Model& model,
                     const std::string& runId,
                     const std::vector<HistoryMark>& stored,
                     Log& log)
    : model_(model)
{
    for (const History& history : model.control.histories) {
        Channel channel{&history, {}, {}, {}, {}, {}};
        if (history.kind == History::Kind::reaction)
            channel.drive = driveOf(history, model, channel.driveRows);
        for (const HistoryTable& table : tablesOf(history, model)) {
            const std::string file = format("postProcessing/{}/0/{}.dat", history.name, table.name);
            std::vector<std::string> notes;
            if (!runId.empty()) notes.push_back(RunMark{runId, file}.text());
            notes.emplace_back("unit"); // one a column
            for (const std::string& unit : table.units) notes.back() += " " + unit;
            channel.names.push_back(file);
            channel.files.push_back(opened(output, file, table, notes, stored, log));
        }
        channels_.push_back(std::move(channel));
    }
}

std::vector<HistoryMark> Histories::marks()
{
    std::vector<HistoryMark> out;
    for (Channel& channel : channels_)
        for (std::size_t i = 0; i < channel.files.size(); ++i) {
            channel.files[i]->synchronise();
            out.push_back({channel.names[i], channel.files[i]->size()});
        }
    return out;
}

void Histories::sample(Solver& solver, const Sample& row)
{
    const Energies& e = row.energies;
    for (Channel& channel : channels_) switch (channel.history->kind) {
        case History::Kind::energies:
            channel.files[0]->append({e.time, e.kinetic, e.internal, e.plastic, e.hourglass,
                                      e.bulkViscosity, e.contact, e.friction, e.contactDamping,
                                      e.damping, e.external, e.total, e.balance, e.kineticShare()});
            break;
        case History::Kind::contactForces:
            sampleContact(channel, solver, row);
            break;
        case History::Kind::point:
            samplePoint(channel, solver, e.time);
            break;
        case History::Kind::reaction:
            sampleReaction(channel, solver, e.time);
            break;
        case History::Kind::rigidBody:
            sampleBody(channel, solver, e.time);
            break;
        case History::Kind::part:
            samplePart(channel, solver, e.time);
            break;
        }
}

void Histories::samplePoint(Channel& channel, Solver& solver, double time)
{
    const NodeValues values = solver.nodes().values({channel.history->node});
    const Point& start = model_.mesh.points[std::size_t(channel.history->node)];
    for (std::size_t i = 0; i < channel.files.size(); ++i) {
        const int quantity = fieldQuantity(channel.history->fields[i]).number;
        Point value = values.at(quantity, 0);
        if (quantity == 0)
            for (std::size_t c = 0; c < 3; ++c) value[c] -= start[c];
        channel.files[i]->append({time, value[0], value[1], value[2]});
    }
}

/// Force the condition or surface exerts on the body. Of a condition: what balances element,
/// contact and load forces; the inertia of the driven nodes themselves is not part of it.
void Histories::sampleReaction(Channel& channel, Solver& solver, double time)
{
    const History& history = *channel.history;
    Point sum{0, 0, 0};
    if (history.surface >= 0) {
        for (std::size_t pair = 0; pair < model_.contactPairs.size(); ++pair) {
            if (model_.contactPairs[pair].surface != history.surface) continue;
            const PairForce force = solver.contact().force(pair);
            for (std::size_t c = 0; c < 3; ++c) sum[c] += force.force[c];
        }
    } else {
        const NodeValues values = solver.nodes().values(history.nodes);
        for (std::size_t i = 0; i < values.count; ++i)
            for (std::size_t c = 0; c < 3; ++c) sum[c] -= values.at(3, i)[c];
    }
    const Point value{channel.drive.value[0], channel.drive.value[1], channel.drive.value[2]};
    const double size = vector::length(value);
    const double travel =
        size > 0 ? size * travelAt(channel.drive, channel.driveRows.data(), time) : 0;
    channel.files[0]->append(
        {time, travel, history.factor * sum[0], history.factor * sum[1], history.factor * sum[2]});
}

void Histories::sampleBody(Channel& channel, Solver& solver, double time)
{
    const std::vector<Index>& parts = solver.bodies().setUp().part;
    const auto part = std::find(parts.begin(), parts.end(), channel.history->part);
    const BodyMotionValues body = solver.bodies().motion(std::size_t(part - parts.begin()));
    std::vector<double> row{time};
    for (const Point& value :
         {body.displacement, body.velocity, body.spin, body.localSpin, body.force, body.moment})
        row.insert(row.end(), value.begin(), value.end());
    channel.files[0]->append(row);
}

void Histories::samplePart(Channel& channel, Solver& solver, double time)
{
    if (!channel.motion) channel.motion.emplace(solver, model_.mesh, channel.history->part);
    const PartMotionValues part = channel.motion->of(solver);
    std::vector<double> row{time};
    for (const Point& value : {part.centre, part.momentum, part.angularMomentum})
        row.insert(row.end(), value.begin(), value.end());
    row.push_back(part.kinetic);
    channel.files[0]->append(row);
}

void Histories::sampleContact(Channel& channel, Solver& solver, const Sample& row)
{
    for (std::size_t pair = 0; pair < channel.files.size(); ++pair) {
        const PairForce force = solver.contact().force(pair);
        const PairStatus& status = row.pairs[pair];
        channel.files[pair]->append({row.energies.time, force.force[0], force.force[1],
                                     force.force[2], double(force.active), status.maxDepth,
                                     status.meanDepth});
    }
}

} // namespace fpm
