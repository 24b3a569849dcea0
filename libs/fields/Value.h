#pragma once

#include "fields/Field.h"

namespace fpm {

/// Ordinary memory of the host.
const Memory& hostMemory();

/// One value of the host that a checkpoint holds; its set lies in hostMemory().
template <class T>
class Value
{
public:
    Value(FieldSet& set, std::string_view name)
        : field_(set, {name, Location::global, Role::state}, 1)
    {
    }
    T operator()() const { return *field_.data(); }
    void operator=(T value) { *field_.data() = value; }
    void operator+=(T value) { *field_.data() += value; }

private:
    Field<T> field_;
};

} // namespace fpm
