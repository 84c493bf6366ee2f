#pragma once

#include <cstdint>
#include <random>

/// Random numbers: the same ones for the same seed, on every machine.
class RandomNumbers {
public:
    explicit RandomNumbers(std::uint64_t seed) : engine(seed) {}

    /// The next number, spread evenly from 0 up to, but not with, 1.
    float next() { return static_cast<float>(engine() >> 40) * 0x1p-24f; }

private:
    std::mt19937_64 engine;
};
