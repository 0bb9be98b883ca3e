#include "method/session/session_times.h"

#include <algorithm>
#include <cstddef>
#include <numeric>

namespace tribolog::method::session {

SessionTimes session_times(const std::vector<joint::Recording>& recordings) {
  SessionTimes out;
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < recordings.size(); ++i) {
    if (recordings[i].size() > 1) order.push_back(i);
  }
  out.begin_s.assign(recordings.size(), 0.0);
  if (order.empty()) return out;
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return recordings[a].t_s.front() < recordings[b].t_s.front();
  });
  out.by_clock = order.size() > 1;
  for (std::size_t k = 1; k < order.size(); ++k) {
    out.by_clock &= recordings[order[k]].t_s.front() >= recordings[order[k - 1]].t_s.back();
  }
  if (out.by_clock) {
    const double begin = recordings[order.front()].t_s.front();
    for (const std::size_t i : order) out.begin_s[i] = recordings[i].t_s.front() - begin;
    out.whole_s = recordings[order.back()].t_s.back() - begin;
    return out;
  }
  for (std::size_t i = 0; i < recordings.size(); ++i) {
    out.begin_s[i] = out.whole_s;
    if (recordings[i].size() > 1) {
      out.whole_s += recordings[i].t_s.back() - recordings[i].t_s.front();
    }
  }
  return out;
}

}  // namespace tribolog::method::session
