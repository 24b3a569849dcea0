#pragma once

#include "fields/FieldSet.h"

#include <type_traits>

namespace fpm {

/// Values of one type whatever the precision of the run: numbers of nodes, doubles, records.
template <class T>
class Field : public FieldBase
{
    static_assert(std::is_trivially_copyable_v<T>);

public:
    Field(FieldSet& set, const FieldInfo& info, std::size_t size = 0)
        : FieldBase(set, info, type(), sizeof(T))
    {
        resize(size);
    }
    Field(FieldSet& set, const FieldInfo& info, const std::vector<T>& values)
        : FieldBase(set, info, type(), sizeof(T))
    {
        assign(values);
    }

    /// For kernels; null without values.
    T* data() { return static_cast<T*>(memory_); }
    const T* data() const { return static_cast<const T*>(memory_); }
    /// New values, as many as there are.
    void fromHost(const std::vector<T>& values) { upload(values.data(), values.size()); }
    /// New values, of any count; resizes.
    void assign(const std::vector<T>& values)
    {
        resize(values.size());
        fromHost(values);
    }
    std::vector<T> toHost() const
    {
        std::vector<T> values(size());
        download(values.data());
        return values;
    }

private:
    static constexpr ValueType type()
    {
        return std::is_same_v<T, double>  ? ValueType::float64
               : std::is_same_v<T, float> ? ValueType::float32
                                          : ValueType::record;
    }
};

} // namespace fpm
