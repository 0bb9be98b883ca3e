#pragma once
// Independent pieces of work on all cores.
//
// What comes out must not depend on the number of threads: each piece writes to its own place and
// draws from its own random stream.

#include <cstddef>
#include <functional>

namespace tribolog {

/// Calls work(0) to work(count - 1), each once, in any order, from several threads at once;
/// returns when all are done. The first exception of a piece is thrown on; pieces not yet begun
/// are then left out.
/// @param threads 0: as many as the machine has cores that no other call uses, so that calls may be
/// nested. With 1 all is done in the calling thread. Calls within one that states a number start no
/// further threads.
void parallel_for(std::size_t count, const std::function<void(std::size_t)>& work,
                  std::size_t threads = 0);

}  // namespace tribolog
