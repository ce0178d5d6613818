// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace plumbline::pathtracer {

/// While it lives, the first SIGINT or SIGTERM only asks for an end; a second ends the process.
class Interrupts {
 public:
    Interrupts();
    ~Interrupts();
    Interrupts(const Interrupts&) = delete;
    Interrupts& operator=(const Interrupts&) = delete;

    /// The signal that asked for an end, or 0. Thread-safe.
    static int received();
};

}  // namespace plumbline::pathtracer
