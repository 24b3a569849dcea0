#pragma once

#include "base/Error.h"

#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace fpm {

/// Appends numbers, texts and vectors of plain values to a string, to be read in the same order.
class ByteWriter
{
public:
    template <class T>
    requires std::is_trivially_copyable_v<T>
    void put(const std::vector<T>& values)
    {
        const std::uint64_t count = values.size();
        bytes_.append(reinterpret_cast<const char*>(&count), sizeof count);
        bytes_.append(reinterpret_cast<const char*>(values.data()), count * sizeof(T));
    }
    void put(const std::string& text) { put(std::vector<char>(text.begin(), text.end())); }
    void put(std::int64_t number) { put(std::vector<std::int64_t>{number}); }
    std::string take() { return std::move(bytes_); }

private:
    std::string bytes_;
};

/// Reads what ByteWriter wrote; throws Error(mesh) naming `subject` where the bytes end too early.
class ByteReader
{
public:
    ByteReader(std::string_view bytes, std::string subject)
        : bytes_(bytes),
          subject_(std::move(subject))
    {
    }
    template <class T>
    requires std::is_trivially_copyable_v<T> std::vector<T> vector()
    {
        std::uint64_t count = 0;
        copy(&count, sizeof count);
        if (count > bytes_.size() / sizeof(T)) fail();
        std::vector<T> values(count);
        copy(values.data(), count * sizeof(T));
        return values;
    }
    std::string text()
    {
        const auto letters = vector<char>();
        return {letters.begin(), letters.end()};
    }
    std::int64_t number()
    {
        const auto values = vector<std::int64_t>();
        if (values.size() != 1) fail();
        return values[0];
    }

private:
    std::string_view bytes_;
    std::string subject_;

    [[noreturn]] void fail() const
    {
        throw Error(ExitCode::mesh, subject_ + ": what its reader found is damaged");
    }
    void copy(void* target, std::size_t size)
    {
        if (size > bytes_.size()) fail();
        if (size > 0) std::memcpy(target, bytes_.data(), size);
        bytes_.remove_prefix(size);
    }
};

} // namespace fpm
