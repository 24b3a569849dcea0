#pragma once

#include "base/Error.h"

#include <gtest/gtest.h>

#include <string>

namespace fpm::test {

/// Message and advice of the Error that `action` throws; fails the test when it throws none.
template <class Action>
std::string refusal(const Action& action)
{
    try {
        action();
    } catch (const Error& error) {
        return error.what() + std::string("\n") + error.advice();
    }
    ADD_FAILURE() << "nothing was refused";
    return "";
}

inline testing::AssertionResult contains(const std::string& text, const std::string& part)
{
    if (text.find(part) != std::string::npos) return testing::AssertionSuccess();
    return testing::AssertionFailure() << "'" << part << "' is not in:\n" << text;
}

} // namespace fpm::test
