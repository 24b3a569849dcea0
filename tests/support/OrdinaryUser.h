#pragma once

#include <unistd.h>

#include <cstdlib>
#include <stdexcept>

namespace fpm::test {

/// Without root's rights, to which nothing is closed, until it is destroyed.
class OrdinaryUser
{
public:
    OrdinaryUser()
    {
        if (geteuid() == 0 && seteuid(nobody) != 0) throw std::runtime_error("seteuid");
    }
    OrdinaryUser(const OrdinaryUser&) = delete;
    OrdinaryUser& operator=(const OrdinaryUser&) = delete;
    ~OrdinaryUser()
    {
        if (geteuid() != getuid() && seteuid(getuid()) != 0) std::abort();
    }

private:
    static constexpr uid_t nobody = 65534;
};

} // namespace fpm::test
