#pragma once

#include "fields/FieldSet.h"
#include "parallel/Precision.h"

namespace fpm {

/// The families of numbers of a run, as DoublePrecision and the others name their types.
enum class Family { position, motion, work, sum };

/// Numbers of a type that follows from their family and the precision of the run.
class NumberField : public FieldBase
{
public:
    NumberField(FieldSet& set, const FieldInfo& info, Family family, std::size_t size = 0);
    /// Rounds `values` to the type of the family.
    NumberField(FieldSet& set,
                const FieldInfo& info,
                Family family,
                const std::vector<double>& values);

    /// For kernels, which know the type of the family; null without values.
    template <class T>
    [[gnu::always_inline]] T* data()
    {
        return static_cast<T*>(memory_);
    }
    /// New values, of any count, rounded to the type; resizes.
    void assign(const std::vector<double>& values);

private:
    ValueType number_;
};

/// The types of DoublePrecision, MixedPrecision or SinglePrecision.
template <class Numbers>
NumberTypes numberTypes()
{
    const auto type = []<class T>(T) {
        return std::is_same_v<T, double>        ? ValueType::float64
               : std::is_same_v<T, Compensated> ? ValueType::compensated
                                                : ValueType::float32;
    };
    return {type(typename Numbers::Position{}), type(typename Numbers::Motion{}),
            type(typename Numbers::Work{}), type(typename Numbers::Sum{})};
}

} // namespace fpm
