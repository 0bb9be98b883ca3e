#pragma once
// What becomes of the outputs where the program ends before its work is done: what is unfinished is
// removed, and what was kept is reported.

#include <list>
#include <string>

namespace tribolog {

/// SIGINT, SIGTERM, SIGHUP and SIGXCPU remove what is Unfinished, say in a line what was kept since
/// this was called, and then end the program as the signal does; a second one ends it at once. One
/// that is ignored at the start stays ignored. SIGXFSZ is ignored, so that writing fails instead.
/// To be called once, before there is a second thread. Processes that are forked have these signals
/// blocked.
void end_cleanly_on_signals();

/// For a process that was forked: these signals end it again.
void let_signals_end_this_process();

/// A file, or an empty directory, that a signal removes as long as this lives.
class Unfinished {
 public:
  explicit Unfinished(const std::string& path);
  ~Unfinished();
  Unfinished(const Unfinished&) = delete;
  Unfinished& operator=(const Unfinished&) = delete;

 private:
  std::list<std::string>::iterator place_;
};

/// Signals wait as long as this lives: for changes that belong together.
class Uninterrupted {
 public:
  Uninterrupted();
  ~Uninterrupted();
  Uninterrupted(const Uninterrupted&) = delete;
  Uninterrupted& operator=(const Uninterrupted&) = delete;
};

/// Something is on the disk to stay, whatever happens from now on. To be said twice is to be said
/// once. Forgotten at once where end_cleanly_on_signals() was not called.
/// @param what safe to print: "out/report.html"
void note_kept(const std::string& what);

/// "nothing was changed", or "kept: out/report.html, out/report.calibration.json".
std::string kept_in_words();
/// Was something noted?
bool is_something_kept();

}  // namespace tribolog
