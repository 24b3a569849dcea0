#pragma once

#include "io/Table.h"
#include "mesh/Mesh.h"
#include "probe/FieldValues.h"

#include <string>
#include <vector>

namespace fpm {

/// system/probeDict, tables: one entry.
struct TableSpec {
    enum class Kind {
        point,   ///< the node (element for element fields) nearest to `position`
        section, ///< mean, sum, min or max of each component over `set`
        extrema, ///< smallest and largest value and where they are, over `part` or all parts
        sum,     ///< each component summed over `set`, `part` or all
        profile  ///< each node (element) of `set` in the order of its place along `axis`, one time
    };
    enum class Operation { mean, sum, min, max };

    std::string name;
    Kind kind = Kind::point;
    FieldChoice field;     ///< the component is used by extrema only
    std::string part, set; ///< empty: not given
    Point position{0, 0, 0};
    Operation operation = Operation::mean;
    std::size_t axis = 0; ///< of a profile: 0 x, 1 y, 2 z
};

/// Collects one row a frame: time, then numbers. A profile instead has one row a node (element) and
/// keeps the last frame only.
class TableProbe
{
public:
    /// Throws Error(dictionary) for an unknown part or set, naming those there are.
    TableProbe(const TableSpec& spec, const Mesh& mesh);

    /// Appends a row; throws Error(dictionary) for a field the frame does not have.
    void sample(const Frame& frame);
    const TableSpec& spec() const { return spec_; }
    /// Columns "time U_x U_y U_z", "time Mises", or for extrema "time min min_x ... max_z" with the
    /// undeformed positions of the extremes; of a profile "x y z U_x U_y U_z", undeformed.
    const Table& table() const { return table_; }

private:
    const std::vector<Index>& entities(bool onNodes) const;
    Point place(Index entity, bool onNodes) const;
    std::vector<double> extremaRow(const Frame& frame);
    std::vector<double> componentRow(const Frame& frame);
    void sampleProfile(const Frame& frame);

    TableSpec spec_;
    const Mesh& mesh_;
    std::vector<Index> nodes_, elements_;
    Table table_;
};

} // namespace fpm
