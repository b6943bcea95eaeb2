#pragma once

#include <cstddef>
#include <cstdint>
#include <random>
#include <string>

// Ways to change an input that leave its frame whole, so that a change gets past lengths and
// checksums to the decoder.
namespace fuzz {

using Random = std::minstd_rand;

/// Each returns what it made of the input, at most `most` bytes.
std::string mutated_bytes(std::string input, std::size_t most, Random& random);  ///< plain numbers, messages
std::string mutated_text(std::string input, std::size_t most, Random& random);   ///< numbers written out
std::string mutated_frames(std::string input, std::size_t most,
                           Random& random);                                    ///< frames after their lengths
std::string mutated_log(std::string input, std::size_t most, Random& random);  ///< records of a league log
std::string mutated_packed(std::string input, std::size_t most, Random& random);  ///< the same, in gzip

}  // namespace fuzz
