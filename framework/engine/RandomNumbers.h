#pragma once

#include <cstdint>

namespace radlab::engine {

constexpr std::uint64_t goldenGamma = 0x9e3779b97f4a7c15;

/// A mix of all bits: the finaliser of SplitMix64.
///
/// @source [Steele2014]
constexpr std::uint64_t mixedBits(std::uint64_t bits) {
    bits += goldenGamma;
    bits = (bits ^ (bits >> 30)) * 0xbf58476d1ce4e5b9;
    bits = (bits ^ (bits >> 27)) * 0x94d049bb133111eb;
    return bits ^ (bits >> 31);
}

/// A number from 0 to 1, less than 1, of 53 bits.
constexpr double unitOf(std::uint64_t bits) { return static_cast<double>(bits >> 11) * 0x1p-53; }

/// Independent random numbers from 0 to 1: the same for the same two keys on every machine.
///
/// @source [Steele2014] SplitMix64
class RandomNumbers {
public:
    RandomNumbers(std::uint64_t key, std::uint64_t k) : state(mixedBits(mixedBits(key) ^ k)) {}

    double next() {
        const double number = unitOf(mixedBits(state));
        state += goldenGamma;
        return number;
    }

private:
    std::uint64_t state;
};

}  // namespace radlab::engine
