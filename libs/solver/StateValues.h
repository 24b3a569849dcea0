#pragma once

#include <cstring>
#include <vector>

namespace fpm {

/// The state of all elements as the kernels keep it, widened to double, in the order that
/// SolverData::placeOf and StateLayout give. Tiles of floats keep their bits (floatAt).
struct StateValues {
    std::vector<double> state, strains;
};

/// Float number `i` of memory that was uploaded as other numbers.
template <class Values>
float floatAt(const Values& values, std::size_t i)
{
    float value;
    std::memcpy(&value, reinterpret_cast<const char*>(values.data()) + i * sizeof value,
                sizeof value);
    return value;
}

} // namespace fpm
