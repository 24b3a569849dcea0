#pragma once

#include "solver/backend/Launches.h"
#include "solver/elements/ElementFields.h"

namespace fpm {

/// What the elements hold, mean over their integration points.
struct ElementValues {
    std::vector<double> stress;        ///< [element][6], XX YY ZZ XY YZ XZ
    std::vector<double> plasticStrain; ///< [element]
    std::vector<bool> deleted;         ///< [element]
    std::vector<double> eroded;        ///< [element], elastic energy at its deletion
    std::vector<double> temperature;   ///< [element]; empty where no part heats
};

/// The state of all elements as the kernels keep it, widened to double, in the order that
/// ElementSetUp::placeOf and StateLayout give. Tiles of floats keep their bits (floatAt).
struct StateValues {
    std::vector<double> state, strains;
};

/// The element solver of the paper: stress update and internal forces.
class ElementSolver
{
public:
    ElementSolver(const ElementSetUp& setUp,
                  ElementFields& fields,
                  ElementLaunches& launches,
                  Backend& backend)
        : setUp_(setUp),
          fields_(fields),
          launches_(launches),
          backend_(backend)
    {
    }

    /// Advances the stress by the increment of the step and gives the internal forces at its end:
    /// once a step. Interior nodes are moved by their patches first (InteriorNodes).
    void updateForces();

    const ElementSetUp& setUp() const { return setUp_; }
    ElementValues values() const;
    StateValues state() const;
    /// FNV-1a over stress, plastic strain and hourglass values, continuing from `hash`.
    std::uint64_t checksum(std::uint64_t hash) const;
    double seconds() const { return seconds_; }

private:
    const ElementSetUp& setUp_;
    ElementFields& fields_;
    ElementLaunches& launches_;
    Backend& backend_;
    double seconds_ = 0;
};

/// Float number `i` of memory that was uploaded as other numbers.
float floatAt(const void* memory, std::size_t i);

} // namespace fpm
