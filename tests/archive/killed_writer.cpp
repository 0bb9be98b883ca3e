#include "archive/killed_writer.h"

#include <array>
#include <csignal>
#include <cstddef>
#include <fstream>
#include <future>
#include <regex>
#include <stdexcept>
#include <thread>

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

namespace tribolog::test {
namespace {

pid_t started(const std::vector<std::string>& arguments, int standard_output) {
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, standard_output, STDOUT_FILENO);
  posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
  std::vector<char*> argv;
  for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
  argv.push_back(nullptr);
  pid_t process = -1;
  const int failed = posix_spawn(&process, argv[0], &actions, nullptr, argv.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (failed != 0) throw std::runtime_error("cannot start " + arguments[0]);
  return process;
}

}  // namespace

std::vector<std::string> calibrations_like(const std::string& json, const std::string& directory,
                                           std::size_t count) {
  const std::string key = "\"sha256\": \"";
  constexpr std::size_t digits = 16;
  std::vector<std::string> files;
  for (std::size_t k = 0; k < count; ++k) {
    std::string other = json;
    for (std::size_t at = 0; (at = other.find(key, at)) != std::string::npos; at += key.size()) {
      other.replace(at + key.size(), digits, fmt::format("{:016x}", k));
    }
    files.push_back(fmt::format("{}/c{}.json", directory, k));
    std::ofstream(files.back(), std::ios::binary) << other;
  }
  return files;
}

WriterRun archive_and_kill(const std::vector<std::string>& files, const std::string& location,
                           std::chrono::microseconds life) {
  std::vector<std::string> arguments{TRIBOLOG_PROGRAM, "archive", "add"};
  arguments.insert(arguments.end(), files.begin(), files.end());
  arguments.insert(arguments.end(), {"--archive", location, "--wait", "60"});
  std::array<int, 2> pipe_ends{};
  if (pipe2(pipe_ends.data(), O_CLOEXEC) != 0) throw std::runtime_error("no pipe");
  const auto start = std::chrono::steady_clock::now();
  const pid_t process = started(arguments, pipe_ends[1]);
  close(pipe_ends[1]);
  std::promise<void> ended;
  std::thread killer([&] {
    if (ended.get_future().wait_until(start + life) == std::future_status::ready) return;
    kill(process, SIGKILL);  // not waited for yet: the number is still its own
  });
  std::string told;
  std::array<char, 4096> piece{};
  for (ssize_t bytes = 0; (bytes = read(pipe_ends[0], piece.data(), piece.size())) > 0;) {
    told.append(piece.data(), static_cast<std::size_t>(bytes));
  }
  close(pipe_ends[0]);
  WriterRun run;
  run.took = std::chrono::duration_cast<std::chrono::microseconds>(
      std::chrono::steady_clock::now() - start);
  ended.set_value();
  killer.join();
  int status = 0;
  waitpid(process, &status, 0);
  run.was_killed = WIFSIGNALED(status);
  run.status = run.was_killed ? 0 : WEXITSTATUS(status);
  const std::regex line("archived: ([0-9a-f]{10}) ");
  for (std::sregex_iterator at(told.begin(), told.end(), line); at != std::sregex_iterator();
       ++at) {
    run.ids.insert((*at)[1]);
  }
  return run;
}

}  // namespace tribolog::test
