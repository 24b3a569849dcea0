#pragma once

#include <type_traits>

namespace fpm {

/// A list of types; their numbers count from 0.
template <class... Types>
struct TypeList {
    static constexpr int size = int(sizeof...(Types));
    template <class Last>
    using With = TypeList<Types..., Last>; ///< and one more

    /// Number of a type, -1 when it is not in the list.
    template <class Type>
    static constexpr int indexOf()
    {
        int index = 0, found = -1;
        ((std::is_same_v<Type, Types> ? void(found = index++) : void(++index)), ...);
        return found;
    }
    /// visit.template operator()<Type>() with type number `index`; nothing for a number that is
    /// not in the list.
    template <class Visit>
    static constexpr void visit(int index, Visit&& visit)
    {
        int i = 0;
        ((i++ == index ? void(visit.template operator()<Types>()) : void()), ...);
    }
    /// The same with all of them in turn.
    template <class Visit>
    static constexpr void visitAll(Visit&& visit)
    {
        (visit.template operator()<Types>(), ...);
    }
};

} // namespace fpm
